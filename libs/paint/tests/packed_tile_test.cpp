// SPDX-License-Identifier: Apache-2.0
#include "packed_tile.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "inside.h"

namespace nazori::paint {
namespace {

constexpr Bands kPaper{0.8, 0.7, 0.6};

bool comes_back(const Tile& tile) {
  const auto bytes = pack(tile);
  Tile back;
  back.surface[5] = 3;  // of another time
  back.evaporated = 9;
  if (!unpack(bytes, kPaper, back)) return false;
  EXPECT_EQ(back.surface, tile.surface);
  EXPECT_EQ(back.fibre, tile.fibre);
  EXPECT_EQ(back.moving, tile.moving);
  EXPECT_EQ(back.fixed, tile.fixed);
  EXPECT_EQ(back.evaporated, tile.evaporated);
  EXPECT_EQ(back.ground != nullptr, tile.ground != nullptr);
  if (back.ground && tile.ground) {
    EXPECT_EQ(*back.ground, *tile.ground);
  }
  return true;
}

TEST(PackedTile, AnUntouchedTileIsNothing) {
  EXPECT_TRUE(pack(Tile{}).empty());
  EXPECT_TRUE(comes_back(Tile{}));
  Tile dried;
  dried.evaporated = 7;
  EXPECT_EQ(pack(dried).size(), 10U);
  EXPECT_TRUE(comes_back(dried));
}

TEST(PackedTile, EachFieldComesBackInItsPlace) {
  Tile tile;
  tile.surface[0] = 1;
  tile.fibre[1] = 2;
  for (std::size_t k = 0; k < kSlots; ++k) {
    tile.moving[k][2 + k] = 3;
    tile.fixed[k][kCells - 1 - k] = 4;
  }
  EXPECT_TRUE(comes_back(tile));
  // A mask of a bit for each cell, and four bytes for each that is not 0.
  EXPECT_EQ(pack(tile).size(), 10U + 8 * (128 + 4));
  for (const auto change : {+[](Tile& t) { t.surface[77] = 5; }, +[](Tile& t) { t.fibre[1023] = 5; },
                            +[](Tile& t) { t.moving[2][8] = 5; }, +[](Tile& t) { t.fixed[1][7] = 5; }}) {
    Tile one;
    change(one);
    EXPECT_EQ(pack(one).size(), 10U + 128 + 4);
    EXPECT_TRUE(comes_back(one));
  }
}

TEST(PackedTile, EachFieldHasTheMostThatACellHolds) {
  const auto with = [](auto change) {
    Tile tile;
    change(tile);
    return comes_back(tile);
  };
  EXPECT_TRUE(with([](Tile& t) { t.surface[9] = 16 * kOne; }));
  EXPECT_FALSE(with([](Tile& t) { t.surface[9] = 16 * kOne + 1; }));
  EXPECT_TRUE(with([](Tile& t) { t.fibre[9] = kOne + 4096; }));
  EXPECT_FALSE(with([](Tile& t) { t.fibre[9] = kOne + 4097; }));
  for (std::size_t k = 0; k < kSlots; ++k) {
    EXPECT_TRUE(with([&](Tile& t) { t.moving[k][9] = 16 * kOne; }));
    EXPECT_FALSE(with([&](Tile& t) { t.moving[k][9] = 16 * kOne + 1; }));
    EXPECT_TRUE(with([&](Tile& t) { t.fixed[k][9] = 10 * kOne; }));
    EXPECT_FALSE(with([&](Tile& t) { t.fixed[k][9] = 10 * kOne + 1; }));
  }
  EXPECT_FALSE(with([](Tile& t) { t.surface[9] = -1; }));
  EXPECT_TRUE(with([](Tile& t) { t.evaporated = TotalAmount{1} << 60; }));
  EXPECT_FALSE(with([](Tile& t) { t.evaporated = (TotalAmount{1} << 60) + 1; }));
  EXPECT_FALSE(with([](Tile& t) { t.evaporated = -1; }));
}

TEST(PackedTile, ItsGroundComesBackWhereItIsCovered) {
  const auto with = [](float reflectance) {
    Tile tile;
    tile.ground = std::make_unique<Ground>();
    for (std::size_t band = 0; band < 3; ++band)
      tile.ground->reflectance[band].fill(static_cast<float>(kPaper[band]));
    tile.ground->covered[40] = INT32_MAX;
    tile.ground->reflectance[0][40] = 0.25F;
    tile.ground->reflectance[2][40] = reflectance;
    return comes_back(tile);
  };
  EXPECT_TRUE(with(0.5F));
  EXPECT_TRUE(with(0));
  EXPECT_TRUE(with(1));
  EXPECT_FALSE(with(1.001F));
  EXPECT_FALSE(with(-0.0F));
  EXPECT_FALSE(with(-0.1F));
  EXPECT_FALSE(with(std::numeric_limits<float>::quiet_NaN()));
}

TEST(PackedTile, WhatIsCutOffOrGoesOnIsRefused) {
  Tile tile;
  tile.surface[0] = 1;
  tile.fixed[2][1000] = 4;
  tile.ground = std::make_unique<Ground>();
  tile.ground->covered[3] = 5;
  auto bytes = pack(tile);
  Tile back;
  ASSERT_TRUE(unpack(bytes, kPaper, back));
  for (std::size_t size = 1; size < bytes.size(); ++size)
    EXPECT_FALSE(unpack(std::span(bytes).first(size), kPaper, back)) << size;
  bytes.push_back(0);
  EXPECT_FALSE(unpack(bytes, kPaper, back));
  // A tile that says it has nothing, an empty field, and a field that is not known.
  const std::vector<std::uint8_t> nothing(10);
  EXPECT_FALSE(unpack(nothing, kPaper, back));
  std::vector<std::uint8_t> empty_field(10 + 128);
  empty_field[8] = 1;
  EXPECT_FALSE(unpack(empty_field, kPaper, back));
  std::vector<std::uint8_t> unknown(10);
  unknown[0] = 1;
  EXPECT_TRUE(unpack(unknown, kPaper, back));
  unknown[9] = 2;
  EXPECT_FALSE(unpack(unknown, kPaper, back));
}

}  // namespace
}  // namespace nazori::paint
