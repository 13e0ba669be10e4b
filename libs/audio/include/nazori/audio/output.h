// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "nazori/base/result.h"

namespace nazori::audio {

/// A source of sound.
class Source {
 public:
  virtual ~Source() = default;
  /// Adds its samples to the buffer: left and right alternate, -1..1 in total. Runs on the audio thread: must
  /// not allocate, lock, throw or wait.
  virtual void add_to(std::span<float> stereo) noexcept = 0;
};

struct OutputSettings {
  int rate_hz = 44'100;  ///< samples per second and channel
  int frames = 512;      ///< requested at a time: 11.6 ms at 44,100; the sound card may choose otherwise
};

/// The loudspeakers, through SDL 2. Requests samples from a source for as long as it lives. Thread: one
/// (interface) makes and destroys it; the source is called on SDL's audio thread.
class Output {
 public:
  /// Opens the sound card the system prefers (or what SDL_AUDIODRIVER names) and starts to request samples.
  /// The rate is exact; where the card has another one, SDL converts.
  /// @param source  must outlive the output.
  /// @return Errc::bad_argument for settings (rate 8,000..192,000; frames a power of two, 64..8,192),
  /// Errc::device with SDL's reason where there is no sound card.
  [[nodiscard]] static base::Result<std::unique_ptr<Output>> open(Source& source,
                                                                  const OutputSettings& settings = {});
  /// Stops the sound; the source is not called any more.
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Name of the audio driver: "pulseaudio", "alsa", "dummy".
  [[nodiscard]] const std::string& driver() const { return driver_; }

 private:
  Output() = default;
  std::string driver_;
  unsigned device_ = 0;
  bool started_ = false;
};

}  // namespace nazori::audio
