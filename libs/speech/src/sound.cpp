// SPDX-License-Identifier: Apache-2.0
#include "nazori/speech/sound.h"

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <utility>

#include "nazori/base/file.h"

namespace nazori::speech {
namespace {

/// A file in memory, as libsndfile reads and writes it.
struct MemoryFile {
  std::span<const std::uint8_t> read;
  std::vector<std::uint8_t> written;
  sf_count_t at = 0;

  [[nodiscard]] sf_count_t size() const {
    return static_cast<sf_count_t>(std::max(read.size(), written.size()));  // one of them is empty
  }
};

MemoryFile& file_of(void* user) { return *static_cast<MemoryFile*>(user); }

SF_VIRTUAL_IO memory_io() {
  SF_VIRTUAL_IO io{};
  io.get_filelen = [](void* user) { return file_of(user).size(); };
  io.seek = [](sf_count_t offset, int whence, void* user) {
    MemoryFile& file = file_of(user);
    const sf_count_t from = whence == SEEK_CUR ? file.at : whence == SEEK_END ? file.size() : 0;
    file.at = std::max<sf_count_t>(0, from + offset);
    return file.at;
  };
  io.read = [](void* to, sf_count_t count, void* user) {
    MemoryFile& file = file_of(user);
    const sf_count_t length = std::clamp<sf_count_t>(file.size() - file.at, 0, count);
    if (length > 0) std::memcpy(to, file.read.data() + file.at, static_cast<std::size_t>(length));
    file.at += length;
    return length;
  };
  io.write = [](const void* from, sf_count_t count, void* user) {
    MemoryFile& file = file_of(user);
    const auto end = static_cast<std::size_t>(file.at + count);
    if (end > file.written.size()) file.written.resize(end);
    std::memcpy(file.written.data() + file.at, from, static_cast<std::size_t>(count));
    file.at += count;
    return count;
  };
  io.tell = [](void* user) { return file_of(user).at; };
  return io;
}

constexpr auto kClose = [](SNDFILE* file) { sf_close(file); };
using SoundFile = std::unique_ptr<SNDFILE, decltype(kClose)>;

constexpr const char* kUsable = "use WAV, FLAC, Ogg, Opus or MP3 of at most 20 seconds";

}  // namespace

double loudness(const Sound& sound) {
  if (sound.samples.empty()) return 0;
  const double sum = std::accumulate(
      sound.samples.begin(), sound.samples.end(), 0.0,
      [](double all, float x) { return all + static_cast<double>(x) * static_cast<double>(x); });
  return std::sqrt(sum / static_cast<double>(sound.samples.size()));
}

base::Result<Sound> decode_sound(std::span<const std::uint8_t> bytes) {
  SF_VIRTUAL_IO io = memory_io();
  MemoryFile memory{bytes, {}};
  SF_INFO info{};
  const SoundFile file(sf_open_virtual(&io, SFM_READ, &info, &memory), kClose);
  if (!file) return base::fail(base::Errc::parse, "is no sound file that can be read", {}, kUsable);
  const auto channels = static_cast<std::size_t>(info.channels);
  const auto most = static_cast<std::size_t>(kMostSound_s * info.samplerate);
  Sound sound;
  sound.rate_hz = info.samplerate;
  // The length in the header is not trusted: what a program writes to a pipe has none.
  std::vector<float> frames(4096 * channels);
  while (true) {
    const sf_count_t got = sf_readf_float(file.get(), frames.data(), 4096);
    if (got <= 0) break;
    if (sound.samples.size() + static_cast<std::size_t>(got) > most)
      return base::fail(base::Errc::parse, "lasts too long", {}, kUsable);
    for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i) {
      const float* frame = frames.data() + i * channels;
      const float mean = std::accumulate(frame, frame + channels, 0.0F) / static_cast<float>(channels);
      sound.samples.push_back(std::isfinite(mean) ? std::clamp(mean, -1.0F, 1.0F) : 0.0F);
    }
  }
  if (sound.samples.empty()) return base::fail(base::Errc::parse, "has no sound in it", {}, kUsable);
  return sound;
}

base::Result<Sound> read_sound(const std::filesystem::path& path) {
  const auto bytes = base::read_file(path, kMostSoundBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto sound = decode_sound(*bytes);
  if (!sound) {
    base::Error error = sound.error();
    error.where = path.string();
    return tl::unexpected(error);
  }
  return sound;
}

base::Result<std::vector<std::uint8_t>> to_wav(const Sound& sound) {
  if (sound.samples.empty() || sound.rate_hz <= 0)
    return base::fail(base::Errc::bad_argument, "there is no sound to write");
  SF_VIRTUAL_IO io = memory_io();
  MemoryFile memory;
  SF_INFO info{};
  info.samplerate = sound.rate_hz;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  SoundFile file(sf_open_virtual(&io, SFM_WRITE, &info, &memory), kClose);
  sf_command(file.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
  const auto count = static_cast<sf_count_t>(sound.samples.size());
  // Also where the file could not be opened: libsndfile writes nothing to none.
  if (sf_writef_float(file.get(), sound.samples.data(), count) != count)
    return base::fail(base::Errc::io, sf_strerror(file.get()), "WAV");
  file.reset();
  return std::move(memory.written);
}

}  // namespace nazori::speech
