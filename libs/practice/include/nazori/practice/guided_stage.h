// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nazori/practice/pen_recorder.h"
#include "nazori/practice/practice_stage.h"

namespace nazori::practice {

/// Tracing with less and less help: only the groove, or only the starting points. Strokes attract the stylus,
/// or a force-feedback device leads the hand along them, and lines are still faintly there; both fade each
/// time the character was traced without a mistake.
class GuidedStage final : public PracticeStage {
 public:
  enum class Guide : std::uint8_t { groove, starting_points };

  explicit GuidedStage(TabletControl& tablet);

  static constexpr std::string_view kId = "guided";
  [[nodiscard]] std::string_view id() const override { return kId; }

  /// Begins again with another guide.
  void set_guide(Guide guide);
  [[nodiscard]] Guide guide() const { return guide_; }
  /// Whether a force-feedback device leads the hand.
  void set_leading(bool on);
  [[nodiscard]] bool leading() const { return leading_; }
  /// Clears the tablet.
  void start_over();
  /// How often this character was traced without a mistake since it came to the tablet.
  [[nodiscard]] int successes() const { return successes_; }
  /// How much help there is, 0..1, where a lesson decides it; nothing: by successes().
  void set_help(std::optional<double> help) { help_ = help; }

 protected:
  void begin() override;
  void end() override;

 private:
  void lay_out();
  [[nodiscard]] TabletGuides guides() const;
  void show_alone(int stroke);
  void clear();
  void invite();
  void handle(TraceEvent event, int stroke);
  void finish();
  void erase();
  void report_giving_way(std::span<const haptics::ServoSample> samples);
  void record(std::span<const haptics::ServoSample> samples);

  Guide guide_ = Guide::groove;
  bool leading_ = false;
  PenRecorder recorder_;
  std::vector<view::InkedStroke> written_;
  char32_t character_ = 0;
  int successes_ = 0;
  std::optional<double> help_;
  int shown_alone_ = 0;  ///< stroke that is shown after too many mistakes
  bool has_mistake_ = false;
  bool has_reported_giving_way_ = false;  ///< once for each time the character is traced
  base::Connection traced_, erased_, pressed_, sampled_;
};

}  // namespace nazori::practice
