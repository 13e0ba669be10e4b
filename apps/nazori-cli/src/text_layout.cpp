// SPDX-License-Identifier: Apache-2.0
#include "text_layout.h"

#include <fmt/format.h>
#include <locale.h>
#include <wchar.h>

#include <algorithm>
#include <cstddef>

#include "nazori/base/utf8.h"

namespace nazori::cli {
namespace {

/// The C library's table of widths, whatever the user's locale is, for the calling thread.
class WidthTable {
 public:
  WidthTable() : table_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (table_ != nullptr) before_ = ::uselocale(table_);
  }
  ~WidthTable() {
    if (table_ == nullptr) return;
    (void)::uselocale(before_);
    ::freelocale(table_);
  }
  WidthTable(const WidthTable&) = delete;
  WidthTable& operator=(const WidthTable&) = delete;

  [[nodiscard]] int width(char32_t c) const {
    if (table_ == nullptr) return c >= 0x1100 ? 2 : 1;
    return std::max(::wcwidth(static_cast<wchar_t>(c)), 0);
  }

 private:
  locale_t table_;
  locale_t before_ = nullptr;
};

/// Length of the valid UTF-8 sequence that `text` starts with, 0 where there is none.
std::size_t sequence_length(std::string_view text) {
  for (std::size_t n = 1; n <= std::min<std::size_t>(4, text.size()); ++n) {
    if (base::decode_utf8(text.substr(0, n))) return n;
  }
  return 0;
}

}  // namespace

int display_width(std::string_view text) {
  const auto code_points = base::decode_utf8(text);
  if (!code_points) return static_cast<int>(text.size());
  static const WidthTable table;
  int width = 0;
  for (const char32_t c : *code_points) width += table.width(c);
  return width;
}

std::string pad(std::string_view text, int width) {
  std::string padded(text);
  const int missing = width - display_width(text);
  if (missing > 0) padded.append(static_cast<std::size_t>(missing), ' ');
  return padded;
}

std::string cut(std::string_view text, int width) {
  std::string out;
  int used = 0;
  while (!text.empty()) {
    const std::size_t n = std::max<std::size_t>(1, sequence_length(text));
    used += display_width(text.substr(0, n));
    if (used > width) break;
    out += text.substr(0, n);
    text.remove_prefix(n);
  }
  return out;
}

std::string shortened(std::string_view text, int width) {
  // Every column needs at least a byte, so a short text need not be measured.
  if (text.size() <= static_cast<std::size_t>(std::max(width, 0)) || display_width(text) <= width)
    return std::string(text);
  const int at_end = width / 3;
  std::size_t end = text.size();
  for (int used = 0; end > 0;) {
    std::size_t begin = end - 1;
    while (begin > 0 && (static_cast<unsigned char>(text[begin]) & 0xC0U) == 0x80U) --begin;
    used += display_width(text.substr(begin, end - begin));
    if (used > at_end) break;
    end = begin;
  }
  return cut(text, width - at_end - 1) + "…" + std::string(text.substr(end));
}

std::string flow(std::span<const std::string> items, std::string_view separator, int indent, int width) {
  std::string out;
  int column = indent;
  const int gap = display_width(separator);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const int item = display_width(items[i]);
    if (i > 0) {
      out += separator;
      column += gap;
      if (column + item > width) {
        while (!out.empty() && out.back() == ' ') out.pop_back();
        out += '\n';
        out.append(static_cast<std::size_t>(indent), ' ');
        column = indent;
      }
    }
    out += items[i];
    column += item;
  }
  return out;
}

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t n = sequence_length(text);
    const auto first = static_cast<unsigned char>(text.front());
    if (n == 0 || first < 0x20 || first == 0x7F) {
      out += fmt::format("\\x{:02X}", first);
      text.remove_prefix(1);
    } else {
      out += text.substr(0, n);
      text.remove_prefix(n);
    }
  }
  return out;
}

std::string with_middle_dot(std::string_view reading) {
  std::string out(reading);
  const std::size_t dot = out.find('.');
  if (dot != std::string::npos) out.replace(dot, 1, "・");
  return out;
}

}  // namespace nazori::cli
