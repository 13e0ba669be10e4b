// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/tone_generator.h"

#include <algorithm>
#include <cmath>

#include "voice.h"

namespace nazori::functions {
namespace {

// A cue packed into 64 bits: pitch in sixteenths of a hertz, then pan, noise and loudness in 4095ths.
constexpr double kPitchSteps = 16;
constexpr double kSteps = 4095;

std::uint64_t steps_of(double v) {
  return static_cast<std::uint64_t>(std::lround(std::clamp(v, 0.0, 1.0) * kSteps));
}

std::uint64_t packed(const Cue& c, bool trembles) {
  const double hertz = std::isfinite(c.hertz) ? std::clamp(c.hertz, 0.0, 60'000.0) : 0.0;
  return static_cast<std::uint64_t>(std::lround(hertz * kPitchSteps)) | steps_of((c.pan + 1) / 2) << 24U |
         steps_of(c.noise) << 36U | steps_of(c.loudness) << 48U | (trembles ? 1ULL : 0ULL) << 63U;
}

Cue unpacked(std::uint64_t bits) noexcept {
  const auto part = [bits](unsigned shift) { return static_cast<double>((bits >> shift) & 0xFFFU) / kSteps; };
  Cue c;
  c.hertz = static_cast<double>(bits & 0xFFFFFFU) / kPitchSteps;
  c.pan = 2 * part(24) - 1;
  c.noise = part(36);
  c.loudness = part(48);
  return c;
}

}  // namespace

struct ToneGenerator::Voices {
  explicit Voices(int sample_rate) : rate(sample_rate), voice(sample_rate), earcon(PointKind::zero, 0, 1) {}
  int rate;
  Voice voice;
  Earcon earcon;
  std::uint64_t last_sign = 0;
  double volume = 0;
};

ToneGenerator::ToneGenerator(const SoundSettings& settings)
    : voices_(std::make_unique<Voices>(std::clamp(settings.sample_rate, 8000, 192'000))),
      volume_(static_cast<float>(std::clamp(settings.volume, 0.0, 1.0))) {}

ToneGenerator::~ToneGenerator() = default;

void ToneGenerator::set(const Cue& cue, bool trembles) {
  cue_.store(packed(cue, trembles), std::memory_order_relaxed);
}

void ToneGenerator::play(PointKind sign, double pan) {
  // The number in front distinguishes two equal signs in a row.
  const std::uint64_t number = (sign_.load(std::memory_order_relaxed) >> 32U) + 1;
  sign_.store(number << 32U | static_cast<std::uint64_t>(sign) << 16U | steps_of((pan + 1) / 2),
              std::memory_order_relaxed);
}

void ToneGenerator::set_volume(double volume) {
  volume_.store(static_cast<float>(std::clamp(volume, 0.0, 1.0)), std::memory_order_relaxed);
}

void ToneGenerator::set_muted(bool muted) { muted_.store(muted, std::memory_order_relaxed); }

void ToneGenerator::fill(std::span<float> stereo) noexcept {
  Voices& v = *voices_;
  const std::uint64_t bits = cue_.load(std::memory_order_relaxed);
  const Cue cue = unpacked(bits);
  const bool trembles = (bits >> 63U) != 0;
  const std::uint64_t sign = sign_.load(std::memory_order_relaxed);
  if (sign != v.last_sign) {
    v.last_sign = sign;
    const double pan = 2 * static_cast<double>(sign & 0xFFFU) / kSteps - 1;
    v.earcon = Earcon(static_cast<PointKind>((sign >> 16U) & 0xFFU), pan, v.rate);
  }
  const double wanted =
      muted_.load(std::memory_order_relaxed) ? 0.0 : volume_.load(std::memory_order_relaxed);
  const double ease = 1 - std::exp(-1 / (0.004 * v.rate));
  for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
    v.volume += (wanted - v.volume) * ease;
    if (wanted == 0 && v.volume < 1e-5) v.volume = 0;
    const StereoSample tone = v.voice.next(cue, trembles);
    const StereoSample earcon = v.earcon.next();
    stereo[i] = static_cast<float>(std::clamp((tone.left + earcon.left) * v.volume, -1.0, 1.0));
    stereo[i + 1] = static_cast<float>(std::clamp((tone.right + earcon.right) * v.volume, -1.0, 1.0));
  }
  if (stereo.size() % 2 == 1) stereo.back() = 0;
}

}  // namespace nazori::functions
