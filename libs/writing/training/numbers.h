// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nazori::writing::training {

using Numbers = std::vector<float>;

/// c += a b, with a of m x k, b of k x n, row by row.
inline void multiply(std::size_t m, std::size_t k, std::size_t n, const float* __restrict a,
                     const float* __restrict b, float* __restrict c) {
  constexpr std::size_t kRows = 4;
  constexpr std::size_t kColumns = 64;
  for (std::size_t j = 0; j < n; j += kColumns) {
    const std::size_t columns = std::min(kColumns, n - j);
    for (std::size_t i = 0; i < m; i += kRows) {
      const std::size_t rows = std::min(kRows, m - i);
      float sum[kRows][kColumns] = {};
      if (rows == kRows && columns == kColumns) {
        for (std::size_t p = 0; p < k; ++p) {
          const float* row = b + p * n + j;
          for (std::size_t r = 0; r < kRows; ++r) {
            const float x = a[(i + r) * k + p];
            for (std::size_t q = 0; q < kColumns; ++q) sum[r][q] += x * row[q];
          }
        }
      } else {
        for (std::size_t p = 0; p < k; ++p)
          for (std::size_t r = 0; r < rows; ++r)
            for (std::size_t q = 0; q < columns; ++q) sum[r][q] += a[(i + r) * k + p] * b[p * n + j + q];
      }
      for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t q = 0; q < columns; ++q) c[(i + r) * n + j + q] += sum[r][q];
    }
  }
}

/// The m x n numbers of a as n x m.
inline Numbers transposed(std::size_t m, std::size_t n, const float* a) {
  Numbers t(m * n);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) t[j * m + i] = a[i * n + j];
  return t;
}

}  // namespace nazori::writing::training
