// SPDX-License-Identifier: Apache-2.0
// What the learner chooses on the page for the brush: actions, panel and paper.
#include <algorithm>
#include <cmath>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/studio/brush/brush_words.h"
#include "nazori/studio/brush/tools_panel.h"
#include "nazori/widgets/page/window_parts.h"

namespace nazori::ui {

void BrushPage::connect_actions() {
  const auto act = [this](QAction* action, auto what) {
    on(action, [this, what] {
      stop_teacher();
      what(*writing_);
      wake();
    });
  };
  act(actions_->dip_in_ink, [this](auto& writing) {
    writing.dip_in_ink();
    parts().respond(Feedback::hint, tr("Dipped in ink."));
  });
  act(actions_->dip_in_water, [this](auto& writing) {
    writing.dip_in_water();
    parts().respond(Feedback::hint, tr("Dipped in water: the ink is paler."));
  });
  act(actions_->wipe, [this](auto& writing) {
    writing.wipe();
    parts().respond(Feedback::hint, tr("Wiped: half of the ink is gone."));
  });
  act(actions_->undo, [](auto& writing) { writing.undo(); });
  act(actions_->redo, [](auto& writing) { writing.redo(); });
  act(actions_->dry, [](auto& writing) { writing.dry_now(); });
  act(actions_->carve, [](auto& writing) { writing.carve(); });
  on(actions_->new_sheet, [this] { choose_paper(choice_.paper); });
  on(actions_->next_paper, [this] {
    const auto& names = paint::paper_names();
    const auto at = std::find(names.begin(), names.end(), choice_.paper) - names.begin();
    choose_paper(std::string(names[static_cast<std::size_t>(at + 1) % names.size()]));
  });
  const auto resize = [this](int by) {
    calligraphy::BrushChoice brush = choice_.brush;
    const int last = static_cast<int>(calligraphy::kBrushSizes.size()) - 1;
    brush.size = static_cast<calligraphy::BrushSize>(std::clamp(static_cast<int>(brush.size) + by, 0, last));
    choose_brush(brush);
  };
  on(actions_->thicker, [resize] { resize(-1); });
  on(actions_->thinner, [resize] { resize(1); });
  on(actions_->next_hair, [this] {
    calligraphy::BrushChoice brush = choice_.brush;
    brush.hair =
        static_cast<brush::Hair>((static_cast<std::size_t>(brush.hair) + 1) % calligraphy::kHairs.size());
    choose_brush(brush);
  });
  on(actions_->next_ink, [this] {
    const auto& inks = calligraphy::kInks;
    const auto at = std::find(inks.begin(), inks.end(), choice_.ink) - inks.begin();
    choose_ink(std::string(inks[static_cast<std::size_t>(at + 1) % inks.size()]));
  });
  on(actions_->watch, [this] { watch_teacher(); });
  on(actions_->describe, [this] { parts().respond(Feedback::hint, sheet_words()); });
  on(actions_->advice, [this](bool on) {
    if (on) return request_advice();
    paper_->show_marks({});
    panel_->show_advice({});
    parts().respond(Feedback::hint, tr("The corrections are gone."));
  });
  on(actions_->save_png, [this] { ask_and_write(QStringLiteral("png")); });

  on(actions_->guess_pressure, [this](bool on) {
    choice_.guess_pressure = on;
    set_handling();
    parts().save_later();
  });
  on(actions_->left_hand, [this](bool on) {
    choice_.left_hand = on;
    paper_->set_left_hand(on);
    set_feeling();
    parts().save_later();
  });
  on(actions_->show_brush, [this](bool on) {
    choice_.show_brush = on;
    paper_->set_shows_brush(on);
    parts().save_later();
  });
  on(actions_->tools, [this](bool on) {
    choice_.show_tools = on;
    tools_folded_ = false;
    tools_wanted_ = on && reviews();
    if (!on && panel_->isAncestorOf(parts().window().focusWidget())) parts().focus_tablet();
    panel_->setVisible(on);
    parts().save_later();
  });
  on(actions_->model_none, [this] { choose_place(ModelPlace::none); });
  on(actions_->model_beneath, [this] { choose_place(ModelPlace::beneath); });
  on(actions_->model_beside, [this] { choose_place(ModelPlace::beside); });
  on(actions_->next_ruling, [this] {
    const auto& all = calligraphy::kRulings;
    const auto at = std::find(all.begin(), all.end(), choice_.ruling) - all.begin();
    choose_ruling(all[static_cast<std::size_t>(at + 1) % all.size()]);
    parts().respond(Feedback::hint, ruling_name(choice_.ruling));
  });
  on(actions_->next_font, [this] {
    if (!fonts_) return;
    if (fonts_->empty()) return parts().respond(Feedback::hint, font_packages_words(*fonts_));
    const auto at = std::find_if(fonts_->begin(), fonts_->end(),
                                 [this](const auto& one) { return one.family == font(); });
    const auto next = at == fonts_->end() ? fonts_->begin() : at + 1;
    choose_font(next == fonts_->end() ? std::string() : std::string(next->family));
  });
  on(actions_->model_text, [this] {
    if (!actions_->tools->isChecked()) actions_->tools->trigger();
    panel_->focus_text();
  });
  on(actions_->next_model, [this] { turn_model(1); });
  on(actions_->previous_model, [this] { turn_model(-1); });
}

void BrushPage::connect_panel() {
  connect(panel_, &BrushToolsPanel::size_chosen, this, [this](calligraphy::BrushSize size) {
    choose_brush({size, choice_.brush.hair});
  });
  connect(panel_, &BrushToolsPanel::hair_chosen, this, [this](brush::Hair hair) {
    choose_brush({choice_.brush.size, hair});
  });
  connect(panel_, &BrushToolsPanel::ink_chosen, this,
          [this](const QString& ink) { choose_ink(ink.toStdString()); });
  connect(panel_, &BrushToolsPanel::paper_chosen, this,
          [this](const QString& paper) { choose_paper(paper.toStdString()); });
  connect(panel_, &BrushToolsPanel::ruling_chosen, this, &BrushPage::choose_ruling);
  connect(panel_, &BrushToolsPanel::place_chosen, this, &BrushPage::choose_place);
  connect(panel_, &BrushToolsPanel::font_chosen, this,
          [this](const QString& family) { choose_font(family.toStdString()); });
  connect(panel_, &BrushToolsPanel::text_typed, this, [this](const QString& text) {
    choice_.text = text;
    part_ = 0;
    request_model();
    parts().save_later();
  });
  connect(panel_, &BrushToolsPanel::text_entered, this, [this] {
    parts().focus_tablet();
    parts().announce(Feedback::hint, model_words());
  });
}

void BrushPage::connect_paper() {
  connect(paper_, &PaperView::pen_moved, this, [this](const brush::PenSample& sample) {
    if (felt_.has_no_hand()) return felt_.move_hand(sample.at, sample.down, sample.pressure);
    stop_teacher();
    clear_advice();
    writing_->move_pen(sample);
    wake();
  });
  connect(paper_, &PaperView::pen_lost, this, [this] {
    writing_->lift_pen();
    wake();
  });
  connect(paper_, &PaperView::eraser_used, actions_->undo, &QAction::trigger);
}

void BrushPage::connect_keys() {
  const auto press_harder = [this](int by) {
    if (ground_.press_harder(by))
      return parts().respond(Feedback::hint, tr("Pressure: %1%.").arg(std::lround(ground_.pressure() * 100)));
    parts().respond(Feedback::hint, by > 0 ? tr("The brush cannot be pressed harder.")
                                           : tr("The brush cannot be pressed more softly."));
  };
  on(actions_->harder, [press_harder] { press_harder(1); });
  on(actions_->softer, [press_harder] { press_harder(-1); });
  connect(actions_->by_key, &QAction::toggled, this, [this](bool on) {
    for (auto* one : {actions_->harder, actions_->softer}) one->setEnabled(on);
  });
  for (auto* one : {actions_->harder, actions_->softer}) one->setEnabled(false);
}

void BrushPage::set_handling() {
  brush::Handling handling;
  handling.guess_pressure = choice_.guess_pressure;
  writing_->set_handling(handling);
}

void BrushPage::choose_brush(const calligraphy::BrushChoice& brush) {
  choice_.brush = brush;
  writing_->set_brush(brush);
  felt_.set_brush(calligraphy::form_of(brush));
  parts().respond(Feedback::hint,
                  tr("Brush: %1, %2.").arg(brush_size_name(brush.size), hair_name(brush.hair)));
  parts().save_later();
  wake();
}

void BrushPage::choose_ink(const std::string& ink) {
  choice_.ink = ink;
  writing_->set_ink(ink);
  parts().save_later();
  wake();
}

void BrushPage::choose_paper(const std::string& paper) {
  stop_teacher();
  choice_.paper = paper;
  writing_->take_new_sheet(paper);
  parts().save_later();
  wake();
}

void BrushPage::choose_ruling(int characters) {
  const bool changes = characters != choice_.ruling;
  choice_.ruling = characters;
  part_ = 0;
  panel_->show_ruling(characters);
  request_model();
  if (!changes) return;
  choose_brush({calligraphy::size_for(characters), choice_.brush.hair});
}

void BrushPage::choose_place(ModelPlace place) {
  choice_.place = place;
  clear_advice();
  show_place();
  show_model();
  parts().brush_session().show_model(brush_model_of(place));
  parts().respond(Feedback::hint, model_words());
  parts().save_later();
}

void BrushPage::show_place() {
  QAction* const actions[] = {actions_->model_none, actions_->model_beneath, actions_->model_beside};
  actions[static_cast<std::size_t>(choice_.place)]->setChecked(true);
  panel_->show_place(choice_.place);
}

void BrushPage::turn_model(int by) {
  const int sheets = calligraphy::sheets_of(model_text(), std::max(ruling(), 1));
  if (sheets <= 1) {
    parts().respond(Feedback::hint, tr("The whole model text is on this sheet."));
    return;
  }
  part_ = ((part_ + by) % sheets + sheets) % sheets;
  request_model();
  parts().respond(Feedback::hint, model_words());
}

}  // namespace nazori::ui
