// SPDX-License-Identifier: Apache-2.0
#include "sfnt.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdlib>
#include <utility>

namespace nazori::author {
namespace {

/// Bits of the flags of a point.
constexpr unsigned kOnCurve = 0x01;
constexpr unsigned kShortX = 0x02;
constexpr unsigned kShortY = 0x04;
constexpr unsigned kRepeated = 0x08;
constexpr unsigned kSameOrPositiveX = 0x10;
constexpr unsigned kSameOrPositiveY = 0x20;
constexpr unsigned kOverlapSimple = 0x40;

std::uint32_t table_checksum(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    sum += static_cast<std::uint32_t>(bytes[i]) << (24U - 8U * (i % 4));
  return sum;
}

/// Writes the step from one coordinate to the next. @return its bits of the flag.
unsigned put_step(int step, unsigned is_short, unsigned same_or_positive, FontBytes& out) {
  if (step == 0) return same_or_positive;
  if (std::abs(step) > 255) {
    out.i16(step);
    return 0;
  }
  out.u8(static_cast<unsigned>(std::abs(step)));
  return is_short | (step > 0 ? same_or_positive : 0U);
}

/// Equal flags one after another are written once, with a count.
void put_flags(std::span<const unsigned> flags, FontBytes& out) {
  for (std::size_t i = 0; i < flags.size();) {
    std::size_t same = 1;
    while (i + same < flags.size() && same < 256 && flags[i + same] == flags[i]) ++same;
    if (same == 1) {
      out.u8(flags[i]);
    } else {
      out.u8(flags[i] | kRepeated);
      out.u8(static_cast<unsigned>(same - 1));
    }
    i += same;
  }
}

}  // namespace

SearchRange search_range(std::size_t count, std::size_t entry_size) {
  const std::size_t power = std::bit_floor(count);
  return {power * entry_size, static_cast<std::size_t>(std::bit_width(count)) - 1,
          (count - power) * entry_size};
}

std::vector<std::uint8_t> font_file(std::vector<FontTable> tables) {
  std::ranges::sort(tables, {}, &FontTable::tag);
  constexpr std::size_t kRecord = 16;
  constexpr std::size_t kAdjustmentInHead = 8;
  FontBytes file;
  const SearchRange search = search_range(tables.size(), kRecord);
  file.u32(0x00010000);  // outlines of TrueType
  file.u16(tables.size());
  file.u16(search.range);
  file.u16(search.selector);
  file.u16(search.shift);
  std::size_t offset = file.size() + tables.size() * kRecord;
  std::size_t head = 0;
  for (const FontTable& table : tables) {
    assert(table.tag.size() == 4);
    if (table.tag == "head") head = offset;
    file.text(table.tag);
    file.u32(table_checksum(table.bytes));
    file.u32(offset);
    file.u32(table.bytes.size());
    offset += (table.bytes.size() + 3) / 4 * 4;
  }
  assert(head != 0);
  for (const FontTable& table : tables) {
    file.raw(table.bytes);
    file.align(4);
  }
  FontBytes adjustment;
  adjustment.u32(0xB1B0AFBAU - table_checksum(file.bytes()));
  std::ranges::copy(adjustment.bytes(),
                    file.bytes().begin() + static_cast<std::ptrdiff_t>(head + kAdjustmentInHead));
  return std::move(file.bytes());
}

FontBox box_of_points(std::span<const FontContour> contours) {
  FontBox box;
  bool is_first = true;
  for (const FontContour& contour : contours) {
    for (const FontPoint& p : contour) {
      if (is_first) box = {p.x, p.y, p.x, p.y};
      is_first = false;
      box = {std::min(box.left, p.x), std::min(box.bottom, p.y), std::max(box.right, p.x),
             std::max(box.top, p.y)};
    }
  }
  return box;
}

std::size_t count_points(std::span<const FontContour> contours) {
  std::size_t points = 0;
  for (const FontContour& contour : contours) points += contour.size();
  return points;
}

std::vector<std::uint8_t> glyph_bytes(std::span<const FontContour> contours) {
  if (contours.empty()) return {};
  FontBytes out;
  const FontBox box = box_of_points(contours);
  out.u16(contours.size());
  out.i16(box.left);
  out.i16(box.bottom);
  out.i16(box.right);
  out.i16(box.top);
  std::size_t end = 0;
  for (const FontContour& contour : contours) {
    assert(!contour.empty());
    end += contour.size();
    out.u16(end - 1);
  }
  out.u16(0);  // no instructions
  FontBytes steps_x;
  FontBytes steps_y;
  std::vector<unsigned> flags;
  flags.reserve(end);
  FontPoint last;
  for (const FontContour& contour : contours) {
    for (const FontPoint& p : contour) {
      unsigned flag = p.on_curve ? kOnCurve : 0U;
      flag |= put_step(p.x - last.x, kShortX, kSameOrPositiveX, steps_x);
      flag |= put_step(p.y - last.y, kShortY, kSameOrPositiveY, steps_y);
      flags.push_back(flag);
      last = p;
    }
  }
  flags.front() |= kOverlapSimple;
  put_flags(flags, out);
  out.raw(steps_x.bytes());
  out.raw(steps_y.bytes());
  out.align(4);
  return std::move(out.bytes());
}

}  // namespace nazori::author
