// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "nazori/base/result.h"

namespace nazori::audio {

/// Something that can be heard.
class Source {
 public:
  virtual ~Source() = default;
  /// Adds its samples to what is there: left and right by turns, -1..1 together. Runs on the audio thread:
  /// neither allocates, locks, throws nor waits.
  virtual void add_to(std::span<float> stereo) noexcept = 0;
};

struct OutputSettings {
  int rate_hz = 44'100;  ///< samples a second and channel
  int frames = 512;      ///< asked for at a time: 11.6 ms at 44,100; the sound card may choose otherwise
};

/// The loudspeakers, through SDL 2: asks a source for samples for as long as it lives.
/// Thread: one (interface) makes and ends it; the source is asked on SDL's audio thread.
class Output {
 public:
  /// Opens the sound card the system prefers (or what SDL_AUDIODRIVER names) and starts asking. The rate is
  /// held to exactly; where the card has another, SDL converts.
  /// @param source  must live until the output is gone.
  /// @return Errc::bad_argument for settings (rate 8,000..192,000; frames a power of two, 64..8,192),
  ///         Errc::device with SDL's reason where there is no sound card.
  [[nodiscard]] static base::Result<std::unique_ptr<Output>> open(Source& source,
                                                                  const OutputSettings& settings = {});
  /// Silence, then no more asking.
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// What plays: "pulseaudio", "alsa", "dummy".
  [[nodiscard]] const std::string& driver() const { return driver_; }

 private:
  Output() = default;
  std::string driver_;
  unsigned device_ = 0;
  bool started_ = false;
};

}  // namespace nazori::audio
