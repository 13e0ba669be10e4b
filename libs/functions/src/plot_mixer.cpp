// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_mixer.h"

#include <algorithm>
#include <utility>

namespace nazori::functions {
namespace {

SoundSettings full_volume(int sample_rate) {
  SoundSettings settings;
  settings.sample_rate = sample_rate;
  settings.volume = 1;
  return settings;
}

}  // namespace

PlotMixer::PlotMixer(int sample_rate) : tone_(full_volume(sample_rate)) {}
PlotMixer::~PlotMixer() = default;

void PlotMixer::set_volume(double volume, bool muted) {
  tone_.set_volume(volume);
  tone_.set_muted(muted);
  gain_.store(muted ? 0.0F : static_cast<float>(std::clamp(volume, 0.0, 1.0)));
}

void PlotMixer::play(Sound sound) {
  auto next = std::make_unique<Sweep>();
  next->samples = std::move(sound.samples);
  present_.store(next->samples.empty() ? nullptr : next.get());
  kept_.push_back(std::move(next));
  const Sweep* in_use = read_.load();
  std::erase_if(kept_,
                [&](const auto& sweep) { return sweep.get() != in_use && sweep.get() != present_.load(); });
}

bool PlotMixer::is_playing() const {
  const Sweep* sweep = present_.load();
  return sweep != nullptr && sweep->position.load() < sweep->samples.size();
}

void PlotMixer::add_to(std::span<float> stereo) noexcept {
  for (std::size_t done = 0; done < stereo.size(); done += piece_.size()) {
    const auto part = stereo.subspan(done, std::min(piece_.size(), stereo.size() - done));
    tone_.fill(std::span(piece_).first(part.size()));
    for (std::size_t i = 0; i < part.size(); ++i) part[i] += piece_[i];
  }
  Sweep* sweep = present_.load();
  read_.store(sweep);
  // Replaced in between: the new one is played from the next call on.
  if (sweep != nullptr && present_.load() == sweep) {
    const std::size_t from = sweep->position.load();
    const std::size_t count = std::min(stereo.size(), sweep->samples.size() - from);
    const float gain = gain_.load();
    for (std::size_t i = 0; i < count; ++i) stereo[i] += gain * sweep->samples[from + i];
    sweep->position.store(from + count);
  }
  read_.store(nullptr);
}

}  // namespace nazori::functions
