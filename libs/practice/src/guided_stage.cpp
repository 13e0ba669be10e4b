// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/guided_stage.h"

#include <algorithm>
#include <array>
#include <utility>

#include "nazori/practice/blank_tablet.h"
#include "nazori/practice/tracing_feedback.h"

namespace nazori::practice {
namespace {

/// By the number of successes: how much of the lines is still seen, and how firmly strokes attract the
/// stylus.
constexpr std::array kLines{0.45, 0.2, 0.0, 0.0};
constexpr std::array kHold{1.0, 0.6, 0.3, 0.0};
/// With less help the numbers are hidden, too.
constexpr double kNumbersUntil = 0.5;

double at_level(const std::array<double, 4>& help, int successes) {
  return help[static_cast<std::size_t>(std::min(successes, 3))];
}

}  // namespace

GuidedStage::GuidedStage(TabletControl& control)
    : PracticeStage(control),
      traced_(control.stroke_event.connect([this](TraceEvent event, int stroke) {
        if (is_entered()) handle(event, stroke);
      })),
      erased_(control.eraser_used.connect([this] {
        if (is_entered()) erase();
      })),
      pressed_(control.pressed.connect([this](geometry::TabletPoint at) { recorder_.press_at(at); })),
      sampled_(control.sampled.connect([this](std::span<const haptics::ServoSample> samples) {
        if (!is_entered()) return;
        if (guide_ == Guide::starting_points) record(samples);
        report_giving_way(samples);
      })) {}

void GuidedStage::set_guide(Guide guide) {
  guide_ = guide;
  if (!is_entered()) return;
  lay_out();
  invite();
}

void GuidedStage::set_leading(bool on) {
  leading_ = on;
  if (!is_entered()) return;
  tablet().set_guides(guides());
  invite();
}

void GuidedStage::start_over() {
  clear();
  invite();
}

void GuidedStage::begin() {
  const char32_t character = subject().sheet ? subject().sheet->character.code_point : 0;
  if (character != character_ || character == 0) successes_ = 0;
  character_ = character;
  lay_out();
  invite();
}

void GuidedStage::end() { tablet().set_writing({}); }

TabletGuides GuidedStage::guides() const {
  TabletGuides guides;
  const double help = help_.value_or(at_level(kHold, successes_));
  guides.lines_opacity = help_ ? kLines.front() * help : at_level(kLines, successes_);
  guides.numbers = guide_ == Guide::starting_points || (help_ ? help > kNumbersUntil : successes_ == 0);
  guides.strokes = guides.numbers || guides.lines_opacity > 0;
  guides.arrows = guides.lines_opacity > 0;
  guides.snapping_strength = help;
  if (shown_alone_ != 0) {
    guides.strokes = guides.arrows = guides.numbers = true;
    guides.lines_opacity = 1;
  }
  guides.leading = leading_ && help > 0;
  guides.snapping = help > 0;
  guides.traced = true;
  return guides;
}

void GuidedStage::lay_out() {
  shown_alone_ = 0;
  tablet().set_guides(guides());
  if (!subject().tablet)
    tablet().set_tablet(nullptr);
  else
    tablet().set_tablet(guide_ == Guide::starting_points ? blank_tablet(subject().tablet->lines())
                                                         : subject().tablet);
  clear();
}

void GuidedStage::show_alone(int stroke) {
  shown_alone_ = stroke;
  tablet().set_guides(guides());
  tablet().set_current_stroke(stroke);
}

void GuidedStage::clear() {
  tablet().clear_ink();
  recorder_.drop();
  written_.clear();
  tablet().set_writing({});
  has_mistake_ = false;
  has_reported_giving_way_ = false;
}

void GuidedStage::invite() {
  report(
      {.event = guide_ == Guide::starting_points ? StageEvent::write_from_starts : StageEvent::follow_hidden,
       .count = successes_,
       .leading = !leading_             ? Leading::none
                  : tablet().can_lead() ? Leading::leading
                                        : Leading::missing});
}

void GuidedStage::erase() {
  tablet().undo_ink();
  if (!written_.empty()) written_.pop_back();
  tablet().set_writing(written_);
}

void GuidedStage::handle(TraceEvent event, int stroke) {
  const int next = tablet().ink().next_stroke();
  if (is_mistake(event, tablet())) {
    has_mistake_ = true;
    if (reply_to_mistake(next - 1) == study::MissReply::show) {
      show_alone(next);
      report({.event = StageEvent::stroke_shown_alone, .tone = Tone::advice, .stroke = next});
      return;
    }
  }
  if (event == TraceEvent::finished && shown_alone_ == stroke) show_alone(0);
  if (event == TraceEvent::finished && next == 0)
    finish();
  else if (const auto what = tracing_feedback(event, stroke, tablet()))
    report(*what);
}

void GuidedStage::finish() {
  if (help_) {
    study::WritingResult result;
    result.help = *help_;
    if (has_mistake_)
      report({.event = StageEvent::lesson_with_mistakes, .tone = Tone::advice});
    else
      report({.event = StageEvent::guided_without_mistake, .tone = Tone::good});
    finished(result);
    return;
  }
  if (has_mistake_) {
    report({.event = StageEvent::guided_with_mistakes, .tone = Tone::advice});
    return;
  }
  ++successes_;
  lay_out();
  report({.event = successes_ > 2 ? StageEvent::guided_without_help : StageEvent::guided_less_help,
          .tone = Tone::good});
}

void GuidedStage::report_giving_way(std::span<const haptics::ServoSample> samples) {
  for (const auto& sample : samples) {
    if (has_reported_giving_way_ || !haptics::has(sample.events, haptics::ServoEvent::resisted)) continue;
    has_reported_giving_way_ = true;
    report({.event = StageEvent::gives_way});
  }
}

void GuidedStage::record(std::span<const haptics::ServoSample> samples) {
  recorder_.lean(tablet().lean_rad());
  bool has_changed = false;
  for (const auto& sample : samples) {
    const auto event = recorder_.follow(sample);
    has_changed = has_changed || event != PenRecorder::Event::none;
    if (event == PenRecorder::Event::ended)
      written_.push_back(view::inked(recorder_.take(), view::Verdict::none));
  }
  if (!has_changed) return;
  auto all = written_;
  if (!recorder_.current().empty())
    all.push_back(view::inked(recorder_.current(), view::Verdict::none, false));
  tablet().set_writing(std::move(all));
}

}  // namespace nazori::practice
