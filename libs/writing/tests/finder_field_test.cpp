// SPDX-License-Identifier: Apache-2.0
// The field that the net of the finder sees, and the net, each by its definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include "finder_net.h"
#include "ink_field.h"

namespace nazori::writing {
namespace {

using FieldLines = std::vector<std::vector<float>>;

InkField field_of(const FieldLines& strokes) {
  const std::vector<FlatLine> lines(strokes.begin(), strokes.end());
  return make_field(lines);
}

std::size_t place_of(int column, int row, std::size_t slant) {
  return (static_cast<std::size_t>(row) * kFieldCells + static_cast<std::size_t>(column)) * kFieldSlants +
         slant;
}

/// The ink of a cell in cells of length: half a cell of it makes 0.5.
double ink_of(const InkField& field, int column, int row, std::size_t slant) {
  const double v = static_cast<double>(field[place_of(column, row, slant)]);
  return 0.5 * v / (1 - v);
}

TEST(InkField, OfALevelLineLiesInItsMiddleRowsAndTellsHowSlimItIs) {
  const InkField field = field_of({{10, 40, 90, 40}});
  // The field is 4.4 spreads wide, of which a line has one in the root of twelve of its length.
  const double cells = 16 / 4.4 * std::sqrt(12);
  double sum = 0;
  for (int row = 0; row < 16; ++row)
    for (int column = 0; column < 16; ++column)
      for (std::size_t slant = 0; slant < 4; ++slant) {
        const double ink = ink_of(field, column, row, slant);
        sum += ink;
        if (slant != 0 || row < 7 || row > 8) {
          EXPECT_EQ(ink, 0) << column << " " << row << " " << slant;
        }
      }
  EXPECT_NEAR(sum, cells, 1e-3);
  for (int column = 3; column < 13; ++column)
    for (const int row : {7, 8}) EXPECT_NEAR(ink_of(field, column, row, 0), 0.5, 0.06) << column;
  EXPECT_EQ(field[kFieldSize], 3) << "as slim as is told";
  EXPECT_EQ(field[kFieldSize + 1], 3);
  EXPECT_NEAR(field[kFieldSize + 2], cells / 60, 1e-4);
  const InkField upright = field_of({{40, 10, 40, 90}});
  EXPECT_EQ(upright[kFieldSize], -3);
  EXPECT_EQ(upright[kFieldSize + 1], 3);
  for (int row = 3; row < 13; ++row) EXPECT_NEAR(ink_of(upright, 7, row, 2), 0.5, 0.06) << row;
}

TEST(InkField, TellsHowWideADrawingIsForItsHeight) {
  // A box of 100 x 50: spreads by integrals along its sides.
  const InkField box = field_of({{0, 0, 100, 0, 100, 50, 0, 50, 0, 0}});
  const double x2 = (2 * 100 * (100.0 * 100 / 12) + 2 * 50 * (50.0 * 50)) / 300;
  const double y2 = (2 * 50 * (50.0 * 50 / 12) + 2 * 100 * (25.0 * 25)) / 300;
  const double sx = std::sqrt(x2), sy = std::sqrt(y2);
  EXPECT_NEAR(box[kFieldSize], std::log((sx + 0.05 * sx) / (sy + 0.05 * sx)), 1e-3);
  const double scale_x = 16 / (4.4 * sx), scale_y = 16 / (4.4 * std::max(sy, 0.6 * sx));
  EXPECT_NEAR(box[kFieldSize + 2], (200 * scale_x + 100 * scale_y) / 60, 1e-3);
}

std::vector<float> random_stroke(std::mt19937& luck) {
  std::uniform_real_distribution<float> place(0, 100);
  std::vector<float> stroke;
  for (int k = 0; k < 8; ++k) stroke.push_back(place(luck));
  return stroke;
}

FieldLines random_drawing(unsigned number) {
  std::mt19937 luck(number);
  return {random_stroke(luck), random_stroke(luck), random_stroke(luck)};
}

TEST(InkField, DoesNotDependOnPlaceSizeOrderOrDirection) {
  for (unsigned i = 0; i < 10; ++i) {
    const FieldLines strokes = random_drawing(i);
    const InkField field = field_of(strokes);
    FieldLines other(strokes.rbegin(), strokes.rend());
    for (auto& stroke : other) {
      std::vector<float> back;
      for (std::size_t k = stroke.size(); k >= 2; k -= 2)
        back.insert(back.end(), {3 * stroke[k - 2] - 40, 3 * stroke[k - 1] + 7});
      stroke = back;
    }
    const InkField again = field_of(other);
    for (std::size_t k = 0; k < field.size(); ++k) EXPECT_NEAR(field[k], again[k], 2e-3) << i << " " << k;
  }
}

TEST(InkField, OfTheMirrorImageIsTheMirrorImage) {
  for (unsigned i = 0; i < 10; ++i) {
    FieldLines strokes = random_drawing(i);
    const InkField field = field_of(strokes);
    for (auto& stroke : strokes)
      for (std::size_t k = 0; k < stroke.size(); k += 2) stroke[k] = 100 - stroke[k];
    const InkField mirrored = field_of(strokes);
    for (int row = 0; row < 16; ++row)
      for (int column = 0; column < 16; ++column)
        for (std::size_t slant = 0; slant < 4; ++slant)
          EXPECT_NEAR(field[place_of(column, row, slant)],
                      mirrored[place_of(15 - column, row, (4 - slant) % 4)], 2e-3);
  }
}

TEST(InkField, AShortStrokeAwayFromAllOthersIsADotInEverySlant) {
  // A long upright stroke; above it a dot, whose ink would hardly show.
  const auto dotted = [](float gap, float length) {
    const InkField field = field_of({{50, 40, 50, 100}, {50, 40 - gap - length, 50, 40 - gap}});
    double level = 0;
    for (int row = 0; row < 16; ++row)
      for (int column = 0; column < 16; ++column) level += ink_of(field, column, row, 0);
    return level;
  };
  // The spread of the ink is some 20, half of it counts as near.
  EXPECT_NEAR(dotted(15, 0.5F), 0.4, 0.01);
  EXPECT_EQ(dotted(3, 0.5F), 0) << "a piece of a broken line";
  EXPECT_EQ(dotted(25, 20), 0) << "too long";
  const InkField alone = field_of({{50, 50}});
  for (std::size_t slant = 0; slant < 4; ++slant) {
    double sum = 0;
    for (int row = 0; row < 16; ++row)
      for (int column = 0; column < 16; ++column) sum += ink_of(alone, column, row, slant);
    EXPECT_NEAR(sum, 0.4, 1e-3) << slant;
  }
}

/// Weights as a file has them: for each layer the scales as floats, then signed bytes.
struct WeightFile {
  std::vector<unsigned char> bytes;
  NetWeights expected;
};

WeightFile random_weights() {
  std::mt19937 luck(5);
  WeightFile file;
  const std::array<std::size_t, 3> inputs{9 * kFieldSlants + 1, 9 * kNetFirst + 1, kNetDense + 1};
  const std::array<std::size_t, 3> outputs{kNetFirst, kNetSecond, kNetOut};
  for (std::size_t layer = 0; layer < 3; ++layer) {
    std::vector<float> scales;
    for (std::size_t k = 0; k < outputs[layer]; ++k) {
      const float scale = 0.001F * static_cast<float>(1 + (k * 7 + layer) % 13);
      scales.push_back(scale);
      std::uint32_t bits = 0;
      std::memcpy(&bits, &scale, sizeof bits);
      for (unsigned shift = 0; shift < 32; shift += 8)
        file.bytes.push_back(static_cast<unsigned char>(bits >> shift & 0xFFU));
    }
    std::vector<float>& weights = layer == 0   ? file.expected.first
                                  : layer == 1 ? file.expected.second
                                               : file.expected.dense;
    for (std::size_t k = 0; k < inputs[layer] * outputs[layer]; ++k) {
      const int value = static_cast<int>(luck() % 256) - 128;
      file.bytes.push_back(static_cast<unsigned char>(value));
      weights.push_back(static_cast<float>(value) * scales[k % outputs[layer]]);
    }
  }
  return file;
}

TEST(FinderNet, WeightsAreReadAsTheyAreWrittenAndOnlyWhole) {
  const WeightFile file = random_weights();
  const NetWeights read = read_weights(file.bytes);
  EXPECT_EQ(read.first, file.expected.first);
  EXPECT_EQ(read.second, file.expected.second);
  EXPECT_EQ(read.dense, file.expected.dense);
  auto shorter = file.bytes;
  shorter.pop_back();
  EXPECT_TRUE(read_weights(shorter).first.empty());
  auto longer = file.bytes;
  longer.push_back(0);
  EXPECT_TRUE(read_weights(longer).dense.empty());
}

/// One layer of 3 x 3 patches, two cells apart, by its definition: cells outside are empty, none is below 0.
std::vector<double> patches_of(const std::vector<double>& in, std::size_t cells, std::size_t depth,
                               const std::vector<float>& weights, std::size_t outputs) {
  const std::size_t half = cells / 2;
  std::vector<double> out;
  for (std::size_t row = 0; row < half; ++row)
    for (std::size_t column = 0; column < half; ++column)
      for (std::size_t o = 0; o < outputs; ++o) {
        double sum = static_cast<double>(weights[9 * depth * outputs + o]);
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const int y = 2 * static_cast<int>(row) + dy, x = 2 * static_cast<int>(column) + dx;
            if (y < 0 || x < 0 || y >= static_cast<int>(cells) || x >= static_cast<int>(cells)) continue;
            const auto part = static_cast<std::size_t>(3 * (dy + 1) + dx + 1);
            for (std::size_t k = 0; k < depth; ++k)
              sum += in[(static_cast<std::size_t>(y) * cells + static_cast<std::size_t>(x)) * depth + k] *
                     static_cast<double>(weights[(part * depth + k) * outputs + o]);
          }
        out.push_back(std::max(sum, 0.0));
      }
  return out;
}

TEST(FinderNet, AnEmbeddingIsTwoLayersOfPatchesAndOneThatSeesAllOfLengthOne) {
  const NetWeights weights = random_weights().expected;
  std::mt19937 luck(6);
  for (int example = 0; example < 3; ++example) {
    InkField field{};
    for (float& v : field) v = static_cast<float>(luck() % 1000) / 1000 * (luck() % 3 == 0 ? 1.0F : 0.0F);
    const std::vector<double> cells(field.begin(), field.begin() + kFieldSize);
    const auto first = patches_of(cells, kFieldCells, kFieldSlants, weights.first, kNetFirst);
    auto all = patches_of(first, kFieldCells / 2, kNetFirst, weights.second, kNetSecond);
    all.insert(all.end(), field.begin() + kFieldSize, field.end());
    ASSERT_EQ(all.size(), kNetDense);
    std::vector<double> out(kNetOut);
    double square = 0;
    for (std::size_t o = 0; o < kNetOut; ++o) {
      out[o] = static_cast<double>(weights.dense[kNetDense * kNetOut + o]);
      for (std::size_t k = 0; k < kNetDense; ++k)
        out[o] += all[k] * static_cast<double>(weights.dense[k * kNetOut + o]);
      square += out[o] * out[o];
    }
    const Embedding found = embed(weights, field);
    for (std::size_t o = 0; o < kNetOut; ++o) EXPECT_NEAR(found[o], out[o] / std::sqrt(square), 1e-4) << o;
    EXPECT_NEAR(likeness(found, found), 1, 1e-5);
  }
}

}  // namespace
}  // namespace nazori::writing
