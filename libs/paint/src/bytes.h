// SPDX-License-Identifier: Apache-2.0
// Numbers as little-endian bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace nazori::paint {

template <class Number>
void append(std::vector<std::uint8_t>& bytes, Number number) {
  if constexpr (std::is_same_v<Number, double>) {
    append(bytes, std::bit_cast<std::uint64_t>(number));
  } else if constexpr (std::is_same_v<Number, float>) {
    append(bytes, std::bit_cast<std::uint32_t>(number));
  } else {
    const auto bits = static_cast<std::make_unsigned_t<Number>>(number);
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(bits) >> (8 * i)));
  }
}

/// Reads numbers one after another. After the first one that is not there everything is zero.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  template <class Number>
  [[nodiscard]] Number next() {
    if constexpr (std::is_same_v<Number, double>) {
      return std::bit_cast<double>(next<std::uint64_t>());
    } else if constexpr (std::is_same_v<Number, float>) {
      return std::bit_cast<float>(next<std::uint32_t>());
    } else {
      const auto part = take(sizeof(Number));
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < part.size(); ++i) bits |= static_cast<std::uint64_t>(part[i]) << (8 * i);
      return static_cast<Number>(bits);
    }
  }
  /// The next `count` bytes; none where there are fewer.
  [[nodiscard]] std::span<const std::uint8_t> take(std::size_t count) {
    if (count > left_.size()) {
      is_whole_ = false;
      left_ = {};
      return {};
    }
    const auto part = left_.first(count);
    left_ = left_.subspan(count);
    return part;
  }
  /// Whether everything that was asked for was there.
  [[nodiscard]] bool is_whole() const { return is_whole_; }
  [[nodiscard]] std::size_t left() const { return left_.size(); }

 private:
  std::span<const std::uint8_t> left_;
  bool is_whole_ = true;
};

}  // namespace nazori::paint
