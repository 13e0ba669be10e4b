# Sanitized tests are not optimised themselves, only what they test: that halves the time they take to compile.
function(nazori_test_program target)
  if(NAZORI_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# nazori_module(NAME SOURCES ... DEPENDS ... [PRIVATE_DEPENDS ...] [TESTS ...] [TEST_DEPENDS ...] [BENCHES ...]
#               [BENCH_DEPENDS ...] [FUZZERS ...] [NEEDS_DATABASE])
#
# One room of the house: the library nazori::NAME from libs/NAME, its tests as one program nazori_NAME_tests, each bench
# file as part of nazori_NAME_bench and each fuzzer file as a program of its own. DEPENDS are seen by those who include the
# public headers, PRIVATE_DEPENDS are not. Tests may use tests/fixtures through the macro NAZORI_FIXTURES; with NEEDS_DATABASE
# they run after kanji.db has been built and find its folder in the environment variable NAZORI_DATA.
function(nazori_module name)
  cmake_parse_arguments(m "NEEDS_DATABASE" ""
    "SOURCES;DEPENDS;PRIVATE_DEPENDS;TESTS;TEST_DEPENDS;BENCHES;BENCH_DEPENDS;FUZZERS" ${ARGN})
  if(m_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "nazori_module(${name}): unknown ${m_UNPARSED_ARGUMENTS}")
  endif()
  set(target nazori_${name})
  if(m_SOURCES)
    add_library(${target} STATIC ${m_SOURCES})
    target_include_directories(${target} PUBLIC include PRIVATE src)
    target_link_libraries(${target} PUBLIC ${m_DEPENDS} PRIVATE nazori_compiler ${m_PRIVATE_DEPENDS})
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE include)
    target_link_libraries(${target} INTERFACE ${m_DEPENDS})
  endif()
  add_library(nazori::${name} ALIAS ${target})

  if(NAZORI_BUILD_TESTS AND m_TESTS)
    add_executable(${target}_tests ${m_TESTS})
    target_link_libraries(${target}_tests PRIVATE ${target} nazori_compiler ${m_TEST_DEPENDS} GTest::gtest GTest::gmock
                                                  GTest::gtest_main)
    target_compile_definitions(${target}_tests PRIVATE NAZORI_FIXTURES="${CMAKE_CURRENT_SOURCE_DIR}/tests/fixtures")
    nazori_test_program(${target}_tests)
    set(properties TIMEOUT 300 ENVIRONMENT "NAZORI_DATA=${NAZORI_TEST_DATA}\;QT_QPA_PLATFORM=offscreen")
    if(m_NEEDS_DATABASE)
      list(APPEND properties FIXTURES_REQUIRED kanji_database)
    endif()
    gtest_discover_tests(${target}_tests TEST_PREFIX "${name}." DISCOVERY_MODE PRE_TEST PROPERTIES ${properties})
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
      target_link_options(${fuzzer} PRIVATE -fsanitize=fuzzer)
      set_property(GLOBAL APPEND PROPERTY NAZORI_FUZZERS ${fuzzer})
    endforeach()
  endif()
endfunction()
