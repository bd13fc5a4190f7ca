# obrys_unit_tests(<folder> <file>...): the tests that stand beside a folder's code, one program a folder.
#
# Property tests run with one seed here, so that a run says something about the change and not about luck; a test program
# started by hand takes a new seed each time and prints it (RC_PARAMS="seed=… max_success=…").
include(GoogleTest)
function(obrys_unit_tests folder)
  string(REPLACE / _ name ${folder})
  add_executable(test_${name} ${ARGN})
  obrys_unity(test_${name})
  target_link_libraries(test_${name} PRIVATE obrys_${name} obrys_warnings GTest::gtest_main rapidcheck)
  # Their own sources take half the time; what they test stays as it is shipped.
  target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_compile_definitions(test_${name} PRIVATE OBRYS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(OBRYS_SANITIZE)
    obrys_shards(${folder} test_${name} ${ARGN})
    return()
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX "${folder}." DISCOVERY_TIMEOUT 60
    PROPERTIES ENVIRONMENT "RC_PARAMS=seed=20261121")
endfunction()

# obrys_shards(<folder> <target> <file>...): a program's tests in as many runs as it has four files of them. Under the
# sanitizers a start takes longer than most tests.
function(obrys_shards folder target)
  list(LENGTH ARGN files)
  math(EXPR shards "1 + ${files} / 4")
  math(EXPR last "${shards} - 1")
  foreach(shard RANGE ${last})
    add_test(NAME ${folder}.${shard} COMMAND ${target})
    set_tests_properties(${folder}.${shard} PROPERTIES TIMEOUT 3600
      ENVIRONMENT "RC_PARAMS=seed=20261121;GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${shard}")
  endforeach()
endfunction()
