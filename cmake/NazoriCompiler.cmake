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

# nazori_names(FILE OVERLOADS HIDDEN VISIBLE): the names that a source declares in namespaces without a name, and in others.
# It reads lines as clang-format writes them, so declarations begin in the first column. OVERLOADS: functions are told
# apart by their parameters, too.
function(nazori_names file overloads hidden visible)
  file(READ "${file}" text)
  # What CMake would take for the parts of a list.
  string(REGEX REPLACE "[][;]" "$" text "\n${text}")
  set(inside "")
  string(FIND "${text}" "\nnamespace {\n" begin)
  while(begin GREATER_EQUAL 0)
    string(SUBSTRING "${text}" 0 ${begin} before)
    string(SUBSTRING "${text}" ${begin} -1 rest)
    string(FIND "${rest}" "\n}  // namespace\n" end)
    string(SUBSTRING "${rest}" 0 ${end} part)
    string(APPEND inside "${part}\n")
    string(SUBSTRING "${rest}" ${end} -1 rest)
    # The line that ends the part begins the next text, so that no part is found twice.
    set(text "${before}\n${rest}")
    string(FIND "${text}" "\nnamespace {\n" begin)
  endwhile()
  foreach(part hidden visible)
    if(part STREQUAL "hidden")
      set(lines "${inside}")
    else()
      set(lines "${text}")
    endif()
    string(REGEX MATCHALL "\n(struct|class|enum class|enum|union) [A-Za-z0-9_]+" types "${lines}")
    string(REGEX MATCHALL "\nusing [A-Za-z0-9_]+ = " aliases "${lines}")
    string(REGEX MATCHALL "\n[A-Za-z_][A-Za-z0-9_:<>,&* ]* [*&]*[A-Za-z_][A-Za-z0-9_]*( =[ \n]|[($]|{)" values "${lines}")
    string(REGEX MATCHALL "\n[a-z_][A-Za-z0-9_]*[(]" functions "${lines}")
    string(REGEX MATCHALL "[,] k[A-Z][A-Za-z0-9]* = " constants "${lines}")
    set(names "")
    if(overloads)
      string(REGEX MATCHALL "\n[A-Za-z_][A-Za-z0-9_:<>,&* ]* [*&]*[A-Za-z_][A-Za-z0-9_]*[(][^\n]*" signatures "${lines}")
      foreach(found IN LISTS signatures)
        string(REGEX REPLACE ".* [*&]*([A-Za-z0-9_]+[(])" "\\1" found "${found}")
        string(MAKE_C_IDENTIFIER "${found}" name)
        list(APPEND names "${name}")
      endforeach()
      list(FILTER values EXCLUDE REGEX "[(]$")
    endif()
    foreach(found IN LISTS types aliases values functions constants)
      string(REGEX REPLACE "( =[ \n]|[($]|{)$" "" found "${found}")
      string(REGEX MATCH "[A-Za-z0-9_]+$" name "${found}")
      list(APPEND names "${name}")
    endforeach()
    list(REMOVE_DUPLICATES names)
    set(${${part}} "${names}" PARENT_SCOPE)
  endforeach()
endfunction()

# nazori_names_of_headers(FILE NAMES): the names that the headers of the same room declare which a file includes,
# directly or through others.
function(nazori_names_of_headers file names)
  get_filename_component(folder "${file}" DIRECTORY)
  file(STRINGS "${file}" includes REGEX "^#include \"")
  set(all "")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" header "${line}")
    foreach(place "${folder}" "${CMAKE_CURRENT_SOURCE_DIR}/src" "${CMAKE_CURRENT_SOURCE_DIR}/tests" "${CMAKE_CURRENT_SOURCE_DIR}/include")
      if(NOT EXISTS "${place}/${header}")
        continue()
      endif()
      string(MAKE_C_IDENTIFIER "${place}/${header}" key)
      get_property(is_known GLOBAL PROPERTY nazori_names_${key} SET)
      if(NOT is_known)
        nazori_names("${place}/${header}" FALSE hidden visible)
        # Before its own headers are read, so that a circle ends.
        set_property(GLOBAL PROPERTY nazori_names_${key} "${visible}")
        nazori_names_of_headers("${place}/${header}" further)
        set_property(GLOBAL PROPERTY nazori_names_${key} "${visible};${further}")
      endif()
      get_property(visible GLOBAL PROPERTY nazori_names_${key})
      list(APPEND all ${visible})
      break()
    endforeach()
  endforeach()
  set(${names} "${all}" PARENT_SCOPE)
endfunction()

