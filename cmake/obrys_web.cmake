# The script of the milling page: web/ copied to the build tree, what it uses installed there from web/package-lock.json,
# made into one file by esbuild. Nothing is written into the source tree.
#
# The packages are fetched when the build is configured, so that the build knows whether there is a page. Without node and
# npm, or where the packages cannot be fetched, the script is empty and report::milling_page_available() is false.
find_program(OBRYS_NODE NAMES node nodejs)
find_program(OBRYS_NPM NAMES npm)
mark_as_advanced(OBRYS_NODE OBRYS_NPM)
if(OBRYS_NODE AND OBRYS_NPM)
  set(page_default ON)
else()
  set(page_default OFF)
endif()
option(OBRYS_PAGE "Compile in the script of the milling page (node and npm)" ${page_default})

set(web ${PROJECT_SOURCE_DIR}/web)
set(web_build ${PROJECT_BINARY_DIR}/web)
set(OBRYS_PAGE_SCRIPT ${web_build}/dist/milling.js)

# obrys_web_packages(<variable>): true where node_modules holds what the lock file names.
function(obrys_web_packages result)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${web}/package.json ${web}/package-lock.json)
  # The browser tests' driver and the type checker are wanted only where the tests are built.
  set(without --omit=dev)
  if(OBRYS_TESTS AND NOT OBRYS_SANITIZE)
    set(without "")
  endif()
  file(SHA256 ${web}/package-lock.json wanted)
  string(APPEND wanted "${without}")
  set(stamp ${web_build}/packages.txt)
  if(EXISTS ${stamp})
    file(READ ${stamp} installed)
    if(installed STREQUAL wanted)
      set(${result} TRUE PARENT_SCOPE)
      return()
    endif()
  endif()
  message(STATUS "Fetching the packages of the milling page's script")
  file(COPY ${web}/package.json ${web}/package-lock.json DESTINATION ${web_build})
  # No scripts of packages are run: esbuild finds its program in the package of this platform.
  execute_process(COMMAND ${OBRYS_NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1 ${without}
    WORKING_DIRECTORY ${web_build} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said TIMEOUT 300)
  if(failed)
    message(WARNING "The milling page is left out: npm ci failed (${failed}). Configure again when the packages can be "
      "fetched, or with -DOBRYS_PAGE=OFF to do without.\n${said}")
    set(${result} FALSE PARENT_SCOPE)
  else()
    file(WRITE ${stamp} "${wanted}")
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()

set(OBRYS_PAGE_MADE FALSE)
if(OBRYS_PAGE AND (NOT OBRYS_NODE OR NOT OBRYS_NPM))
  message(FATAL_ERROR "OBRYS_PAGE needs node and npm (Debian: nodejs npm); -DOBRYS_PAGE=OFF builds without the milling page")
elseif(OBRYS_PAGE)
  obrys_web_packages(OBRYS_PAGE_MADE)
endif()

if(OBRYS_PAGE_MADE)
  file(GLOB web_sources CONFIGURE_DEPENDS ${web}/src/*.ts)
  add_custom_command(OUTPUT ${OBRYS_PAGE_SCRIPT}
    COMMAND ${CMAKE_COMMAND} -E rm -rf src dist
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${web}/src src
    COMMAND ${CMAKE_COMMAND} -E copy ${web}/build.mjs ${web}/tsconfig.json .
    COMMAND ${OBRYS_NODE} build.mjs
    DEPENDS ${web_sources} ${web}/build.mjs ${web}/tsconfig.json ${web}/package-lock.json
    WORKING_DIRECTORY ${web_build} COMMENT "Making the milling page's script" VERBATIM)
else()
  set(OBRYS_PAGE_SCRIPT ${web_build}/none/milling.js)
  file(CONFIGURE OUTPUT ${OBRYS_PAGE_SCRIPT} CONTENT "")
endif()
add_custom_target(obrys_web DEPENDS ${OBRYS_PAGE_SCRIPT})
