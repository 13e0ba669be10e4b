// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "nazori/recording/byte_source.h"

namespace nazori::recording::test {

/// Bytes that come a few at a time, as from a pipe, and may end with an error.
class PieceSource final : public ByteSource {
 public:
  PieceSource(std::string bytes, std::size_t piece, std::uint64_t size = 0, bool fails = false)
      : bytes_(std::move(bytes)), piece_(piece), size_(size), fails_(fails) {}
  base::Result<std::size_t> read(std::span<char> out) override {
    const std::size_t n = std::min({out.size(), piece_, bytes_.size() - at_});
    if (n == 0 && fails_) return base::fail(base::Errc::io, "the plug was pulled", name_);
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), n, out.begin());
    at_ += n;
    return n;
  }
  [[nodiscard]] std::uint64_t size() const override { return size_; }
  [[nodiscard]] const std::string& name() const override { return name_; }

 private:
  std::string bytes_;
  std::size_t piece_, at_ = 0;
  std::uint64_t size_;
  bool fails_;
  std::string name_ = "pieces";
};

}  // namespace nazori::recording::test
