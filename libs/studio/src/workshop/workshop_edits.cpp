// SPDX-License-Identifier: Apache-2.0
// What the actions of the page do to the character.
#include <array>
#include <cmath>

#include "nazori/author/check.h"
#include "nazori/studio/workshop/character_canvas.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/studio/workshop/workshop_page.h"
#include "nazori/studio/workshop/workshop_panel.h"
#include "nazori/studio/workshop/workshop_words.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr double kStep = 1.1;  ///< of width and depth by key
constexpr double kZoom = 1.5;

}  // namespace

void WorkshopPage::connect_actions() {
  for (std::size_t i = 0; i < actions_->tools.size(); ++i)
    on(actions_->tools[i], [this, i] { choose_tool(static_cast<author::Tool>(i)); });
  const auto hold = [this](auto change) {
    auto held = bench_->settings();
    change(held);
    bench_->set_settings(held);
    emit parts().save_later();
  };
  on(actions_->straight, [hold](bool wanted) { hold([wanted](auto& held) { held.straight = wanted; }); });
  on(actions_->mirrored, [hold](bool wanted) { hold([wanted](auto& held) { held.mirrored = wanted; }); });
  on(actions_->wider, [this] { change_width(kStep); });
  on(actions_->thinner, [this] { change_width(1 / kStep); });
  on(actions_->deeper, [this] { change_depth(kStep); });
  on(actions_->shallower, [this] { change_depth(1 / kStep); });
  on(actions_->next_stamp, [this] { choose_stamp(); });

  on(actions_->undo, [this] { bench_->undo(); });
  on(actions_->redo, [this] { bench_->redo(); });
  on(actions_->step_back, [this] { bench_->step_back(); });
  on(actions_->finish, [this] {
    if (!bench_->finish_placing())
      parts().respond(Feedback::hint, tr("Place at least two points first: the start and the end."));
  });
  const auto choose = [this](auto which, int by) {
    return [this, which, by] {
      (bench_.get()->*which)(by);
      say_selection();
    };
  };
  on(actions_->next_stroke, choose(&author::Workbench::select_next_stroke, 1));
  on(actions_->previous_stroke, choose(&author::Workbench::select_next_stroke, -1));
  on(actions_->next_point, choose(&author::Workbench::select_next_point, 1));
  on(actions_->previous_point, choose(&author::Workbench::select_next_point, -1));
  const auto edit = [this](auto what) {
    return [this, what] {
      if (!what(*bench_)) say_nothing_chosen();
    };
  };
  on(actions_->number, [this] {
    if (!bench_->select_number()) return say_selection();
    // The arrow keys move what is chosen with this tool alone.
    if (bench_->settings().tool != author::Tool::edit)
      actions_->tools[static_cast<std::size_t>(author::Tool::edit)]->trigger();
    // In the panel they would move something else.
    canvas_->setFocus();
    say_selection();
  });
  on(actions_->place_number, [this] {
    if (!bench_->selection().stroke) return say_nothing_chosen();
    bench_->place_number();
    parts().respond(Feedback::hint, tr("The program places the number."));
  });
  on(actions_->curve, [this] {
    if (!bench_->selection().stroke) bench_->select_next_stroke(1);
    if (!bench_->selection().stroke) return say_selection();
    if (!actions_->panel->isChecked()) actions_->panel->trigger();
    panel_->focus_curve();
  });
  on(actions_->earlier, edit([](author::Workbench& bench) { return bench.reorder(-1); }));
  on(actions_->later, edit([](author::Workbench& bench) { return bench.reorder(1); }));
  on(actions_->reverse, edit([](author::Workbench& bench) { return bench.reverse(); }));
  on(actions_->insert, edit([](author::Workbench& bench) { return bench.insert_point(); }));
  on(actions_->split, edit([](author::Workbench& bench) { return bench.split(); }));
  on(actions_->join, edit([](author::Workbench& bench) { return bench.join(); }));
  on(actions_->remove, edit([](author::Workbench& bench) { return bench.remove(); }));
  on(actions_->ending, [this] { choose_ending(); });

  on(actions_->start_empty, [this] {
    if (may_replace()) begin({}, tr("An empty tablet. Draw the first stroke."));
  });
  on(actions_->copy, [this] { ask_copy(); });
  on(actions_->from_picture, [this] { ask_picture(); });
  on(actions_->from_font, [this] { ask_font(); });
  on(actions_->from_plot, [this] { ask_plot(); });
  on(actions_->clear_relief, [this] { bench_->clear_relief(); });
  on(actions_->keep, [this] { keep(); });
  on(actions_->instead, [this] { toggle_instead(); });
  on(actions_->remove_kept, [this] { remove_kept(); });
  on(actions_->details, [this] {
    if (!actions_->panel->isChecked()) actions_->panel->trigger();
    panel_->focus_name();
  });
  on(actions_->add_part, [this] {
    if (!actions_->panel->isChecked()) actions_->panel->trigger();
    panel_->add_part();
  });
  on(actions_->remove_part, [this] {
    if (!panel_->remove_part()) parts().respond(Feedback::hint, tr("Choose a part in the list first."));
  });
  on(actions_->check, [this] { actions_->check->isChecked() ? show_check() : clear_check(); });
  on(actions_->describe, [this] { describe(); });
  on(actions_->carve, [this] { feel(); });
  on(actions_->save_copy, [this] { ask_and_write(QStringLiteral("svg")); });

  on(actions_->zoom_in, [this] { canvas_->zoom(kZoom); });
  on(actions_->zoom_out, [this] { canvas_->zoom(1 / kZoom); });
  on(actions_->zoom_whole, [this] { canvas_->show_whole(); });
  on(actions_->strokes, [this](bool wanted) {
    canvas_->set_shows_strokes(wanted);
    emit parts().save_later();
  });
  on(actions_->panel, [this](bool wanted) {
    if (!wanted && panel_->isAncestorOf(widget_->window()->focusWidget())) canvas_->setFocus();
    panel_->setVisible(wanted);
    emit parts().save_later();
  });
}

