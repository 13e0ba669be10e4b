// SPDX-License-Identifier: Apache-2.0
#include <sndfile.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "nazori/base/file.h"
#include "nazori/functions/sound.h"

namespace nazori::functions {
namespace {

/// A file in memory, with the interface of libsndfile's virtual input and output.
struct MemoryFile {
  std::vector<std::uint8_t> bytes;
  sf_count_t at = 0;
};

MemoryFile& file_of(void* user) { return *static_cast<MemoryFile*>(user); }

sf_count_t length_of(void* user) { return static_cast<sf_count_t>(file_of(user).bytes.size()); }

sf_count_t seek(sf_count_t offset, int whence, void* user) {
  MemoryFile& f = file_of(user);
  const sf_count_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? f.at : length_of(user);
  f.at = std::max<sf_count_t>(0, base + offset);
  return f.at;
}

sf_count_t read(void* to, sf_count_t count, void* user) {
  MemoryFile& f = file_of(user);
  const sf_count_t n = std::clamp<sf_count_t>(length_of(user) - f.at, 0, count);
  std::memcpy(to, f.bytes.data() + f.at, static_cast<std::size_t>(n));
  f.at += n;
  return n;
}

sf_count_t write(const void* from, sf_count_t count, void* user) {
  MemoryFile& f = file_of(user);
  const auto end = static_cast<std::size_t>(f.at + count);
  if (end > f.bytes.size()) f.bytes.resize(end);
  std::memcpy(f.bytes.data() + f.at, from, static_cast<std::size_t>(count));
  f.at += count;
  return count;
}

sf_count_t tell(void* user) { return file_of(user).at; }

}  // namespace

base::Result<void> save_wav(const Sound& sound, const std::filesystem::path& path) {
  MemoryFile file;
  file.bytes.reserve(sound.samples.size() * 2 + 64);
  SF_VIRTUAL_IO io{length_of, seek, read, write, tell};
  SF_INFO info{};
  info.samplerate = sound.sample_rate;
  info.channels = 2;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  const auto close = [](SNDFILE* f) { (void)sf_close(f); };
  std::unique_ptr<SNDFILE, decltype(close)> wav(sf_open_virtual(&io, SFM_WRITE, &info, &file), close);
  if (!wav) return base::fail(base::Errc::io, sf_strerror(nullptr), path.string());
  const auto frames = static_cast<sf_count_t>(sound.samples.size() / 2);
  if (sf_writef_float(wav.get(), sound.samples.data(), frames) != frames)
    return base::fail(base::Errc::io, sf_strerror(wav.get()), path.string());
  wav.reset();
  return base::write_file(path, file.bytes);
}

}  // namespace nazori::functions
