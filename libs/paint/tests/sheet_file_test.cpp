// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/sheet_file.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <zlib.h>

#include <filesystem>

#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;
using Bytes = std::vector<std::uint8_t>;

/// Wet, with two layers and an odd palette.
std::pair<Sheet, InkLoad> painted() {
  Sheet sheet = sheet_of(128, find_paper("gasenshi").value());
  InkLoad load = full_of(0), red = full_of(1);
  EXPECT_TRUE(sheet.set_pigment(2, find_pigment("burnt-umber").value()));
  write(sheet, load, {});
  sheet.dry_now();
  write(sheet, red, {.from = {0, 0.03}, .to = {0, -0.03}}, [&] { sheet.step(); });
  return {std::move(sheet), load};
}

void repair(Bytes& bytes) {
  const auto sum = static_cast<std::uint32_t>(crc32(0, bytes.data(), static_cast<uInt>(bytes.size() - 4)));
  for (std::size_t i = 0; i < 4; ++i) bytes[bytes.size() - 4 + i] = static_cast<std::uint8_t>(sum >> (8 * i));
}

TEST(SheetFile, ReopensBitForBitAndGoesOnAlike) {
  auto [sheet, load] = painted();
  sheet.set_frozen(true);
  const Bytes bytes = to_bytes(sheet, load);
  auto saved = parse_sheet(bytes);
  ASSERT_TRUE(saved) << base::to_line(saved.error());
  EXPECT_TRUE(saved->sheet.is_same_as(sheet));
  EXPECT_EQ(saved->load, load);
  EXPECT_TRUE(saved->sheet.is_frozen());
  EXPECT_EQ(to_bytes(saved->sheet, saved->load), bytes);
  sheet.set_frozen(false);
  saved->sheet.set_frozen(false);
  for (int i = 0; i < 50; ++i) {
    sheet.step();
    saved->sheet.step();
  }
  EXPECT_EQ(to_bytes(saved->sheet, load), to_bytes(sheet, load));
  for (int row = 0; row < 128; ++row) EXPECT_EQ(saved->sheet.at(60, row), sheet.at(60, row));
}

TEST(SheetFile, IsSmallWhereNothingWasWritten) { EXPECT_LT(to_bytes(sheet_of(128), {}).size(), 1500U); }

TEST(SheetFile, WhatIsAttachedComesBackAndAnOlderVersionHasNone) {
  const auto [sheet, load] = painted();
  Bytes attached(5000);
  for (std::size_t i = 0; i < attached.size(); ++i) attached[i] = static_cast<std::uint8_t>(i * i % 251);
  const Bytes with = to_bytes(sheet, load, attached), without = to_bytes(sheet, load);
  EXPECT_EQ(with[8], 2);
  EXPECT_EQ(without[8], 1);
  const auto saved = parse_sheet(with);
  ASSERT_TRUE(saved) << base::to_line(saved.error());
  EXPECT_EQ(saved->attached, attached);
  EXPECT_TRUE(saved->sheet.is_same_as(sheet));
  EXPECT_EQ(to_bytes(saved->sheet, saved->load, saved->attached), with);
  EXPECT_TRUE(parse_sheet(without)->attached.empty());
}

TEST(SheetFile, AnAttachmentThatCannotBeUnpackedIsRefused) {
  const auto [sheet, load] = painted();
  const Bytes attached(300, 7);
  const Bytes good = to_bytes(sheet, load, attached);
  const std::size_t at = to_bytes(sheet, load).size() - 4;  // its length, and the length of what is packed
  const auto with = [&](std::size_t offset, std::uint8_t value) {
    Bytes bytes = good;
    bytes[at + offset] = value;
    repair(bytes);
    return parse_sheet(bytes);
  };
  ASSERT_EQ(good[at] + 256 * good[at + 1], 300);
  EXPECT_TRUE(with(0, good[at]));
  EXPECT_EQ(with(0, static_cast<std::uint8_t>(good[at] + 1)).error().what,
            "has strokes that cannot be unpacked");
  EXPECT_FALSE(with(0, static_cast<std::uint8_t>(good[at] - 1)));
  EXPECT_FALSE(with(3, 0x80));
  EXPECT_FALSE(with(4, static_cast<std::uint8_t>(good[at + 4] + 1)));
  EXPECT_FALSE(with(4, static_cast<std::uint8_t>(good[at + 4] - 1)));
  EXPECT_FALSE(with(8, 0));  // not packed by zlib
  // One byte more behind what was packed.
  Bytes longer = good;
  longer.insert(longer.end() - 4, 0);
  repair(longer);
  EXPECT_FALSE(parse_sheet(longer));
}

