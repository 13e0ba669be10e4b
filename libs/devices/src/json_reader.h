// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <system_error>

namespace nazori::devices {

/// Reads a JSON text (RFC 8259) from front to back, once, without memory of its own: no call allocates,
/// throws or recurses deeper than kDeepest. The first fault stops it: good() is false from then on and every
/// call does nothing. Strings are returned as written, with their escapes.
class JsonReader {
 public:
  static constexpr int kDeepest = 32;
  enum class Kind : std::uint8_t { object, array, string, number, truth, null, none };

  explicit JsonReader(std::string_view text) noexcept : at_(text.data()), end_(text.data() + text.size()) {}

  [[nodiscard]] bool good() const noexcept { return good_; }
  /// After the outermost value: whether the text was valid and nothing follows.
  [[nodiscard]] bool at_end() noexcept {
    skip_space();
    return good_ && at_ == end_;
  }

  /// The kind of the next value, according to its first character.
  [[nodiscard]] Kind next() noexcept {
    skip_space();
    if (!good_ || at_ == end_) return Kind::none;
    switch (*at_) {
      case '{':
        return Kind::object;
      case '[':
        return Kind::array;
      case '"':
        return Kind::string;
      case 't':
      case 'f':
        return Kind::truth;
      case 'n':
        return Kind::null;
      default:
        return *at_ == '-' || is_digit(*at_) ? Kind::number : Kind::none;
    }
  }

  /// Calls `member(name)` for each member of an object; it must read or skip exactly one value.
  template <class F>
  void object(F member) noexcept {
    list('{', '}', [&] {
      const std::string_view name = string();
      skip_space();
      if (take(':')) member(name);
    });
  }
  /// Calls `item()` for each value of an array; it must read or skip exactly one value.
  template <class F>
  void array(F item) noexcept {
    list('[', ']', item);
  }
  std::string_view string() noexcept;
  /// A number too large for a double is a fault.
  double number() noexcept;
  /// The digits of a number as they are written.
  std::string_view number_text() noexcept;
  bool truth() noexcept;
  /// Skips a value of any kind.
  void skip() noexcept;

 private:
  static bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
  static bool is_hex(char c) noexcept {
    return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
  }
  void fail() noexcept { good_ = false; }
  void skip_space() noexcept {
    while (good_ && at_ != end_ && (*at_ == ' ' || *at_ == '\t' || *at_ == '\n' || *at_ == '\r')) ++at_;
  }
  bool take(char wanted) noexcept {
    if (!good_ || at_ == end_ || *at_ != wanted) {
      fail();
      return false;
    }
    ++at_;
    return true;
  }
  bool digits() noexcept {
    if (at_ == end_ || !is_digit(*at_)) {
      fail();
      return false;
    }
    while (at_ != end_ && is_digit(*at_)) ++at_;
    return true;
  }
  void word(std::string_view wanted) noexcept {
    for (const char c : wanted) {
      if (!take(c)) return;
    }
  }
  template <class F>
  void list(char open, char close, F entry) noexcept {
    skip_space();
    if (!take(open)) return;
    if (++depth_ > kDeepest) return fail();
    skip_space();
    if (good_ && at_ != end_ && *at_ == close) {
      ++at_;
    } else {
      while (good_) {
        skip_space();
        entry();
        skip_space();
        if (!good_ || at_ == end_) return fail();
        if (*at_ == close) {
          ++at_;
          break;
        }
        (void)take(',');
      }
    }
    --depth_;
  }

  const char* at_;
  const char* end_;
  int depth_ = 0;
  bool good_ = true;
};

inline std::string_view JsonReader::string() noexcept {
  skip_space();
  if (!take('"')) return {};
  const char* const begin = at_;
  while (at_ != end_ && *at_ != '"') {
    if (static_cast<unsigned char>(*at_) < 0x20) break;
    if (*at_++ != '\\') continue;
    if (at_ == end_ || std::string_view("\"\\/bfnrtu").find(*at_) == std::string_view::npos) break;
    if (*at_++ != 'u') continue;
    for (int i = 0; i < 4; ++i, ++at_) {
      if (at_ == end_ || !is_hex(*at_)) {
        fail();
        return {};
      }
    }
  }
  const std::string_view text(begin, static_cast<std::size_t>(at_ - begin));
  return take('"') ? text : std::string_view{};
}

inline std::string_view JsonReader::number_text() noexcept {
  skip_space();
  if (!good_) return {};
  const char* const begin = at_;
  if (at_ != end_ && *at_ == '-') ++at_;
  if (at_ != end_ && *at_ == '0')
    ++at_;
  else if (!digits())
    return {};
  if (at_ != end_ && *at_ == '.') {
    ++at_;
    if (!digits()) return {};
  }
  if (at_ != end_ && (*at_ == 'e' || *at_ == 'E')) {
    ++at_;
    if (at_ != end_ && (*at_ == '+' || *at_ == '-')) ++at_;
    if (!digits()) return {};
  }
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

inline double JsonReader::number() noexcept {
  const std::string_view text = number_text();
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed == std::errc()) return value;
  // A number too small for a double counts as 0. from_chars reports it in the same way as one too large.
  constexpr std::size_t kUsual = 40;
  const bool is_tiny = text.size() <= kUsual && (text.find("e-") != std::string_view::npos ||
                                                 text.find("E-") != std::string_view::npos);
  if (!is_tiny) fail();
  return 0;
}

inline bool JsonReader::truth() noexcept {
  skip_space();
  const bool value = good_ && at_ != end_ && *at_ == 't';
  word(value ? "true" : "false");
  return value;
}

inline void JsonReader::skip() noexcept {
  switch (next()) {
    case Kind::object:
      return object([this](std::string_view) { skip(); });
    case Kind::array:
      return array([this] { skip(); });
    case Kind::string:
      return (void)string();
    case Kind::number:
      return (void)number();
    case Kind::truth:
      return (void)truth();
    case Kind::null:
      skip_space();
      return word("null");
    case Kind::none:
      return fail();
  }
}

}  // namespace nazori::devices
