// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "nazori/recording/recording_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::recording;
  // Tested unchanged and after a valid header, because random input would hardly ever pass its checksum.
  static const auto kHeader = encode_header(Session{});
  std::string behind(kHeader.begin(), kHeader.end());
  const std::size_t header = behind.size();
  behind.append(reinterpret_cast<const char*>(data), size);
  for (const std::string_view bytes :
       {std::string_view(reinterpret_cast<const char*>(data), size), std::string_view(behind)}) {
    auto reader = RecordingReader::from(memory_source(bytes, "fuzz"));
    if (!reader) continue;
    std::array<nazori::haptics::ServoSample, 5> samples;
    std::uint64_t count = 0;
    for (;;) {
      const auto got = reader->read(samples);
      if (!got) std::abort();
      if (*got == 0) break;
      count += *got;
    }
    const RecordingEnd& end = reader->end();
    const std::uint64_t records = end.samples + end.damaged + (end.finished ? 1 : 0);
    if (end.samples != count || records * kRecordBytes + header > bytes.size() + kRecordBytes) std::abort();
  }
  return 0;
}
