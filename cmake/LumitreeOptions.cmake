# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Options with three states. AUTO: used when found, else left out. ON: used, and missing is an error
# (so that CI skips nothing silently). OFF: not even looked for.

function (lumitree_option name doc)
  set("LUMITREE_${name}" AUTO CACHE STRING "${doc} (AUTO, ON or OFF)")
  set_property(CACHE "LUMITREE_${name}" PROPERTY STRINGS AUTO ON OFF)
  if (NOT LUMITREE_${name} MATCHES "^(AUTO|ON|OFF)$")
    message(FATAL_ERROR "LUMITREE_${name} is `${LUMITREE_${name}}`; it must be AUTO, ON or OFF.")
  endif ()
endfunction ()

lumitree_option(VTK "Filters as VTK modules")
lumitree_option(PARAVIEW "Plugins for ParaView")
lumitree_option(PYTHON "Python wrapping and the package `lumitree`")
lumitree_option(EMBREE "Embree as a reference back end")
lumitree_option(CGAL "CGAL as ground truth (GPL, in a library and a plugin of its own)")
lumitree_option(OPENMESH "OpenMesh for half-edge work")
lumitree_option(TESTING "Tests")

# lumitree_component(<NAME> <found> <detail>)
# Decides LUMITREE_HAVE_<NAME> and records the line of the closing table. <detail> is the version when
# found, the reason when not.
function (lumitree_component name found detail)
  set(option "${LUMITREE_${name}}")
  if (option STREQUAL "OFF")
    set(found FALSE)
    set(detail "switched off (LUMITREE_${name}=OFF)")
  elseif (NOT found AND option STREQUAL "ON")
    message(FATAL_ERROR "LUMITREE_${name} is ON, but: ${detail}")
  endif ()
  if (found)
    set("LUMITREE_HAVE_${name}" TRUE PARENT_SCOPE)
    lumitree_component_line("${name}" in "${detail}")
  else ()
    set("LUMITREE_HAVE_${name}" FALSE PARENT_SCOPE)
    lumitree_component_line("${name}" out "${detail}")
  endif ()
endfunction ()

function (lumitree_component_line name state detail)
  string(SUBSTRING "${name}            " 0 12 name)
  string(SUBSTRING "${state}   " 0 5 state)
  set_property(GLOBAL APPEND PROPERTY LUMITREE_COMPONENT_LINES "  ${name}${state}${detail}")
endfunction ()

function (lumitree_print_components)
  get_property(lines GLOBAL PROPERTY LUMITREE_COMPONENT_LINES)
  list(JOIN lines "\n" table)
  message(STATUS "Lumitree ${PROJECT_VERSION}, ${CMAKE_BUILD_TYPE} build:\n${table}")
endfunction ()
