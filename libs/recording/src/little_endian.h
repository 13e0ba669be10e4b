// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

namespace nazori::recording {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

/// Writes `value` at `offset` of `bytes`.
template <class T>
void store(std::span<std::uint8_t> bytes, std::size_t offset, T value) {
  std::memcpy(bytes.subspan(offset, sizeof(T)).data(), &value, sizeof(T));
}

/// The value at `offset` of `bytes`.
template <class T>
[[nodiscard]] T load(std::span<const std::uint8_t> bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.subspan(offset, sizeof(T)).data(), sizeof(T));
  return value;
}

}  // namespace nazori::recording
