// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/base/clock.h"
#include "nazori/practice/practice_stage.h"
#include "nazori/practice/stroke_player.h"

namespace nazori::practice {

/// A brush writes the character at a teacher's speed. While is_playing(), whoever shows the tablet calls
/// advance() for each frame.
class WatchStage final : public PracticeStage {
 public:
  /// @param clock  outlives this.
  WatchStage(TabletControl& tablet, const base::Clock& clock) : PracticeStage(tablet), clock_(clock) {}

  static constexpr std::string_view kId = "watch";
  [[nodiscard]] std::string_view id() const override { return kId; }
  [[nodiscard]] std::vector<StageCommand> commands() override;

  /// Nothing moves unless it is asked for.
  void set_reduced_motion(bool on) { reduced_motion_ = on; }
  /// Begins again at the end.
  void set_looping(bool on) { is_looping_ = on; }

  void set_playing(bool playing);
  [[nodiscard]] bool is_playing() const { return is_playing_; }
  /// Goes on by the time that has passed on the clock.
  void advance();
  /// Goes to the end of the next stroke (+1), or back to the start of the first or the end of an earlier one
  /// (-1).
  void step(int by);
  void change_speed(double factor);
  void faster();
  void slower();
  [[nodiscard]] double speed() const { return speed_; }
  /// Goes to a moment of the writing [s].
  void show_moment(double time_s);
  /// The stroke that the brush writes or will write next, from 1; 0 where there is none.
  [[nodiscard]] int current_stroke() const;
  [[nodiscard]] const StrokePlayer& player() const { return player_; }

 protected:
  void begin() override;
  void end() override;

 private:
  void report_stroke(int stroke);

  const base::Clock& clock_;
  StrokePlayer player_;
  base::Clock::Steady since_{};  ///< when the time was last advanced
  double time_s_ = 0;
  double speed_ = 1;
  int reported_ = 0;  ///< stroke that was reported last
  bool is_playing_ = false;
  bool is_looping_ = false;
  bool reduced_motion_ = false;
};

}  // namespace nazori::practice
