# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The package that find_package(Lumitree) finds, in the build tree and in the installed one.

include(CMakePackageConfigHelpers)
set(LUMITREE_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Lumitree")
set(_lumitree_package_directory "${CMAKE_BINARY_DIR}/${LUMITREE_CMAKE_DESTINATION}")

install(TARGETS LumitreeFloatingPoint EXPORT LumitreeCore)
install(EXPORT LumitreeCore
  NAMESPACE Lumitree::
  FILE LumitreeCore-targets.cmake
  DESTINATION "${LUMITREE_CMAKE_DESTINATION}")
export(EXPORT LumitreeCore
  NAMESPACE Lumitree::
  FILE "${_lumitree_package_directory}/LumitreeCore-targets.cmake")

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/LumitreeConfig.cmake.in"
  "${_lumitree_package_directory}/LumitreeConfig.cmake"
  INSTALL_DESTINATION "${LUMITREE_CMAKE_DESTINATION}")
write_basic_package_version_file(
  "${_lumitree_package_directory}/LumitreeConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
configure_file("${CMAKE_CURRENT_LIST_DIR}/LumitreeVTKPackages.cmake" "${_lumitree_package_directory}" COPYONLY)
install(FILES
  "${_lumitree_package_directory}/LumitreeVTKPackages.cmake"
  "${_lumitree_package_directory}/LumitreeConfig.cmake"
  "${_lumitree_package_directory}/LumitreeConfigVersion.cmake"
  DESTINATION "${LUMITREE_CMAKE_DESTINATION}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Lumitree")
