// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/sheet_mark.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "reed_solomon.h"

namespace nazori::print {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

/// The product of two bytes in the field, by the definition: polynomials modulo x^8 + x^4 + x^3 + x^2 + 1.
unsigned product(unsigned a, unsigned b) {
  unsigned sum = 0;
  for (unsigned k = 0; k < 8; ++k)
    if ((b >> k & 1U) != 0) sum ^= a << k;
  for (unsigned k = 15; k >= 8; --k)
    if ((sum >> k & 1U) != 0) sum ^= 0x11DU << (k - 8);
  return sum;
}

TEST(ReedSolomon, EveryWordIsAMultipleOfTheGenerator) {
  std::vector<std::uint8_t> bytes{'N', 'a', 'z', 'o', 'r', 'i'};
  append_parity(bytes, 4);
  ASSERT_THAT(bytes, SizeIs(10));
  unsigned root = 1;
  for (int i = 0; i < 4; ++i, root = product(root, 2)) {
    unsigned value = 0;
    for (const std::uint8_t b : bytes) value = product(value, root) ^ b;
    EXPECT_EQ(value, 0U) << i;
  }
}

TEST(ReedSolomon, CorrectsHalfAsManyErrorsAsThereIsParityAndNotMore) {
  std::mt19937 random(5);
  for (const std::size_t length : {20U, 70U, 140U, 254U}) {
    for (const std::size_t parity : {6U, 20U}) {
      if (parity >= length) continue;
      std::vector<std::uint8_t> right(length - parity);
      for (auto& b : right) b = static_cast<std::uint8_t>(random());
      append_parity(right, parity);
      for (std::size_t wrong = 0; wrong <= parity / 2; ++wrong) {
        auto bytes = right;
        std::set<std::size_t> places;
        while (places.size() < wrong) places.insert(random() % length);
        for (const std::size_t at : places)
          bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1 + random() % 255));
        EXPECT_TRUE(correct(bytes, parity)) << length << " " << wrong;
        EXPECT_EQ(bytes, right) << length << " " << wrong;
      }
      auto bytes = right;
      for (std::size_t i = 0; i < parity; ++i) bytes[i] = static_cast<std::uint8_t>(bytes[i] ^ 0x5AU);
      EXPECT_FALSE(correct(bytes, parity) && bytes == right);
    }
  }
}

SheetMark practice_mark() {
  SheetMark mark;
  mark.guide = Guide::diagonals;
  mark.cell_mm = 15;
  mark.copies = 4;
  mark.page = 7;
  mark.runs = {{24 + 1.5, 2, {U'休'}}, {90.25, 3, {U'ア'}}, {180, 1, {U'𠮟'}}};
  return mark;
}

SheetMark quiz_mark() {
  SheetMark mark;
  mark.layout = Layout::quiz;
  mark.vertical = true;
  mark.guide = Guide::none;
  mark.width_mm = 128.5;
  mark.height_mm = 182;
  mark.cell_mm = 12.34;
  mark.runs = {{0, 1, {U'休', 0, U'日'}}, {15.35, 1, {0}}};
  return mark;
}

TEST(SheetMark, IsReadBackAsItWasWritten) {
  for (const SheetMark& mark : {practice_mark(), quiz_mark(), SheetMark{}}) {
    const auto bytes = mark_bytes(mark, kMostMarkBytes);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->size() % kMarkStep, 0U);
    const auto read = read_mark(*bytes);
    ASSERT_TRUE(read) << base::to_line(read.error());
    EXPECT_EQ(*read, mark);
  }
  EXPECT_THAT(*mark_bytes(practice_mark(), kMostMarkBytes), SizeIs(35)) << "it is small";
}

TEST(SheetMark, SurvivesOneWrongByteInSeven) {
  const auto right = mark_bytes(practice_mark(), kMostMarkBytes);
  auto bytes = *right;
  for (std::size_t i = 0; i < bytes.size(); i += 7) bytes[i] = static_cast<std::uint8_t>(bytes[i] ^ 0xC3U);
  const auto read = read_mark(bytes);
  ASSERT_TRUE(read) << base::to_line(read.error());
  EXPECT_EQ(*read, practice_mark());
}

TEST(SheetMark, OtherBytesAreRefused) {
  std::mt19937 random(3);
  for (int i = 0; i < 20'000; ++i) {
    std::vector<std::uint8_t> bytes(kFewestMarkBytes + i % 25 * kMarkStep);
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
    const auto read = read_mark(bytes);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, base::Errc::parse);
  }
  EXPECT_FALSE(read_mark({}));
  EXPECT_FALSE(read_mark(std::vector<std::uint8_t>(kFewestMarkBytes)));
  EXPECT_FALSE(read_mark(std::vector<std::uint8_t>(21)));
}

/// Content with its checksum and so many bytes of parity.
std::vector<std::uint8_t> sealed(std::vector<std::uint8_t> all, std::size_t parity) {
  // CRC-16 with 0x1021 from 0xFFFF, one bit at a time.
  unsigned sum = 0xFFFF;
  for (std::size_t i = 0; i < all.size() * 8; ++i) {
    const unsigned bit = all[i / 8] >> (7 - i % 8) & 1U;
    const unsigned out = sum >> 15U ^ bit;
    sum = (sum << 1U & 0xFFFFU) ^ (out != 0 ? 0x1021U : 0U);
  }
  all.push_back(static_cast<std::uint8_t>(sum >> 8U));
  all.push_back(static_cast<std::uint8_t>(sum));
  append_parity(all, parity);
  return all;
}

