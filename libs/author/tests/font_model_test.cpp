// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/font_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "characters.h"
#include "line_comparison.h"
#include "nazori/author/font_picture.h"

namespace nazori::author::test {
namespace {

// Of fonts-kouzan-mouhitsu and fonts-aoyagi-kouzan-t.
const std::string kKouzan = "KouzanBrushFont";
const std::string kAoyagi = "AoyagiKouzanFontT";
const std::string kPrinted = "Klee One";  // of fonts-klee, no brush font

struct Case {
  char32_t character;
  const char* name;
};
constexpr Case kCases[] = {{U'三', "三"}, {U'十', "十"}, {U'永', "永"}, {U'休', "休"}};

kanji::StrokeLine straight(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y1}}, kanji::StrokeEnding::stop, {}};
}

bool has_ink(const scan::Photo& picture, GlyphPoint at) {
  const double scale = picture.width / geometry::kGlyphSide;
  return picture.sample(at.x * scale - 0.5, at.y * scale - 0.5) < 128;
}

TEST(FontModel, LiesInTheInkOfTheFontWhereItStandsInItsSquare) {
  for (const std::string& family : {kKouzan, kAoyagi, kPrinted})
    for (const Case& c : kCases) {
      const auto model = font_model(c.character, kanjivg(c.name), family);
      ASSERT_TRUE(model) << family << ' ' << c.name << ": " << base::to_line(model.error());
      const auto picture = font_picture(c.character, family, 700).value();
      int points = 0, inked = 0;
      for (const OwnStroke& stroke : model->strokes)
        for (const GroovePoint& point : stroke.points) {
          ++points;
          inked += has_ink(picture, point.at) ? 1 : 0;
        }
      EXPECT_GT(inked, 0.93 * points) << family << ' ' << c.name;
    }
}

/// Share of the dark pixels that lie in a stroke.
double covered(const scan::Photo& picture, const std::vector<OwnStroke>& strokes) {
  int dark = 0, in_strokes = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at(x, y) >= 128) continue;
      ++dark;
      const double unit = geometry::kGlyphSide / picture.width;
      const GlyphPoint at{(x + 0.5) * unit, (y + 0.5) * unit};
      in_strokes += std::any_of(strokes.begin(), strokes.end(), [at](const OwnStroke& stroke) {
        return std::any_of(stroke.points.begin(), stroke.points.end(), [at](const GroovePoint& point) {
          return geometry::distance(point.at, at) <= point.half_width;
        });
      });
    }
  return static_cast<double>(in_strokes) / dark;
}

TEST(FontModel, CoversTheInkOfTheFontAndSaysHowMuch) {
  for (const std::string& family : {kKouzan, kAoyagi})
    for (const Case& c : kCases) {
      const auto model = font_model(c.character, kanjivg(c.name), family);
      ASSERT_TRUE(model) << family << ' ' << c.name;
      const double share = covered(font_picture(c.character, family, 150).value(), model->strokes);
      EXPECT_GT(share, 0.82) << family << ' ' << c.name;
      EXPECT_NEAR(share, model->fit.covered, 0.04) << family << ' ' << c.name;
    }
}

TEST(FontModel, HasOrderDirectionsAndEndingsOfTheKnownCharacter) {
  for (const std::string& family : {kKouzan, kAoyagi})
    for (const Case& c : kCases) {
      const auto known = kanjivg(c.name);
      const auto model = font_model(c.character, known, family);
      ASSERT_TRUE(model);
      ASSERT_EQ(model->strokes.size(), known.size());
      for (std::size_t k = 0; k < known.size(); ++k) {
        const OwnStroke& stroke = model->strokes[k];
        EXPECT_EQ(stroke.ending, known[k].ending);
        const GlyphPoint way = known[k].points.back() - known[k].points.front();
        EXPECT_GT(geometry::dot(stroke.points.back().at - stroke.points.front().at, way), 0)
            << family << ' ' << c.name << ' ' << k + 1;
      }
    }
  const auto bars = kanjivg("三");
  const auto upwards = font_model(U'三', std::vector{bars[2], bars[1], bars[0]}, kKouzan);
  ASSERT_TRUE(upwards);
  EXPECT_GT(upwards->strokes[0].points[0].at.y, upwards->strokes[1].points[0].at.y + 10);
  EXPECT_GT(upwards->strokes[1].points[0].at.y, upwards->strokes[2].points[0].at.y + 10);
}

