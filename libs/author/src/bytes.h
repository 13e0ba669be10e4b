// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::author {

/// Writes numbers, little-endian, and texts one after another.
class ByteWriter {
 public:
  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void u32(std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) u8(static_cast<std::uint8_t>(value >> shift));
  }
  void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
  void f64(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    u32(static_cast<std::uint32_t>(bits));
    u32(static_cast<std::uint32_t>(bits >> 32U));
  }
  void count(std::size_t value) { u32(static_cast<std::uint32_t>(value)); }
  void raw(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  void text(std::string_view text) {
    count(text.size());
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }
  [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reads them back. Behind the end every number is 0 and ok() is false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }
  std::uint8_t u8() {
    const auto piece = take(1);
    return piece.empty() ? std::uint8_t{0} : piece[0];
  }
  std::uint32_t u32() {
    std::uint32_t value = 0;
    const auto piece = take(4);
    for (std::size_t i = 0; i < piece.size(); ++i) value |= std::uint32_t{piece[i]} << (8 * i);
    return value;
  }
  float f32() { return std::bit_cast<float>(u32()); }
  double f64() {
    const std::uint64_t low = u32();
    return std::bit_cast<double>(low | std::uint64_t{u32()} << 32U);
  }
  /// A number of things that take at least `each` bytes, so that no more room is made than there are bytes.
  std::size_t count(std::size_t each) {
    const std::size_t value = u32();
    if (value <= bytes_.size() / each) return value;
    ok_ = false;
    return 0;
  }
  std::span<const std::uint8_t> take(std::size_t size) {
    ok_ = ok_ && size <= bytes_.size();
    if (!ok_) {
      bytes_ = {};
      return {};
    }
    const auto piece = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return piece;
  }
  std::string text() {
    const auto piece = take(count(1));
    return {piece.begin(), piece.end()};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool ok_ = true;
};

}  // namespace nazori::author
