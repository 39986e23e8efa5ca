# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the library with its headers, its CMake package and its pkg-config file.
include(CMakePackageConfigHelpers)

set(VBM_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/vbm)
install(TARGETS vbm EXPORT vbmTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include/vbm DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT library FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(EXPORT vbmTargets NAMESPACE vbm:: DESTINATION ${VBM_PACKAGE_DIR} COMPONENT library)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/vbmConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/vbmConfig.cmake INSTALL_DESTINATION ${VBM_PACKAGE_DIR})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/vbmConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vbmConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/vbmConfigVersion.cmake DESTINATION ${VBM_PACKAGE_DIR}
  COMPONENT library)

set(VBM_PC_DIR ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH VBM_PC_TO_PREFIX /${VBM_PC_DIR} /)
string(REGEX REPLACE "/$" "" VBM_PC_TO_PREFIX "${VBM_PC_TO_PREFIX}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/vbm.pc.in ${CMAKE_CURRENT_BINARY_DIR}/vbm.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vbm.pc DESTINATION ${VBM_PC_DIR} COMPONENT library)
