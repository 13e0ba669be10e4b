// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::speech {

/// Recorded or spoken sound of one channel.
struct Sound {
  int rate_hz = 0;             ///< samples per second
  std::vector<float> samples;  ///< -1..1

  [[nodiscard]] double duration_s() const {
    return rate_hz > 0 ? static_cast<double>(samples.size()) / rate_hz : 0;
  }

  friend bool operator==(const Sound&, const Sound&) = default;
};

/// A sound file is at most this large, and lasts at most this long.
inline constexpr std::size_t kMostSoundBytes = 8U << 20U;
inline constexpr double kMostSound_s = 20;

/// The root mean square of the samples, 0..1; 0 for a sound without samples.
[[nodiscard]] double loudness(const Sound& sound);

/// Decodes a sound file: WAV, FLAC, Ogg Vorbis, Opus or MP3. Several channels become one, their mean.
/// @return Errc::parse for data that are none of these, that hold no samples, or that last too long.
[[nodiscard]] base::Result<Sound> decode_sound(std::span<const std::uint8_t> bytes);

/// Reads a sound file. @return the errors of base::read_file() and decode_sound(), with the path.
[[nodiscard]] base::Result<Sound> read_sound(const std::filesystem::path& path);

/// The sound as a WAV file of 16 bits per sample. @return Errc::bad_argument for a sound without samples.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> to_wav(const Sound& sound);

}  // namespace nazori::speech
