# What `cmake --install` and the .deb hold: the program, one library libobrys.a made of all folders, its headers,
# CMake and pkg-config files, the shipped machines and examples, the manual page. Each loadable module is a component and
# a .deb of its own, obrys-<name>, so that the libraries it needs are asked of those who want it only.
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY obrys_modules)
get_property(libraries GLOBAL PROPERTY obrys_libraries)
list(REMOVE_DUPLICATES libraries)
set(objects)
foreach(module IN LISTS modules)
  get_target_property(type ${module} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    list(APPEND objects $<TARGET_OBJECTS:${module}>)
  endif()
endforeach()

add_library(obrys_library STATIC ${objects})
add_library(obrys::obrys ALIAS obrys_library)
set_target_properties(obrys_library PROPERTIES OUTPUT_NAME obrys EXPORT_NAME obrys LINKER_LANGUAGE CXX)
target_compile_features(obrys_library INTERFACE cxx_std_20)
target_include_directories(obrys_library INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/obrys>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

# CMake: find_package(obrys) gives obrys::obrys. Folders name their libraries as <package>::<target>. Libraries that are
# headers only are compiled in already and are no concern of our users.
set(OBRYS_FIND_DEPENDENCIES "")
set(obrys_pc_libs "")
foreach(library IN LISTS libraries)
  get_target_property(type ${library} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    continue()
  endif()
  string(REGEX REPLACE "::.*" "" package ${library})
  string(REGEX REPLACE ".*::" "" name ${library})
  target_link_libraries(obrys_library PRIVATE ${library})
  string(APPEND OBRYS_FIND_DEPENDENCIES "find_dependency(${package})\n")
  string(APPEND obrys_pc_libs " -l${name}")
endforeach()
set(cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/obrys)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/obrysConfig.cmake.in ${PROJECT_BINARY_DIR}/obrysConfig.cmake
  INSTALL_DESTINATION ${cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/obrysConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(TARGETS obrys_library EXPORT obrys ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT obrys NAMESPACE obrys:: FILE obrysTargets.cmake DESTINATION ${cmake_dir})
install(FILES ${PROJECT_BINARY_DIR}/obrysConfig.cmake ${PROJECT_BINARY_DIR}/obrysConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Findlua.cmake DESTINATION ${cmake_dir})

# pkg-config; found from the file's own place, so that the tree can be moved.
file(RELATIVE_PATH obrys_pc_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/obrys.pc.in ${PROJECT_BINARY_DIR}/obrys.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/obrys.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/obrys
  FILES_MATCHING PATTERN "*.hpp" PATTERN "apps" EXCLUDE PATTERN "obrys" EXCLUDE PATTERN "*_test*" EXCLUDE PATTERN "bench_*" EXCLUDE)
# The doors, as <obrys/check.hpp>. What lies beside them may change with every version.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/obrys/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/obrys
  FILES_MATCHING PATTERN "*.hpp" PATTERN "shown.hpp" EXCLUDE PATTERN "*_test*" EXCLUDE)
install(TARGETS obrys RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
get_property(loadables GLOBAL PROPERTY obrys_loadables)
foreach(loadable IN LISTS loadables)
  install(TARGETS ${loadable} LIBRARY DESTINATION ${OBRYS_LOADABLE_DIR} COMPONENT ${loadable})
endforeach()
foreach(folder IN ITEMS machines materials examples)
  if(EXISTS ${PROJECT_SOURCE_DIR}/${folder})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/obrys)
  endif()
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/docs/obrys.1.in ${PROJECT_BINARY_DIR}/obrys.1 @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/obrys.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME obrys)
set(CPACK_PACKAGE_CONTACT "obrys maintainers <maintainers@obrys.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What the program loads while it runs, dpkg-shlibdeps does not see.
get_property(later GLOBAL PROPERTY obrys_later_packages)
list(JOIN later ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libfmt-dev, libtomlplusplus-dev, libtbb-dev, liblua5.4-dev")
if(loadables)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING IGNORE)
  set(CPACK_COMPONENTS_ALL Unspecified ${loadables})
  set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME obrys)
  list(JOIN loadables ", " CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS)
  foreach(loadable IN LISTS loadables)
    string(TOUPPER ${loadable} component)
    set(CPACK_DEBIAN_${component}_PACKAGE_NAME ${loadable})
    set(CPACK_DEBIAN_${component}_PACKAGE_DEPENDS "obrys (= ${PROJECT_VERSION})")
    set(CPACK_DEBIAN_${component}_PACKAGE_SUGGESTS "")
    set(CPACK_COMPONENT_${component}_DESCRIPTION "Module of obrys, loaded when it is wanted")
  endforeach()
endif()
include(CPack)
