// SPDX-License-Identifier: Apache-2.0
#include "number_labels.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string_view>

#include "nazori/geometry/polyline.h"
#include FT_FREETYPE_H

namespace nazori::view {
namespace {

constexpr int kColumns = 8;
/// Height of the digits as a fraction of the cell, for numbers of one, two and more digits.
constexpr std::array<double, 3> kDigitHeight{0.52, 0.44, 0.32};

/// Coverage of one character.
struct Glyph {
  int width = 0;
  int height = 0;
  int advance = 0;
  int left = 0;
  int top = 0;  ///< rows above the base line
  std::vector<std::uint8_t> coverage;
};

std::size_t place_in(int width, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

/// Figures of straight pieces on a field 4 wide and 6 high, y down: pairs of points.
using Figure = std::vector<std::array<glm::dvec2, 2>>;

Figure figure_from(std::string_view path) {
  Figure figure;
  glm::dvec2 last{-1, -1};
  for (std::size_t i = 0; i + 1 < path.size(); i += 3) {
    const glm::dvec2 p(path[i] - '0', path[i + 1] - '0');
    if (last.x >= 0) figure.push_back({last, p});
    last = path[i + 2 < path.size() ? i + 2 : i] == '/' ? glm::dvec2(-1, -1) : p;
  }
  return figure;
}

const Figure& built_in_figure(int digit) {
  static const std::array<Figure, 10> figures{
      figure_from("10 30 41 45 36 16 05 01 10"),
      figure_from("11 20 26/16 36"),
      figure_from("01 10 30 41 42 06 46"),
      figure_from("00 40 22 33 44 45 36 16 05"),
      figure_from("30 04 44/30 36"),
      figure_from("40 00 03 12 32 43 45 36 16 05"),
      figure_from("31 20 10 02 05 16 36 45 44 33 13 04"),
      figure_from("00 40 16"),
      figure_from("10 30 41 42 33 13 02 01 10/13 04 05 16 36 45 44 33"),
      figure_from("42 33 13 02 01 10 30 41 44 26 16")};
  return figures[static_cast<std::size_t>(digit)];
}

/// Of what stands in numbers besides digits; empty for other characters.
const Figure& built_in_sign(char sign) {
  static const Figure minus = figure_from("03 43");
  static const Figure plus = figure_from("03 43/21 25");
  static const Figure point = figure_from("26 26");
  static const Figure power = figure_from("04 44 33 13 04 05 16 36");
  static const Figure none;
  switch (sign) {
    case '-':
      return minus;
    case '+':
      return plus;
    case '.':
      return point;
    case 'e':
      return power;
    default:
      return none;
  }
}

Glyph built_in_glyph(const Figure& figure, int pixels) {
  const double unit = pixels / 6.9;
  const double half = 0.45 * unit;
  Glyph glyph;
  glyph.height = pixels;
  glyph.width = static_cast<int>(std::ceil(4 * unit + 2 * half));
  glyph.advance = glyph.width + std::max(1, static_cast<int>(unit * 0.9));
  glyph.top = glyph.height;
  for (int y = 0; y < glyph.height; ++y) {
    for (int x = 0; x < glyph.width; ++x) {
      const glm::dvec2 p(x + 0.5 - half, y + 0.5 - half);
      double nearest = 1e9;
      for (const auto& piece : figure) {
        const glm::dvec2 from = piece[0] * unit;
        const glm::dvec2 to = piece[1] * unit;
        nearest = std::min(nearest, geometry::distance_to_segment(p, from, to));
      }
      glyph.coverage.push_back(
          static_cast<std::uint8_t>(std::lround(std::clamp(half + 0.5 - nearest, 0.0, 1.0) * 255)));
    }
  }
  return glyph;
}

/// The file of the best sans-serif bold face that has all ten digits.
std::string find_font_file() {
  std::string file;
  FcConfig* config = FcInitLoadConfigAndFonts();
  if (config == nullptr) return file;
  FcPattern* wanted = FcNameParse(reinterpret_cast<const FcChar8*>("sans-serif:bold"));
  FcCharSet* digits = FcCharSetCreate();
  for (FcChar32 c = '0'; c <= '9'; ++c) FcCharSetAddChar(digits, c);
  FcPatternAddCharSet(wanted, FC_CHARSET, digits);
  FcPatternAddBool(wanted, FC_SCALABLE, FcTrue);
  FcConfigSubstitute(config, wanted, FcMatchPattern);
  FcDefaultSubstitute(wanted);
  FcResult result = FcResultNoMatch;
  FcPattern* found = FcFontMatch(config, wanted, &result);
  if (found != nullptr) {
    FcChar8* name = nullptr;
    if (FcPatternGetString(found, FC_FILE, 0, &name) == FcResultMatch)
      file = reinterpret_cast<const char*>(name);
    FcPatternDestroy(found);
  }
  FcCharSetDestroy(digits);
  FcPatternDestroy(wanted);
  FcConfigDestroy(config);
  return file;
}

}  // namespace

struct NumberFont::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }

