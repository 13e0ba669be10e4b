// SPDX-License-Identifier: Apache-2.0
#include "../src/material.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../src/noise.h"
#include "../src/palette.h"
#include "../src/rings.h"

namespace nazori::view {
namespace {

TEST(Srgb, IsTheTransferFunctionOfTheStandard) {
  // IEC 61966-2-1; the middle grey of 8 bits, 188, is half the light.
  EXPECT_NEAR(srgb_from_linear(0.5F), 0.735357F, 1e-5);
  EXPECT_NEAR(srgb_from_linear(0.18F), 0.461356F, 1e-5);
  EXPECT_NEAR(srgb_from_linear(0.001F), 0.01292F, 1e-6);
  EXPECT_NEAR(srgb_from_linear(0.0031308F), 0.0404499F, 1e-5);
  EXPECT_NEAR(srgb_from_linear(0.0035F), 0.044988F, 1e-5) << "the power begins there";
  EXPECT_EQ(srgb_from_linear(0), 0);
  EXPECT_NEAR(srgb_from_linear(1), 1, 1e-6);
  const glm::vec3 linear = linear_from_srgb({0.5F, 0.02F, 1.0F});
  EXPECT_NEAR(linear.x, 0.214041F, 1e-5);
  EXPECT_NEAR(linear.y, 0.02F / 12.92F, 1e-7);
  EXPECT_NEAR(linear.z, 1, 1e-6);
  for (int i = 0; i <= 255; ++i) {
    const float s = static_cast<float>(i) / 255;
    const glm::vec3 back = linear_from_srgb({s, 0, s});
    EXPECT_NEAR(srgb_from_linear(back.x), s, 2e-5) << i;
    EXPECT_NEAR(srgb_from_linear(back.z), s, 2e-5) << i;
  }
}

TEST(Palette, AColourIsWhatItsHexadecimalNumberSays) {
  EXPECT_EQ(from_hex(0xFF0000), Colour(1, 0, 0));
  EXPECT_EQ(from_hex(0x00FF00), Colour(0, 1, 0));
  EXPECT_EQ(from_hex(0x0000FF), Colour(0, 0, 1));
  EXPECT_EQ(from_hex(0x336699), Colour(0x33 / 255.0F, 0x66 / 255.0F, 0x99 / 255.0F));
}

TEST(Noise, OfALatticeIsSpreadEvenlyAndItsNeighboursHaveNothingInCommon) {
  constexpr int kSide = 100;
  for (const std::uint32_t seed : {1U, 2U, 26U}) {
    double sum = 0, squares = 0, beside = 0, below = 0, other = 0;
    float least = 1, most = 0;
    std::vector<int> bins(16, 0);
    for (int y = -50; y < 50; ++y) {
      for (int x = -50; x < 50; ++x) {
        const float v = lattice_random(x, y, seed);
        ASSERT_GE(v, 0);
        ASSERT_LT(v, 1);
        least = std::min(least, v);
        most = std::max(most, v);
        ++bins[static_cast<std::size_t>(v * 16)];
        sum += v;
        squares += (v - 0.5) * (v - 0.5);
        beside += (v - 0.5) * (lattice_random(x + 1, y, seed) - 0.5);
        below += (v - 0.5) * (lattice_random(x, y + 1, seed) - 0.5);
        other += (v - 0.5) * (lattice_random(x, y, seed + 1) - 0.5);
      }
    }
    constexpr double kCount = kSide * kSide;
    EXPECT_NEAR(sum / kCount, 0.5, 0.015);
    EXPECT_NEAR(squares / kCount, 1.0 / 12, 0.005);
    // Five standard deviations of a mean of products of even numbers.
    for (const double shared : {beside, below, other}) EXPECT_NEAR(shared / kCount, 0, 5.0 / 12 / 100);
    for (const int bin : bins) EXPECT_NEAR(bin, kCount / 16, 5 * std::sqrt(kCount / 16));
    EXPECT_LT(least, 0.002F);
    EXPECT_GT(most, 0.998F);
  }
}

TEST(Noise, RunsLevelThroughTheLatticeAndMeetsTheMeanHalfway) {
  for (const auto& place : {std::pair{3, 7}, {-4, 2}, {-1, -1}, {0, 0}, {12, -9}}) {
    const int x = place.first, y = place.second;
    const auto at = [&](float u, float v) {
      return value_noise(static_cast<float>(x) + u, static_cast<float>(y) + v, 5);
    };
    const float a = lattice_random(x, y, 5), b = lattice_random(x + 1, y, 5);
    const float c = lattice_random(x, y + 1, 5), d = lattice_random(x + 1, y + 1, 5);
    EXPECT_NEAR(at(0, 0), a, 1e-6);
    EXPECT_NEAR(at(0.5F, 0), (a + b) / 2, 1e-5);
    EXPECT_NEAR(at(0, 0.5F), (a + c) / 2, 1e-5);
    EXPECT_NEAR(at(0.5F, 0.5F), (a + b + c + d) / 4, 1e-5);
    // 3 u^2 - 2 u^3, the curve that is level at both ends, a quarter of the way.
    constexpr float kQuarter = 0.15625F;
    EXPECT_NEAR(at(0.25F, 0), a + (b - a) * kQuarter, 1e-5);
    EXPECT_NEAR(at(0, 0.25F), a + (c - a) * kQuarter, 1e-5);
    const float top = a + (b - a) * kQuarter, low = c + (d - c) * kQuarter;
    EXPECT_NEAR(at(0.25F, 0.25F), top + (low - top) * kQuarter, 1e-5);
  }
}

TEST(Noise, AlongALineIsTheNoiseOfThePlane) {
  for (const float y : {0.5F, 3.25F, 7.5F}) {
    const NoiseLine line(y, 5);
    // -8 and 55 are the first and the last of the values that are drawn beforehand.
    for (float x = -12; x < 60; x += 0.125F) EXPECT_NEAR(line.at(x), value_noise(x, y, 5), 1e-6) << x;
  }
}

TEST(Noise, ALineThatMovesIsTheNoiseOfItsNewPlace) {
  NoiseLine line(0.5F, 5, -2.5F, 3.5F);
  for (const float y : {-3.75F, 0.0F, 2.125F}) {
    line.set_y(y);
    for (float x = -6; x < 8; x += 0.125F)
      EXPECT_NEAR(line.at(x), value_noise(x, y, 5), 1e-6) << x << ' ' << y;
  }
}

TEST(GrainLine, IsTheGrainOfItsRow) {
  for (const Style style : {Style::wood, Style::slate}) {
    const Material material(style, Theme::light);
    GrainLine line(style, -0.05F, 0.05F);
    for (const float y : {-0.05F, 0.0F, 0.0371F}) {
      line.set_y(y);
      for (float x = -0.05F; x <= 0.05F; x += 0.0007F) {
        const Grain along = line.at(x), alone = material.grain({x, y});
        EXPECT_NEAR(along.across_m, alone.across_m, 1e-6) << x;
        EXPECT_NEAR(along.cloud, alone.cloud, 1e-4) << x;
        EXPECT_NEAR(along.detail, alone.detail, 1e-3) << x;
      }
    }
  }
}

TEST(Material, ARowHasTheColoursOfItsPoints) {
  for (const Style style : {Style::wood, Style::slate}) {
    const Material material(style, Theme::dark);
    MaterialRow row(7);
    row.y_m = 0.013F;
    row.count = 5;
    row.red[5] = -1;
    for (std::size_t i = 0; i < row.count; ++i) {
      const auto part = static_cast<float>(i) / 4;
      row.x_m[i] = 0.09F * part - 0.04F;
      row.z_m[i] = -0.01F * part;
      row.carved[i] = part;
      row.set_grain(i, material.grain({row.x_m[i], row.y_m}));
    }
    material.colour(row);
    for (std::size_t i = 0; i < row.count; ++i) {
      const glm::vec3 alone = material.reflectance({row.x_m[i], row.y_m, row.z_m[i]}, row.carved[i]);
      EXPECT_FLOAT_EQ(row.red[i], alone.x);
      EXPECT_FLOAT_EQ(row.green[i], alone.y);
      EXPECT_FLOAT_EQ(row.blue[i], alone.z);
    }
    EXPECT_EQ(row.red[5], -1) << "what is not in use stays";
  }
}

struct Substance {
  Style style;
  Theme theme;
  std::uint32_t pale;
  std::uint32_t deep;
};

class Substances : public testing::TestWithParam<Substance> {
 protected:
  /// Reflectances all over the face and in its depth.
  [[nodiscard]] std::vector<glm::vec3> sampled(float carved) const {
    const Material material(GetParam().style, GetParam().theme);
    std::vector<glm::vec3> all;
    for (float x = -0.05F; x <= 0.05F; x += 0.00037F)
      for (float y = -0.05F; y <= 0.05F; y += 0.0011F)
        all.push_back(material.reflectance({x, y, -0.01F * carved}, carved));
    return all;
  }
};

INSTANTIATE_TEST_SUITE_P(View, Substances,
                         testing::Values(Substance{Style::wood, Theme::light, 0xF1DFBD, 0xDDB989},
                                         Substance{Style::wood, Theme::dark, 0x735B43, 0x563F2B},
                                         Substance{Style::slate, Theme::light, 0x5B646B, 0x485057},
                                         Substance{Style::slate, Theme::dark, 0x383D42, 0x2B2F33}));

TEST_P(Substances, LieBetweenTheirTwoColoursAndVaryLittleMore) {
  const glm::vec3 pale = linear_from_srgb(from_hex(GetParam().pale));
  const glm::vec3 deep = linear_from_srgb(from_hex(GetParam().deep));
  const std::vector<glm::vec3> all = sampled(0);
  glm::vec3 mean(0);
  double within = 0;
  for (const glm::vec3& colour : all) {
    mean = mean + colour / static_cast<float>(all.size());
    const float share = (colour.y - deep.y) / (pale.y - deep.y);
    within += share > -0.3F && share < 1.3F ? 1.0 / static_cast<double>(all.size()) : 0;
    EXPECT_GT(colour.y, deep.y * 0.80F);
    EXPECT_LT(colour.y, pale.y * 1.6F);
  }
  EXPECT_GT(within, 0.97);
  EXPECT_LT(mean.y, pale.y);
  EXPECT_GT(mean.y, deep.y);
  // The hue of the mean is that of the two colours.
  EXPECT_GT(mean.x / mean.z, std::min(pale.x / pale.z, deep.x / deep.z) * 0.99F);
  EXPECT_LT(mean.x / mean.z, std::max(pale.x / pale.z, deep.x / deep.z) * 1.01F);
  // The colour varies in depth, too.
  double spread = 0;
  for (const glm::vec3& colour : all)
    spread += std::pow(colour.y / mean.y - 1, 2) / static_cast<double>(all.size());
  EXPECT_GT(std::sqrt(spread), 0.02);
  EXPECT_LT(std::sqrt(spread), 0.2);
}

TEST(Rings, TheTableSaysWhatTheirDefinitionSays) {
  double most = 0;
  for (int i = 0; i <= 60 * 997; ++i) {
    const float radius = static_cast<float>(i) / 997;
    most = std::max<double>(most, std::abs(Rings::shared().at(radius) - Rings::late_wood(radius)));
  }
  EXPECT_LT(most, 0.004);
  for (const float radius : {47.99F, 48.0F, 60.0F})
    EXPECT_NEAR(Rings::shared().at(radius), Rings::late_wood(radius), 0.004) << radius;
}

TEST(Rings, AreAsManyAsTheRadiusSaysAndLateWoodEndsWithinATenthOfARing) {
  int ends = 0;
  float before = 0, high = 0;
  int since_high = 0;
  for (int i = 0; i <= 40 * 1000; ++i) {
    const float late = Rings::late_wood(static_cast<float>(i) / 1000);
    ASSERT_LT(std::abs(late - before), 0.08) << i << ": no step";
    if (late > 0.35F && late >= before) {
      high = late;
      since_high = 0;
    } else {
      ++since_high;
    }
    if (high > 0 && late < 0.01F) {
      ++ends;
      EXPECT_LE(since_high, 250) << i;
      high = 0;
    }
    before = late;
  }
  EXPECT_NEAR(ends, 40, 2);
}

TEST(Wood, HasRingsThatRunAlongTheBoardAndEndAtOnce) {
  const Material wood(Style::wood, Theme::light);
  const auto light = [&](float x, float y) { return wood.reflectance({x, y, 0}, 0).y; };
  // Along the grain neighbouring places are more alike than across it.
  double along = 0, across = 0;
  for (float x = -0.045F; x < 0.045F; x += 0.0013F) {
    for (float y = -0.045F; y < 0.045F; y += 0.0017F) {
      along += std::abs(light(x, y) - light(x, y + 0.002F));
      across += std::abs(light(x, y) - light(x + 0.002F, y));
    }
  }
  EXPECT_GT(across, 1.5 * along);
}

TEST(Wood, ItsRingsGoDownIntoTheGrooves) {
  const Material wood(Style::wood, Theme::dark);
  int differ = 0;
  for (float x = -0.045F; x < 0.045F; x += 0.001F)
    differ +=
        std::abs(wood.reflectance({x, 0, 0}, 0).y - wood.reflectance({x, 0, -0.008F}, 0).y) > 0.004F ? 1 : 0;
  EXPECT_GT(differ, 20);
  // The carving does not change the wood itself.
  EXPECT_EQ(wood.reflectance({0.01F, 0.02F, -0.003F}, 0), wood.reflectance({0.01F, 0.02F, -0.003F}, 1));
}

TEST(Slate, IsPalerWhereItWasCutAndFullySoFromAQuarterOfTheDepthOn) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const Material slate(Style::slate, theme);
    const glm::vec3 fresh = linear_from_srgb(from_hex(theme == Theme::light ? 0x838C92 : 0x565C61));
    double face = 0, eighth = 0, quarter = 0, full = 0, count = 0;
    for (float x = -0.045F; x < 0.045F; x += 0.003F) {
      for (float y = -0.045F; y < 0.045F; y += 0.003F) {
        const auto light = [&](float carved) { return slate.reflectance({x, y, 0}, carved).y; };
        face += light(0);
        eighth += light(0.125F);
        quarter += light(0.25F);
        full += light(1);
        ++count;
      }
    }
    EXPECT_NEAR(eighth, (face + quarter) / 2, 0.02 * face);
    EXPECT_EQ(quarter, full);
    // Three quarters of the way to freshly cut stone.
    EXPECT_NEAR(full, face + 0.75 * (fresh.y * count - face), 0.02 * full);
  }
}

}  // namespace
}  // namespace nazori::view
