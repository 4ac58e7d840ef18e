# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause

# lumitree_add_core_library(<Name>
#   SOURCES <file>...              explicit, relative to the calling directory
#   [PUBLIC_LINKS <target>...] [PRIVATE_LINKS <target>...])
#
# A shared library Lumitree<Name>, target Lumitree::<Name>, without VTK. Headers are included from the
# source root ("Accel/Surface.h"); those beside the calling CMakeLists.txt are public and installed under the same
# path in include/lumitree, those in its subdirectories are not. A core with an Export.h shows only what it marks.
function (lumitree_add_core_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;PUBLIC_LINKS;PRIVATE_LINKS")
  set(target "Lumitree${name}")
  add_library("${target}" SHARED ${arg_SOURCES})
  add_library("Lumitree::${name}" ALIAS "${target}")
  set_target_properties("${target}" PROPERTIES
    EXPORT_NAME "${name}"
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PROJECT_VERSION_MAJOR}")
  if (EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/Export.h")
    set_target_properties("${target}" PROPERTIES
      CXX_VISIBILITY_PRESET hidden
      VISIBILITY_INLINES_HIDDEN ON)
  endif ()
  target_include_directories("${target}" PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/lumitree>")
  target_link_libraries("${target}"
    PUBLIC LumitreeFloatingPoint ${arg_PUBLIC_LINKS}
    PRIVATE ${arg_PRIVATE_LINKS})
  lumitree_warnings("${target}")

  install(TARGETS "${target}" EXPORT LumitreeCore LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  file(RELATIVE_PATH subdirectory "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
  file(GLOB headers CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.h")
  install(FILES ${headers} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/lumitree/${subdirectory}")
endfunction ()
