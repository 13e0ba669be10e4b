// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/practice_stage.h"

namespace nazori::practice {

/// Tracing the grooves, with lines, arrows and numbers as the learner switches them on the tablet: the
/// program of 2005.
class TraceStage final : public PracticeStage {
 public:
  explicit TraceStage(TabletControl& tablet);

  [[nodiscard]] study::Stage stage() const override { return study::Stage::trace; }

  void show_next_stroke();
  void show_previous_stroke();
  void show_all_strokes();
  void set_strokes_visible(bool on);
  void set_snapping(bool on);
  void clear_ink();

 protected:
  void begin() override;

 private:
  void handle(TraceEvent event, int stroke);

  int shown_alone_ = 0;  ///< stroke that is shown alone after too many mistakes
  base::Connection traced_, erased_;
};

}  // namespace nazori::practice
