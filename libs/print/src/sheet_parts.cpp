// SPDX-License-Identifier: Apache-2.0
#include "sheet_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nazori/base/utf8.h"
#include "nazori/geometry/polyline.h"
#include "nazori/geometry/svg_path.h"
#include "nazori/kanji/own_characters.h"

namespace nazori::print {
namespace {

constexpr double kStrokeWidth = 3.6;  // glyph units
constexpr double kBrushWidth = 8;     // glyph units
constexpr double kBrushStep = 1.5;    // glyph units
constexpr double kThinnest = 0.12;    // of that, where a sweep ends
constexpr double kArrow = 7;          // glyph units
constexpr double kNumberGrey = 0.35;

bool is_latin(char32_t c) { return c < 0x2000 || (c >= 0x2010 && c <= 0x2027); }

}  // namespace

std::u32string wide(std::string_view utf8) { return base::decode_utf8(utf8).value_or(U""); }

void Flow::text(Canvas& canvas, double along, double across, std::u32string_view text, double size_mm,
                double grey) const {
  const Rect start = rect(along, across, 0, size_mm);
  if (!vertical_) {
    canvas.text(start.x, start.y + size_mm * 0.85, text, size_mm, grey);
    return;
  }
  if (std::all_of(text.begin(), text.end(), is_latin)) {
    canvas.turned_text(start.x + size_mm * 0.15, start.y, text, size_mm, grey);
    return;
  }
  double y = start.y;
  for (const char32_t c : text) {
    if (c != U' ') canvas.vertical_letter(start.x, y, c, size_mm, grey);
    y += c == U' ' ? size_mm / 2 : size_mm;
  }
}

void draw_cell(Canvas& canvas, const Rect& r, Guide guide) {
  const double x = r.x + r.width / 2;
  const double y = r.y + r.height / 2;
  if (guide != Guide::none) {
    const Pen pen{0.72, 0.15, guide == Guide::field ? 0 : std::min(1.0, r.width / 16)};
    canvas.line(x, r.y, x, r.y + r.height, pen);
    canvas.line(r.x, y, r.x + r.width, y, pen);
    if (guide == Guide::diagonals) {
      canvas.line(r.x, r.y, r.x + r.width, r.y + r.height, pen);
      canvas.line(r.x + r.width, r.y, r.x, r.y + r.height, pen);
    }
  }
  canvas.rectangle(r, {0.45, 0.25, 0});
}

std::string strokes_content(const kanji::Character& character, std::size_t first, std::size_t last) {
  std::string content = fmt::format("{} w 1 J 1 j\n", kStrokeWidth);
  for (std::size_t i = first; i < last; ++i) {
    const kanji::Stroke& stroke = character.strokes[i];
    const auto path = geometry::parse_svg_path(stroke.path);
    if (path) {
      content += fmt::format("{} {} m", number(path->start.x), number(path->start.y));
      for (const auto& piece : path->pieces) {
        for (const geometry::GlyphPoint p : piece) content += fmt::format(" {} {}", number(p.x), number(p.y));
        content += " c";
      }
    } else {
      for (std::size_t k = 0; k < stroke.line.points.size(); ++k) {
        const geometry::GlyphPoint p = stroke.line.points[k];
        content += fmt::format("{}{} {} {}", k == 0 ? "" : " ", number(p.x), number(p.y), k == 0 ? "m" : "l");
      }
    }
    content += " S\n";
  }
  return content;
}

std::string brush_content(const kanji::Character& character) {
  std::string content = "1 J 1 j\n";
  for (const kanji::Stroke& stroke : character.strokes) {
    const double length = geometry::arc_length<geometry::GlyphFrame>(stroke.line.points);
    const auto count = static_cast<std::size_t>(length / kBrushStep) + 2;
    const auto points = geometry::resample<geometry::GlyphFrame>(stroke.line.points, count);
    // What thins out, as a share of the stroke but not of a long one.
    const double thinning = stroke.line.ending == kanji::StrokeEnding::taper  ? std::min(0.6 * length, 30.0)
                            : stroke.line.ending == kanji::StrokeEnding::hook ? std::min(0.3 * length, 9.0)
                                                                              : 0.0;
    double at = 0;
    for (std::size_t k = 1; k < points.size(); ++k) {
      at += std::hypot(points[k].x - points[k - 1].x, points[k].y - points[k - 1].y);
      const double share = thinning > 0 ? std::min(1.0, (length - at) / thinning) : 1.0;
      content += fmt::format(
          "{} w {} {} m {} {} l S\n", number(kBrushWidth * (kThinnest + (1 - kThinnest) * std::sqrt(share))),
          number(points[k - 1].x), number(points[k - 1].y), number(points[k].x), number(points[k].y));
    }
  }
  return content;
}

void draw_numbers(Canvas& canvas, const kanji::Character& character, const Rect& square) {
  const double unit = square.width / geometry::kGlyphSide;
  for (std::size_t i = 0; i < character.strokes.size(); ++i) {
    const kanji::StrokeLine& line = character.strokes[i].line;
    if (line.points.empty()) continue;
    const geometry::GlyphPoint start = line.points.front();
    const geometry::GlyphPoint at =
        line.number_position.value_or(geometry::GlyphPoint{start.x - 8, start.y - 2});
    // A number at the edge of the box stays inside it.
    const double x = std::clamp(at.x, 0.0, geometry::kGlyphSide - (i < 9 ? 5.0 : 10.0));
    const double y = std::clamp(at.y, 8.0, geometry::kGlyphSide - 1);
    canvas.text(square.x + x * unit, square.y + y * unit, wide(std::to_string(i + 1)), 8.5 * unit,
                kNumberGrey);
  }
}

void draw_arrows(Canvas& canvas, const kanji::Character& character, const Rect& square) {
  const double unit = square.width / geometry::kGlyphSide;
  for (const kanji::Stroke& stroke : character.strokes) {
    const std::span<const geometry::GlyphPoint> line = stroke.line.points;
    const double length = geometry::arc_length(line);
    if (length < 1) continue;
    const double from = std::min(12.0, length * 0.4);
    const geometry::GlyphPoint back = geometry::point_at(line, from);
    const geometry::GlyphPoint tip = geometry::point_at(line, std::min(from + kArrow, length));
    const double size = geometry::distance(back, tip);
    if (size < 0.5) continue;
    const geometry::GlyphPoint along = (tip - back) * (1 / size);
    const geometry::GlyphPoint side{-along.y * kArrow / 2.6, along.x * kArrow / 2.6};
    const auto x = [&](geometry::GlyphPoint p) { return square.x + p.x * unit; };
    const auto y = [&](geometry::GlyphPoint p) { return square.y + p.y * unit; };
    const geometry::GlyphPoint left = back + side;
    const geometry::GlyphPoint right = back - side;
    canvas.triangle(x(tip), y(tip), x(left), y(left), x(right), y(right), 0.55);
  }
}

Facts facts_of(const kanji::Character& character) {
  const auto joined = [](const std::vector<std::string>& readings) {
    std::u32string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(readings.size(), 4); ++i) {
      if (!text.empty()) text += U'、';
      const std::u32string reading = wide(readings[i]);
      const std::size_t dot = reading.find(U'.');
      // Okurigana stand in brackets, as school books print them.
      text += dot == std::u32string::npos ? reading
                                          : reading.substr(0, dot) + U"(" + reading.substr(dot + 1) + U")";
    }
    return text;
  };
  Facts facts{joined(character.entry.on_readings), joined(character.entry.kun_readings), {}};
  int count = 0;
  for (const kanji::Meaning& meaning : character.entry.meanings) {
    if (meaning.language != "en" || count == 4) continue;
    facts.meanings += (count++ == 0 ? U"" : U", ") + wide(meaning.text);
  }
  return facts;
}

