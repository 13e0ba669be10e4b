// SPDX-License-Identifier: Apache-2.0
#include "functions/function_sound.h"

#include <algorithm>
#include <utility>

#include "nazori/functions/plot_mixer.h"

namespace nazori::ui {
namespace {

constexpr int kBrief_ms = 220;
constexpr int kRate_hz = 44'100;

}  // namespace

/// The mixer as something that the sound card asks.
class FunctionSound::Heard final : public audio::Source {
 public:
  void add_to(std::span<float> stereo) noexcept override { mixer.add_to(stereo); }
  functions::PlotMixer mixer{kRate_hz};
};

FunctionSound::FunctionSound(QObject* parent) : QObject(parent), heard_(std::make_unique<Heard>()) {
  brief_.setSingleShot(true);
  brief_.setInterval(kBrief_ms);
  connect(&brief_, &QTimer::timeout, this, [this] { heard_->mixer.tone().set({}); });
  heard_->mixer.set_volume(volume_ / 100.0, muted_);
}

FunctionSound::~FunctionSound() = default;

void FunctionSound::set_volume(int percent) {
  volume_ = std::clamp(percent, 0, 100);
  heard_->mixer.set_volume(volume_ / 100.0, muted_);
}

void FunctionSound::set_muted(bool muted) {
  muted_ = muted;
  heard_->mixer.set_volume(volume_ / 100.0, muted_);
}

bool FunctionSound::ready() {
  if (muted_ || refused_) return false;
  if (output_) return true;
  auto opened = audio::Output::open(*heard_, {kRate_hz, 512});
  if (!opened) {
    refused_ = true;
    emit unavailable(opened.error());
    return false;
  }
  output_ = std::move(*opened);
  return true;
}

void FunctionSound::touch(const functions::Cue& cue, bool trembles) {
  brief_.stop();
  if (cue.loudness > 0 && !ready()) return;
  heard_->mixer.tone().set(cue, trembles);
}

void FunctionSound::touch_briefly(const functions::Cue& cue) {
  touch(cue);
  brief_.start();
}

void FunctionSound::sign(functions::PointKind kind, double pan) {
  if (ready()) heard_->mixer.tone().play(kind, std::clamp(pan, -1.0, 1.0));
}

void FunctionSound::play(functions::Sound sound) {
  if (ready()) heard_->mixer.play(std::move(sound));
}

void FunctionSound::stop() {
  brief_.stop();
  heard_->mixer.tone().set({});
  heard_->mixer.play({});
}

bool FunctionSound::is_playing() const {
  return output_ && (heard_->mixer.is_playing() || brief_.isActive());
}

}  // namespace nazori::ui