# nazori_compile_together(TARGET [OVERLOADS] [ALONE <FILE>...])
#
# Compiles the sources of a target in groups of eight: they use the same large templates, so that is several times as
# fast. Where one file hides a name that another one or its headers declare, they come into different groups;
# with OVERLOADS, functions only where they have the same parameters. A file with options of its own is compiled alone. ALONE: files that cannot be compiled with others for
# another reason. CMake's own groups name each file with
# the folder of the source tree, so that the compiler cache finds none of them from another folder.
option(NAZORI_COMPILE_TOGETHER "Compile the sources of a target in groups" ON)
function(nazori_compile_together target)
  cmake_parse_arguments(u "OVERLOADS" "" "ALONE" ${ARGN})
  # Options of single files may be set after this call, so the folder is read to the end first.
  cmake_language(EVAL CODE "cmake_language(DEFER CALL nazori_make_groups [[${target}]] [[${u_OVERLOADS}]] [[${u_ALONE}]])")
endfunction()

function(nazori_make_groups target overloads alone)
  if(NOT NAZORI_COMPILE_TOGETHER)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^[^/].*\\.cpp$")
  if(alone)
    list(REMOVE_ITEM sources ${alone})
  endif()
  set(groups 0)
  set(grouped "")
  foreach(source IN LISTS sources)
    get_source_file_property(options "${source}" COMPILE_OPTIONS)
    get_source_file_property(definitions "${source}" COMPILE_DEFINITIONS)
    # A program has one operator new, and the compiler assumes the usual one where it has not seen another.
    file(STRINGS "${source}" allocates REGEX "^[^ /].* operator new[(]" LIMIT_COUNT 1)
    if(options OR definitions OR allocates)
      continue()
    endif()
    nazori_names("${CMAKE_CURRENT_SOURCE_DIR}/${source}" "${overloads}" hidden visible)
    nazori_names_of_headers("${CMAKE_CURRENT_SOURCE_DIR}/${source}" included)
    list(APPEND visible ${included})
    set(chosen ${groups})
    set(group 0)
    while(group LESS groups)
      list(LENGTH files_${group} many)
      set(clashes FALSE)
      foreach(name IN LISTS hidden)
        if(DEFINED hidden_${group}_${name} OR DEFINED visible_${group}_${name})
          set(clashes TRUE)
          break()
        endif()
      endforeach()
      foreach(name IN LISTS visible)
        if(DEFINED hidden_${group}_${name})
          set(clashes TRUE)
          break()
        endif()
      endforeach()
      if(many LESS 8 AND NOT clashes)
        set(chosen ${group})
        break()
      endif()
      math(EXPR group "${group} + 1")
    endwhile()
    if(chosen EQUAL groups)
      math(EXPR groups "${groups} + 1")
    endif()
    list(APPEND files_${chosen} "${source}")
    list(APPEND grouped "${source}")
    foreach(name IN LISTS hidden)
      set(hidden_${chosen}_${name} 1)
    endforeach()
    foreach(name IN LISTS visible)
      set(visible_${chosen}_${name} 1)
    endforeach()
    # Qt's moc looks for the header of each source.
    string(REGEX REPLACE "cpp$" "h" header "${source}")
    if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${header}")
      target_sources(${target} PRIVATE "${header}")
    endif()
  endforeach()
  if(NOT grouped)
    return()
  endif()
  get_target_property(others ${target} SOURCES)
  list(REMOVE_ITEM others ${grouped})
  set_property(TARGET ${target} PROPERTY SOURCES ${others})
  math(EXPR last "${groups} - 1")
  foreach(group RANGE 0 ${last})
    set(text "")
    foreach(source IN LISTS files_${group})
      file(RELATIVE_PATH path "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}/${source}")
      string(APPEND text "#include \"${path}\"\n")
    endforeach()
    set(unit "${CMAKE_CURRENT_BINARY_DIR}/Unity/${target}_${group}.cpp")
    file(CONFIGURE OUTPUT "${unit}" CONTENT "${text}" @ONLY)
    # Hidden names of one file are no business of the others, so a local name may be the same. The preset dev warns of it
    # within a file.
    set_source_files_properties("${unit}" PROPERTIES INCLUDE_DIRECTORIES "${CMAKE_SOURCE_DIR}" COMPILE_OPTIONS
      "$<$<CXX_COMPILER_ID:GNU>:-Wno-shadow;-Wshadow=local;-Wno-subobject-linkage>;$<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>")
    target_sources(${target} PRIVATE "${unit}")
  endforeach()
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