std::u32string text_of(const SheetCharacter& one) {
  if (kanji::is_own(one.character.code_point) && one.made && !one.made->name.empty())
    return wide(one.made->name);
  return {one.character.code_point};
}

std::u32string credits_of(std::span<const SheetCharacter> characters) {
  bool is_published = false;
  std::vector<std::string> makers;
  for (const SheetCharacter& one : characters) {
    const auto& made = one.made;
    is_published = is_published || !made || made->is_from_kanjivg;
    // A copy of a published form names its authors, and the line does so already.
    if (!made || made->author.empty() ||
        (made->is_from_kanjivg && made->author.find("KanjiVG") != std::string::npos))
      continue;
    std::string maker = made->author + (made->licence.empty() ? "" : ", " + made->licence);
    if (std::ranges::find(makers, maker) == makers.end()) makers.push_back(std::move(maker));
  }
  std::string line = is_published ? "KanjiVG, CC BY-SA 3.0" : "";
  for (const std::string& maker : makers) line += (line.empty() ? "" : "; ") + maker;
  return wide((line.empty() ? "" : "Strokes: " + line + ". ") + "Made with Nazori.");
}

std::u32string cut(Fonts& fonts, std::u32string text, double most) {
  if (fonts.width(text) <= most) return text;
  while (!text.empty() && fonts.width(text + U"…") > most) text.pop_back();
  return text.empty() ? text : text + U"…";
}

}  // namespace nazori::print
