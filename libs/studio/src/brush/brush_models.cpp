// SPDX-License-Identifier: Apache-2.0
// The model on the page for the brush: which characters, and in which lines.
#include <algorithm>
#include <utility>

#include "nazori/studio/brush/brush_page.h"
#include "nazori/studio/brush/brush_words.h"
#include "nazori/studio/brush/tools_panel.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

std::u32string BrushPage::model_text() const {
  if (reviews()) return std::u32string(1, parts().brush_session().character());
  std::u32string text = choice_.text.trimmed().toStdU32String();
  if (!text.empty()) return text;
  const auto& sheet = parts().practice().sheet();
  return std::u32string(1, sheet ? sheet->character.code_point : parts().preferences().kanji);
}

std::vector<char32_t> BrushPage::models() const {
  return calligraphy::models_on_sheet(model_text(), std::max(ruling(), 1), part_);
}

void BrushPage::request_model() {
  clear_advice();
  if (const auto& sheet = parts().practice().sheet())
    characters_[sheet->character.code_point] = sheet->character;
  std::vector<char32_t> missing;
  for (const char32_t c : models())
    if (!characters_.contains(c) && std::find(missing.begin(), missing.end(), c) == missing.end())
      missing.push_back(c);
  if (!missing.empty()) parts().library().request_characters(missing);
  show_model();
}

std::vector<calligraphy::RuledSquare> BrushPage::model_squares() const {
  auto squares = calligraphy::ruled_squares(ruling());
  return squares.empty() ? std::vector{calligraphy::only_square()} : squares;
}

std::string BrushPage::font() const {
  const bool is_installed = fonts_ && std::any_of(fonts_->begin(), fonts_->end(), [this](const auto& one) {
                              return one.family == choice_.font;
                            });
  return is_installed ? choice_.font : std::string();
}

std::vector<calligraphy::SheetModel> BrushPage::sheet_models() const {
  std::vector<calligraphy::SheetModel> standing;
  // Printed lines would be shown for a moment only.
  if (!choice_.font.empty() && !fonts_) return standing;
  const bool in_font = !font().empty();
  const auto squares = model_squares();
  const auto characters = models();
  for (std::size_t i = 0; i < characters.size() && i < squares.size(); ++i) {
    const auto found = characters_.find(characters[i]);
    if (found == characters_.end()) continue;
    calligraphy::SheetModel model{found->second, squares[i]};
    if (in_font) {
      const auto made = in_font_.find(characters[i]);
      if (made == in_font_.end()) continue;
      model.strokes = made->second;
    }
    standing.push_back(std::move(model));
  }
  return standing;
}

std::vector<calligraphy::ModelStroke> BrushPage::model_strokes() const {
  std::vector<calligraphy::ModelStroke> all;
  for (const auto& model : sheet_models())
    for (auto& stroke : calligraphy::strokes_of(model)) all.push_back(std::move(stroke));
  return all;
}

void BrushPage::show_model() {
  request_font_models();
  draw_model();
}

void BrushPage::draw_model() {
  stop_teacher();
  auto all = model_strokes();
  show_strokes_to_keys(all);
  paper_->show_model(std::move(all), calligraphy::ruled_squares(ruling()), choice_.place);
  panel_->show_model_words(model_words());
  paper_->setAccessibleDescription(sheet_words());
}

void BrushPage::show_strokes_to_keys(const std::vector<calligraphy::ModelStroke>& strokes) {
  std::vector<practice::KeyPenGround::Line> lines;
  // Without a model the learner writes from memory.
  if (choice_.place != ModelPlace::none) {
    for (const calligraphy::ModelStroke& stroke : strokes) {
      auto& line = lines.emplace_back();
      for (const geometry::PaperPoint p : stroke.points) line.push_back({p.x, p.y});
    }
  }
  ground_.set_strokes(std::move(lines));
}

void BrushPage::request_font_models() {
  std::vector<author::KnownCharacter> missing;
  std::u32string names;
  if (!font().empty())
    for (const char32_t c : models()) {
      const auto known = characters_.find(c);
      if (known == characters_.end() || in_font_.contains(c) || names.find(c) != std::u32string::npos)
        continue;
      missing.push_back({c, known->second.lines()});
      names.push_back(c);
    }
  if (font_models_.is_busy() && names == asked_) return;
  font_models_.cancel();
  asked_ = std::move(names);
  refused_.clear();
  if (!missing.empty()) font_models_.make(font(), std::move(missing));
}

void BrushPage::connect_font_models() {
  subscribe(font_models_.listed, this, [this](const auto& fonts) { show_fonts(fonts); });
  subscribe(font_models_.made, this, [this](const author::MadeModel& made) { note_model(made); });
  subscribe(font_models_.finished, this, [this] { note_all_models(); });
}

void BrushPage::show_fonts(const std::vector<author::BrushFont>& fonts) {
  fonts_ = fonts;
  panel_->show_fonts(fonts, font_packages_words(fonts));
  panel_->show_font(to_text(font()));
  if (!choice_.font.empty() && font().empty())
    parts().announce(
        Feedback::advice,
        tr("The font %1 is not installed: the model has printed lines.").arg(to_text(choice_.font)));
  show_model();
}

void BrushPage::note_model(const author::MadeModel& made) {
  if (made.family != font()) return;
  auto& strokes = in_font_[made.character];
  if (made.model)
    strokes = author::grooves_of(made.model->strokes);
  else
    refused_.push_back(made.character);
  draw_model();
}

void BrushPage::note_all_models() {
  asked_.clear();
  if (!refused_.empty())
    parts().announce(Feedback::advice, tr("%1 has printed lines: %2 does not have it with the same strokes.")
                                           .arg(QString::fromStdU32String(refused_), to_text(font())));
  refused_.clear();
  if (std::exchange(advises_later_, false)) request_advice();
}

void BrushPage::choose_font(const std::string& family) {
  choice_.font = family;
  in_font_.clear();
  clear_advice();
  panel_->show_font(to_text(font()));
  show_model();
  parts().respond(Feedback::hint, tr("Model: %1.").arg(font_name(font())));
  parts().save_later();
}

QString BrushPage::model_words() const {
  if (choice_.place == ModelPlace::none) return tr("No model.");
  QString text;
  for (const char32_t c : models()) text += to_text(c);
  QString words = choice_.place == ModelPlace::beneath ? tr("Model beneath: %1.").arg(text)
                                                       : tr("Model beside: %1.").arg(text);
  if (!font().empty()) words += QLatin1Char(' ') + tr("Font: %1.").arg(to_text(font()));
  const int sheets = calligraphy::sheets_of(model_text(), std::max(ruling(), 1));
  if (sheets <= 1) return words;
  const int at = ((part_ % sheets) + sheets) % sheets;
  return words + QLatin1Char(' ') + tr("Part %1 of %2.").arg(at + 1).arg(sheets);
}

}  // namespace nazori::ui
