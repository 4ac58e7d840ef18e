# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fails if a core includes what it may not know.

function (refuse room pattern)
  file(GLOB_RECURSE files
    "${SOURCE_DIR}/${room}/*.h" "${SOURCE_DIR}/${room}/*.hpp" "${SOURCE_DIR}/${room}/*.inl"
    "${SOURCE_DIR}/${room}/*.cpp" "${SOURCE_DIR}/${room}/*.cxx" "${SOURCE_DIR}/${room}/*.cc")
  if (NOT files)
    message(SEND_ERROR "${room}: no source files found, so nothing was checked")
  endif ()
  foreach (file IN LISTS files)
    file(STRINGS "${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]${pattern}")
    if (lines)
      message(SEND_ERROR "${file} may not include this:\n${lines}")
    endif ()
  endforeach ()
endfunction ()

refuse(Accel "((.*/)?vtk|Filters/|Radiometry/|Data/)")
refuse(Radiometry "((.*/)?vtk|Filters/|Data/)")
refuse(Data "((.*/)?vtk|Filters/|Radiometry/|Accel/)")
