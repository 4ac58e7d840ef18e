# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The VTK modules are built once, wrapped for Python, and only linked by the ParaView plugins.

set(LUMITREE_PYTHON_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages" CACHE STRING
  "Where the Python package goes, relative to the prefix")
set(LUMITREE_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Lumitree")

# lumitree_module_settings(<module>): the project's warnings and floating-point rules for one VTK module,
# called from the module's CMakeLists.txt.
function (lumitree_module_settings module)
  vtk_module_link("${module}" PRIVATE Lumitree::FloatingPoint)
  vtk_module_compile_options("${module}" PRIVATE -Wall -Wextra -Wshadow)
  if (LUMITREE_WERROR)
    vtk_module_compile_options("${module}" PRIVATE -Werror)
  endif ()
endfunction ()

file(GLOB _lumitree_module_files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/Filters/*/vtk.module")
vtk_module_scan(
  MODULE_FILES ${_lumitree_module_files}
  PROVIDES_MODULES LUMITREE_MODULES
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${LUMITREE_MODULES}
  PACKAGE Lumitree
  INSTALL_EXPORT LumitreeModules
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/lumitree"
  CMAKE_DESTINATION "${LUMITREE_CMAKE_DESTINATION}"
  LICENSE_DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Lumitree"
  HIERARCHY_DESTINATION "${CMAKE_INSTALL_LIBDIR}/vtk/hierarchy/Lumitree"
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}")

if (LUMITREE_HAVE_PYTHON)
  # Modules lumitree.vtk.LumitreeFiltersRays and so on; lumitree/vtk/__init__.py gathers their classes.
  vtk_module_wrap_python(
    MODULES ${LUMITREE_MODULES}
    INSTALL_HEADERS OFF
    PYTHON_PACKAGE "lumitree.vtk"
    MODULE_DESTINATION "${LUMITREE_PYTHON_DESTINATION}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    WRAPPED_MODULES LUMITREE_WRAPPED_MODULES
    TARGET Lumitree::PythonModules
    BUILD_STATIC OFF)
endif ()
