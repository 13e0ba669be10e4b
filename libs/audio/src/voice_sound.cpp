// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/voice_sound.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::audio {

VoiceMixer::VoiceMixer(int rate_hz) : rate_hz_(rate_hz) {}

VoiceMixer::~VoiceMixer() = default;

std::vector<float> at_rate(const speech::Sound& sound, int rate_hz) {
  if (sound.samples.empty() || sound.rate_hz <= 0 || rate_hz <= 0) return {};
  if (sound.rate_hz == rate_hz) return sound.samples;
  const double step = static_cast<double>(sound.rate_hz) / rate_hz;
  const auto count = static_cast<std::size_t>(std::ceil(static_cast<double>(sound.samples.size()) / step));
  std::vector<float> samples(count);
  const std::size_t last = sound.samples.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i) * step;
    const std::size_t before = std::min(static_cast<std::size_t>(at), last);
    const float share = static_cast<float>(at - static_cast<double>(before));
    const float next = sound.samples[std::min(before + 1, last)];
    samples[i] = sound.samples[before] + std::min(share, 1.0F) * (next - sound.samples[before]);
  }
  return samples;
}

void VoiceMixer::play(const speech::Sound& sound) {
  auto clip = std::make_unique<Clip>();
  clip->samples = at_rate(sound, rate_hz_);
  put(std::move(clip));
}

void VoiceMixer::stop() { put(nullptr); }

void VoiceMixer::put(std::unique_ptr<Clip> clip) {
  Clip* const now = clip.get();
  if (clip) clips_.push_back(std::move(clip));
  current_.store(now);
  // The audio thread names the clip before it checks that it is still the current one, so a clip that is
  // neither named nor current is not read any more.
  const Clip* const used = in_use_.load();
  std::erase_if(clips_,
                [&](const std::unique_ptr<Clip>& one) { return one.get() != now && one.get() != used; });
}

bool VoiceMixer::is_playing() const {
  const Clip* const clip = current_.load();
  return clip != nullptr && clip->at.load() < clip->samples.size();
}

void VoiceMixer::add_to(std::span<float> stereo) noexcept {
  Clip* const clip = current_.load();
  in_use_.store(clip);
  // Replaced in between: silent for this once, about 10 ms.
  if (clip != nullptr && current_.load() == clip) {
    std::size_t at = clip->at.load();
    const float volume = volume_.load();
    const float* const samples = clip->samples.data();
    const std::size_t end = clip->samples.size();
    for (std::size_t i = 0; i + 1 < stereo.size() && at < end; i += 2, ++at) {
      stereo[i] += volume * samples[at];
      stereo[i + 1] += volume * samples[at];
    }
    clip->at.store(at);
  }
  in_use_.store(nullptr);
}

VoiceSound::VoiceSound() = default;
VoiceSound::~VoiceSound() = default;

base::Result<void> VoiceSound::play(const speech::Sound& sound) {
  if (!output_) {
    auto opened = Output::open(mixer_);
    if (!opened) return tl::unexpected(opened.error());
    output_ = std::move(*opened);
  }
  mixer_.play(sound);
  return {};
}

void VoiceSound::set_volume(double volume) {
  mixer_.set_volume(static_cast<float>(std::clamp(std::isfinite(volume) ? volume : 0.0, 0.0, 1.0)));
}

void VoiceSound::close() {
  mixer_.stop();
  output_.reset();
}

}  // namespace nazori::audio
