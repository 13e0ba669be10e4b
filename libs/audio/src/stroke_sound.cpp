// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/stroke_sound.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace nazori::audio {
namespace {

constexpr double kFullPress_m = 0.015;  // the depth that the hardest press of a pen reaches
constexpr double kInGroove = 0.1;       // of the tablet's depth

}  // namespace

GrooveMotion groove_motion(const haptics::ServoSample& before, const haptics::ServoSample& now,
                           const geometry::TabletShape& shape) {
  GrooveMotion motion;
  if (!now.touching || !before.touching) return motion;
  const double elapsed_s = now.time_s - before.time_s;
  if (!(elapsed_s > 0)) return motion;
  motion.speed_m_s = static_cast<float>(glm::length(now.proxy_m - before.proxy_m) / elapsed_s);
  const double press = glm::length(now.proxy_m - now.device_m) / kFullPress_m;
  motion.pressure = static_cast<float>(std::clamp(press, 0.05, 1.0));
  motion.on_stroke = now.proxy_m.z < -kInGroove * shape.depth_m;
  motion.pan = static_cast<float>(std::clamp(now.proxy_m.x / (shape.width_m / 2), -1.0, 1.0));
  return motion;
}

StrokeSound::StrokeSound() = default;

StrokeSound::~StrokeSound() = default;

void StrokeSound::on_failure(std::function<void(const base::Error&)> failed) { failed_ = std::move(failed); }

void StrokeSound::set_on(bool on) {
  on_ = on;
  sound_.set_muted(!on);
  if (!on) {
    output_.reset();
    return;
  }
  if (output_) return;
  auto opened = Output::open(sound_);
  if (opened) {
    output_ = std::move(*opened);
  } else if (!std::exchange(reported_, true) && failed_) {
    failed_(opened.error());
  }
}

void StrokeSound::set_volume(double volume) { sound_.set_volume(static_cast<float>(volume)); }

void StrokeSound::follow(std::span<const haptics::ServoSample> samples, const geometry::TabletShape& shape) {
  if (!output_ || samples.empty()) return;
  // Average over all samples: a single millisecond is as coarse as the pixels of the screen.
  sound_.set(groove_motion(last_, samples.back(), shape));
  last_ = samples.back();
}

}  // namespace nazori::audio
