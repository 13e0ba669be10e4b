# Warnings and sanitizers, as one interface target that every module links.
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
endif()
