// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "nazori/functions/tone_generator.h"

namespace nazori::functions {

/// All sound of a plot: the tone under the hand with the earcons of points of interest, mixed with a sound
/// that is played once.
///
/// add_to() is for the audio thread and does not allocate, lock, throw or call the system; all other
/// functions are for one other thread (the interface). Neither waits for the other: the interface frees a
/// replaced sound once the audio thread no longer uses it.
class PlotMixer {
 public:
  /// @param sample_rate  of the sound card and of every sound that is played.
  explicit PlotMixer(int sample_rate);
  PlotMixer(const PlotMixer&) = delete;
  PlotMixer& operator=(const PlotMixer&) = delete;
  ~PlotMixer();

  /// The tone under the hand. Its volume is set by set_volume() of the mixer.
  [[nodiscard]] ToneGenerator& tone() noexcept { return tone_; }
  /// Sets the volume of everything. @param volume  0 to 1.
  void set_volume(double volume, bool muted);
  /// Plays `sound` from its start and stops the previous one; an empty one is silence.
  void play(Sound sound);
  /// Whether a sound is playing.
  [[nodiscard]] bool is_playing() const;

  /// Adds the next samples to `stereo`, left and right alternating. Thread: audio.
  void add_to(std::span<float> stereo) noexcept;

 private:
  struct Sweep {
    std::vector<float> samples;
    std::atomic<std::size_t> position{0};
  };

  ToneGenerator tone_;
  std::atomic<float> gain_{0.5F};
  std::atomic<Sweep*> present_{nullptr};
  std::atomic<Sweep*> read_{nullptr};         // used by the audio thread: must not be freed
  std::vector<std::unique_ptr<Sweep>> kept_;  // interface thread
  std::array<float, 1024> piece_{};           // audio thread
};

}  // namespace nazori::functions
