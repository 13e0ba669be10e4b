// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

#include "nazori/functions/sound.h"

namespace nazori::functions {

/// A tone that follows a hand: the interface sets the position of the hand, the audio callback requests
/// samples.
///
/// set(), play() and the volume are for one thread at a time, fill() for another; neither waits for the
/// other. fill() does not allocate, lock, throw or call the system. Changes take 5 ms, so that there are no
/// clicks.
class ToneGenerator {
 public:
  /// @param settings  sample rate and volume; out-of-range values are limited to the range. Allocates.
  explicit ToneGenerator(const SoundSettings& settings = {});
  ToneGenerator(const ToneGenerator&) = delete;
  ToneGenerator& operator=(const ToneGenerator&) = delete;
  ~ToneGenerator();

  /// Sets the sound from now on; a loudness of 0 is silence. Wait-free.
  /// @param trembles  over a dense band, where there is no single height.
  void set(const Cue& cue, bool trembles = false);
  /// Plays the earcon of a point of interest over the present tone; a newer one ends an older one. Wait-free.
  /// @param pan  -1 left to 1 right.
  void play(PointKind sign, double pan);
  /// Master volume, 0 to 1. Wait-free.
  void set_volume(double volume);
  /// Mutes the sound without changing the volume. Wait-free.
  void set_muted(bool muted);

  /// The next samples in -1..1, left and right alternating; an odd last one is set to 0.
  void fill(std::span<float> stereo) noexcept;

 private:
  struct Voices;
  std::unique_ptr<Voices> voices_;
  // A cue packed into one word, so that its parts always match.
  std::atomic<std::uint64_t> cue_{0};
  std::atomic<std::uint64_t> sign_{0};
  std::atomic<float> volume_;
  std::atomic<bool> muted_{false};
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<float>::is_always_lock_free);
};

}  // namespace nazori::functions
