// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/plot_sound.h"

#include <algorithm>
#include <utility>

#include "nazori/functions/plot_mixer.h"

namespace nazori::audio {
namespace {

constexpr int kRate_hz = 44'100;

}  // namespace

/// Makes the mixer a source for the sound card.
class PlotSound::Heard final : public Source {
 public:
  void add_to(std::span<float> stereo) noexcept override { mixer.add_to(stereo); }
  functions::PlotMixer mixer{kRate_hz};
};

PlotSound::PlotSound() : heard_(std::make_unique<Heard>()) { apply_volume(); }

PlotSound::~PlotSound() = default;

void PlotSound::on_failure(std::function<void(const base::Error&)> failed) { failed_ = std::move(failed); }

void PlotSound::set_volume(int percent) {
  volume_ = std::clamp(percent, 0, 100);
  apply_volume();
}

void PlotSound::set_muted(bool muted) {
  muted_ = muted;
  apply_volume();
}

void PlotSound::apply_volume() { heard_->mixer.set_volume(volume_ / 100.0, muted_); }

bool PlotSound::ready() {
  if (muted_ || refused_) return false;
  if (output_) return true;
  auto opened = Output::open(*heard_, {kRate_hz, 512});
  if (!opened) {
    refused_ = true;
    if (failed_) failed_(opened.error());
    return false;
  }
  output_ = std::move(*opened);
  return true;
}

void PlotSound::touch(const functions::Cue& cue, bool trembles) {
  if (cue.loudness > 0 && !ready()) return;
  heard_->mixer.tone().set(cue, trembles);
}

void PlotSound::sign(functions::PointKind kind, double pan) {
  if (ready()) heard_->mixer.tone().play(kind, std::clamp(pan, -1.0, 1.0));
}

void PlotSound::play(functions::Sound sound) {
  if (ready()) heard_->mixer.play(std::move(sound));
}

void PlotSound::stop() {
  heard_->mixer.tone().set({});
  heard_->mixer.play({});
}

bool PlotSound::is_playing() const { return output_ && heard_->mixer.is_playing(); }

}  // namespace nazori::audio
