// SPDX-License-Identifier: Apache-2.0
// Pictures against tables of facts. Another table and other sizes can be given in the environment:
// NAZORI_CURVES=FILE NAZORI_CURVE_SIZES=256,512,1024 NAZORI_HALF_WIDTH=0.0125 NAZORI_CURVE_TIMES=1
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>

#include "curve_facts.h"
#include "test_paths.h"

namespace nazori::functions::test {
namespace {

std::string setting(const char* name, std::string otherwise) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): before any thread
  return value != nullptr ? value : std::move(otherwise);
}

constexpr std::size_t kParts = 8;

/// An eighth of the table, so that the parts run in parallel.
class CurveFactsOfPart : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Parts, CurveFactsOfPart, testing::Range(std::size_t{0}, kParts));

TEST_P(CurveFactsOfPart, EveryPictureAgreesWithWhatIsKnownOfItBefore) {
  const auto table =
      facts_of_file(setting("NAZORI_CURVES", std::string(test_paths::kFixtures) + "/curves.json"));
  ASSERT_GT(table.size(), 0U);
  std::istringstream sizes(setting("NAZORI_CURVE_SIZES", "256"));
  const double half_width = std::stod(setting("NAZORI_HALF_WIDTH", "0.0125"));
  const bool times = setting("NAZORI_CURVE_TIMES", "0") == "1";
  for (std::string size; std::getline(sizes, size, ',');) {
    int good = 0;
    for (std::size_t i = GetParam(); i < table.size(); i += kParts) {
      const CurveFacts& f = table[i];
      const auto start = std::chrono::steady_clock::now();
      const auto bad = disagreements(f, std::stoi(size), half_width);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      if (times && took.count() > 0.3)
        std::printf("%6.2f s %s %s\n", took.count(), f.id.c_str(), size.c_str());
      good += bad.empty() ? 1 : 0;
      std::string lines;
      for (const std::string& line : bad) lines += "\n  " + line;
      EXPECT_TRUE(bad.empty()) << f.id << " " << f.expression << " at " << size << lines;
    }
    if (times) std::printf("%s: %d agree\n", size.c_str(), good);
  }
}

// The closed form: across a straight line at any angle, and across a circle along its radius, the distance to
// the curve is the step itself.
TEST(WidthOfGrooves, IsTheSameAtEveryAngleAndPlaceFrom256SamplesOn) {
  constexpr double kHalfWidth = 0.0125;
  std::mt19937 random(20'050'801);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  PlateSettings settings;
  settings.layers = Layers::none();
  double worst = 0;
  for (const int size : {256, 384, 512}) {
    settings.size = size;
    for (int i = 0; i < 40; ++i) {
      const double angle = std::acos(-1.0) * any(random);
      const double a = 0.4 + 0.2 * any(random);
      const double b = 0.4 + 0.2 * any(random);
      const double radius = 0.1 + 0.25 * any(random);
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const auto line = parse(fmt::format("{:.17f} (x - {:.17f}) + {:.17f} (y - {:.17f}) = 0", c, a, s, b));
      const auto circle = parse(fmt::format("(x - {:.17f})^2 + (y - {:.17f})^2 = {:.17f}^2", a, b, radius));
      ASSERT_TRUE(line && circle);
      const auto straight = draw(*line, {0, 1, 0, 1}, settings);
      const auto round = draw(*circle, {0, 1, 0, 1}, settings);
      ASSERT_TRUE(straight && round);
      for (const double width :
           {relative_width(straight->plate, a, b, c, s, kHalfWidth),
            relative_width(round->plate, a + radius * c, b + radius * s, c, s, kHalfWidth)}) {
        worst = std::max(worst, std::abs(width - 1));
        EXPECT_NEAR(width, 1, 0.02) << size << " angle " << angle << " at " << a << ", " << b;
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

}  // namespace
}  // namespace nazori::functions::test
