# Compiler cache, linker, warnings and sanitizers. Modules get the last two from one interface target that all of them link.

# Paths below the source tree are cached relative to it, so that a build in another folder finds the same entries. Debug
# information names the folder of the first build then; -ffile-prefix-map keeps that out of it.
find_program(NAZORI_CCACHE ccache)
if(NAZORI_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_PCH_EXTSUM=true ${NAZORI_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# Half of the time of a first build is spent on reading the same headers, so they are read once per room.
option(NAZORI_PRECOMPILED_HEADERS "Read the most common headers once a room" ON)

# nazori_precompiled_headers(TARGET <HEADER>...)
#
# Objects made with them are found in the compiler cache from any folder. GCC's need nothing for that. Clang writes the
# folder into its precompiled headers, so the cache compares a file beside them instead (CCACHE_PCH_EXTSUM), which says
# what is in them: the headers, the compiler and the versions of the installed packages. Only Debian provides the
# versions.
function(nazori_precompiled_headers target)
  if(NOT NAZORI_PRECOMPILED_HEADERS)
    return()
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_precompile_headers(${target} PRIVATE ${ARGN})
    target_compile_options(${target} PRIVATE -fpch-preprocess)
    return()
  endif()
  find_program(NAZORI_DPKG_QUERY dpkg-query)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang" OR NOT NAZORI_DPKG_QUERY)
    return()
  endif()
  get_property(versions GLOBAL PROPERTY NAZORI_HEADER_VERSIONS)
  if(NOT versions)
    execute_process(COMMAND ${NAZORI_DPKG_QUERY} -W -f "\${Package} \${Version}\n" *-dev OUTPUT_VARIABLE versions)
    string(SHA256 versions "${versions}")
    set_property(GLOBAL PROPERTY NAZORI_HEADER_VERSIONS "${versions}")
  endif()
  list(TRANSFORM ARGN PREPEND "#include " OUTPUT_VARIABLE includes)
  list(JOIN includes "\n" text)
  file(CONFIGURE OUTPUT ${target}_headers.cpp CONTENT "${text}\n" @ONLY)
  # The "object" of this library is the precompiled header.
  add_library(${target}_headers OBJECT "${CMAKE_CURRENT_BINARY_DIR}/${target}_headers.cpp")
  set_target_properties(${target}_headers PROPERTIES AUTOMOC OFF CXX_COMPILER_LAUNCHER "" EXPORT_COMPILE_COMMANDS OFF)
  target_link_libraries(${target}_headers PRIVATE $<TARGET_PROPERTY:${target},LINK_LIBRARIES>)
  target_compile_definitions(${target}_headers PRIVATE $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>)
  target_compile_options(${target}_headers PRIVATE
    "$<FILTER:$<TARGET_PROPERTY:${target},COMPILE_OPTIONS>,EXCLUDE,include-pch>" -x c++-header "SHELL:-Xclang -emit-pch")
  file(RELATIVE_PATH header ${CMAKE_BINARY_DIR}
       "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}_headers.dir/${target}_headers.cpp.o")
  file(WRITE "${CMAKE_BINARY_DIR}/${header}.sum" "${CMAKE_CXX_COMPILER_VERSION} ${versions} ${text}")
  target_compile_options(${target} PRIVATE "SHELL:-include-pch ${header}")
  # Sources may be added to the target after this call, so its folder is read to the end first.
  cmake_language(EVAL CODE "cmake_language(DEFER CALL nazori_headers_first [[${target}]] [[${CMAKE_BINARY_DIR}/${header}]])")
endfunction()

# nazori_headers_first(TARGET HEADER): without this Ninja compiles the sources before the precompiled header that they
# read.
function(nazori_headers_first target header)
  get_target_property(sources ${target} SOURCES)
  list(APPEND sources "${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/mocs_compilation.cpp")
  set_property(SOURCE ${sources} APPEND PROPERTY OBJECT_DEPENDS "${header}")
endfunction()

# nazori_compile_together(TARGET [ALONE <FILE>...])
#
# Compiles the sources of a target in groups: if all of them use the same large templates, that is several times as
# fast. ALONE: files with names of their own that others have too. CMake's own groups name each file with the folder of
# the source tree, so that the compiler cache finds none of them from another folder.
option(NAZORI_COMPILE_TOGETHER "Compile the sources of large targets in groups" ON)
function(nazori_compile_together target)
  cmake_parse_arguments(u "" "" "ALONE" ${ARGN})
  if(NOT NAZORI_COMPILE_TOGETHER)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^[^/].*\\.cpp$")
  if(u_ALONE)
    list(REMOVE_ITEM sources ${u_ALONE})
  endif()
  # Qt's moc looks for the header of each source.
  foreach(source IN LISTS sources)
    string(REGEX REPLACE "cpp$" "h" header "${source}")
    if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${header}")
      target_sources(${target} PRIVATE "${header}")
    endif()
  endforeach()
  get_target_property(others ${target} SOURCES)
  list(REMOVE_ITEM others ${sources})
  set_property(TARGET ${target} PROPERTY SOURCES ${others})
  list(LENGTH sources left)
  set(number 0)
  while(left GREATER 0)
    list(SUBLIST sources 0 8 together)
    list(REMOVE_ITEM sources ${together})
    list(LENGTH sources left)
    set(text "")
    foreach(source IN LISTS together)
      file(RELATIVE_PATH path "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}/${source}")
      string(APPEND text "#include \"${path}\"\n")
    endforeach()
    set(group "${CMAKE_CURRENT_BINARY_DIR}/Unity/${target}_${number}.cpp")
    file(CONFIGURE OUTPUT "${group}" CONTENT "${text}" @ONLY)
    set_source_files_properties("${group}" PROPERTIES INCLUDE_DIRECTORIES "${CMAKE_SOURCE_DIR}")
    target_sources(${target} PRIVATE "${group}")
    math(EXPR number "${number} + 1")
  endwhile()
endfunction()

# A quarter of the time of the usual linker: the sanitized test programs have hundreds of megabytes.
find_program(NAZORI_MOLD mold)
if(NAZORI_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

add_library(nazori_compiler INTERFACE)
target_compile_options(nazori_compiler INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                 -Wnon-virtual-dtor -Woverloaded-virtual)
if(NAZORI_WARNINGS_AS_ERRORS)
  target_compile_options(nazori_compiler INTERFACE -Werror)
endif()
if(NAZORI_SANITIZE)
  string(REPLACE ";" "," sanitizers "${NAZORI_SANITIZE}")
  target_compile_options(nazori_compiler INTERFACE -fsanitize=${sanitizers} -fno-omit-frame-pointer
                                                   -fno-sanitize-recover=all)
  target_link_options(nazori_compiler INTERFACE -fsanitize=${sanitizers})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # The makers' libraries are called through types of this program, which only match in binary form. The option for
    # the list uses the older spelling, which ccache knows, and a path relative to the build folder, so that the cache
    # also works from another folder.
    file(RELATIVE_PATH ignorelist ${CMAKE_BINARY_DIR} "${CMAKE_SOURCE_DIR}/cmake/sanitizer-ignorelist.txt")
    target_compile_options(nazori_compiler INTERFACE -fno-sanitize=function -fsanitize-blacklist=${ignorelist})
    # Errors inside the standard library that the undefined behaviour sanitizer would find are found by the library's
    # own checks.
    target_compile_definitions(nazori_compiler INTERFACE _GLIBCXX_ASSERTIONS)
  endif()
endif()
