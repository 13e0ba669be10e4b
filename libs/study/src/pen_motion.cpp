// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "saved_point.h"

namespace nazori::study {
namespace {

constexpr double kSampleS = 0.01;
constexpr double kCutOffHz = 10;
constexpr double kFrequencyStepHz = 0.1;
constexpr double kAmplitudeLimit = 0.05;
constexpr double kShortestLength = 2;
constexpr double kShortestS = 0.08;
// A stroke ends where it rests longer than this: the rest is not a movement.
constexpr double kLongestS = 20;

/// A point as it is saved, so that an imported history gives the same measures.
struct TimedPoint {
  geometry::GlyphPoint at;
  std::int32_t time_ms = 0;
};
using TimedStroke = std::vector<TimedPoint>;

TimedStroke as_saved(const HandwritingStroke& written) {
  TimedStroke stroke;
  stroke.reserve(written.size());
  for (const HandwritingPoint& point : written) {
    const SavedPoint steps = in_steps(point);
    stroke.push_back({from_steps(steps).at, steps.time_ms});
  }
  return stroke;
}

double length_of(const TimedStroke& stroke) {
  double length = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    length += geometry::distance(stroke[i - 1].at, stroke[i].at);
  }
  return length;
}

double duration_s(const TimedStroke& stroke) {
  return stroke.empty() ? 0 : (stroke.back().time_ms - stroke.front().time_ms) / 1000.0;
}

/// Speed in samples of 10 ms. The pen's points are unevenly spaced in time, so the drawn length is
/// interpolated between them.
std::vector<double> speed_profile(const TimedStroke& stroke) {
  const auto samples = static_cast<std::size_t>(std::min(duration_s(stroke), kLongestS) / kSampleS);
  std::vector<double> speed(samples);
  std::size_t next = 1;
  double passed = 0;  // length up to point next - 1
  double before = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const double at_ms = stroke.front().time_ms + static_cast<double>(i + 1) * kSampleS * 1000;
    while (next + 1 < stroke.size() && stroke[next].time_ms < at_ms) {
      passed += geometry::distance(stroke[next - 1].at, stroke[next].at);
      ++next;
    }
    const TimedPoint& a = stroke[next - 1];
    const TimedPoint& b = stroke[next];
    const double gap = std::max(1, b.time_ms - a.time_ms);
    const double share = std::clamp((at_ms - a.time_ms) / gap, 0.0, 1.0);
    const double length = passed + share * geometry::distance(a.at, b.at);
    speed[i] = (length - before) / kSampleS;
    before = length;
  }
  return speed;
}

constexpr std::size_t kSteps = 101;  // 0 Hz to the cut-off
static_assert((kSteps - 1) * kFrequencyStepHz > kCutOffHz - 1e-6 &&
              (kSteps - 1) * kFrequencyStepHz < kCutOffHz + 1e-6);
/// Padded, so that the processor can handle them in parallel.
constexpr std::size_t kLanes = (kSteps + 7) / 8 * 8;
using Lanes = std::array<double, kLanes>;

/// The waves of all frequencies at one sample.
struct Waves {
  Lanes real{};
  Lanes imaginary{};
};

/// One turn, divided into as many parts as there are samples in a period of the frequency step: after that
/// many samples every wave repeats.
constexpr std::size_t kParts = 1000;
static_assert(kFrequencyStepHz * kSampleS * kParts > 0.999999 &&
              kFrequencyStepHz * kSampleS * kParts < 1.000001);

const std::vector<Waves>& waves() {
  static const std::vector<Waves> all = [] {
    std::vector<Waves> made(kParts);
    for (std::size_t sample = 0; sample < kParts; ++sample) {
      for (std::size_t step = 0; step < kSteps; ++step) {
        const auto part = static_cast<double>(sample * step % kParts);
        const double angle = 2 * std::numbers::pi * part / kParts;
        made[sample].real[step] = std::cos(angle);
        made[sample].imaginary[step] = -std::sin(angle);
      }
    }
    return made;
  }();
  return all;
}

/// Amplitudes of the spectrum from 0 Hz to the cut-off, the first being 1.
std::array<double, kSteps> amplitudes(const std::vector<double>& speed) {
  Lanes real{};
  Lanes imaginary{};
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const Waves& wave = waves()[i % kParts];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      real[lane] += speed[i] * wave.real[lane];
      imaginary[lane] += speed[i] * wave.imaginary[lane];
    }
  }
  std::array<double, kSteps> spectrum{};
  for (std::size_t step = 0; step < kSteps; ++step)
    spectrum[step] = std::sqrt(real[step] * real[step] + imaginary[step] * imaginary[step]);
  const double first = spectrum.front();
  for (double& one : spectrum) one = first > 0 ? one / first : 0;
  return spectrum;
}

double spectral_arc_length(const std::vector<double>& speed) {
  const auto spectrum = amplitudes(speed);
  std::size_t last = spectrum.size() - 1;
  while (last > 1 && spectrum[last] < kAmplitudeLimit) --last;
  double arc = 0;
  for (std::size_t i = 1; i <= last; ++i) {
    const double along = 1.0 / static_cast<double>(last);
    const double up = spectrum[i] - spectrum[i - 1];
    arc += std::sqrt(along * along + up * up);
  }
  return -arc;
}

}  // namespace

std::optional<PenMotion> motion_of(const Handwriting& ink) {
  double length = 0;
  double seconds = 0;
  double arcs = 0;
  int counted = 0;
  for (const HandwritingStroke& written : ink) {
    const TimedStroke stroke = as_saved(written);
    const double own_length = length_of(stroke);
    const double own_s = duration_s(stroke);
    if (own_length < kShortestLength || own_s < kShortestS) continue;
    length += own_length;
    seconds += own_s;
    arcs += spectral_arc_length(speed_profile(stroke));
    ++counted;
  }
  if (counted == 0) return std::nullopt;
  return PenMotion{length / seconds, arcs / counted};
}

}  // namespace nazori::study
