// SPDX-License-Identifier: Apache-2.0
#include "canvas.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "nazori/geometry/point.h"

namespace nazori::print {
namespace {

constexpr double kPoints = 72 / 25.4;
constexpr double kEmAscent = 0.88;

}  // namespace

std::string number(double value) {
  const long units = std::lround(value * 100);
  std::string text = units < 0 ? "-" : "";
  const long size = std::labs(units);
  text += std::to_string(size / 100);
  if (size % 100 == 0) return text;
  text += '.';
  text += static_cast<char>('0' + size % 100 / 10);
  if (size % 10 != 0) text += static_cast<char>('0' + size % 10);
  return text;
}

std::string square_matrix(const Rect& square, double page_height_mm) {
  const double scale = square.width / geometry::kGlyphSide * kPoints;
  return fmt::format("{:.5g} 0 0 {:.5g} {} {} cm\n", scale, -scale, number(square.x * kPoints),
                     number((page_height_mm - square.y) * kPoints));
}

base::Result<Fonts> Fonts::installed() {
  Fonts fonts;
  auto klee = Font::installed("Klee One", "fonts-klee");
  if (!klee) return tl::unexpected(std::move(klee.error()));
  fonts.fonts_.push_back(*std::move(klee));
  auto gothic = Font::installed("IPAexGothic", "fonts-ipaexfont-gothic");
  if (!gothic) return tl::unexpected(std::move(gothic.error()));
  fonts.fonts_.push_back(*std::move(gothic));
  return fonts;
}

Fonts::Choice Fonts::choose(char32_t code_point, bool vertical) {
  for (const char32_t c : {code_point, U'〓'}) {
    for (std::size_t i = 0; i < fonts_.size(); ++i) {
      const GlyphId glyph = fonts_[i].glyph(c, vertical);
      if (glyph != 0) return {i, glyph};
    }
  }
  return {};
}

double Fonts::width(std::u32string_view text) {
  double sum = 0;
  for (const char32_t c : text) {
    const Choice choice = choose(c, false);
    sum += fonts_[choice.font].advance(choice.glyph);
  }
  return sum;
}

void Canvas::set(const Pen& pen) {
  content_ += fmt::format("{} G {} w ", number(pen.grey), number(pen.width_mm * kPoints));
  content_ += pen.dash_mm > 0 ? fmt::format("[{0} {0}] 0 d ", number(pen.dash_mm * kPoints)) : "[] 0 d ";
}

void Canvas::line(double x0, double y0, double x1, double y1, const Pen& pen) {
  set(pen);
  content_ += fmt::format("{} {} m {} {} l S\n", number(x0 * kPoints), number((height_mm_ - y0) * kPoints),
                          number(x1 * kPoints), number((height_mm_ - y1) * kPoints));
}

void Canvas::rectangle(const Rect& rect, const Pen& pen) {
  set(pen);
  content_ += fmt::format("{} {} {} {} re S\n", number(rect.x * kPoints),
                          number((height_mm_ - rect.y - rect.height) * kPoints), number(rect.width * kPoints),
                          number(rect.height * kPoints));
}

void Canvas::triangle(double x0, double y0, double x1, double y1, double x2, double y2, double grey) {
  content_ += fmt::format("{} g {} {} m {} {} l {} {} l f\n", number(grey), number(x0 * kPoints),
                          number((height_mm_ - y0) * kPoints), number(x1 * kPoints),
                          number((height_mm_ - y1) * kPoints), number(x2 * kPoints),
                          number((height_mm_ - y2) * kPoints));
}

void Canvas::disc(double x, double y, double radius) {
  constexpr double kBend = 0.5523;  // of the curves that are closest to a quarter of a circle
  const auto point = [&](double dx, double dy) {
    return number((x + dx * radius) * kPoints) + ' ' + number((height_mm_ - y - dy * radius) * kPoints) + ' ';
  };
  content_ += "0 g " + point(1, 0) + "m ";
  double cosine = 1;
  double sine = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    content_ += point(cosine - kBend * sine, sine + kBend * cosine);
    content_ += point(-sine + kBend * cosine, cosine + kBend * sine) + point(-sine, cosine) + "c ";
    const double turned = -sine;
    sine = cosine;
    cosine = turned;
  }
  content_ += "f\n";
}

void Canvas::fill(std::span<const Rect> rects) {
  content_ += "0 g";
  for (const Rect& r : rects)
    content_ +=
        fmt::format(" {} {} {} {} re", number(r.x * kPoints), number((height_mm_ - r.y - r.height) * kPoints),
                    number(r.width * kPoints), number(r.height * kPoints));
  content_ += " f\n";
}

void Canvas::show(std::u32string_view text, double size_mm, bool vertical) {
  std::size_t current = fonts_->count();
  std::string glyphs;
  const auto flush = [&] {
    if (!glyphs.empty())
      content_ += fmt::format("/F{} {} Tf <{}> Tj ", current, number(size_mm * kPoints), glyphs);
    glyphs.clear();
  };
  for (const char32_t c : text) {
    const Fonts::Choice choice = fonts_->choose(c, vertical);
    if (choice.font != current) flush();
    current = choice.font;
    fonts_->at(choice.font).use(choice.glyph, c);
    glyphs += fmt::format("{:04X}", choice.glyph);
  }
  flush();
}

void Canvas::text(double x, double y, std::u32string_view text, double size_mm, double grey, bool invisible) {
  if (text.empty()) return;
  content_ += fmt::format("BT {} g {}1 0 0 1 {} {} Tm ", number(grey), invisible ? "3 Tr " : "0 Tr ",
                          number(x * kPoints), number((height_mm_ - y) * kPoints));
  show(text, size_mm, false);
  content_ += "ET\n";
}

void Canvas::turned_text(double x, double y, std::u32string_view text, double size_mm, double grey) {
  if (text.empty()) return;
  content_ += fmt::format("BT {} g 0 Tr 0 -1 1 0 {} {} Tm ", number(grey), number(x * kPoints),
                          number((height_mm_ - y) * kPoints));
  show(text, size_mm, false);
  content_ += "ET\n";
}

void Canvas::vertical_letter(double x, double y, char32_t letter, double size_mm, double grey) {
  const Fonts::Choice choice = fonts_->choose(letter, true);
  const double advance = fonts_->at(choice.font).advance(choice.glyph);
  content_ += fmt::format("BT {} g 0 Tr 1 0 0 1 {} {} Tm ", number(grey),
                          number((x + (1 - advance) / 2 * size_mm) * kPoints),
                          number((height_mm_ - y - kEmAscent * size_mm) * kPoints));
  show(std::u32string_view(&letter, 1), size_mm, true);
  content_ += "ET\n";
}

void Canvas::object(std::string_view name, const Rect& rect) {
  content_ += fmt::format("q 1 0 0 1 {} {} cm /{} Do Q\n", number(rect.x * kPoints),
                          number((height_mm_ - rect.y - rect.height) * kPoints), name);
}

void Canvas::character(int index, const Rect& square, double grey) {
  in_square(square, fmt::format("/C{} Do\n", index), grey);
}

void Canvas::in_square(const Rect& square, std::string_view content, double grey) {
  content_ += fmt::format("q [] 0 d {} G ", number(grey)) + square_matrix(square, height_mm_);
  content_ += content;
  content_ += "Q\n";
}

}  // namespace nazori::print
