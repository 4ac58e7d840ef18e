# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# One step of the install test; see CMakeLists.txt.

set(moved "${WORK_DIR}/moved")

function (run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction ()

function (install_and_move)
  file(REMOVE_RECURSE "${WORK_DIR}")
  run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/first")
  file(RENAME "${WORK_DIR}/first" "${moved}")
endfunction ()

# A path of this machine's build in an installed file would work here and nowhere else. (Debug information
# names source files; in a library only the places where it looks for others matter.)
function (refuse_leftovers)
  set(ours "(^|[^A-Za-z0-9_./-])(${BUILD_DIR}|${SOURCE_DIR})(/|[^A-Za-z0-9_./-]|$)")
  file(GLOB_RECURSE files "${moved}/*")
  foreach (file IN LISTS files)
    set(lines "")
    if (file MATCHES "\\.(cmake|h|py|xml)$")
      file(STRINGS "${file}" lines REGEX "${ours}")
    elseif (file MATCHES "\\.so[.0-9]*$")
      file(READ_ELF "${file}" RPATH rpath RUNPATH runpath)
      if ("${rpath} ${runpath}" MATCHES "${ours}")
        set(lines "${rpath} ${runpath}")
      endif ()
    endif ()
    if (lines)
      message(SEND_ERROR "${file} names the build tree:\n${lines}")
    endif ()
  endforeach ()
endfunction ()

function (build_and_run consumer)
  string(REPLACE "|" ";" hints "${PACKAGE_HINTS}")
  list(FILTER hints EXCLUDE REGEX "(=|NOTFOUND)$")
  list(TRANSFORM hints PREPEND "-D")
  run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}/Testing/Install/${consumer}" -B "${WORK_DIR}/${consumer}"
    -G "${GENERATOR}" -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
    "-DCMAKE_PREFIX_PATH=${moved}" ${hints})
  run("${CMAKE_COMMAND}" --build "${WORK_DIR}/${consumer}")
  run("${WORK_DIR}/${consumer}/consumer")
endfunction ()

function (import_package)
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${moved}/${PYTHON_DESTINATION}" --unset=LD_LIBRARY_PATH
    "${PYTHON}" "${SOURCE_DIR}/Testing/Install/consumer.py" "${moved}")
endfunction ()

if (STEP STREQUAL "Install")
  install_and_move()
elseif (STEP STREQUAL "Leftovers")
  refuse_leftovers()
elseif (STEP STREQUAL "Python")
  import_package()
else ()
  build_and_run("${STEP}")
endif ()
