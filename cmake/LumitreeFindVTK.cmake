# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# ParaView first, because it brings a VTK of its own that a plugin must share; plain VTK otherwise.

include(LumitreeVTKPackages)

# lumitree_probe(<package> <components> <reason variable>)
# Loads the package in a project of its own. The CMake files of ParaView and VTK stop the configure step when a
# development package that they name is missing, even if asked to be quiet; here that is only a reason, empty
# when all is well. A success is remembered.
function (lumitree_probe package components reason_variable)
  set("${reason_variable}" "" PARENT_SCOPE)
  if (LUMITREE_PROBED_${package})
    return ()
  endif ()
  set(directory "${CMAKE_BINARY_DIR}/probe/${package}")
  file(REMOVE_RECURSE "${directory}")
  file(WRITE "${directory}/CMakeLists.txt"
    "cmake_minimum_required(VERSION 3.25)\nproject(Probe LANGUAGES C CXX)\n"
    "find_package(${package} REQUIRED COMPONENTS ${components})\n")
  string(REPLACE ";" "\\;" prefixes "${CMAKE_PREFIX_PATH}")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${directory}" -B "${directory}/build" -G "${CMAKE_GENERATOR}"
      "-DCMAKE_C_COMPILER=${CMAKE_C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
      "-DCMAKE_PREFIX_PATH=${prefixes}" "-DPython3_EXECUTABLE=${Python3_EXECUTABLE}"
      "-D${package}_DIR=${${package}_DIR}"
    RESULT_VARIABLE result
    OUTPUT_FILE "${directory}/log.txt"
    ERROR_FILE "${directory}/log.txt")
  if (result EQUAL 0)
    set("LUMITREE_PROBED_${package}" TRUE CACHE INTERNAL "${package} can be loaded")
    return ()
  endif ()
  file(READ "${directory}/log.txt" log)
  if (log MATCHES "CMake Error[^\n]*\n *Could NOT find ([A-Za-z0-9_+-]+)")
    set(reason "${package} is there, but its CMake files ask for ${CMAKE_MATCH_1}, which was not found")
  elseif (log MATCHES "package configuration file provided by \"${package}\"")
    set(reason "${package} was not found")
  else ()
    set(reason "${package} could not be loaded; see ${directory}/log.txt")
  endif ()
  set("${reason_variable}" "${reason}" PARENT_SCOPE)
endfunction ()

set(_lumitree_vtk FALSE)
set(_lumitree_vtk_detail "neither ParaView nor VTK was found")
set(_lumitree_paraview FALSE)
set(_lumitree_paraview_detail "ParaView was not found")
if (LUMITREE_VTK STREQUAL "OFF" AND LUMITREE_PARAVIEW STREQUAL "ON")
  message(FATAL_ERROR "LUMITREE_PARAVIEW=ON needs LUMITREE_VTK.")
endif ()

if (NOT LUMITREE_VTK STREQUAL "OFF" AND NOT LUMITREE_PARAVIEW STREQUAL "OFF")
  lumitree_repair_package(ParaView)
  lumitree_probe(ParaView "${LUMITREE_PARAVIEW_COMPONENTS}" _lumitree_paraview_detail)
  if (NOT _lumitree_paraview_detail)
    find_package(ParaView QUIET REQUIRED COMPONENTS ${LUMITREE_PARAVIEW_COMPONENTS})
    set(_lumitree_paraview TRUE)
    set(_lumitree_paraview_detail "${ParaView_VERSION}")
    set(_lumitree_vtk TRUE)
    set(_lumitree_vtk_detail "${VTK_VERSION}, the one inside ParaView")
  endif ()
endif ()
if (NOT LUMITREE_VTK STREQUAL "OFF" AND NOT _lumitree_paraview)
  lumitree_repair_package(VTK)
  lumitree_probe(VTK "${LUMITREE_VTK_COMPONENTS}" _lumitree_vtk_detail)
  if (NOT _lumitree_vtk_detail)
    find_package(VTK 9.1 QUIET REQUIRED
      COMPONENTS ${LUMITREE_VTK_COMPONENTS}
      OPTIONAL_COMPONENTS ${LUMITREE_VTK_OPTIONAL_COMPONENTS})
    set(_lumitree_vtk TRUE)
    set(_lumitree_vtk_detail "${VTK_VERSION}, plain")
  endif ()
endif ()
lumitree_component(VTK "${_lumitree_vtk}" "${_lumitree_vtk_detail}")
lumitree_component(PARAVIEW "${_lumitree_paraview}" "${_lumitree_paraview_detail}")

set(_lumitree_python FALSE)
if (NOT LUMITREE_HAVE_VTK)
  set(_lumitree_python_detail "there are no VTK modules to wrap")
elseif (NOT TARGET VTK::WrappingPythonCore)
  set(_lumitree_python_detail "this VTK was built without Python")
elseif (NOT LUMITREE_PYTHON STREQUAL "OFF")
  find_package(Python3 QUIET COMPONENTS Interpreter Development)
  if (Python3_FOUND)
    set(_lumitree_python TRUE)
    set(_lumitree_python_detail "${Python3_VERSION} (${Python3_EXECUTABLE})")
  else ()
    set(_lumitree_python_detail "Python 3 with its headers was not found")
  endif ()
endif ()
lumitree_component(PYTHON "${_lumitree_python}" "${_lumitree_python_detail}")
