// SPDX-License-Identifier: Apache-2.0
#include "functions/function_sound.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <vector>

namespace nazori::ui {
namespace {

constexpr int kBrief_ms = 220;
constexpr int kRate_hz = 44'100;

functions::SoundSettings full_volume() {
  functions::SoundSettings settings;
  settings.sample_rate = kRate_hz;
  settings.volume = 1;
  return settings;
}

}  // namespace

/// The tone and the sweep together. A sweep that was replaced is freed when the audio thread no longer reads
/// it: it says so in `read_`.
class FunctionSound::Mixer final : public audio::Source {
 public:
  Mixer() : tone_(full_volume()) {}

  functions::ToneGenerator& tone() { return tone_; }

  void set_gain(double volume, bool muted) {
    tone_.set_volume(volume);
    tone_.set_muted(muted);
    gain_.store(muted ? 0.0F : static_cast<float>(volume));
  }

  void play(functions::Sound sound) {
    auto next = std::make_unique<Sweep>();
    next->samples = std::move(sound.samples);
    present_.store(next->samples.empty() ? nullptr : next.get());
    kept_.push_back(std::move(next));
    const Sweep* in_use = read_.load();
    std::erase_if(kept_,
                  [&](const auto& sweep) { return sweep.get() != in_use && sweep.get() != present_.load(); });
  }

  [[nodiscard]] bool is_playing() const {
    const Sweep* sweep = present_.load();
    return sweep != nullptr && sweep->position.load() < sweep->samples.size();
  }

  void add_to(std::span<float> stereo) noexcept override {
    for (std::size_t done = 0; done < stereo.size(); done += piece_.size()) {
      const auto part = stereo.subspan(done, std::min(piece_.size(), stereo.size() - done));
      tone_.fill(std::span(piece_).first(part.size()));
      for (std::size_t i = 0; i < part.size(); ++i) part[i] += piece_[i];
    }
    Sweep* sweep = present_.load();
    read_.store(sweep);
    // Replaced in between: the other one is heard from the next call on.
    if (sweep != nullptr && present_.load() == sweep) {
      const std::size_t from = sweep->position.load();
      const std::size_t count = std::min(stereo.size(), sweep->samples.size() - from);
      const float gain = gain_.load();
      for (std::size_t i = 0; i < count; ++i) stereo[i] += gain * sweep->samples[from + i];
      sweep->position.store(from + count);
    }
    read_.store(nullptr);
  }

 private:
  struct Sweep {
    std::vector<float> samples;
    std::atomic<std::size_t> position{0};
  };

  functions::ToneGenerator tone_;
  std::atomic<float> gain_{0.5F};
  std::atomic<Sweep*> present_{nullptr};
  std::atomic<Sweep*> read_{nullptr};
  std::vector<std::unique_ptr<Sweep>> kept_;  // interface thread
  std::array<float, 1024> piece_{};           // audio thread
};

FunctionSound::FunctionSound(QObject* parent) : QObject(parent), mixer_(std::make_unique<Mixer>()) {
  brief_.setSingleShot(true);
  brief_.setInterval(kBrief_ms);
  connect(&brief_, &QTimer::timeout, this, [this] { mixer_->tone().set({}); });
  mixer_->set_gain(volume_ / 100.0, muted_);
}

FunctionSound::~FunctionSound() = default;

void FunctionSound::set_volume(int percent) {
  volume_ = std::clamp(percent, 0, 100);
  mixer_->set_gain(volume_ / 100.0, muted_);
}

void FunctionSound::set_muted(bool muted) {
  muted_ = muted;
  mixer_->set_gain(volume_ / 100.0, muted_);
}

bool FunctionSound::ready() {
  if (muted_ || refused_) return false;
  if (output_) return true;
  auto opened = audio::Output::open(*mixer_, {kRate_hz, 512});
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
  mixer_->tone().set(cue, trembles);
}

void FunctionSound::touch_briefly(const functions::Cue& cue) {
  touch(cue);
  brief_.start();
}

void FunctionSound::sign(functions::PointKind kind, double pan) {
  if (ready()) mixer_->tone().play(kind, std::clamp(pan, -1.0, 1.0));
}

void FunctionSound::play(functions::Sound sound) {
  if (ready()) mixer_->play(std::move(sound));
}

void FunctionSound::stop() {
  brief_.stop();
  mixer_->tone().set({});
  mixer_->play({});
}

bool FunctionSound::is_playing() const { return output_ && (mixer_->is_playing() || brief_.isActive()); }

}  // namespace nazori::ui