void WorkshopPage::choose_tool(author::Tool tool) {
  auto held = bench_->settings();
  held.tool = tool;
  bench_->set_settings(held);
  emit parts().save_later();
  parts().respond(Feedback::hint, tr("Tool: %1.").arg(tool_name(tool)));
}

void WorkshopPage::change_width(double factor) {
  if (bench_->settings().tool == author::Tool::edit && bench_->scale_width(factor)) return;
  auto held = bench_->settings();
  held.width *= factor;
  bench_->set_settings(held);
  emit parts().save_later();
  parts().respond(Feedback::hint,
                  tr("Width: %1 of 109.").arg(QLocale().toString(bench_->settings().width, 'f', 1)));
}

void WorkshopPage::change_depth(double factor) {
  if (bench_->settings().tool == author::Tool::edit && bench_->scale_depth(factor)) return;
  auto held = bench_->settings();
  held.depth *= factor;
  bench_->set_settings(held);
  emit parts().save_later();
  parts().respond(Feedback::hint,
                  tr("Depth: %1%.").arg(QLocale().toString(bench_->settings().depth * 100, 'f', 0)));
}

void WorkshopPage::choose_stamp() {
  auto held = bench_->settings();
  held.stamp = static_cast<author::StampShape>((static_cast<std::size_t>(held.stamp) + 1) %
                                               author::kStampNames.size());
  bench_->set_settings(held);
  emit parts().save_later();
  parts().respond(Feedback::hint, tr("Stamp: %1.").arg(stamp_name(held.stamp)));
}

void WorkshopPage::choose_ending() {
  const auto next = [](kanji::StrokeEnding ending) {
    return static_cast<kanji::StrokeEnding>((static_cast<std::size_t>(ending) + 1) %
                                            author::kEndingNames.size());
  };
  if (const auto& chosen = bench_->selection(); chosen.stroke) {
    const auto ending = next(bench_->character().strokes[*chosen.stroke].ending);
    bench_->set_ending(ending);
    parts().respond(Feedback::hint, tr("Ending: %1.").arg(ending_name(ending)));
    return;
  }
  auto held = bench_->settings();
  held.ending = next(held.ending);
  bench_->set_settings(held);
  emit parts().save_later();
  parts().respond(Feedback::hint, tr("Ending of placed strokes: %1.").arg(ending_name(held.ending)));
}

void WorkshopPage::say_selection() {
  const QString words = selection_words(bench_->character(), bench_->selection());
  parts().respond(Feedback::hint, words.isEmpty() ? tr("There are no strokes yet.") : words);
}

void WorkshopPage::say_nothing_chosen() {
  parts().respond(Feedback::hint, bench_->selection().stroke
                                      ? tr("This is not possible here.")
                                      : tr("Choose a stroke first. N: next stroke. Full stop: next point."));
}

void WorkshopPage::show_check() {
  author::CheckSettings settings;
  const std::u32string name = named_character();
  const auto known = name.empty() ? characters_.end() : characters_.find(name.front());
  if (known != characters_.end()) settings.dictionary = &known->second.entry;
  const auto findings = author::check(bench_->character(), settings);
  is_checked_ = true;
  panel_->show_findings(findings, true);
  if (findings.empty()) return parts().respond(Feedback::good, tr("Checked: nothing was found."));
  QStringList sentences;
  for (const auto& finding : findings) sentences.append(finding_words(finding));
  parts().respond(Feedback::advice, sentences.join(QLatin1Char(' ')));
}

void WorkshopPage::clear_check() {
  if (!std::exchange(is_checked_, false)) return;
  actions_->check->setChecked(false);
  panel_->show_findings({}, false);
}

void WorkshopPage::describe() {
  QString words = character_words(bench_->character());
  if (const QString chosen = selection_words(bench_->character(), bench_->selection()); !chosen.isEmpty())
    words += QLatin1Char(' ') + chosen;
  words += QLatin1Char(' ') + tr("Tool: %1.").arg(tool_name(bench_->settings().tool));
  const auto cursor = bench_->cursor();
  words += QLatin1Char(' ') + tr("Cursor: %1 from the left and %2 from the top, of 109.")
                                  .arg(std::lround(cursor.x))
                                  .arg(std::lround(cursor.y));
  if (!bench_->editor().state().is_saved) words += QLatin1Char(' ') + tr("Not saved.");
  parts().respond(Feedback::hint, words);
}

void WorkshopPage::feel() {
  auto tablet = author::carved_tablet(bench_->editor().map(), bench_->character().strokes);
  if (!tablet)
    return parts().announce(Feedback::wrong, tr("This is not possible: %1.").arg(reason(tablet.error())));
  const QString name = to_text(bench_->character().facts.name);
  parts().workshop().show({*std::move(tablet), (name.isEmpty() ? tr("Own character") : name).toStdString(),
                           bench_->editor().map().size(), !bench_->character().strokes.empty()});
}

}  // namespace nazori::ui