  bool open() {
    const std::string file = find_font_file();
    if (file.empty() || FT_Init_FreeType(&library) != 0) return false;
    if (FT_New_Face(library, file.c_str(), 0, &face) != 0) {
      face = nullptr;
      return false;
    }
    for (FT_ULong c = '0'; c <= '9'; ++c) {
      if (FT_Get_Char_Index(face, c) == 0) return false;
    }
    return FT_IS_SCALABLE(face) != 0;
  }

  /// A character, so large that the upper edge of a digit lies `pixels` above the base line; nothing where
  /// the face fails.
  [[nodiscard]] Glyph draw(FT_ULong code, int pixels) const {
    Glyph glyph;
    // Figures of a sans-serif face are close to 0.73 em high; measured on the zero rather than assumed.
    if (FT_Load_Char(face, '0', FT_LOAD_NO_SCALE) != 0) return glyph;
    const double units = static_cast<double>(face->glyph->metrics.height);
    const double em = face->units_per_EM;
    const double size = units > 0 ? pixels * em / units : pixels * 1.37;
    if (FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(std::max(1L, std::lround(size)))) != 0) return glyph;
    if (FT_Load_Char(face, code, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0) return glyph;
    const FT_GlyphSlot slot = face->glyph;
    const FT_Bitmap& bitmap = slot->bitmap;
    if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY) return glyph;
    glyph.width = static_cast<int>(bitmap.width);
    glyph.height = static_cast<int>(bitmap.rows);
    glyph.advance = static_cast<int>(slot->advance.x >> 6);
    glyph.left = slot->bitmap_left;
    glyph.top = slot->bitmap_top;
    for (int y = 0; y < glyph.height; ++y) {
      const unsigned char* row = bitmap.buffer + static_cast<std::ptrdiff_t>(y) * bitmap.pitch;
      glyph.coverage.insert(glyph.coverage.end(), row, row + glyph.width);
    }
    return glyph;
  }
};

NumberFont::NumberFont(std::unique_ptr<Face> face) : face_(std::move(face)) {}
NumberFont::NumberFont() : face_(std::make_unique<Face>()) {
  if (!face_->open()) face_.reset();
}
NumberFont::~NumberFont() = default;
NumberFont::NumberFont(NumberFont&&) noexcept = default;
NumberFont& NumberFont::operator=(NumberFont&&) noexcept = default;
NumberFont NumberFont::built_in() { return NumberFont(nullptr); }

std::string NumberFont::family() const {
  if (!face_ || face_->face->family_name == nullptr) return "built-in";
  return face_->face->family_name;
}