constexpr std::size_t kParity = 2 * 5;  // of 35 bytes

/// A mark with other bits at its beginning, whose checksum and parity are right.
std::vector<std::uint8_t> changed(const std::vector<std::uint8_t>& bytes, std::size_t at, std::uint8_t bits) {
  std::vector<std::uint8_t> content(bytes.begin(), bytes.end() - kParity - 2);
  content[at] = static_cast<std::uint8_t>(content[at] ^ bits);
  return sealed(std::move(content), kParity);
}

TEST(SheetMark, OfASizeThatNoMarkHasIsRefused) {
  const auto bytes = *mark_bytes(practice_mark(), kMostMarkBytes);
  std::vector<std::uint8_t> content(bytes.begin(), bytes.end() - kParity - 2);
  ASSERT_EQ(sealed(content, kParity), bytes);
  // The parity is twice the seventh part of all bytes, rounded up.
  EXPECT_FALSE(read_mark(sealed(content, 12))) << "37 bytes";
  content.resize(98);
  EXPECT_TRUE(read_mark(sealed(content, 40))) << "140 bytes";
  content.resize(101);
  EXPECT_FALSE(read_mark(sealed(content, 42))) << "145 bytes";
}

TEST(SheetMark, AnotherVersionIsNamed) {
  const auto bytes = *mark_bytes(practice_mark(), kMostMarkBytes);
  ASSERT_EQ(changed(bytes, 0, 0), bytes);
  const auto read = read_mark(changed(bytes, 0, 0x30));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, base::Errc::schema);
  EXPECT_THAT(read.error().what, testing::HasSubstr("version 2"));
}

TEST(SheetMark, CellsBeyondThePageAreRefused) {
  // Bits 32 to 44 are the side of the cells, of which the highest is worth 41 mm.
  const auto bytes = *mark_bytes(practice_mark(), kMostMarkBytes);
  const auto read = read_mark(changed(bytes, 4, 0x80));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, base::Errc::parse);
}

TEST(SheetMark, WhatDoesNotFitIsRefused) {
  SheetMark mark = practice_mark();
  EXPECT_FALSE(mark_bytes(mark, 30));
  mark.cell_mm = 100;
  EXPECT_FALSE(mark_bytes(mark, kMostMarkBytes));
  mark = quiz_mark();
  for (int i = 0; i < 70; ++i) mark.runs.push_back(mark.runs.front());
  EXPECT_FALSE(mark_bytes(mark, kMostMarkBytes));
}

TEST(SheetMark, BoxesLieWhereCellsArePrinted) {
  SheetMark mark = practice_mark();
  mark.runs = {{25.5, 1, {U'休'}}};
  auto boxes = boxes_of(mark);
  ASSERT_THAT(boxes, SizeIs(12));  // 186 mm by 15
  EXPECT_EQ(boxes[3], (MarkedBox{U'休', {12 + 45, 21 + 25.5}, 15, true}));
  EXPECT_EQ(boxes[4], (MarkedBox{U'休', {12 + 60, 21 + 25.5}, 15, false}));
  mark.vertical = true;
  boxes = boxes_of(mark);
  ASSERT_THAT(boxes, SizeIs(16));  // 254 mm by 15
  EXPECT_EQ(boxes[1], (MarkedBox{U'休', {198 - 25.5 - 15, 21 + 15}, 15, true}));
  boxes = boxes_of(quiz_mark());
  ASSERT_THAT(boxes, SizeIs(2)) << "printed letters are not to be written";
  EXPECT_EQ(boxes[1].character, U'日');
  EXPECT_NEAR(boxes[1].corner.x, 116.5 - 12.34, 1e-9);
  EXPECT_NEAR(boxes[1].corner.y, 21 + 2 * 12.34, 1e-9);
}

TEST(SheetMark, TheStripLiesBesideTheMiddleOfTheLowerLeftDisc) {
  for (const auto& [width, height] : page_sizes()) {
    const PaperPoint disc = disc_centres(width, height)[3];
    const PaperPoint first = module_centre(height, 0, 0), last = module_centre(height, 0, kMarkRows);
    EXPECT_NEAR((first.y + last.y) / 2, disc.y, 1e-9);
    EXPECT_NEAR(last.y - first.y, 5 * 0.8, 1e-9);
    EXPECT_NEAR(module_centre(height, 3, 0).x - first.x, 3 * 0.8, 1e-9);
    // Upper left corners of the first cells lie above it.
    EXPECT_GT(first.y - 0.4, height - 12 - 4 - 6) << "the cells end there";
  }
}

TEST(SheetMark, TheStripEndsBeforeTheOtherDisc) {
  for (const auto& [width, height] : page_sizes()) {
    const auto discs = disc_centres(width, height);
    const std::size_t room = mark_room(width);
    ASSERT_GE(room, 60U);
    const PaperPoint last = module_centre(height, mark_columns(room) - 1, kMarkRows);
    EXPECT_LT(last.x + kModule_mm / 2, discs[2].x - kDisc_mm / 2 - 1);
    EXPECT_LT(last.y + kModule_mm / 2, height - kMargin_mm - 3) << "below it there is text";
    EXPECT_GT(module_centre(height, 0, 0).x - kModule_mm / 2, discs[3].x + kDisc_mm / 2 + 1);
  }
}

}  // namespace
}  // namespace nazori::print
