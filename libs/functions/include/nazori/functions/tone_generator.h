// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

#include "nazori/functions/sound.h"

namespace nazori::functions {

/// A tone that follows a hand: the interface says where the hand is, the audio callback asks for samples.
///
/// set(), play() and the volume are for one thread at a time, fill() for another; neither waits for the
/// other. fill() does not allocate, lock, throw or call the system. Changes glide within 5 ms, so nothing
/// clicks.
class ToneGenerator {
 public:
  /// @param settings  sample rate and volume; out-of-range values are brought into range. Allocates.
  explicit ToneGenerator(const SoundSettings& settings = {});
  ToneGenerator(const ToneGenerator&) = delete;
  ToneGenerator& operator=(const ToneGenerator&) = delete;
  ~ToneGenerator();

  /// What is to be heard from now on; a loudness of 0 is silence. Wait-free.
  /// @param trembles  over a dense band, where there is no single height.
  void set(const Cue& cue, bool trembles = false);
  /// The sign of a point of interest, over what sounds already; a newer one ends an older one. Wait-free.
  /// @param pan  -1 left to 1 right.
  void play(PointKind sign, double pan);
  /// Master volume, 0 to 1. Wait-free.
  void set_volume(double volume);
  /// Silence without losing the volume. Wait-free.
  void set_muted(bool muted);

  /// The next samples in -1..1, left and right by turns; an odd last one is set to 0.
  void fill(std::span<float> stereo) noexcept;

 private:
  struct Voices;
  std::unique_ptr<Voices> voices_;
  // A cue in one word, so that its parts always belong together.
  std::atomic<std::uint64_t> cue_{0};
  std::atomic<std::uint64_t> sign_{0};
  std::atomic<float> volume_;
  std::atomic<bool> muted_{false};
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<float>::is_always_lock_free);
};

}  // namespace nazori::functions
