// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/trace_stage.h"

#include <utility>

#include "nazori/practice/tracing_feedback.h"

namespace nazori::practice {

TraceStage::TraceStage(TabletControl& control)
    : PracticeStage(control),
      traced_(control.stroke_event.connect([this](TraceEvent event, int stroke) {
        if (is_entered()) handle(event, stroke);
      })),
      erased_(control.eraser_used.connect([this] {
        if (is_entered()) tablet().undo_ink();
      })) {}

void TraceStage::begin() {
  tablet().set_guides({});
  tablet().set_tablet(subject().tablet);
  shown_alone_ = 0;
  changed();
  report(tracing_invitation(tablet()));
}

void TraceStage::show_next_stroke() {
  tablet().next_stroke();
  report(shown_stroke_feedback(tablet()));
}

void TraceStage::show_previous_stroke() {
  tablet().previous_stroke();
  report(shown_stroke_feedback(tablet()));
}

void TraceStage::show_all_strokes() {
  tablet().set_current_stroke(0);
  report(shown_stroke_feedback(tablet()));
}

void TraceStage::set_strokes_visible(bool on) {
  tablet().set_strokes_visible(on);
  report(tablet().snapping() ? snapping_feedback(tablet()) : tracing_invitation(tablet()));
}

void TraceStage::set_snapping(bool on) {
  tablet().set_snapping(on);
  report(snapping_feedback(tablet()));
}

void TraceStage::clear_ink() {
  tablet().clear_ink();
  report(tracing_invitation(tablet()));
}

void TraceStage::handle(TraceEvent event, int stroke) {
  const int next = tablet().ink().next_stroke();
  if (is_mistake(event, tablet()) && reply_to_mistake(next - 1) == study::MissReply::show) {
    shown_alone_ = next;
    tablet().set_current_stroke(next);
    report(shown_stroke_feedback(tablet()));
    return;
  }
  if (event == TraceEvent::finished && std::exchange(shown_alone_, 0) == stroke && next != 0)
    tablet().set_current_stroke(0);
  if (const auto what = tracing_feedback(event, stroke, tablet())) report(*what);
  if (event == TraceEvent::finished && next == 0) finished({});
}

}  // namespace nazori::practice
