// SPDX-License-Identifier: Apache-2.0
#include "learner_fixture.h"

#include <stdlib.h>
#include <cmath>
#include <fstream>
#include <iterator>

namespace nazori::study::test {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "nazori-study-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) std::abort();
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Writing review(Rating rating) {
  Writing writing;
  writing.stage = Stage::memory;
  writing.rating = rating;
  writing.proposed = rating;
  writing.result.accepted = rating != Rating::again;
  writing.result.score = rating == Rating::again ? 40 : 85;
  if (rating <= Rating::hard) writing.result.faults = {{FaultKind::wrong, 2}, {FaultKind::ending, 0}};
  writing.result.duration = std::chrono::milliseconds(12'345);
  return writing;
}

Ink some_ink(int seed) {
  Ink ink;
  int time = 0;
  for (int stroke = 0; stroke < 2; ++stroke) {
    InkStroke points;
    for (int i = 0; i < 60; ++i, time += 8) {
      points.push_back(
          ink_point({20 + i + 3 * std::sin(i * 0.1 * seed), 30.0 + 20 * stroke}, time, 0.5 + 0.004 * i));
    }
    time += 200;
    ink.strokes.push_back(points);
  }
  return ink;
}

void use_zone(LearnerStore& store, const char* zone) {
  Settings settings = store.settings();
  settings.time_zone = zone;
  const auto changed = store.change_settings(settings);
  ASSERT_TRUE(changed) << base::to_line(changed.error());
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace nazori::study::test