TEST(FontModel, ASweepThinsOut) {
  // 永: the last stroke is broad before it ends in a point.
  const auto model = font_model(U'永', kanjivg("永"), kKouzan);
  ASSERT_TRUE(model);
  const auto& sweep = model->strokes[4].points;
  double widest = 0;
  for (const GroovePoint& point : sweep) widest = std::max(widest, point.half_width);
  EXPECT_LT(sweep.back().half_width, 0.4 * widest);
}

void expect_refused(const base::Result<FontStrokes>& model, base::Errc code) {
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().code, code) << base::to_line(model.error());
}

TEST(FontModel, OtherStrokesThanThoseOfTheFontAreRefused) {
  expect_refused(font_model(U'三', kanjivg("十"), kKouzan), base::Errc::not_found);
  expect_refused(font_model(U'十', kanjivg("三"), kKouzan), base::Errc::not_found);
  expect_refused(font_model(U'休', kanjivg("永"), kKouzan), base::Errc::not_found);
  // One stroke too many, and one too few.
  auto bars = kanjivg("三");
  bars.push_back(straight(54, 10, 54, 100));
  expect_refused(font_model(U'三', bars, kKouzan), base::Errc::not_found);
  expect_refused(font_model(U'三', std::vector{bars[0], bars[2]}, kKouzan), base::Errc::not_found);
}

TEST(FontModel, ACursiveFormIsRefused) {
  for (const Case& c : {Case{U'書', "書"}, Case{U'永', "永"}})
    expect_refused(font_model(c.character, kanjivg(c.name), "KouzanBrushFontSousyo"), base::Errc::not_found);
}

TEST(FontModel, WhatTheFontLacksAndWhatNoCharacterIsAreRefused) {
  const std::vector bar{straight(20, 54, 90, 54)};
  expect_refused(font_model(U'\U0010FFFD', bar, kKouzan), base::Errc::not_found);
  expect_refused(font_model(U'一', bar, "No Such Family"), base::Errc::not_found);
  expect_refused(font_model(U'\u3000', bar, kPrinted), base::Errc::not_found);  // a space has no ink
  expect_refused(font_model(U'一', {}, kKouzan), base::Errc::bad_argument);
  expect_refused(font_model(U'一', std::vector{straight(20, NAN, 90, 54)}, kKouzan),
                 base::Errc::bad_argument);
}

TEST(GoodFit, NeedsInkUnderAllStrokesAndStrokesOverAllInk) {
  const FontFit good{.covered = 0.95, .outside = 0.05, .on_ink = 0.98, .alone = 0.7, .moved = 2};
  EXPECT_TRUE(is_good_fit(good));
  const std::pair<double FontFit::*, double> bad[] = {{&FontFit::covered, 0.6},
                                                      {&FontFit::outside, 0.5},
                                                      {&FontFit::on_ink, 0.5},
                                                      {&FontFit::alone, 0.05},
                                                      {&FontFit::moved, 30}};
  for (const auto& [measure, value] : bad) {
    FontFit fit = good;
    fit.*measure = value;
    EXPECT_FALSE(is_good_fit(fit)) << value;
  }
}

TEST(BrushFonts, ThoseThatAreInstalledAreSomeOfThoseKnown) {
  const auto installed = installed_brush_fonts();
  const auto has = [](const auto& fonts, const std::string& family) {
    return std::any_of(fonts.begin(), fonts.end(),
                       [&family](const BrushFont& font) { return font.family == family; });
  };
  EXPECT_TRUE(has(installed, kKouzan));
  EXPECT_TRUE(has(installed, kAoyagi));
  EXPECT_FALSE(has(installed, kPrinted));
  for (const BrushFont& font : installed) {
    EXPECT_TRUE(has(brush_fonts(), std::string(font.family)));
    EXPECT_FALSE(font.package.empty());
  }
}

}  // namespace
}  // namespace nazori::author::test
