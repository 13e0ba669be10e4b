// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "nazori/audio/output.h"

namespace nazori::audio {

/// How the stylus moves over the tablet.
struct GrooveMotion {
  float speed_m_s = 0;    ///< along the surface
  float pressure = 0;     ///< 0 lifted .. 1 pressed as hard as makes a difference
  bool on_stroke = true;  ///< false: beside it
  float pan = 0;          ///< -1 left .. 1 right
};

/// The scratching sound of a stylus in a groove: noise that grows louder with speed and pressure and brighter
/// with speed, as a real one does. Beside the stroke it is a low rough tone under a dull noise, which differs
/// from the scratch at any loudness. Silent at rest and when lifted. Changes take up to 20 ms. Thread rules:
/// set(), set_volume() and set_muted() on one thread, add_to() on the audio thread; neither waits for the
/// other.
class GrooveSound final : public Source {
 public:
  explicit GrooveSound(int rate_hz = OutputSettings{}.rate_hz);

  /// Sets the present motion; wait-free. Values that are not finite count as 0.
  void set(const GrooveMotion& motion);
  /// 0 to 1.
  void set_volume(float volume);
  void set_muted(bool muted);

  void add_to(std::span<float> stereo) noexcept override;

 private:
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<float>::is_always_lock_free);

  const float rate_hz_;
  std::atomic<std::uint64_t> motion_{0};  // packed into one word, so that its parts always match
  std::atomic<float> volume_{0.5F};
  std::atomic<bool> muted_{false};

  // Audio thread.
  float gain_ = 0;
  float beside_ = 0;  // 0 in the groove .. 1 beside it
  float pan_ = 0;
  float cutoff_hz_ = 500;
  float phase_ = 0;
  std::uint32_t noise_ = 0x9E3779B9U;
  std::array<float, 2> low_{};
  float high_ = 0;
};

}  // namespace nazori::audio
