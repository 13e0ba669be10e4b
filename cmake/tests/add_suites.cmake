# SPDX-License-Identifier: Apache-2.0
# Read by ctest before it runs.

# nazori_add_suites(PROGRAM PREFIX WITHOUT PROPERTIES): a test for each suite of a GoogleTest program, but for the tests
# of the filter WITHOUT. The start of a program takes longer than most tests.
function(nazori_add_suites program prefix without properties)
  if(NOT EXISTS "${program}")
    add_test("${prefix}NOT_BUILT" "${program}")
    return()
  endif()
  execute_process(COMMAND "${program}" --gtest_list_tests "--gtest_filter=*-${without}"
                  OUTPUT_VARIABLE listed RESULT_VARIABLE result TIMEOUT 60)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} does not list its tests: ${result}")
  endif()
  string(REGEX MATCHALL "(^|\n)[^ \n.]+[.]" suites "${listed}")
  foreach(suite IN LISTS suites)
    string(STRIP "${suite}" suite)
    string(REGEX REPLACE "[.]$" "" suite "${suite}")
    add_test("${prefix}${suite}" "${program}" --gtest_brief=1 "--gtest_filter=${suite}.*-${without}")
    set_tests_properties("${prefix}${suite}" PROPERTIES ${properties})
  endforeach()
endfunction()
