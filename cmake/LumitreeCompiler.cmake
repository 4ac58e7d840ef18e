# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The language, the warnings, and the floating-point rules that the precision guarantees rest on.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
option(BUILD_SHARED_LIBS "Build shared libraries" ON)
option(LUMITREE_WERROR "Treat warnings as errors" OFF)
if (NOT BUILD_SHARED_LIBS)
  message(FATAL_ERROR "Lumitree needs BUILD_SHARED_LIBS=ON: the registry of back ends and the shared "
    "cache must exist once per process.")
endif ()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

# A relocatable tree: libraries find each other beside themselves, and a VTK outside the system
# directories is still found where it was linked.
set(CMAKE_INSTALL_RPATH "$ORIGIN")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)

# Exact and watertight tests are proved for IEEE arithmetic. With reassociation, or with infinities
# and NaN assumed away, the proofs are void and nobody would notice: so refuse.
set(_lumitree_unsafe_flags
  -ffast-math -Ofast -funsafe-math-optimizations -ffinite-math-only -fassociative-math
  -freciprocal-math)
set(_lumitree_all_flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}}")
foreach (_lumitree_config IN ITEMS DEBUG RELEASE RELWITHDEBINFO MINSIZEREL)
  string(APPEND _lumitree_all_flags " ${CMAKE_CXX_FLAGS_${_lumitree_config}}")
endforeach ()
foreach (_lumitree_flag IN LISTS _lumitree_unsafe_flags)
  if (" ${_lumitree_all_flags} " MATCHES " ${_lumitree_flag} ")
    message(FATAL_ERROR "${_lumitree_flag} is among the C++ flags. Lumitree's precision guarantees do "
      "not survive it; remove it from CMAKE_CXX_FLAGS.")
  endif ()
endforeach ()

# GCC contracts a*b+c into a fused multiply-add by default, which changes the sign of a determinant
# near zero. Much of the arithmetic is in headers, hence a usage requirement and not a source flag.
add_library(LumitreeFloatingPoint INTERFACE)
add_library(Lumitree::FloatingPoint ALIAS LumitreeFloatingPoint)
set_target_properties(LumitreeFloatingPoint PROPERTIES EXPORT_NAME FloatingPoint)
target_compile_options(LumitreeFloatingPoint INTERFACE
  "$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>")
target_compile_features(LumitreeFloatingPoint INTERFACE cxx_std_17)

# Warnings for the code of this project; generated wrappers and dependencies are left alone.
function (lumitree_warnings target)
  target_compile_options("${target}" PRIVATE -Wall -Wextra -Wshadow)
  if (LUMITREE_WERROR)
    target_compile_options("${target}" PRIVATE -Werror)
  endif ()
endfunction ()
