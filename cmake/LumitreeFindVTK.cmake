# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# ParaView first, because it brings a VTK of its own that a plugin must share; plain VTK otherwise.

include(LumitreeVTKPackages)

set(_lumitree_vtk FALSE)
set(_lumitree_vtk_detail "neither ParaView nor VTK was found")
set(_lumitree_paraview FALSE)
set(_lumitree_paraview_detail "ParaView was not found")
if (LUMITREE_VTK STREQUAL "OFF" AND LUMITREE_PARAVIEW STREQUAL "ON")
  message(FATAL_ERROR "LUMITREE_PARAVIEW=ON needs LUMITREE_VTK.")
endif ()

if (NOT LUMITREE_VTK STREQUAL "OFF" AND NOT LUMITREE_PARAVIEW STREQUAL "OFF")
  lumitree_repair_package(ParaView)
  find_package(ParaView QUIET COMPONENTS ${LUMITREE_PARAVIEW_COMPONENTS})
  if (ParaView_FOUND)
    set(_lumitree_paraview TRUE)
    set(_lumitree_paraview_detail "${ParaView_VERSION}")
    set(_lumitree_vtk TRUE)
    set(_lumitree_vtk_detail "${VTK_VERSION}, the one inside ParaView")
  endif ()
endif ()
if (NOT LUMITREE_VTK STREQUAL "OFF" AND NOT _lumitree_paraview)
  lumitree_repair_package(VTK)
  find_package(VTK 9.1 QUIET
    COMPONENTS ${LUMITREE_VTK_COMPONENTS}
    OPTIONAL_COMPONENTS ${LUMITREE_VTK_OPTIONAL_COMPONENTS})
  if (VTK_FOUND)
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
