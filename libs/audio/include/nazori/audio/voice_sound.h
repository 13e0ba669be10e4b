// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "nazori/audio/output.h"
#include "nazori/base/result.h"
#include "nazori/speech/sound.h"

namespace nazori::audio {

/// Mixes one recorded sound at a time. Thread rules: play(), stop() and is_playing() on one thread, add_to()
/// on the audio thread; neither waits for the other.
class VoiceMixer final : public Source {
 public:
  /// @param rate_hz  of the output.
  explicit VoiceMixer(int rate_hz = OutputSettings{}.rate_hz);
  ~VoiceMixer() override;

  /// Plays a sound from its start, in place of the previous one. Its rate is converted.
  void play(const speech::Sound& sound);
  void stop();
  [[nodiscard]] bool is_playing() const;
  /// 0..1
  void set_volume(float volume) { volume_.store(volume); }

  void add_to(std::span<float> stereo) noexcept override;

 private:
  struct Clip {
    std::vector<float> samples;
    std::atomic<std::size_t> at{0};
  };
  void put(std::unique_ptr<Clip> clip);

  const int rate_hz_;
  std::vector<std::unique_ptr<Clip>>
      clips_;  ///< the present one, and those that the audio thread may still read
  std::atomic<Clip*> current_{nullptr};
  std::atomic<Clip*> in_use_{nullptr};  ///< by the audio thread
  std::atomic<float> volume_{1};
};

/// The samples of `sound` at another rate, by straight lines between samples.
[[nodiscard]] std::vector<float> at_rate(const speech::Sound& sound, int rate_hz);

/// Plays what a voice has spoken through the loudspeakers. The sound card is opened when the first sound is
/// to be played. Thread: one (interface).
class VoiceSound {
 public:
  VoiceSound();
  ~VoiceSound();
  VoiceSound(const VoiceSound&) = delete;
  VoiceSound& operator=(const VoiceSound&) = delete;

  /// @return Errc::device where there is no sound card; each call tries again.
  [[nodiscard]] base::Result<void> play(const speech::Sound& sound);
  void stop() { mixer_.stop(); }
  /// 0..1
  void set_volume(double volume);
  [[nodiscard]] bool is_playing() const { return output_ != nullptr && mixer_.is_playing(); }
  [[nodiscard]] bool is_open() const { return output_ != nullptr; }
  /// Gives the sound card back.
  void close();

 private:
  VoiceMixer mixer_;
  std::unique_ptr<Output> output_;  // declared last, so that it is destroyed before the sounds it plays
};

}  // namespace nazori::audio
