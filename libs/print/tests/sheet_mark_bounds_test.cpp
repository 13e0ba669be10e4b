// SPDX-License-Identifier: Apache-2.0
// What the mark of a sheet can hold, up to its bounds and one beyond them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "nazori/print/sheet_mark.h"

namespace nazori::print {
namespace {

/// One row of twelve cells on a page of A4, whose area is 186 x 254 mm.
SheetMark practice() {
  SheetMark mark;
  mark.runs = {{10, 1, {U'休'}}};
  return mark;
}
SheetMark quiz() {
  SheetMark mark;
  mark.layout = Layout::quiz;
  mark.runs = {{10, 1, {U'休', 0, U'日'}}};
  return mark;
}

using Change = std::function<void(SheetMark&)>;

/// Whether a mark can be written.
bool fits(SheetMark mark, const Change& change) {
  change(mark);
  return mark_bytes(mark, kMostMarkBytes).has_value();
}

/// Whether a mark that can be written is read again as it was.
bool is_read(SheetMark mark, const Change& change) {
  change(mark);
  const auto bytes = mark_bytes(mark, kMostMarkBytes);
  EXPECT_TRUE(bytes);
  if (!bytes) return false;
  const auto read = read_mark(*bytes);
  if (read) {
    EXPECT_EQ(*read, mark);
  }
  return read.has_value();
}

TEST(SheetMarkBounds, NumbersHaveAsManyBitsAsTheyNeed) {
  const double inside = 409.5;
  const double outside = 409.6;
  EXPECT_TRUE(fits(practice(), [&](SheetMark& m) { m.width_mm = inside; }));
  EXPECT_FALSE(fits(practice(), [&](SheetMark& m) { m.width_mm = outside; }));
  EXPECT_TRUE(fits(practice(), [&](SheetMark& m) { m.height_mm = inside; }));
  EXPECT_FALSE(fits(practice(), [&](SheetMark& m) { m.height_mm = outside; }));
  EXPECT_TRUE(fits(practice(), [](SheetMark& m) { m.runs[0].across_mm = 409.55; }));
  EXPECT_FALSE(fits(practice(), [&](SheetMark& m) { m.runs[0].across_mm = outside; }));
  EXPECT_TRUE(fits(practice(), [](SheetMark& m) { m.cell_mm = 81.91; }));
  EXPECT_FALSE(fits(practice(), [](SheetMark& m) { m.cell_mm = 81.92; }));
  EXPECT_TRUE(fits(practice(), [](SheetMark& m) { m.copies = 63; }));
  EXPECT_FALSE(fits(practice(), [](SheetMark& m) { m.copies = 64; }));
  EXPECT_FALSE(fits(practice(), [](SheetMark& m) { m.copies = -1; }));
  EXPECT_TRUE(fits(practice(), [](SheetMark& m) { m.page = 1023; }));
  EXPECT_FALSE(fits(practice(), [](SheetMark& m) { m.page = 1024; }));
  EXPECT_TRUE(fits(practice(), [](SheetMark& m) { m.runs[0].rows = 63; }));
  EXPECT_FALSE(fits(practice(), [](SheetMark& m) { m.runs[0].rows = 64; }));
  EXPECT_TRUE(fits(quiz(), [](SheetMark& m) { m.runs[0].characters.assign(31, 0); }));
  EXPECT_FALSE(fits(quiz(), [](SheetMark& m) { m.runs[0].characters.assign(32, 0); }));
  // The largest mark has 98 bytes of content: 67 bits and 18 for each line.
  EXPECT_TRUE(fits(quiz(), [](SheetMark& m) { m.runs.assign(39, {0, 1, {}}); }));
  EXPECT_FALSE(fits(quiz(), [](SheetMark& m) { m.runs.assign(40, {0, 1, {}}); }));
  EXPECT_FALSE(fits(practice(), [](SheetMark& m) { m.width_mm = -1; }));
}

TEST(SheetMarkBounds, CellsLieOnThePageOrTheMarkIsRefused) {
  // 254 mm high, with a tenth of a millimetre for rounding.
  EXPECT_TRUE(is_read(practice(), [](SheetMark& m) { m.runs[0].across_mm = 254.1 - 15; }));
  EXPECT_FALSE(is_read(practice(), [](SheetMark& m) { m.runs[0].across_mm = 254.15 - 15; }));
  EXPECT_TRUE(is_read(practice(), [](SheetMark& m) { m.runs[0] = {254 - 45, 3, {U'休'}}; }));
  EXPECT_FALSE(is_read(practice(), [](SheetMark& m) { m.runs[0] = {254 - 44.5, 3, {U'休'}}; }));
  EXPECT_TRUE(is_read(quiz(), [](SheetMark& m) { m.runs[0].across_mm = 254.1 - 15; }));
  EXPECT_FALSE(is_read(quiz(), [](SheetMark& m) { m.runs[0].across_mm = 254.15 - 15; }));
  // Twelve letters of 15.5 mm are 186 mm.
  EXPECT_TRUE(is_read(quiz(), [](SheetMark& m) {
    m.cell_mm = 15.5;
    m.runs[0].characters.assign(12, U'休');
  }));
  EXPECT_FALSE(is_read(quiz(), [](SheetMark& m) {
    m.cell_mm = 15.51;
    m.runs[0].characters.assign(12, U'休');
  }));
  // Five letters of 37.22 mm are 186.1 mm: exactly the tenth that rounding may add.
  EXPECT_TRUE(is_read(quiz(), [](SheetMark& m) {
    m.cell_mm = 37.22;
    m.runs[0].characters.assign(5, U'休');
  }));
  EXPECT_FALSE(is_read(quiz(), [](SheetMark& m) {
    m.cell_mm = 37.23;
    m.runs[0].characters.assign(5, U'休');
  }));
  EXPECT_TRUE(is_read(quiz(), [](SheetMark& m) {
    m.vertical = true;
    m.runs[0].across_mm = 186 - 15;
    m.runs[0].characters.assign(16, U'休');
  }));
  EXPECT_FALSE(is_read(quiz(), [](SheetMark& m) {
    m.vertical = true;
    m.runs[0].characters.assign(17, U'休');
  }));
}

TEST(SheetMarkBounds, CellsHaveTheSizesOfSheetsToAHundredth) {
  for (const auto& make : {practice, quiz}) {
    for (const double fine : {7.99, 8.0, 60.0, 60.01})
      EXPECT_TRUE(is_read(make(), [&](SheetMark& m) { m.cell_mm = fine; })) << fine;
    for (const double wrong : {7.98, 60.02})
      EXPECT_FALSE(is_read(make(), [&](SheetMark& m) { m.cell_mm = wrong; })) << wrong;
  }
  // A page must hold a cell: 24 mm of margins across, 43 mm of margins, header, footer and mark down.
  const auto page = [](double width, double height) {
    return is_read(SheetMark{}, [&](SheetMark& m) {
      m.width_mm = width;
      m.height_mm = height;
    });
  };
  EXPECT_TRUE(page(39, 58));
  EXPECT_FALSE(page(38.9, 58));
  EXPECT_FALSE(page(39, 57.9));
}

TEST(SheetMarkBounds, CharactersAreThoseOfUnicode) {
  for (const char32_t c : {char32_t{0x20}, char32_t{0x4DFF}, char32_t{0x4E00}, char32_t{0xCDFF},
                           char32_t{0xCE00}, char32_t{0xD7FF}, char32_t{0xE000}, char32_t{0x10FFFF}}) {
    EXPECT_TRUE(is_read(practice(), [&](SheetMark& m) { m.runs[0].characters = {c}; }))
        << static_cast<std::uint32_t>(c);
    EXPECT_TRUE(is_read(quiz(), [&](SheetMark& m) { m.runs[0].characters = {c}; }))
        << static_cast<std::uint32_t>(c);
  }
  for (const char32_t c : {char32_t{0x1F}, char32_t{0xD800}, char32_t{0xDFFF}, char32_t{0x110000}}) {
    EXPECT_FALSE(is_read(practice(), [&](SheetMark& m) { m.runs[0].characters = {c}; }))
        << static_cast<std::uint32_t>(c);
    EXPECT_FALSE(is_read(quiz(), [&](SheetMark& m) { m.runs[0].characters = {c}; }))
        << static_cast<std::uint32_t>(c);
  }
  EXPECT_FALSE(is_read(practice(), [](SheetMark& m) { m.runs[0].characters = {0}; })) << "nothing to write";
  EXPECT_FALSE(is_read(quiz(), [](SheetMark& m) { m.runs[0].characters = {}; }));
}

/// Symbols that correct errors in a mark of so many bytes: two for each seventh of it, six at least.
std::size_t parity_of(std::size_t bytes) { return 2 * std::max<std::size_t>(3, (bytes + 6) / 7); }

TEST(SheetMarkBounds, AMarkIsAsSmallAsItsContentAllows) {
  for (std::size_t content = 0; content <= 100; ++content) {
    std::size_t size = 20;
    while (size < 140 && size - parity_of(size) - 2 < content) size += 5;
    EXPECT_EQ(sealed_mark(std::vector<std::uint8_t>(content, 0x5A)).size(), size) << content;
  }
  EXPECT_EQ(sealed_mark(std::vector<std::uint8_t>(1000, 0x5A)).size(), kMostMarkBytes);
}

TEST(SheetMarkBounds, AMarkNeedsTheRoomOfItsBytes) {
  for (std::size_t runs = 1; runs < 12; ++runs) {
    SheetMark mark = practice();
    mark.cell_mm = 8;
    mark.runs.assign(runs, {0, 1, {U'休'}});
    const std::size_t size = mark_bytes(mark, kMostMarkBytes)->size();
    EXPECT_TRUE(mark_bytes(mark, size));
    EXPECT_FALSE(mark_bytes(mark, size - 1)) << runs;
  }
}

TEST(SheetMarkBounds, OfEachSizeAsManyBytesMayBeWrongAsAreCorrected) {
  for (std::size_t runs : {1U, 3U, 8U, 15U}) {
    SheetMark mark = practice();
    mark.runs.assign(runs, {0, 1, {U'休'}});
    const auto right = *mark_bytes(mark, kMostMarkBytes);
    const std::size_t most = parity_of(right.size()) / 2;
    auto bytes = right;
    for (std::size_t i = 0; i < most; ++i) bytes[i * right.size() / most] ^= 0x81U;
    const auto read = read_mark(bytes);
    ASSERT_TRUE(read) << right.size();
    EXPECT_EQ(*read, mark);
    bytes[1] ^= 0x7EU;
    EXPECT_FALSE(read_mark(bytes)) << right.size();
  }
}

TEST(SheetMarkBounds, AStripHasTheBytesOfItsLength) {
  // Between the discs, with 3.6 mm beside each, five modules of 0.8 mm below one another are five bits.
  for (const double width : {60.0, 105.0, 148.5, 182.0, 210.0, 215.9}) {
    const double length = width - 2 * (12 + 2 + 3.6);
    std::size_t bytes = 0;
    while (static_cast<double>((bytes + 5) * 8) <= length / 0.8 * 5 && bytes + 5 <= 140) bytes += 5;
    EXPECT_EQ(mark_room(width), bytes) << width;
  }
  EXPECT_EQ(mark_room(30), 0U);
  EXPECT_EQ(mark_room(500), 140U);
}

}  // namespace
}  // namespace nazori::print
