// SPDX-License-Identifier: Apache-2.0
// How many characters of a font are models to write after, and what they look like.
//   nazori_font_figures KANJI.DB FAMILY [CHARACTERS [PICTURE.png]]
// fits the strokes of each character to the font. Without CHARACTERS: kana and the kanji of grades 1 and 2.
// The picture shows the ink of the font in grey, the strokes in colours and their middle lines, each from a
// dot at its start; a red frame says that the fit is poor.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "nazori/author/font_model.h"
#include "nazori/author/font_picture.h"
#include "nazori/base/utf8.h"
#include "nazori/geometry/polyline.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/surface/colour_picture.h"

namespace {

using namespace nazori;

constexpr int kCell = 256;
constexpr int kColumns = 8;

using Colour = std::array<double, 3>;

class Sheet {
 public:
  explicit Sheet(std::size_t cells) {
    const int rows = static_cast<int>((cells + kColumns - 1) / kColumns);
    picture_.width = kCell * kColumns;
    picture_.height = kCell * rows;
    picture_.rgb.assign(
        std::size_t{3} * static_cast<std::size_t>(picture_.width) * static_cast<std::size_t>(picture_.height),
        255);
  }
  void blend(int cell, int x, int y, const Colour& colour, double share) {
    if (x < 0 || y < 0 || x >= kCell || y >= kCell) return;
    const int column = cell % kColumns * kCell + x;
    const int row = cell / kColumns * kCell + y;
    const auto at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture_.width) +
                         static_cast<std::size_t>(column));
    for (std::size_t k = 0; k < 3; ++k)
      picture_.rgb[at + k] =
          static_cast<std::uint8_t>(picture_.rgb[at + k] * (1 - share) + colour[k] * share);
  }
  [[nodiscard]] const surface::ColourPicture& picture() const { return picture_; }

 private:
  surface::ColourPicture picture_;
};

void draw(Sheet& sheet, int cell, const author::FontStrokes& found, const scan::Photo& glyph, bool fits) {
  constexpr std::array kColours{Colour{220, 40, 40},  Colour{40, 120, 220}, Colour{20, 160, 60},
                                Colour{230, 140, 0},  Colour{150, 40, 190}, Colour{0, 160, 170},
                                Colour{190, 90, 120}, Colour{110, 110, 0}};
  constexpr double kScale = kCell / geometry::kGlyphSide;
  for (int y = 0; y < kCell; ++y)
    for (int x = 0; x < kCell; ++x) {
      sheet.blend(cell, x, y, {60, 60, 60}, 0.5 * (1 - glyph.at(x, y) / 255.0));
      if (!fits && (x < 3 || y < 3)) sheet.blend(cell, x, y, {255, 0, 0}, 1);
    }
  for (std::size_t k = 0; k < found.strokes.size(); ++k) {
    const auto& points = found.strokes[k].points;
    const Colour& colour = kColours[k % kColours.size()];
    for (int y = 0; y < kCell; ++y)
      for (int x = 0; x < kCell; ++x) {
        const geometry::GlyphPoint p{(x + 0.5) / kScale, (y + 0.5) / kScale};
        double rim = 1e9, line = 1e9;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
          const double share = geometry::nearest_share(p, points[i].at, points[i + 1].at);
          const double d = geometry::distance(p, points[i].at + (points[i + 1].at - points[i].at) * share);
          line = std::min(line, d);
          rim = std::min(
              rim, d - points[i].half_width - (points[i + 1].half_width - points[i].half_width) * share);
        }
        if (rim < 0) sheet.blend(cell, x, y, colour, rim > -0.45 ? 0.9 : 0.35);
        if (line < 0.3 || geometry::distance(p, points.front().at) < 1.2)
          sheet.blend(cell, x, y, {0, 0, 0}, 0.8);
      }
  }
}

std::u32string wanted(const kanji::KanjiDatabase& database, const std::string& given) {
  if (!given.empty()) return base::decode_utf8(given).value_or(U"");
  std::u32string all;
  for (const auto list :
       {kanji::List::hiragana, kanji::List::katakana, kanji::List::grade_1, kanji::List::grade_2})
    for (const kanji::Summary& one : database.list(list)) all.push_back(one.code_point);
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i) { return argc > i ? std::string(argv[i]) : std::string(); };
  auto database = kanji::KanjiDatabase::open(argument(1));
  if (!database) {
    std::fprintf(stderr, "%s\n", base::to_line(database.error()).c_str());
    return 1;
  }
  const std::string family = argument(2);
  const std::u32string characters = wanted(*database, argument(3));
  Sheet sheet(characters.size());
  int there = 0, fitting = 0;
  double covered = 0, outside = 0, seconds = 0, slowest = 0;
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const char32_t c = characters[i];
    const auto character = database->find(c);
    if (!character) continue;
    const auto start = std::chrono::steady_clock::now();
    const auto found = author::font_strokes(c, character->lines(), family);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    const std::string name = base::encode_utf8(c);
    if (!found) {
      std::printf("%s %s\n", name.c_str(), base::to_line(found.error()).c_str());
      continue;
    }
    ++there;
    seconds += took.count();
    slowest = std::max(slowest, took.count());
    const bool fits = author::is_good_fit(found->fit);
    if (fits) {
      ++fitting;
      covered += found->fit.covered;
      outside += found->fit.outside;
    }
    std::printf("%s %s covered %.3f outside %.3f on ink %.2f alone %.2f moved %.1f %.0f ms\n", name.c_str(),
                fits ? "fits" : "poor", found->fit.covered, found->fit.outside, found->fit.on_ink,
                found->fit.alone, found->fit.moved, 1000 * took.count());
    if (argc > 4)
      if (const auto glyph = author::font_picture(c, family, kCell))
        draw(sheet, static_cast<int>(i), *found, *glyph, fits);
  }
  std::printf(
      "%s: %zu characters, %d in the font, %d fit (%.1f %%); of these %.1f %% of the ink are covered, %.1f "
      "%% of the "
      "strokes are outside; %.0f ms a character, %.0f ms the slowest\n",
      family.c_str(), characters.size(), there, fitting, 100.0 * fitting / std::max(1, there),
      100 * covered / std::max(1, fitting), 100 * outside / std::max(1, fitting),
      1000 * seconds / std::max(1, there), 1000 * slowest);
  if (argc > 4)
    if (auto saved = surface::save_png(sheet.picture(), argument(4)); !saved) {
      std::fprintf(stderr, "%s\n", base::to_line(saved.error()).c_str());
      return 1;
    }
  return 0;
}
