# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause

string(REPLACE "|" ";" arguments "${ARGUMENTS}")
file(REMOVE_RECURSE "${WORK_DIR}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${WORK_DIR}" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    -DLUMITREE_VTK=OFF -DLUMITREE_CGAL=OFF -DLUMITREE_OPENMESH=OFF -DLUMITREE_TESTING=OFF
    ${arguments}
  RESULT_VARIABLE result
  OUTPUT_VARIABLE output
  ERROR_VARIABLE output)
file(REMOVE_RECURSE "${WORK_DIR}")

if (FAILS AND result EQUAL 0)
  message(FATAL_ERROR "configured, but should have refused:\n${output}")
elseif (NOT FAILS AND NOT result EQUAL 0)
  message(FATAL_ERROR "refused, but should have configured:\n${output}")
endif ()
# cmake wraps long messages.
string(REGEX REPLACE "[ \n]+" " " flat "${output}")
if (NOT flat MATCHES "${EXPECT}")
  message(FATAL_ERROR "expected to read `${EXPECT}` in:\n${output}")
endif ()
