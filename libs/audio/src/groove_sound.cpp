// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/groove_sound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nazori::audio {
namespace {

constexpr float kGlide_s = 0.020F;
constexpr float kFastest_m_s = 0.30F;  ///< brisk writing; faster is no louder
constexpr float kDullest_hz = 600.0F;
constexpr float kBrightest_hz = 6'000.0F;
constexpr float kBeside_hz = 110.0F;
constexpr float kRumble_hz = 150.0F;  ///< a scratch has no frequencies below this

float finite(float value) { return std::isfinite(value) ? value : 0.0F; }

constexpr float kUnit = 32'767.0F;
std::uint64_t packed(float value) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * kUnit));
}
float unpacked(std::uint64_t word, int shift) {
  return static_cast<float>((word >> shift) & 0xFFFFU) / kUnit;
}

}  // namespace

GrooveSound::GrooveSound(int rate_hz) : rate_hz_(static_cast<float>(rate_hz)) {}

void GrooveSound::set(const GrooveMotion& motion) {
  const float speed = std::abs(finite(motion.speed_m_s)) / kFastest_m_s;
  const float right = 0.5F + 0.5F * std::clamp(finite(motion.pan), -1.0F, 1.0F);
  motion_.store(packed(speed) | packed(finite(motion.pressure)) << 16 | packed(right) << 32 |
                    static_cast<std::uint64_t>(motion.on_stroke ? 0 : 1) << 48,
                std::memory_order_relaxed);
}

void GrooveSound::set_volume(float volume) {
  volume_.store(std::clamp(finite(volume), 0.0F, 1.0F), std::memory_order_relaxed);
}

void GrooveSound::set_muted(bool muted) { muted_.store(muted, std::memory_order_relaxed); }

void GrooveSound::add_to(std::span<float> stereo) noexcept {
  const std::uint64_t word = motion_.load(std::memory_order_relaxed);
  const float speed = unpacked(word, 0);
  const float pressure = unpacked(word, 16);
  const float pan = unpacked(word, 32);
  const float beside = (word >> 48) != 0 ? 1.0F : 0.0F;
  const float volume =
      muted_.load(std::memory_order_relaxed) ? 0.0F : volume_.load(std::memory_order_relaxed);
  // A scratch's power grows with speed and load; the root keeps slow writing audible.
  const float gain = volume * std::sqrt(speed * pressure);
  const float cutoff_hz = kDullest_hz * std::pow(kBrightest_hz / kDullest_hz, std::sqrt(speed));

  const float glide = 1 - std::exp(-1 / (kGlide_s * rate_hz_));
  constexpr float kTurn = 2 * std::numbers::pi_v<float>;
  const float drop = 1 - std::exp(-kTurn * kRumble_hz / rate_hz_);
  for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
    gain_ += (gain - gain_) * glide;
    beside_ += (beside - beside_) * glide;
    pan_ += (pan - pan_) * glide;
    cutoff_hz_ += (cutoff_hz - cutoff_hz_) * glide;

    noise_ = noise_ * 1'664'525U + 1'013'904'223U;
    const float white = static_cast<float>(static_cast<std::int32_t>(noise_)) * 0x1p-31F;
    const float dull_hz = cutoff_hz_ + (0.35F * kDullest_hz - cutoff_hz_) * beside_;
    const float pass = 1 - std::exp(-kTurn * dull_hz / rate_hz_);
    low_[0] += (white - low_[0]) * pass;
    low_[1] += (low_[0] - low_[1]) * pass;
    high_ += (low_[1] - high_) * drop;
    // White noise after two low-pass filters, amplified to about its original power.
    const float scratch = (low_[1] - high_ * (1 - beside_)) * 0.6F / std::sqrt(pass);

    phase_ += kBeside_hz / rate_hz_;
    phase_ -= std::floor(phase_);
    const float rough =
        std::sin(kTurn * phase_) + 0.5F * std::sin(2 * kTurn * phase_) + 0.33F * std::sin(3 * kTurn * phase_);
    const float sample = gain_ * ((1 - 0.5F * beside_) * scratch + beside_ * 0.35F * rough);
    stereo[i] += sample * std::sqrt(1 - pan_);
    stereo[i + 1] += sample * std::sqrt(pan_);
  }
}

}  // namespace nazori::audio
