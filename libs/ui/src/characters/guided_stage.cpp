// SPDX-License-Identifier: Apache-2.0
#include "characters/guided_stage.h"

#include <QSettings>
#include <algorithm>
#include <array>

#include "characters/stroke_teller.h"
#include "nazori/practice/blank_tablet.h"

namespace nazori::ui {
namespace {

/// By the number of successes: how much of the lines is still seen, and how firmly strokes hold.
constexpr std::array kLines{0.45, 0.2, 0.0, 0.0};
constexpr std::array kHold{1.0, 0.6, 0.3, 0.0};
/// With less help the numbers are gone, too.
constexpr double kNumbersUntil = 0.5;

double at_level(const std::array<double, 4>& help, int successes) {
  return help[static_cast<std::size_t>(std::min(successes, 3))];
}

}  // namespace

GuidedStage::GuidedStage(Desk& desk, CharacterActions& actions) : CharacterStage(desk, actions) {
  actions.by_groove->setChecked(true);
  for (auto* choice : {actions.by_groove, actions.by_starts})
    connect(choice, &QAction::triggered, this, [this] {
      lay_out();
      invite();
    });
  connect(actions.lead_hand, &QAction::triggered, this, [this] {
    controller().set_guides(guides());
    invite();
  });
  connect(actions.clear_ink, &QAction::triggered, this, [this] {
    if (!is_entered()) return;
    clear();
    invite();
  });
  connect(&controller(), &TabletController::stroke_event, this,
          [this](practice::TraceEvent event, int stroke) {
            if (is_entered()) take(event, stroke);
          });
  connect(&controller(), &TabletController::eraser_used, this, [this] {
    if (!is_entered()) return;
    controller().undo_ink();
    if (!written_.empty()) written_.pop_back();
    controller().set_writing(written_);
  });
  connect(&controller(), &TabletController::pressed, this,
          [this](geometry::TabletPoint at) { recorder_.press_at(at); });
  connect(&controller(), &TabletController::sampled, this,
          [this](std::span<const haptics::ServoSample> samples) {
            if (!is_entered()) return;
            if (this->actions().by_starts->isChecked()) take_samples(samples);
            note_giving_way(samples);
          });
}

QList<QAction*> GuidedStage::own_actions() const {
  return {actions().by_groove, actions().by_starts, actions().lead_hand, actions().clear_ink};
}

QList<Tool> GuidedStage::tools() const {
  return {{actions().by_groove, true}, {actions().by_starts, true}, {}, {actions().lead_hand, true}, {},
          {actions().clear_ink}};
}

void GuidedStage::load(const QSettings& settings) {
  actions().lead_hand->setChecked(settings.value(QStringLiteral("lead_hand"), false).toBool());
}

void GuidedStage::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("lead_hand"), actions().lead_hand->isChecked());
}

void GuidedStage::begin() {
  const char32_t character = lesson().sheet ? lesson().sheet->character.code_point : 0;
  if (character != character_ || character == 0) successes_ = 0;
  character_ = character;
  lay_out();
  invite();
}

void GuidedStage::end() { controller().set_writing({}); }

TabletGuides GuidedStage::guides() const {
  const bool starts = actions().by_starts->isChecked();
  TabletGuides guides;
  const double help = help_.value_or(at_level(kHold, successes_));
  guides.lines_opacity = help_ ? kLines.front() * help : at_level(kLines, successes_);
  guides.numbers = starts || (help_ ? help > kNumbersUntil : successes_ == 0);
  guides.strokes = guides.numbers || guides.lines_opacity > 0;
  guides.arrows = guides.lines_opacity > 0;
  guides.snapping_strength = help;
  if (shown_alone_ != 0) {
    guides.strokes = guides.arrows = guides.numbers = true;
    guides.lines_opacity = 1;
  }
  guides.leading = actions().lead_hand->isChecked() && help > 0;
  guides.snapping = help > 0;
  guides.traced = true;
  return guides;
}

