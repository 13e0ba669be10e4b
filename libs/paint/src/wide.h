// SPDX-License-Identifier: Apache-2.0
#pragma once

// A function with loops over cells is also compiled for AVX2, and the program takes what the machine has. The
// basic instructions have no minimum of whole numbers and take half as many cells at a time. AVX2 has no
// fused multiplication, so the bits are the same.
//
// All that the function calls must become part of it, or it would stay as it was: flatten. Clang 14 does not
// take both. The choice is made before a sanitizer has started.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define NAZORI_WIDE __attribute__((target_clones("avx2", "default"), flatten, noinline))
#else
#define NAZORI_WIDE
#endif
