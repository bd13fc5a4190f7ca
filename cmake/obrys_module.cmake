# obrys_unity(<target>): so many of its sources at a time are one translation unit, where OBRYS_UNITY is on. Most of the
# time goes into headers; more at a time make one changed source too slow. Sources with flags of their own stay alone, and
# generated ones, so that a new text does not compile the others.
set(OBRYS_UNITY_BATCH 10 CACHE STRING "Sources of a translation unit, where OBRYS_UNITY is on")
mark_as_advanced(OBRYS_UNITY_BATCH)
function(obrys_unity target)
  if(NOT OBRYS_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${OBRYS_UNITY_BATCH})
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^${PROJECT_BINARY_DIR}/")
  if(sources)
    set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# obrys_optimise(<target> <option>): another level than the configuration's, where that is the optimised one.
function(obrys_optimise target option)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${option}>)
endfunction()

# obrys_module(<folder> SOURCES <file>... [USES <folder>...] [LIBRARIES <target>...] [ALONE] [COLD])
#
# One folder of the house: a static library obrys_<folder>, the folders it may include (each must
# already stand), and outside libraries that stay private to it. With no SOURCES it is headers only.
# ALONE: each source is a translation unit of its own, also with OBRYS_UNITY. COLD: no time goes there; -O1 instead of -O3
# saves a third of its compilation.
set_property(GLOBAL PROPERTY obrys_layers "")
set_property(GLOBAL PROPERTY obrys_modules "")
set_property(GLOBAL PROPERTY obrys_libraries "")
set_property(GLOBAL PROPERTY obrys_loadables "")

function(obrys_module folder)
  cmake_parse_arguments(ARG "ALONE;COLD" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  string(REPLACE / _ target obrys_${folder})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    if(NOT ARG_ALONE)
      obrys_unity(${target})
    endif()
    if(ARG_COLD)
      obrys_optimise(${target} -O1)
    endif()
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:obrys_warnings> ${ARG_LIBRARIES})
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_compile_features(${target} ${scope} cxx_std_20)
  foreach(used IN LISTS ARG_USES)
    string(REPLACE / _ below obrys_${used})
    if(NOT TARGET ${below})
      message(FATAL_ERROR "${folder} uses ${used}, which does not stand below it")
    endif()
    target_link_libraries(${target} ${scope} ${below})
  endforeach()
  list(JOIN ARG_USES " " uses)
  set_property(GLOBAL APPEND PROPERTY obrys_layers "${folder}: ${uses}")
  set_property(GLOBAL APPEND PROPERTY obrys_modules ${target})
  set_property(GLOBAL APPEND PROPERTY obrys_libraries ${ARG_LIBRARIES})
  file(GLOB tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp)
  if(OBRYS_TESTS AND tests)
    obrys_unit_tests(${folder} ${tests})
  endif()
endfunction()

# obrys_layer(<folder>...): the folder of the CMakeLists.txt at hand is held to these, whether it is built or not.
function(obrys_layer)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/src ${CMAKE_CURRENT_SOURCE_DIR})
  list(JOIN ARGN " " uses)
  set_property(GLOBAL APPEND PROPERTY obrys_layers "${folder}: ${uses}")
endfunction()

# obrys_app(<name> SOURCES <file>... USES <folder>... [LIBRARIES <target>...]): a program, at the top of the house.
# It stands in a folder of its own below src/ and is held to its USES like every other folder.
function(obrys_app name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  obrys_unity(${name})
  obrys_optimise(${name} -O1)
  target_link_libraries(${name} PRIVATE obrys_warnings ${ARG_LIBRARIES})
  foreach(used IN LISTS ARG_USES)
    string(REPLACE / _ below obrys_${used})
    if(NOT TARGET ${below})
      message(FATAL_ERROR "${name} uses ${used}, which does not stand below it")
    endif()
    target_link_libraries(${name} PRIVATE ${below})
  endforeach()
  obrys_layer(${ARG_USES})
endfunction()

# Writes <build>/layers.txt, a line "folder: used used ..." for each folder, bottom to top; the test `layers` reads it.
function(obrys_write_layers)
  get_property(layers GLOBAL PROPERTY obrys_layers)
  list(JOIN layers "\n" text)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/layers.txt CONTENT "${text}\n")
endfunction()

# obrys_loadable(<name> WHEN <bool> SOURCES <file>... USES <folder>... LIBRARIES <target>...): a library libobrys-<name>
# that the driver loads when it is wanted. It stands in a folder of its own below src/ and is held to its USES, of which
# it takes headers only; where WHEN is false the folder is held to them as well, but nothing is built.
set(OBRYS_LOADABLE_DIR lib/obrys)  # from the prefix, of the build tree as of the installed one
function(obrys_loadable name)
  cmake_parse_arguments(ARG "" "WHEN" "SOURCES;USES;LIBRARIES" ${ARGN})
  obrys_layer(${ARG_USES})
  if(NOT ARG_WHEN)
    return()
  endif()
  add_library(obrys-${name} MODULE ${ARG_SOURCES})
  obrys_unity(obrys-${name})
  set_target_properties(obrys-${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${OBRYS_LOADABLE_DIR})
  target_include_directories(obrys-${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(obrys-${name} PRIVATE obrys_warnings ${ARG_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY obrys_loadables obrys-${name})
endfunction()
