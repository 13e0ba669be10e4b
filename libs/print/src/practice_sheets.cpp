// SPDX-License-Identifier: Apache-2.0
#include "sheets.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace nazori::print {
namespace {

constexpr double kRuby_mm = 1.9;

}  // namespace

double Sheets::practice_depth(const kanji::Character& character, int rows) const {
  double depth = model_mm();
  if (s_.steps) {
    const int in_row = std::max(1, static_cast<int>((flow_length() + 1e-6) / step_mm()));
    const int strokes = static_cast<int>(character.strokes.size());
    const int step_rows = (strokes + in_row - 1) / in_row;
    depth += kGap_mm / 2 + step_rows * step_mm();
  }
  if (rows > 0) depth += kGap_mm / 2 + rows * s_.cell_mm;
  return depth;
}

void Sheets::draw_facts(const SheetCharacter& one, const Flow& flow, double along, double across,
                        double length, double depth) {
  Canvas& canvas = *pages_.back();
  const Facts facts = facts_of(one.character);
  const double most = length / kText_mm;
  double at = across;
  const auto line = [&](const std::u32string& text) {
    if (text.empty() || at + kText_mm > across + depth) return;
    flow.text(canvas, along, at, cut(fonts_, text, most), kText_mm);
    at += kText_mm * 1.35;
  };
  if (!facts.on.empty()) line(label("on", "音") + U" " + facts.on);
  if (!facts.kun.empty()) line(label("kun", "訓") + U" " + facts.kun);
  line(facts.meanings);
  for (const kanji::Word& word : one.words) {
    const std::u32string text = wide(word.text);
    const std::u32string reading = wide(word.reading);
    if (at + kRuby_mm * 1.1 + kText_mm > across + depth) break;
    const double width = fonts_.width(text) * kText_mm;
    const double ruby = std::min(kRuby_mm, width / std::max(1.0, fonts_.width(reading)) * 1.4);
    // The reading stands above the word, to its right in vertical text.
    if (reading != text) flow.text(canvas, along, at + kRuby_mm - ruby, reading, ruby, 0.2);
    at += kRuby_mm * 1.1;
    flow.text(canvas, along, at, text, kText_mm);
    const double taken = std::max(width, fonts_.width(reading) * ruby) + 2;
    if (!word.glosses.empty())
      flow.text(canvas, along + taken, at,
                cut(fonts_, wide(word.glosses.front()), (length - taken) / kText_mm), kText_mm, 0.25);
    at += kText_mm * 1.25;
  }
}

void Sheets::annotate(Canvas& canvas, const SheetCharacter& one, const Rect& box) {
  if (s_.arrows) draw_arrows(canvas, one.character, box);
  if (s_.numbers) draw_numbers(canvas, one.character, box);
  place_text(canvas, one, box);
}

void Sheets::place_text(Canvas& canvas, const SheetCharacter& one, const Rect& box) {
  const std::u32string text = text_of(one);
  canvas.text(box.x, box.y + box.height * 0.88, text, box.width / std::max(1.0, fonts_.width(text)), 0, true);
}

void Sheets::draw_model(const SheetCharacter& one, std::size_t i, const Rect& box) {
  Canvas& canvas = *pages_.back();
  place_cell(canvas, box, s_.guide);
  used_.insert(i);
  canvas.character(static_cast<int>(i), box, 0);
  annotate(canvas, one, box);
}

void Sheets::practice(std::size_t i) {
  const SheetCharacter& one = characters_[i];
  int rows = s_.rows;
  if (s_.whole_page) {
    const double left = flow_depth() - practice_depth(one.character, 0) - kGap_mm / 2;
    rows = std::max(0, static_cast<int>((left + 1e-6) / s_.cell_mm));
  }
  // More steps than the check of the settings reckons with take the place of rows.
  while (rows > 0 && practice_depth(one.character, rows) > flow_depth() + 1e-6) --rows;
  const double depth = practice_depth(one.character, rows);
  if (pages_.empty() || s_.whole_page || used_depth_ + depth > flow_depth() + 1e-6) new_page(true);
  Canvas& canvas = *pages_.back();
  const Flow flow(area(), s_.vertical);
  double at = used_depth_;
  const double model = model_mm();
  draw_model(one, i, flow.rect(0, at, model, model));
  if (s_.facts) draw_facts(one, flow, model + kGap_mm, at, flow.length() - model - kGap_mm, model);
  at += model;
  if (s_.steps) {
    at += kGap_mm / 2;
    const double step = step_mm();
    const int in_row = std::max(1, static_cast<int>((flow.length() + 1e-6) / step));
    const auto strokes = static_cast<int>(one.character.strokes.size());
    for (int stroke = 0; stroke < strokes; ++stroke) {
      const int row = stroke / in_row;
      const Rect box = flow.rect(stroke % in_row * step, at + row * step, step, step);
      place_cell(canvas, box, std::nullopt);
      const auto last = static_cast<std::size_t>(stroke);
      if (stroke > 0) canvas.in_square(box, strokes_content(one.character, 0, last), 0.62);
      canvas.in_square(box, strokes_content(one.character, last, last + 1), 0);
    }
    const int step_rows = (strokes + in_row - 1) / in_row;
    at += step_rows * step;
  }
  if (rows > 0) {
    at += kGap_mm / 2;
    mark_->runs.push_back({at, rows, {one.character.code_point}});
  }
  const int in_row = cells_in_row();
  for (int cell = 0; cell < rows * in_row; ++cell) {
    const int row = cell / in_row;
    const Rect box = flow.rect(cell % in_row * s_.cell_mm, at + row * s_.cell_mm, s_.cell_mm, s_.cell_mm);
    place_cell(canvas, box, s_.guide);
    if (cell < s_.copies) {
      canvas.character(static_cast<int>(i), box, 0.5 + 0.38 * faded(cell));
    }
  }
  used_depth_ += depth + kGap_mm;
}

}  // namespace nazori::print
