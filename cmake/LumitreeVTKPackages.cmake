# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# How ParaView and VTK are found, both by this build and by those who use the installed package.

# What the modules, their tests and the wrapping link.
set(LUMITREE_VTK_COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  FiltersCore FiltersExtraction FiltersGeneral FiltersGeometry FiltersSources IOLegacy IOXML
  ParallelCore)
set(LUMITREE_VTK_OPTIONAL_COMPONENTS Python WrappingPythonCore WrappingTools)

# Only what a plugin without a user interface links: asking for all would require the development packages
# of everything that ParaView was built with (HDF5, Qt, and many more).
set(LUMITREE_PARAVIEW_COMPONENTS RemotingCore RemotingServerManager WrapClientServer)

# lumitree_repair_package(<ParaView|VTK>)
# The CMake files of Debian 13 name the Python modules vtkX.so, while the files are vtkX.cpython-313-….so, so
# that find_package stops. If that is so, this makes a corrected copy of those CMake files in the build folder
# and sets <package>_DIR to it; the system is not touched.
function (lumitree_repair_package package)
  string(TOLOWER "${package}" lower)
  set(original "${${package}_DIR}")
  if (NOT original)
    # Searches where find_package would, but loads only the small file that names the prefix.
    find_package(LumitreeProbe QUIET CONFIG NAMES "${package}" CONFIGS "${lower}-prefix.cmake")
    set(original "${LumitreeProbe_DIR}")
    unset(LumitreeProbe_DIR CACHE)
  endif ()
  if (NOT original OR EXISTS "${original}/corrected-copy")
    return ()
  endif ()

  file(GLOB_RECURSE module_lists RELATIVE "${original}" "${original}/*Python*-targets-*.cmake")
  get_filename_component(prefix "${original}" DIRECTORY)
  while (NOT EXISTS "${prefix}/lib/python3/dist-packages/vtkmodules")
    if (prefix STREQUAL "/" OR prefix STREQUAL "")
      return ()
    endif ()
    get_filename_component(prefix "${prefix}" DIRECTORY)
  endwhile ()
  set(python_modules "${prefix}/lib/python3/dist-packages/vtkmodules")
  file(GLOB suffixed RELATIVE "${python_modules}" "${python_modules}/vtkCommonCore.*.so")
  if (NOT suffixed OR NOT module_lists OR EXISTS "${python_modules}/vtkCommonCore.so")
    return ()
  endif ()
  list(GET suffixed 0 suffix)
  string(REPLACE "vtkCommonCore" "" suffix "${suffix}")

  set(copy "${CMAKE_BINARY_DIR}/packages/${package}")
  file(REMOVE_RECURSE "${copy}")
  file(COPY "${original}/" DESTINATION "${copy}")
  file(GLOB_RECURSE files RELATIVE "${copy}" "${copy}/*.cmake")
  foreach (file IN LISTS files)
    file(READ "${copy}/${file}" content)
    set(before "${content}")
    get_filename_component(directory "${original}/${file}" DIRECTORY)
    # The prefix is worked out from the place of the file, which is now another.
    string(REPLACE "(_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\"" "(_IMPORT_PREFIX \"${original}/${file}\""
      content "${content}")
    string(REPLACE "(_vtk_module_import_prefix \"\${CMAKE_CURRENT_LIST_DIR}\""
      "(_vtk_module_import_prefix \"${directory}\"" content "${content}")
    string(REPLACE "(PACKAGE_PREFIX_DIR \"\${CMAKE_CURRENT_LIST_DIR}" "(PACKAGE_PREFIX_DIR \"${directory}"
      content "${content}")
    if (file IN_LIST module_lists)
      string(REGEX REPLACE "(dist-packages/[A-Za-z0-9_/]+)\\.so\"" "\\1${suffix}\"" content "${content}")
    endif ()
    if (NOT content STREQUAL before)
      file(WRITE "${copy}/${file}" "${content}")
    endif ()
  endforeach ()
  file(TOUCH "${copy}/corrected-copy")
  message(STATUS "${original} names Python modules that do not exist; using a corrected copy in ${copy}")
  set("${package}_DIR" "${copy}" CACHE PATH "The directory with the CMake files of ${package}" FORCE)
endfunction ()
