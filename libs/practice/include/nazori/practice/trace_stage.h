// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/practice_stage.h"

namespace nazori::practice {

/// Tracing the grooves, with lines, arrows and numbers as the learner switches them on the tablet: the
/// program of 2005.
class TraceStage final : public PracticeStage {
 public:
  explicit TraceStage(TabletControl& tablet);

  static constexpr std::string_view kId = "trace";
  [[nodiscard]] std::string_view id() const override { return kId; }
  /// Also a tablet of the learner's own.
  [[nodiscard]] bool can_practise(const StageSubject& /*subject*/) const override { return true; }

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
