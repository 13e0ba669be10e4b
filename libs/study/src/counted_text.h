// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/study/exchange.h"

namespace nazori::study {

/// A text that is read once, byte by byte, and is never in memory as a whole. Counts its lines, and keeps the
/// text of one part for messages. If its source fails, the learner stops it, or a part becomes too long, the
/// text ends there and trouble() says why.
class CountedText {
 public:
  /// Maximum number of bytes between two calls of reset_limit().
  static constexpr std::size_t kLongestPart = std::size_t{16} << 20;

  /// @param source  must outlive this.
  CountedText(const TextSource& source, base::Progress progress);

  [[nodiscard]] bool at_end() { return at_ == size_ && !refill(); }
  /// The next byte. Must not be called at the end.
  [[nodiscard]] const char& front() const { return buffer_[at_]; }
  void pop() {
    last_ = buffer_[at_++];
    if (last_ == '\n') ++line_;
  }

  [[nodiscard]] int line() const { return line_; }   ///< of the next byte, from 1
  [[nodiscard]] char last() const { return last_; }  ///< the byte that was read last
  [[nodiscard]] const std::optional<base::Error>& trouble() const { return trouble_; }

  /// Keeps the text from the last read byte on.
  void begin_part();
  /// The text read since begin_part(). Valid until the next call of any function.
  [[nodiscard]] std::string_view part();
  void end_part() { keeps_part_ = false; }
  void reset_limit() { limit_ = taken_ + at_ + kLongestPart; }

 private:
  bool refill();

  const TextSource& source_;
  base::Progress progress_;
  std::vector<char> buffer_;
  std::size_t at_ = 0;
  std::size_t size_ = 0;
  std::uint64_t taken_ = 0;  ///< before the buffer
  std::uint64_t limit_ = kLongestPart;
  int line_ = 1;
  char last_ = 0;
  bool keeps_part_ = false;
  std::size_t part_from_ = 0;
  std::string part_;
  bool ended_ = false;
  std::optional<base::Error> trouble_;
};

/// Makes a counted text readable for a parser that takes iterators.
class CountedTextIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedTextIterator() = default;  ///< the end
  explicit CountedTextIterator(CountedText& text) : text_(&text) {}
  reference operator*() const { return text_->front(); }
  CountedTextIterator& operator++() {
    text_->pop();
    return *this;
  }
  CountedTextIterator operator++(int) {
    const CountedTextIterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const CountedTextIterator& a, const CountedTextIterator& b) {
    return a.is_end() == b.is_end();
  }

 private:
  [[nodiscard]] bool is_end() const { return text_ == nullptr || text_->at_end(); }
  CountedText* text_ = nullptr;
};

}  // namespace nazori::study