LabelSheet NumberFont::draw(int count, int cell) const {
  LabelSheet sheet;
  sheet.cell = cell;
  sheet.columns = std::min(count, kColumns);
  sheet.rows = (count + kColumns - 1) / kColumns;
  const int width = sheet.columns * cell;
  sheet.coverage.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(sheet.rows * cell), 0);
  for (int number = 1; number <= count; ++number) {
    const std::string digits = std::to_string(number);
    const double share = kDigitHeight[std::min(digits.size(), kDigitHeight.size()) - 1];
    const int pixels = std::max(5, static_cast<int>(std::lround(cell * share)));
    std::vector<Glyph> glyphs;
    int run = 0;
    int left = 0;
    int right = 0;
    for (const char digit : digits) {
      Glyph glyph = face_ ? face_->draw(static_cast<FT_ULong>(digit), pixels) : Glyph{};
      if (glyph.coverage.empty()) glyph = built_in_glyph(built_in_figure(digit - '0'), pixels);
      if (glyphs.empty()) left = glyph.left;
      right = run + glyph.left + glyph.width;
      run += glyph.advance;
      glyphs.push_back(std::move(glyph));
    }
    const int cell_left = (number - 1) % kColumns * cell;
    const int cell_top = (number - 1) / kColumns * cell;
    int pen = (cell - (right - left)) / 2 - left;
    for (const Glyph& glyph : glyphs) {
      const int top = (cell - glyph.height) / 2;
      for (int y = 0; y < glyph.height; ++y) {
        for (int x = 0; x < glyph.width; ++x) {
          const int to_x = pen + glyph.left + x;
          const int to_y = top + y;
          if (to_x < 0 || to_y < 0 || to_x >= cell || to_y >= cell) continue;
          auto& target = sheet.coverage[place_in(width, cell_left + to_x, cell_top + to_y)];
          target = std::max(target, glyph.coverage[place_in(glyph.width, x, y)]);
        }
      }
      pen += glyph.advance;
    }
  }
  return sheet;
}

LabelPicture NumberFont::draw_text(std::string_view text, int height, int margin) const {
  constexpr FT_ULong kMinus = 0x2212;
  std::vector<Glyph> glyphs;
  int run = 0, left = 0, right = 0, top = height, bottom = 0;
  for (const char c : text) {
    const bool is_digit = c >= '0' && c <= '9';
    const Figure& figure = is_digit ? built_in_figure(c - '0') : built_in_sign(c);
    if (figure.empty()) continue;
    Glyph glyph;
    if (face_) {
      const bool has_minus = c == '-' && FT_Get_Char_Index(face_->face, kMinus) != 0;
      const FT_ULong code = has_minus ? kMinus : static_cast<FT_ULong>(c);
      if (FT_Get_Char_Index(face_->face, code) != 0) glyph = face_->draw(code, height);
    }
    if (glyph.coverage.empty()) glyph = built_in_glyph(figure, height);
    if (glyphs.empty()) left = glyph.left;
    right = std::max(right, run + glyph.left + glyph.width);
    top = std::max(top, glyph.top);
    bottom = std::max(bottom, glyph.height - glyph.top);
    run += glyph.advance;
    glyphs.push_back(std::move(glyph));
  }
  LabelPicture picture;
  picture.width = right - left + 2 * margin;
  picture.height = top + bottom + 2 * margin;
  picture.coverage.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height),
                          0);
  int pen = margin - left;
  for (const Glyph& glyph : glyphs) {
    for (int y = 0; y < glyph.height; ++y) {
      for (int x = 0; x < glyph.width; ++x) {
        const int to_x = pen + glyph.left + x;
        const int to_y = margin + top - glyph.top + y;
        if (to_x < 0 || to_x >= picture.width) continue;
        auto& target = picture.coverage[place_in(picture.width, to_x, to_y)];
        target = std::max(target, glyph.coverage[place_in(glyph.width, x, y)]);
      }
    }
    pen += glyph.advance;
  }
  return picture;
}

}  // namespace nazori::view
