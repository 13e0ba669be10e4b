// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/workshop_page.h"

#include <QHBoxLayout>
#include <QSettings>
#include <algorithm>

#include "nazori/author/check.h"
#include "nazori/studio/workshop/character_canvas.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/studio/workshop/workshop_panel.h"
#include "nazori/studio/workshop/workshop_words.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

author::CharacterEditor empty_editor() {
  auto made = author::CharacterEditor::create({});
  Q_ASSERT(made);
  return *std::move(made);
}

}  // namespace

WorkshopPage::WorkshopPage(WindowParts& parts)
    : Page(parts, {QStringLiteral("workshop"),
                   tr("&Workshop"),
                   tr("Make your own characters and signs"),
                   Icon::chisel,
                   {}}),
      actions_(new WorkshopActions(&parts.window())),
      widget_(named(new QWidget(&parts.window()), "workshop_page")),
      bench_(std::make_unique<author::Workbench>(empty_editor())),
      canvas_(new CharacterCanvas(*bench_, widget_)),
      panel_(new WorkshopPanel(*actions_, widget_)),
      tracer_(parts.inbox()),
      files_(parts.inbox()),
      felt_(parts.inbox(),
            [this](const practice::Tablet& tablet) { this->parts().tablet().set_tablet(tablet); }) {
  auto* row = new QHBoxLayout(widget_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(canvas_, 1);
  row->addWidget(panel_);
  widget_->setFocusProxy(canvas_);
  panel_->set_radicals([this](const QString& form) -> std::optional<int> {
    const auto* database = this->parts().learner().database();
    return database != nullptr ? database->radical_of_form(form.toStdString()) : std::nullopt;
  });
  QSettings settings(parts.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  load(settings);
  connect_actions();
  connect_edits();
  connect_canvas();
  connect_panel();
  connect_tracing();
  slow_.setSingleShot(true);
  connect(&slow_, &QTimer::timeout, this, [this] {
    if (files_.is_waiting_for(slow_call_)) this->parts().announce(Feedback::hint, slow_sentence_);
  });
  show_bench();
}

WorkshopPage::~WorkshopPage() = default;

QWidget* WorkshopPage::instead_of_tablet() const { return widget_; }
ActionSet* WorkshopPage::actions() const { return actions_; }

QList<Tool> WorkshopPage::tools() const {
  return {{actions_->tools[0], true},
          {actions_->tools[1], true},
          {actions_->tools[2], true},
          {actions_->tools[3], true},
          {},
          {actions_->undo, true},
          {actions_->redo, true},
          {actions_->remove},
          {},
          {actions_->check, true},
          {},
          {actions_->panel}};
}

void WorkshopPage::load(const QSettings& settings) {
  const base::Settings values = read_settings(settings);
  author::BenchSettings held;
  held.tool = base::named_setting(values, "tool", author::kToolNames, held.tool);
  held.width = base::number_setting(values, "width", held.width, author::kThinnestTool, author::kWidestTool);
  held.depth = base::number_setting(values, "depth", held.depth, author::kShallowestTool, 1);
  held.ending = base::named_setting(values, "ending", author::kEndingNames, held.ending);
  held.stamp = base::named_setting(values, "stamp", author::kStampNames, held.stamp);
  held.straight = base::flag_setting(values, "straight", held.straight);
  held.mirrored = base::flag_setting(values, "mirrored", held.mirrored);
  bench_->set_settings(held);
  actions_->tools[static_cast<std::size_t>(held.tool)]->setChecked(true);
  actions_->straight->setChecked(held.straight);
  actions_->mirrored->setChecked(held.mirrored);
  actions_->strokes->setChecked(base::flag_setting(values, "show_strokes", true));
  actions_->panel->setChecked(base::flag_setting(values, "show_panel", true));
  canvas_->set_shows_strokes(actions_->strokes->isChecked());
  panel_->setVisible(actions_->panel->isChecked());
}

void WorkshopPage::save(QSettings& settings) const {
  auto values = read_settings(settings);
  const auto& held = bench_->settings();
  values.insert_or_assign("tool", std::string(author::kToolNames[static_cast<std::size_t>(held.tool)]));
  base::set_number(values, "width", held.width);
  base::set_number(values, "depth", held.depth);
  values.insert_or_assign("ending", std::string(author::kEndingNames[static_cast<std::size_t>(held.ending)]));
  values.insert_or_assign("stamp", std::string(author::kStampNames[static_cast<std::size_t>(held.stamp)]));
  base::set_flag(values, "straight", held.straight);
  base::set_flag(values, "mirrored", held.mirrored);
  base::set_flag(values, "show_strokes", actions_->strokes->isChecked());
  base::set_flag(values, "show_panel", actions_->panel->isChecked());
  write_settings(settings, values);
}

void WorkshopPage::enter() {
  // As the panels beside the tablet: on the other side for the left hand.
  static_cast<QHBoxLayout*>(widget_->layout())
      ->setDirection(parts().preferences().left_handed ? QBoxLayout::RightToLeft : QBoxLayout::LeftToRight);
  parts().note_opened();
  const bool first = !std::exchange(entered_, true);
  parts().announce(Feedback::hint,
                   tr("Draw strokes with mouse or pen. 1 to 8: tools. K: check. S: describe what is there."));
  if (first) recover();
  // A force-feedback device feels what is made, from here on after each edit.
  is_shown_ = true;
  begin_feeling();
}

void WorkshopPage::leave() {
  bench_->lose_pen();
  is_shown_ = false;
  felt_.end();
}

void WorkshopPage::begin_feeling() {
  if (is_shown_) felt_.begin(bench_->editor().map(), bench_->character().strokes);
}

void WorkshopPage::refresh_appearance() { canvas_->refresh_appearance(); }

void WorkshopPage::connect_edits() {
  subscribe(bench_->relief_changed, this, [this](const carving::GridBox& box) {
    canvas_->refresh_relief(box);
    if (is_shown_) felt_.update(bench_->editor().map(), box, bench_->character().strokes);
  });
  subscribe(bench_->changed, this, [this] { show_bench(); });
  // While a line is drawn nothing but the line is painted again.
  subscribe(bench_->pen_moved, this, [this] { canvas_->update(); });
  subscribe(bench_->edited, this, [this](author::EditKind kind, author::EditWay way) {
    ++edits_;
    // Direction and order of strokes change without a sample of the relief.
    if (is_shown_) felt_.update(bench_->editor().map(), {}, bench_->character().strokes);
    clear_check();
    parts().respond(Feedback::hint, edit_words(kind, way));
    if (const auto error = bench_->editor().journal_error(); error && !std::exchange(journal_failed_, true))
      parts().announce(Feedback::advice,
                       tr("Your changes cannot be kept for an emergency: %1.").arg(reason(*error)));
  });
  subscribe(bench_->refused, this, [this](const base::Error& error) {
    parts().respond(Feedback::wrong, tr("This is not possible: %1.").arg(reason(error)));
  });
}

void WorkshopPage::show_bench() {
  const auto state = bench_->editor().state();
  actions_->undo->setEnabled(state.undoes != author::EditKind::none);
  actions_->redo->setEnabled(state.redoes != author::EditKind::none);
  actions_->instead->setChecked(bench_->character().facts.instead_of.has_value());
  actions_->clear_relief->setEnabled(!bench_->character().hand.is_untouched());
  canvas_->refresh();
  panel_->show_character(*bench_);
  panel_->show_settings(bench_->settings());
  canvas_->setAccessibleDescription(character_words(bench_->character()));
  emit title_changed();
}

void WorkshopPage::connect_canvas() {
  connect(canvas_, &CharacterCanvas::pen_moved, this,
          [this](const geometry::WrittenPoint<geometry::GlyphFrame>& pen, bool down) {
            bench_->move_pen(pen, down);
          });
  connect(canvas_, &CharacterCanvas::pen_lost, this, [this] { bench_->lose_pen(); });
  connect(canvas_, &CharacterCanvas::double_clicked, this, [this](geometry::GlyphPoint at) {
    if (bench_->settings().tool == author::Tool::place)
      bench_->finish_placing();
    else if (bench_->settings().tool == author::Tool::edit)
      bench_->insert_point_at(at);
  });
  connect(canvas_, &CharacterCanvas::moved_by_key, this,
          [this](geometry::GlyphPoint by) { bench_->move_by_key(by); });
  connect(canvas_, &CharacterCanvas::pressed_by_key, this, [this](double time_s) {
    const auto placed = bench_->placed().size();
    bench_->press_at_cursor(time_s);
    if (bench_->placed().size() > placed)
      parts().respond(Feedback::hint, tr("Point %1 placed. Enter: finish the stroke.").arg(placed + 1));
    else if (bench_->is_down())
      parts().respond(Feedback::hint, tr("Pen down. Move it with the arrow keys; space lifts it."));
    else if (bench_->settings().tool == author::Tool::edit)
      say_selection();
  });
}

void WorkshopPage::connect_panel() {
  connect(panel_, &WorkshopPanel::tool_changed, this,
          [this](double width, double depth, int ending, int stamp) {
            auto held = bench_->settings();
            held.width = width;
            held.depth = depth;
            held.ending = static_cast<kanji::StrokeEnding>(ending);
            held.stamp = static_cast<author::StampShape>(stamp);
            bench_->set_settings(held);
            emit parts().save_later();
          });
  connect(panel_, &WorkshopPanel::stroke_chosen, this, [this](std::size_t stroke) {
    if (bench_->selection().stroke != stroke) bench_->select({stroke, std::nullopt});
  });
  connect(panel_, &WorkshopPanel::stroke_dragged, this, [this](std::size_t from, std::size_t to) {
    bench_->select({from, std::nullopt});
    bench_->reorder(static_cast<int>(to) - static_cast<int>(from));
  });
  connect(panel_, &WorkshopPanel::facts_typed, this,
          [this](const author::Facts& facts) { bench_->set_facts(facts); });
  connect(panel_, &WorkshopPanel::point_chosen, this, [this](std::size_t point) {
    bench_->select({bench_->selection().stroke, point});
  });
  connect(panel_, &WorkshopPanel::half_width_moved, this,
          [this](std::size_t point, double value, bool goes_on) {
            bench_->set_half_width(point, value, goes_on);
          });
  connect(panel_, &WorkshopPanel::depth_moved, this, [this](std::size_t point, double value, bool goes_on) {
    bench_->set_depth(point, value, goes_on);
  });
  connect(panel_, &WorkshopPanel::left, this, [this] { canvas_->setFocus(); });
  connect(panel_, &WorkshopPanel::curve_said, this,
          [this](const QString& sentence) { parts().respond(Feedback::hint, sentence); });
  connect(panel_, &WorkshopPanel::text_refused, this,
          [this](const QString& sentence) { parts().respond(Feedback::wrong, sentence); });
  connect(panel_, &WorkshopPanel::finding_chosen, this, [this](const author::Finding& finding) {
    if (!finding.stroke) return;
    using author::FindingKind;
    const bool of_number = finding.kind == FindingKind::number_far ||
                           finding.kind == FindingKind::numbers_overlap ||
                           finding.kind == FindingKind::number_hides_start;
    bench_->select({finding.stroke, finding.point, of_number});
    parts().respond(Feedback::advice, finding_words(finding));
  });
}

}  // namespace nazori::ui
