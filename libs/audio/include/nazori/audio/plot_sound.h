// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "nazori/audio/output.h"
#include "nazori/base/result.h"
#include "nazori/functions/tone_generator.h"

namespace nazori::audio {

/// The sound of a plot: the tone under the hand, the short sounds of points of interest, and the sweep of
/// whole curves, with one volume. The sound card is opened when the first sound is to be played. Thread: one
/// (interface).
class PlotSound {
 public:
  PlotSound();
  ~PlotSound();
  PlotSound(const PlotSound&) = delete;
  PlotSound& operator=(const PlotSound&) = delete;

  /// @param failed  called once if there is no sound card, within the call that was to play a sound;
  ///   everything else works.
  void on_failure(std::function<void(const base::Error&)> failed);

  /// 0 to 100; other values are limited to this range.
  void set_volume(int percent);
  [[nodiscard]] int volume() const { return volume_; }
  void set_muted(bool muted);
  [[nodiscard]] bool muted() const { return muted_; }

  /// Sets the tone of what is under the hand, until the next call. A loudness of 0 is silence.
  void touch(const functions::Cue& cue, bool trembles = false);
  /// Plays the short sound of a point of interest. @param pan  -1 left to 1 right.
  void sign(functions::PointKind kind, double pan);
  /// Plays a sweep from its start, and stops the previous one.
  void play(functions::Sound sound);
  /// Ends every sound.
  void stop();
  /// Whether the sound card is open.
  [[nodiscard]] bool is_open() const { return output_ != nullptr; }
  /// Whether a sweep is playing.
  [[nodiscard]] bool is_playing() const;
  /// Whether opening the sound card has failed, so that nothing can be heard from this object.
  [[nodiscard]] bool is_refused() const { return refused_; }

 private:
  class Heard;
  [[nodiscard]] bool ready();
  void apply_volume();

  int volume_ = 50;
  bool muted_ = false;
  bool refused_ = false;
  std::function<void(const base::Error&)> failed_;
  std::unique_ptr<Heard> heard_;
  std::unique_ptr<Output> output_;  // declared last, so that it is destroyed before the sounds it plays
};

}  // namespace nazori::audio
