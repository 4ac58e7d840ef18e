# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Defaults that have to be known before the compiler is looked at.

get_property(_lumitree_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if (NOT CMAKE_BUILD_TYPE AND NOT _lumitree_multi_config)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel")
  set_property(CACHE CMAKE_BUILD_TYPE PROPERTY STRINGS Release Debug RelWithDebInfo MinSizeRel)
endif ()

# -O2 as distributions build: -O3 buys nothing measurable here and costs compile time.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "C++ flags of the Release build")

find_program(LUMITREE_CCACHE ccache DOC "ccache, used when found")
mark_as_advanced(LUMITREE_CCACHE)
if (LUMITREE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without the sloppiness a precompiled header makes every compilation a miss.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND}" -E env "CCACHE_SLOPPINESS=pch_defines,time_macros" "${LUMITREE_CCACHE}"
    CACHE STRING "Run in front of the C++ compiler")
endif ()

# VTK's wrapping breaks when a Python other than the one VTK was built for comes first on the PATH
# (pyenv, conda). Distributions build against /usr/bin/python3.
if (NOT DEFINED Python3_EXECUTABLE AND EXISTS "/usr/bin/python3")
  set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python that VTK was built for")
endif ()