void GuidedStage::lay_out() {
  const bool starts = actions().by_starts->isChecked();
  shown_alone_ = 0;
  controller().set_guides(guides());
  if (!lesson().tablet)
    controller().set_tablet(nullptr);
  else
    controller().set_tablet(starts ? practice::blank_tablet(lesson().tablet->lines()) : lesson().tablet);
  clear();
}

void GuidedStage::show_alone(int stroke) {
  shown_alone_ = stroke;
  controller().set_guides(guides());
  controller().set_current_stroke(stroke);
}

void GuidedStage::clear() {
  controller().clear_ink();
  recorder_.drop();
  written_.clear();
  controller().set_writing({});
  slipped_ = false;
  told_giving_way_ = false;
}

void GuidedStage::invite() {
  QString sentence =
      actions().by_starts->isChecked() ? tr("Write each stroke from its number.") : tr("Follow the groove.");
  if (actions().lead_hand->isChecked())
    sentence = controller().can_lead()
                   ? tr("Let the stylus take the hand along; hold back, and it gives way.")
                   : tr("%1 Only a device with force leads the hand; here strokes hold it.").arg(sentence);
  if (successes_ > 0) sentence = tr("%1 Without a slip so far: %2.").arg(sentence).arg(successes_);
  desk().say(Feedback::hint, sentence);
}

void GuidedStage::take(practice::TraceEvent event, int stroke) {
  const int next = controller().ink().next_stroke();
  if (StrokeTeller::is_miss(event, controller())) {
    slipped_ = true;
    if (reply_to_miss(next - 1) == study::MissReply::show) {
      show_alone(next);
      desk().say(Feedback::advice, tr("Stroke %1 is shown. Draw it from its number.").arg(next));
      return;
    }
  }
  if (event == practice::TraceEvent::finished && shown_alone_ == stroke) show_alone(0);
  if (event == practice::TraceEvent::finished && next == 0) {
    if (help_) {
      study::WritingResult result;
      result.help = *help_;
      desk().say(slipped_ ? Feedback::advice : Feedback::good,
                 slipped_ ? tr("All strokes are there, not all at their turn.") : tr("Without a slip."));
      emit finished(result);
      return;
    }
    if (slipped_) {
      desk().say(Feedback::advice,
                 tr("All strokes are there, not all at their turn. Delete clears the tablet."));
      return;
    }
    ++successes_;
    lay_out();
    desk().say(Feedback::good,
               successes_ > 2 ? tr("Without a slip, and without help. F8 goes on to writing from memory.")
                              : tr("Without a slip. There is less help now: write it again."));
    return;
  }
  const auto sentence = StrokeTeller::about(event, stroke, controller());
  desk().say(sentence.kind, sentence.text);
}

void GuidedStage::note_giving_way(std::span<const haptics::ServoSample> samples) {
  for (const auto& sample : samples) {
    if (told_giving_way_ || !haptics::has(sample.events, haptics::ServoEvent::resisted)) continue;
    told_giving_way_ = true;
    desk().say(Feedback::hint, tr("The stylus gives way. Go on a little by yourself, and it leads again."));
  }
}

void GuidedStage::take_samples(std::span<const haptics::ServoSample> samples) {
  recorder_.lean(controller().lean_rad());
  bool changed = false;
  for (const auto& sample : samples) {
    const auto event = recorder_.follow(sample);
    changed = changed || event != practice::PenRecorder::Event::none;
    if (event == practice::PenRecorder::Event::ended)
      written_.push_back(practice::to_written(recorder_.take(), view::Verdict::none));
  }
  if (!changed) return;
  auto all = written_;
  if (!recorder_.current().empty())
    all.push_back(practice::to_written(recorder_.current(), view::Verdict::none));
  controller().set_writing(std::move(all));
}

}  // namespace nazori::ui
