// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::base {

/// Writes numbers, little-endian, and texts one after another. Thread rules: one thread at a time.
class ByteWriter {
 public:
  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void u16(std::uint16_t value) { least(value, 2); }
  void u32(std::uint32_t value) { least(value, 4); }
  void i32(std::int32_t value) { u32(static_cast<std::uint32_t>(value)); }
  void i64(std::int64_t value) { least(static_cast<std::uint64_t>(value), 8); }
  void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
  void f64(double value) { least(std::bit_cast<std::uint64_t>(value), 8); }
  /// A number of things, as ByteReader::count() reads it: 32 bits.
  void count(std::size_t value) { u32(static_cast<std::uint32_t>(value)); }
  void raw(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  /// The number of bytes, as count(), and the bytes.
  void text(std::string_view text) {
    count(text.size());
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }
  /// What was written so far.
  [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  /// The `size` least bytes.
  void least(std::uint64_t bits, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) u8(static_cast<std::uint8_t>(bits >> (8 * i)));
  }

  std::vector<std::uint8_t> bytes_;
};

/// Reads what ByteWriter wrote. From the first number on that is not there everything is 0 and ok() is false.
class ByteReader {
 public:
  /// @param bytes  must outlive the reader.
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  /// Whether everything that was asked for was there.
  [[nodiscard]] bool ok() const { return ok_; }
  /// The bytes that were not read yet.
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }
  std::uint8_t u8() { return static_cast<std::uint8_t>(least(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(least(2)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(least(4)); }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
  std::int64_t i64() { return static_cast<std::int64_t>(least(8)); }
  float f32() { return std::bit_cast<float>(u32()); }
  double f64() { return std::bit_cast<double>(least(8)); }
  /// A number of things that take at least `each` bytes, so that no more room is made than there are bytes.
  std::size_t count(std::size_t each) {
    const std::size_t value = u32();
    if (value <= bytes_.size() / each) return value;
    ok_ = false;
    return 0;
  }
  /// The next `size` bytes; none where there are fewer.
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
  std::uint64_t least(std::size_t size) {
    std::uint64_t bits = 0;
    const auto piece = take(size);
    for (std::size_t i = 0; i < piece.size(); ++i) bits |= std::uint64_t{piece[i]} << (8 * i);
    return bits;
  }

  std::span<const std::uint8_t> bytes_;
  bool ok_ = true;
};

}  // namespace nazori::base
