// SPDX-License-Identifier: Apache-2.0
#include "voice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace nazori::functions {
namespace {

// Amplitudes of the harmonics of the tone: richer than a sine, but not shrill.
constexpr std::array<double, 4> kHarmonics{1.0, 0.45, 0.25, 0.12};
constexpr double kSumOfHarmonics = 1.82;
constexpr double kTremoloHz = 14;
constexpr double kGlideSeconds = 0.004;
constexpr double kEarconLoudness = 0.35;
constexpr double kEarconHz = 660;

/// The two short tones of each kind of point, as factors of 660 Hz.
std::pair<double, double> earcon_of(PointKind kind) noexcept {
  switch (kind) {
    case PointKind::zero:
      return {2.0, 2.0};
    case PointKind::y_intercept:
      return {1.5, 1.5};
    case PointKind::maximum:
      return {2.0, 3.0};
    case PointKind::minimum:
      return {3.0, 2.0};
    case PointKind::crossing:
      return {1.0, 2.5};
    case PointKind::touching:
      return {2.5, 2.5};
    case PointKind::hole:
      return {0.5, 0.5};
    case PointKind::vertical_asymptote:
    case PointKind::horizontal_asymptote:
      return {4.0, 1.0};
    case PointKind::jump:
      return {1.0, 4.0};
    case PointKind::end:
      return {1.0, 0.75};
    default:
      return {1.25, 1.5};
  }
}

}  // namespace

StereoSample panned(double value, double pan) noexcept {
  const double angle = (pan + 1) * std::numbers::pi / 4;
  return {value * std::cos(angle), value * std::sin(angle)};
}

Voice::Voice(int sample_rate) noexcept
    : rate_(sample_rate), ease_(1 - std::exp(-1 / (kGlideSeconds * sample_rate))) {}

StereoSample Voice::next(const Cue& target, bool trembles) noexcept {
  const bool sounds = target.loudness > 0 && target.hertz > 0;
  if (sounds) {
    // After silence a tone begins at its own pitch; a fading tone keeps its last one.
    const bool begins = loudness_ < 1e-4;
    hertz_ = begins ? target.hertz : hertz_ * std::pow(target.hertz / hertz_, ease_);
    pan_ = begins ? target.pan : pan_ + (target.pan - pan_) * ease_;
    noise_ = begins ? target.noise : noise_ + (target.noise - noise_) * ease_;
  }
  loudness_ += ((sounds ? target.loudness : 0.0) - loudness_) * ease_;
  if (loudness_ < 1e-5) return {};
  phase_ += hertz_ / rate_;
  phase_ -= std::floor(phase_);
  double tone = 0;
  for (std::size_t h = 0; h < kHarmonics.size(); ++h) {
    const auto order = static_cast<double>(h + 1);
    if (hertz_ * order < 0.45 * rate_)
      tone += kHarmonics[h] * std::sin(2 * std::numbers::pi * order * phase_);
  }
  // The same noise in every run, so that files can be compared.
  seed_ = seed_ * 1664525U + 1013904223U;
  const double noise = static_cast<double>(seed_ >> 8U) / 8388608.0 - 1.0;
  double volume = loudness_;
  if (trembles) {
    tremolo_phase_ += kTremoloHz / rate_;
    tremolo_phase_ -= std::floor(tremolo_phase_);
    volume *= 0.6 + 0.4 * std::sin(2 * std::numbers::pi * tremolo_phase_);
  }
  return panned((tone / kSumOfHarmonics * (1 - noise_) + noise * noise_) * volume, pan_);
}

Earcon::Earcon(PointKind kind, double pan, int sample_rate) noexcept
    : rate_(sample_rate),
      first_hz_(kEarconHz * earcon_of(kind).first),
      second_hz_(kEarconHz * earcon_of(kind).second),
      pan_(pan),
      count_(static_cast<std::size_t>(kSeconds * sample_rate)) {}

StereoSample Earcon::next() noexcept {
  if (is_over()) return {};
  const double t = static_cast<double>(at_) / rate_;
  const double hz = 2 * at_ < count_ ? first_hz_ : second_hz_;
  const double envelope =
      std::sin(std::numbers::pi * static_cast<double>((2 * at_) % count_) / static_cast<double>(count_));
  ++at_;
  return panned(kEarconLoudness * envelope * std::sin(2 * std::numbers::pi * hz * t), pan_);
}

}  // namespace nazori::functions
