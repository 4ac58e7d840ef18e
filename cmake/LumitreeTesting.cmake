# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# One ctest per binary or script; labels say which part of the house it tests (ctest -L Accel).

set(LUMITREE_TEST_TIMEOUT 300 CACHE STRING "Seconds after which a test is stopped")
mark_as_advanced(LUMITREE_TEST_TIMEOUT)

# All that a test needs to find what was built; nothing is taken from an installed Lumitree.
set(_lumitree_test_environment
  "PYTHONPATH=path_list_prepend:${CMAKE_BINARY_DIR}/${LUMITREE_PYTHON_DESTINATION}"
  "LD_LIBRARY_PATH=path_list_prepend:${CMAKE_LIBRARY_OUTPUT_DIRECTORY}"
  # Holds Lumitree/Lumitree.so and LumitreeReference/LumitreeReference.so.
  "LUMITREE_PLUGIN_DIR=set:${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${PARAVIEW_PLUGIN_SUBDIR}"
  "LUMITREE_SOURCE_DIR=set:${PROJECT_SOURCE_DIR}"
  "LUMITREE_BUILD_DIR=set:${CMAKE_BINARY_DIR}"
  "PYTHONDONTWRITEBYTECODE=set:1"
  # Open MPI runs as root only if told twice.
  "OMPI_ALLOW_RUN_AS_ROOT=set:1"
  "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=set:1")

set_property(GLOBAL PROPERTY LUMITREE_NEXT_SCREEN 100)

function (_lumitree_test_properties name)
  get_filename_component(label "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  set_tests_properties("${name}" PROPERTIES
    ENVIRONMENT_MODIFICATION "${_lumitree_test_environment}"
    TIMEOUT "${LUMITREE_TEST_TIMEOUT}"
    LABELS "${label}")
endfunction ()

function (_lumitree_add_gtest name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBS")
  add_executable("${name}" ${arg_SOURCES})
  target_link_libraries("${name}" PRIVATE Lumitree::FloatingPoint ${arg_LIBS} GTest::gtest_main)
  target_include_directories("${name}" PRIVATE "${PROJECT_SOURCE_DIR}")
  lumitree_warnings("${name}")
  add_test(NAME "${name}" COMMAND "${name}")
  _lumitree_test_properties("${name}")
endfunction ()

# lumitree_add_core_test(<name> <source>... [LIBS <target>...])
# A GoogleTest binary for a core. LIBS defaults to the core of the calling directory.
function (lumitree_add_core_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBS")
  if (NOT arg_LIBS)
    get_filename_component(core "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
    set(arg_LIBS "Lumitree::${core}")
  endif ()
  _lumitree_add_gtest("${name}" SOURCES ${arg_UNPARSED_ARGUMENTS} LIBS ${arg_LIBS})
endfunction ()

# lumitree_add_vtk_test(<name> <source>... [LIBS <target>...])
# A GoogleTest binary that links every VTK module of Lumitree, and both cores.
function (lumitree_add_vtk_test name)
  if (NOT LUMITREE_HAVE_VTK)
    return ()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBS")
  _lumitree_add_gtest("${name}"
    SOURCES ${arg_UNPARSED_ARGUMENTS}
    LIBS ${LUMITREE_MODULES} Lumitree::Accel Lumitree::Data Lumitree::Radiometry
      VTK::FiltersCore VTK::FiltersGeneral VTK::FiltersSources VTK::IOXML ${arg_LIBS})
  vtk_module_autoinit(TARGETS "${name}" MODULES ${LUMITREE_MODULES})
endfunction ()

# lumitree_add_python_test(<name> <script> [PYTEST|PVPYTHON|PVBATCH] [XVFB] [MPI <n>] [ARGS <argument>...])
# Runs a script: with the Python that VTK was built for (default), with pytest, or with ParaView's pvpython
# or pvbatch. XVFB gives it a screen; MPI runs it on n ranks.
function (lumitree_add_python_test name script)
  cmake_parse_arguments(PARSE_ARGV 2 arg "PYTEST;PVPYTHON;PVBATCH;XVFB" "MPI" "ARGS")
  if (NOT LUMITREE_HAVE_PYTHON OR ((arg_PVPYTHON OR arg_PVBATCH) AND NOT LUMITREE_HAVE_PARAVIEW))
    return ()
  endif ()
  if (arg_PVPYTHON)
    set(command "${LUMITREE_PVPYTHON}")
  elseif (arg_PVBATCH)
    set(command "${LUMITREE_PVBATCH}")
  elseif (arg_PYTEST)
    set(command "${Python3_EXECUTABLE}" -m pytest -q -p no:cacheprovider)
  else ()
    set(command "${Python3_EXECUTABLE}")
  endif ()
  if (arg_MPI)
    list(PREPEND command "${LUMITREE_MPIRUN}" --oversubscribe -np "${arg_MPI}")
  endif ()
  if (arg_XVFB)
    # A server that resets when its last client leaves may refuse the next one.
    # Two xvfb-run that look for a free screen at the same time may take the same one: each starts
    # looking at a number of its own.
    get_property(screen GLOBAL PROPERTY LUMITREE_NEXT_SCREEN)
    math(EXPR next "${screen} + 10")
    set_property(GLOBAL PROPERTY LUMITREE_NEXT_SCREEN "${next}")
    list(PREPEND command
      "${LUMITREE_XVFB_RUN}" -a "--server-num=${screen}" -s "-noreset -screen 0 1280x1024x24")
  endif ()
  add_test(NAME "${name}"
    COMMAND ${command} "${CMAKE_CURRENT_SOURCE_DIR}/${script}" ${arg_ARGS}
    WORKING_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}")
  _lumitree_test_properties("${name}")
  if (arg_MPI)
    set_tests_properties("${name}" PROPERTIES PROCESSORS "${arg_MPI}")
  endif ()
endfunction ()

# lumitree_add_benchmark(<name> <source>... [LIBS <target>...])
# A program in bin/benchmarks that prints a table when run without arguments, with or without Google
# Benchmark. Built only with the target `benchmarks`.
function (lumitree_add_benchmark name)
  if (NOT TARGET benchmark::benchmark)
    return ()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBS")
  add_executable("${name}" EXCLUDE_FROM_ALL ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries("${name}" PRIVATE
    Lumitree::FloatingPoint Lumitree::Accel Lumitree::Data Lumitree::Radiometry ${arg_LIBS}
    benchmark::benchmark)
  set_target_properties("${name}" PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/benchmarks")
  lumitree_warnings("${name}")
  if (NOT TARGET benchmarks)
    add_custom_target(benchmarks)
  endif ()
  add_dependencies(benchmarks "${name}")
endfunction ()

# The programs that run scripts; needed only if what they run is in the build.
if (LUMITREE_HAVE_PARAVIEW)
  find_program(LUMITREE_PVPYTHON pvpython HINTS "${ParaView_PREFIX_PATH}/bin" REQUIRED)
  find_program(LUMITREE_PVBATCH pvbatch HINTS "${ParaView_PREFIX_PATH}/bin" REQUIRED)
  find_program(LUMITREE_MPIRUN mpirun REQUIRED)
endif ()
if (LUMITREE_HAVE_VTK)
  find_program(LUMITREE_XVFB_RUN xvfb-run REQUIRED)
endif ()
