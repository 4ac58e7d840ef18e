# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fails if a source of this project is compiled with contraction allowed: one file forgotten is enough to
# leak, because the arithmetic of the headers is compiled into it.

file(READ "${BUILD_DIR}/compile_commands.json" commands)
string(JSON count LENGTH "${commands}")
math(EXPR last "${count} - 1")
set(checked 0)
foreach (i RANGE ${last})
  string(JSON file GET "${commands}" ${i} file)
  if (file MATCHES "^${SOURCE_DIR}/(Accel|Data|Radiometry|Filters|Testing)/")
    string(JSON command GET "${commands}" ${i} command)
    math(EXPR checked "${checked} + 1")
    if (NOT command MATCHES " -ffp-contract=off")
      message(SEND_ERROR "${file} is compiled without -ffp-contract=off")
    endif ()
  endif ()
endforeach ()
if (checked EQUAL 0)
  message(FATAL_ERROR "no compile commands were checked")
endif ()
message(STATUS "${checked} sources, all without contraction")
