// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "nazori/study/learner_store.h"
#include "temporary_folder.h"

namespace nazori::study::test {

using nazori::test::TemporaryFolder;

/// A clock that the test moves.
class MovedClock {
 public:
  explicit MovedClock(const char* start) : time_(std::make_shared<Time>(*parse_time(start))) {}
  void set(const char* time) { *time_ = *parse_time(time); }
  void advance(std::chrono::milliseconds by) { *time_ += by; }
  [[nodiscard]] Time now() const { return *time_; }
  [[nodiscard]] Clock clock() const {
    return [time = time_] { return *time; };
  }

 private:
  std::shared_ptr<Time> time_;
};

/// A review from memory with this rating.
Writing review(Rating rating);
/// Ink of two strokes with times.
Handwriting some_ink(int seed = 1);

/// The value; a missing value fails the test and aborts.
template <class T>
T must(base::Result<T> result) {
  if (!result) {
    ADD_FAILURE() << base::to_line(result.error());
    std::abort();
  }
  return *std::move(result);
}

/// Settings with a zone that does not depend on the computer.
void use_zone(LearnerStore& store, const char* zone);

/// Studies for some weeks with every kind of action; the same seed gives the same weeks.
void study_at_random(LearnerStore& store, MovedClock& clock, unsigned seed, int actions);

/// A log of a learner who writes 30 characters from memory on every day, repeatedly.
LearnerStore::Source long_history(int entries);

std::string bytes_of(const std::filesystem::path& path);

}  // namespace nazori::study::test