TEST(SheetFile, AFileIsWrittenAndReadAgain) {
  std::string folder = (std::filesystem::temp_directory_path() / "nazori-paint-XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const auto path = std::filesystem::path(folder) / "ei.nzs";
  const auto [sheet, load] = painted();
  ASSERT_TRUE(save_sheet(sheet, load, path));
  const auto saved = load_sheet(path);
  ASSERT_TRUE(saved);
  EXPECT_TRUE(saved->sheet.is_same_as(sheet));
  std::filesystem::resize_file(path, 700);
  const auto broken = load_sheet(path);
  ASSERT_FALSE(broken);
  EXPECT_EQ(base::to_line(broken.error()), path.string() + ": is damaged: its checksum is wrong");
  std::filesystem::remove_all(folder);
  EXPECT_EQ(load_sheet(path).error().code, base::Errc::not_found);
}

TEST(SheetFile, EveryByteCountsAndEveryLengthIsChecked) {
  const auto [sheet, load] = painted();
  const Bytes good = to_bytes(sheet, load);
  for (std::size_t at = 0; at < good.size(); at += 1 + at / 50) {
    Bytes bad = good;
    bad[at] ^= 0x41;
    EXPECT_FALSE(parse_sheet(bad)) << at;
    Bytes shorter(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(at));
    EXPECT_FALSE(parse_sheet(shorter)) << at;
    if (at < 40) continue;
    shorter.resize(at + 4);
    repair(shorter);
    EXPECT_FALSE(parse_sheet(shorter)) << at;
  }
  Bytes longer = good;
  longer.insert(longer.end() - 4, 0);
  repair(longer);
  EXPECT_EQ(parse_sheet(longer).error().what, "does not end where its last part does");
}

TEST(SheetFile, WrongValuesAreRefusedThoughTheChecksumIsRight) {
  const auto [sheet, load] = painted();
  const Bytes good = to_bytes(sheet, load);
  const auto with = [&](std::size_t at, std::uint8_t value) {
    Bytes bytes = good;
    bytes[at] = value;
    repair(bytes);
    return parse_sheet(bytes);
  };
  EXPECT_FALSE(with(8, 2));  // there is no attachment
  EXPECT_EQ(with(8, 0).error().code, base::Errc::schema);
  EXPECT_EQ(with(8, 3).error().code, base::Errc::schema);
  EXPECT_EQ(with(10, 1).error().code, base::Errc::schema);
  EXPECT_FALSE(with(12, 100));  // size
  EXPECT_FALSE(with(15, 1));
  EXPECT_FALSE(with(16, 2));  // flags
  EXPECT_EQ(with(0, 0x88).error().what, "is not a sheet of paper");
  EXPECT_TRUE(with(16, 1));
  // After the load, 9 numbers of 8 bytes, stand the number of tiles, the first tile's number, its length,
  // what evaporated and which fields there are.
  const std::size_t text = good[20] + 256U * good[21];
  std::size_t at = 24 + text;
  for (int i = 0; i < 3; ++i) at += 4 + good[at] + 8 * 8;
  EXPECT_FALSE(with(at + 7, 0x80));  // capacity below zero
  EXPECT_FALSE(with(at + 15, 0x80));
  at += 9 * 8;
  EXPECT_FALSE(with(at, static_cast<std::uint8_t>(good[at] + 1)));
  EXPECT_FALSE(with(at, static_cast<std::uint8_t>(good[at] - 1)));
  EXPECT_FALSE(with(at + 4, 200));
  EXPECT_FALSE(with(at + 19, 0x80));  // evaporated below zero
  EXPECT_FALSE(with(at + 21, 0xFF));
}

}  // namespace
}  // namespace nazori::paint
