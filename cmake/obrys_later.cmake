include_guard()
# obrys_later(<target> <library> <include dir> <definition>): the headers of a shared library that is loaded while the
# program runs (src/base/library), and its name for the loader as a definition. Who makes a .deb finds the package it
# lies in among the global property obrys_later_packages.
set_property(GLOBAL PROPERTY obrys_later_packages "")
function(obrys_later target library include definition)
  get_filename_component(real ${library} REALPATH)
  get_filename_component(name ${real} NAME)
  string(REGEX MATCH "^[^/]+[.]so[.][0-9]+" soname "${name}")  # libzip.so.4.0 is loaded as libzip.so.4
  if(NOT soname)
    set(soname ${name})
  endif()
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${include}"
    INTERFACE_COMPILE_DEFINITIONS "${definition}=\"${soname}\"")
  find_program(DPKG_QUERY dpkg-query)
  mark_as_advanced(DPKG_QUERY)
  if(DPKG_QUERY)
    execute_process(COMMAND ${DPKG_QUERY} -S ${real} OUTPUT_VARIABLE owner ERROR_QUIET)
    if(owner MATCHES "^([^:]+):")
      set_property(GLOBAL APPEND PROPERTY obrys_later_packages ${CMAKE_MATCH_1})
    endif()
  endif()
endfunction()
