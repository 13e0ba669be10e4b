// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "nazori/haptics/servo.h"
#include "nazori/recording/recording_file.h"

namespace nazori::recording::test {

inline Session session_of(const haptics::DeviceDescription& device) {
  Session session;
  session.device = device;
  session.character = "休";
  return session;
}

inline haptics::DeviceSample hand_at(int i) {
  haptics::DeviceSample sample;
  sample.time_s = 0.001 * i;
  sample.position_m = {0.03 * std::sin(0.01 * i), 0.02 * std::cos(0.02 * i), 0.01 * std::sin(0.05 * i)};
  return sample;
}

struct Read {
  std::vector<haptics::ServoSample> samples;
  RecordingEnd end;
};
inline Read read(const std::filesystem::path& path) {
  Read got;
  auto reader = RecordingReader::open(path);
  if (!reader) {
    ADD_FAILURE() << base::to_line(reader.error());
    return got;
  }
  std::vector<haptics::ServoSample> some(100);
  while (const std::size_t count = *reader->read(some)) {
    got.samples.insert(got.samples.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  }
  got.end = reader->end();
  return got;
}

}  // namespace nazori::recording::test
