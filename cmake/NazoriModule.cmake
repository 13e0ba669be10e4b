# Every test program has a folder for temporary files of its own. Tests are optimised less than the code under test,
# sanitized ones not at all: that halves their compile time.
function(nazori_test_program target)
  if(NOT TARGET nazori_private_folder)
    add_library(nazori_private_folder OBJECT "${CMAKE_SOURCE_DIR}/cmake/tests/private_folder.cpp")
    target_link_libraries(nazori_private_folder PRIVATE nazori_compiler)
  endif()
  target_link_libraries(${target} PRIVATE nazori_private_folder)
  if(NAZORI_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  elseif(CMAKE_BUILD_TYPE MATCHES "^Rel")
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()

# Patterns of code that starts a thread.
set(NAZORI_THREAD_WORDS "std::j?thread|base::Bands|std::async|pthread_create|RtThread|asio::|SDL_OpenAudioDevice|QThread")

# nazori_isolated_suites(ISOLATED SHARED REGEX TESTS...)
#
# ISOLATED: a filter of GoogleTest for the suites in the files that match; SHARED: whether other files have tests.
function(nazori_isolated_suites isolated shared regex)
  set(filter "")
  set(${shared} FALSE PARENT_SCOPE)
  foreach(file ${ARGN})
    if(NOT file MATCHES "_test\\.cpp$")
      continue()
    elseif(NOT regex OR NOT file MATCHES "${regex}")
      set(${shared} TRUE PARENT_SCOPE)
      continue()
    endif()
    file(STRINGS "${file}" tests REGEX "^TEST(_F|_P)?\\([A-Za-z0-9_]+,")
    foreach(test ${tests})
      if(test MATCHES "^TEST[_FP]*\\(([A-Za-z0-9_]+),")
        list(APPEND filter "${CMAKE_MATCH_1}.*" "*/${CMAKE_MATCH_1}.*")
      endif()
    endforeach()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach()
  list(REMOVE_DUPLICATES filter)
  list(JOIN filter ":" filter)
  set(${isolated} "${filter}" PARENT_SCOPE)
endfunction()

# nazori_test_parts(NAME COUNT WITHOUT PROPERTIES): the tests of nazori_NAME_tests in COUNT processes (empty: 2), but for
# those of the filter WITHOUT. The start of a sanitized program takes longer than most tests. COUNT "2/8": with the
# address sanitizer two of eight parts run, always the same (NAZORI_SANITIZE_ALL: all of them), so each eighth test and
# the next one. A part whose program passed before is not run again (tools/test-once); what the tests read of the source
# tree are the room's own folder, data and, named in ARGN, other folders.
function(nazori_test_parts name count without properties)
  if(NOT count)
    set(count 2)
  endif()
  set(run ${count})
  if(count MATCHES "^([0-9]+)/([0-9]+)$")
    set(run ${CMAKE_MATCH_1})
    set(count ${CMAKE_MATCH_2})
    if(NAZORI_SANITIZE_ALL OR NOT NAZORI_SANITIZE MATCHES "address")
      set(run ${count})
    endif()
  endif()
  set(trees "")
  file(RELATIVE_PATH here "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
  foreach(tree ${here} data ${ARGN})
    list(APPEND trees --tree ${tree})
  endforeach()
  math(EXPR last "${run} - 1")
  foreach(part RANGE 0 ${last})
    add_test(NAME ${name}.part_${part} COMMAND "${CMAKE_SOURCE_DIR}/tools/test-once" "${CMAKE_BINARY_DIR}" nazori_${name}_tests ${trees} --
      "$<TARGET_FILE:nazori_${name}_tests>" --gtest_brief=1 "--gtest_filter=*-${without}")
    # A part runs hundreds of tests, on a busy machine for longer than any one of them may.
    set_tests_properties(${name}.part_${part} PROPERTIES ${properties} TIMEOUT 1200)
    set_property(TEST ${name}.part_${part} APPEND PROPERTY ENVIRONMENT GTEST_TOTAL_SHARDS=${count} GTEST_SHARD_INDEX=${part})
  endforeach()
endfunction()

# nazori_suite_tests(NAME WITHOUT PROPERTIES): a test for each suite of nazori_NAME_tests, but for what the filter WITHOUT
# names. The programs are asked for their suites when ctest starts.
function(nazori_suite_tests name without properties)
  set(file "${CMAKE_CURRENT_BINARY_DIR}/nazori_${name}_suites.cmake")
  file(GENERATE OUTPUT "${file}" CONTENT
       "include(\"${CMAKE_SOURCE_DIR}/cmake/tests/add_suites.cmake\")\nnazori_add_suites(\"$<TARGET_FILE:nazori_${name}_tests>\" \"${name}.\" \"${without}\" \"${properties}\")\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${file}")
endfunction()

# nazori_threaded_tests(RESULT TESTS ... THREADED ... SOURCES ...)
#
# The test files that are built for the thread sanitizer: THREADED, which is ALL or a list of files, and files that are
# not tests themselves (fixtures). A source that starts threads is listed there, too, with the tests that reach it.
# Stops if a file that starts threads is missing from the list.
function(nazori_threaded_tests result)
  cmake_parse_arguments(t "" "" "TESTS;THREADED;SOURCES" ${ARGN})
  if("ALL" IN_LIST t_THREADED)
    set(${result} ${t_TESTS} PARENT_SCOPE)
    return()
  endif()
  set(forgotten "")
  set(kept "")
  foreach(file ${t_SOURCES} ${t_TESTS})
    set(words "")
    if(NOT IS_ABSOLUTE "${file}" AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
      file(STRINGS "${file}" words REGEX "${NAZORI_THREAD_WORDS}" LIMIT_COUNT 1)
    endif()
    if(words AND NOT file IN_LIST t_THREADED)
      list(APPEND forgotten "${file}")
    endif()
  endforeach()
  if(forgotten)
    message(FATAL_ERROR "these files start threads, so the thread sanitizer must see their tests: ${forgotten}; "
                        "name the tests behind THREADED_TESTS in ${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt (ALL: every test)")
  endif()
  if(t_THREADED)
    foreach(file ${t_TESTS})
      if(file IN_LIST t_THREADED OR NOT file MATCHES "_test\\.cpp$")
        list(APPEND kept "${file}")
      endif()
    endforeach()
  endif()
  set(${result} ${kept} PARENT_SCOPE)
endfunction()

# nazori_test_paths(TARGET NAME PATH [NAME PATH]...): defines the paths of cmake/tests/test_paths.h that the program
# uses.
function(nazori_test_paths target)
  set(definitions "")
  list(LENGTH ARGN count)
  math(EXPR last "${count} - 1")
  foreach(i RANGE 0 ${last} 2)
    list(GET ARGN ${i} name)
    math(EXPR j "${i} + 1")
    list(GET ARGN ${j} path)
    string(APPEND definitions "const char* const ${name} = \"${path}\";\n")
  endforeach()
  set(file "${CMAKE_CURRENT_BINARY_DIR}/${target}_paths.cpp")
  file(GENERATE OUTPUT "${file}" CONTENT
       "#include \"test_paths.h\"\n\nnamespace nazori::test_paths {\n${definitions}}  // namespace nazori::test_paths\n")
  target_sources(${target} PRIVATE "${file}")
  target_include_directories(${target} PRIVATE "${CMAKE_SOURCE_DIR}/cmake/tests")
endfunction()

# nazori_rt_calls(NAME ROOTS): adds a test that determines from the objects of room NAME which functions ROOTS can
# reach; see cmake/tests/check_rt_calls.sh. ROOTS and the functions they call must be compiled with -ffunction-sections.
function(nazori_rt_calls name roots)
  if(NAZORI_BUILD_TESTS AND NOT NAZORI_SANITIZE)
    add_test(NAME ${name}.rt_calls
      COMMAND "${CMAKE_SOURCE_DIR}/cmake/tests/check_rt_calls.sh" ${CMAKE_OBJDUMP} "${roots}" $<TARGET_OBJECTS:nazori_${name}>
      COMMAND_EXPAND_LISTS)
  endif()
endfunction()

# nazori_module(NAME SOURCES ... [ALONE ...] DEPENDS ... [PRIVATE_DEPENDS ...] [TESTS ...] [TEST_DEPENDS ...] [TEST_PATHS NAME PATH
# ...] [THREADED_TESTS ALL|...] [TEST_HEADERS <...>] [TESTS_ALONE ...] [ISOLATED_TESTS REGEX] [SANITIZED_PARTS N]
# [NOT_SANITIZED FILTER] [NOT_THREADED FILTER] [BENCHES ...] [BENCH_DEPENDS ...] [FUZZERS ...] [NEEDS_DATABASE])
#
# One room: the library nazori::NAME from libs/NAME, its tests as one program nazori_NAME_tests, each bench file as part
# of nazori_NAME_bench and each fuzzer file as a program of its own. DEPENDS are visible to users of the public headers,
# PRIVATE_DEPENDS are not. Tests may use tests/fixtures through test_paths.h; with NEEDS_DATABASE they run after
# kanji.db has been built and find its folder in the environment variable NAZORI_DATA. ISOLATED_TESTS: a pattern for
# test files whose tests need a process each, because they share one set of signals. Of the other tests each suite has a
# process. With a sanitizer they share SANITIZED_PARTS processes (2 unless told otherwise; "2/8": see nazori_test_parts),
# without those that the filter NOT_SANITIZED names. The thread sanitizer builds only THREADED_TESTS: tests of code without threads cannot
# race. It runs all of them but those that NOT_SANITIZED or NOT_THREADED names. ALONE and TESTS_ALONE: see
# nazori_compile_together.
function(nazori_module name)
  cmake_parse_arguments(m "NEEDS_DATABASE" "ISOLATED_TESTS;SANITIZED_PARTS;NOT_SANITIZED;NOT_THREADED"
    "SOURCES;ALONE;DEPENDS;PRIVATE_DEPENDS;TESTS;TEST_DEPENDS;TEST_PATHS;THREADED_TESTS;TEST_HEADERS;TESTS_ALONE;BENCHES;BENCH_DEPENDS;FUZZERS" ${ARGN})
  if(m_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "nazori_module(${name}): unknown ${m_UNPARSED_ARGUMENTS}")
  endif()
  set(target nazori_${name})
  if(m_SOURCES)
    add_library(${target} STATIC ${m_SOURCES})
    target_include_directories(${target} PUBLIC include PRIVATE src)
    target_link_libraries(${target} PUBLIC ${m_DEPENDS} PRIVATE nazori_compiler ${m_PRIVATE_DEPENDS})
    # The fuzzers are guided by the coverage of the rooms that they test.
    if(NAZORI_BUILD_FUZZERS AND m_FUZZERS)
      target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    nazori_compile_together(${target} ALONE ${m_ALONE})
    list(LENGTH m_SOURCES files)
    if(files GREATER_EQUAL 10 AND NOT name MATCHES "^(studio|ui|widgets)$")
      nazori_precompiled_headers(${target} <algorithm> <cmath> <functional> <memory> <optional> <span> <string> <vector>)
    endif()
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE include)
    target_link_libraries(${target} INTERFACE ${m_DEPENDS})
  endif()
  add_library(nazori::${name} ALIAS ${target})

  if(NAZORI_SANITIZE STREQUAL "thread")
    # Built only if a test needs it.
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
    nazori_threaded_tests(m_TESTS TESTS ${m_TESTS} THREADED ${m_THREADED_TESTS} SOURCES ${m_SOURCES})
  endif()
  if(NAZORI_BUILD_TESTS AND m_TESTS)
    add_executable(${target}_tests ${m_TESTS})
    target_link_libraries(${target}_tests PRIVATE ${target} nazori_compiler ${m_TEST_DEPENDS} GTest::gtest GTest::gmock
                                                  GTest::gtest_main)
    nazori_test_paths(${target}_tests kFixtures "${CMAKE_CURRENT_SOURCE_DIR}/tests/fixtures" ${m_TEST_PATHS})
    nazori_test_program(${target}_tests)
    nazori_compile_together(${target}_tests ALONE ${m_TESTS_ALONE})
    # Precompiled headers take a hundred megabytes and more, so only programs of many files use them.
    list(LENGTH m_TESTS test_files)
    if(test_files GREATER_EQUAL 10)
      nazori_precompiled_headers(${target}_tests <gtest/gtest.h> <gmock/gmock.h> ${m_TEST_HEADERS})
    endif()
    # Programs of many files run longest, so they begin first: otherwise one of them runs alone at the end.
    set(properties COST ${test_files} TIMEOUT 300 ENVIRONMENT "NAZORI_DATA=${NAZORI_TEST_DATA}\;QT_QPA_PLATFORM=offscreen\;NAZORI_CHARACTERS=")
    if(m_NEEDS_DATABASE)
      list(APPEND properties FIXTURES_REQUIRED kanji_database)
    endif()
    set(left_out "")
    if(NAZORI_SANITIZE)
      set(left_out ${m_NOT_SANITIZED})
      if(NAZORI_SANITIZE STREQUAL "thread")
        list(APPEND left_out ${m_NOT_THREADED})
      endif()
      list(JOIN left_out ":" left_out)
    endif()
    nazori_isolated_suites(isolated shared "${m_ISOLATED_TESTS}" ${m_TESTS})
    if(shared)
      if(NAZORI_SANITIZE)
        set(read "")
        foreach(path ${m_TEST_PATHS})
          # Stand-ins of devices are loaded at run time from the build folder.
          if(path MATCHES "/standins$")
            list(APPEND read libs/devices)
          elseif(path MATCHES "^${CMAKE_SOURCE_DIR}/(.+)")
            list(APPEND read "${CMAKE_MATCH_1}")
          endif()
        endforeach()
        nazori_test_parts(${name} "${m_SANITIZED_PARTS}" "${isolated}:${left_out}" "${properties}" ${read})
      else()
        nazori_suite_tests(${name} "${isolated}" "${properties}")
      endif()
    endif()
    if(isolated)
      gtest_discover_tests(${target}_tests TEST_PREFIX "${name}." TEST_FILTER "${isolated}-${left_out}"
                           DISCOVERY_MODE PRE_TEST PROPERTIES ${properties})
    endif()
  endif()
  if(NAZORI_BUILD_BENCH AND m_BENCHES)
    add_executable(${target}_bench ${m_BENCHES})
    target_link_libraries(${target}_bench PRIVATE ${target} nazori_compiler ${m_BENCH_DEPENDS} benchmark::benchmark
                                                  benchmark::benchmark_main)
  endif()
  if(NAZORI_BUILD_FUZZERS)
    foreach(file ${m_FUZZERS})
      get_filename_component(fuzzer ${file} NAME_WE)
      add_executable(${fuzzer} ${file})
      target_link_libraries(${fuzzer} PRIVATE ${target} nazori_compiler)
      target_compile_options(${fuzzer} PRIVATE -fsanitize=fuzzer-no-link)
      target_link_options(${fuzzer} PRIVATE -fsanitize=fuzzer)
      set_property(GLOBAL APPEND PROPERTY NAZORI_FUZZERS ${fuzzer})
    endforeach()
  endif()
endfunction()
