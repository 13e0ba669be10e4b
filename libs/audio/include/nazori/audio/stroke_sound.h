// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "nazori/audio/groove_sound.h"
#include "nazori/audio/output.h"
#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/haptics/servo.h"

namespace nazori::audio {

/// The motion of the stylus, as the sound needs it. @param before,now  two samples of one servo. A stroke is
/// where the surface lies lower than the plateau by a tenth of the tablet's depth.
[[nodiscard]] GrooveMotion groove_motion(const haptics::ServoSample& before, const haptics::ServoSample& now,
                                         const geometry::TabletShape& shape);

/// Plays the scratching sound of the stylus through the loudspeakers while it is switched on. The sound card
/// is opened when it is switched on, and closed when it is switched off. Thread: one (interface).
class StrokeSound {
 public:
  StrokeSound();
  ~StrokeSound();
  StrokeSound(const StrokeSound&) = delete;
  StrokeSound& operator=(const StrokeSound&) = delete;

  /// @param failed  called once if there is no sound card, within set_on(); everything else works.
  void on_failure(std::function<void(const base::Error&)> failed);

  void set_on(bool on);
  [[nodiscard]] bool is_on() const { return on_; }
  /// 0..1
  void set_volume(double volume);
  /// Takes the newest samples of the servo, in order.
  void follow(std::span<const haptics::ServoSample> samples, const geometry::TabletShape& shape);

 private:
  bool on_ = false;
  bool reported_ = false;
  std::function<void(const base::Error&)> failed_;
  haptics::ServoSample last_;
  GrooveSound sound_;
  std::unique_ptr<Output> output_;  // declared last, so that it is destroyed before the sound it plays
};

}  // namespace nazori::audio
