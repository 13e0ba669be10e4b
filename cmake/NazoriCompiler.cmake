# Compiler cache, linker, warnings and sanitizers. Modules get the last two from one interface target that all of them link.

# Paths below the source tree are cached relative to it, so that a build in another folder finds the same entries. Debug
# information names the folder of the first build then; -ffile-prefix-map keeps that out of it.
find_program(NAZORI_CCACHE ccache)
if(NAZORI_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros ${NAZORI_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# Half of the time of a first build goes into reading the same headers. Only GCC's precompiled headers can be cached for
# another folder; the build with clang, which has none, finds includes that are missing.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  option(NAZORI_PRECOMPILED_HEADERS "Read the most common headers once a room" ON)
endif()

# nazori_precompiled_headers(TARGET <HEADER>...)
function(nazori_precompiled_headers target)
  if(NAZORI_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
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
  # The makers' libraries are called through types of our own, which are the same only to the machine.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(nazori_compiler INTERFACE -fno-sanitize=function)
  endif()
endif()
