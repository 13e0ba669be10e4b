// SPDX-License-Identifier: Apache-2.0
#include "learner_fixture.h"

#include "nazori/study/store_filling.h"

#include <stdlib.h>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

namespace nazori::study::test {

Writing review(Rating rating) {
  Writing writing;
  writing.stage = Stage::memory;
  writing.rating = rating;
  writing.proposed = rating;
  writing.result.accepted = rating != Rating::again;
  writing.result.score = rating == Rating::again ? 40 : 85;
  if (rating <= Rating::hard)
    writing.result.mistakes = {{kanji::MistakeKind::wrong, 2}, {kanji::MistakeKind::ending, 0}};
  writing.result.duration = std::chrono::milliseconds(12'345);
  return writing;
}

Handwriting some_ink(int seed) {
  Handwriting ink;
  int time = 0;
  for (int stroke = 0; stroke < 2; ++stroke) {
    HandwritingStroke points;
    for (int i = 0; i < 60; ++i, time += 8) {
      points.push_back(saved_point(
          {{20 + i + 3 * std::sin(i * 0.1 * seed), 30.0 + 20 * stroke}, time / 1000.0, 0.5 + 0.004 * i}));
    }
    time += 200;
    ink.push_back(points);
  }
  return ink;
}

void use_zone(LearnerStore& store, const char* zone) {
  Settings settings = store.settings();
  settings.time_zone = zone;
  const auto changed = store.change_settings(settings);
  ASSERT_TRUE(changed) << base::to_line(changed.error());
}

void study_at_random(LearnerStore& store, MovedClock& clock, unsigned seed, int actions) {
  std::mt19937 random(seed);
  constexpr std::u32string_view kCharacters = U"一二三四五六七八九十百千休木林森";
  for (int i = 0; i < actions; ++i) {
    const char32_t one = kCharacters[random() % kCharacters.size()];
    const std::array some{one, kCharacters[random() % kCharacters.size()]};
    clock.advance(std::chrono::minutes(random() % 2000));
    switch (random() % 20) {
      case 0:
        (void)must(store.undo());
        break;
      case 1:
        ASSERT_TRUE(store.pause(some));
        break;
      case 2:
        ASSERT_TRUE(store.resume(some));
        break;
      case 3:
        ASSERT_TRUE(store.postpone(some, store.today() + std::chrono::days(random() % 5)));
        break;
      case 4:
        ASSERT_TRUE(store.reset(std::span(&one, 1)));
        break;
      case 5: {
        Settings settings = store.settings();
        settings.fsrs.desired_retention = 0.8 + 0.01 * static_cast<double>(random() % 17);
        settings.fsrs.weights[2] = 2 + 0.1 * static_cast<double>(random() % 9);
        settings.fuzz = random() % 2 == 0;
        settings.load_balance = random() % 2 == 0;
        ASSERT_TRUE(store.change_settings(settings));
        break;
      }
      default: {
        Writing writing = review(kRatings[random() % 4]);
        writing.stage = kStages[random() % 8 < 2 ? random() % 3 : 3];
        (void)must(store.add_writing(
            one, 5, writing, random() % 3 == 0 ? some_ink(static_cast<int>(random() % 9)) : Handwriting{}));
      }
    }
  }
}

LearnerStore::Source long_history(int entries) {
  return [entries](LearnerStore::Filling& filling) -> base::Result<void> {
    constexpr int kEachDay = 30;
    constexpr int kCharacters = 2'000;
    constexpr Time kBegin = Time(std::chrono::days(16'000)) + std::chrono::hours(9);
    for (int i = 0; i < entries; ++i) {
      LogEntry entry;
      entry.id = entry.action = i + 1;
      entry.at = kBegin + std::chrono::days(i / kEachDay) + std::chrono::seconds(30 * (i % kEachDay));
      entry.day = std::chrono::floor<std::chrono::days>(entry.at);
      entry.character = U'一' + static_cast<char32_t>(i % std::min(kCharacters, entries / 3 + 1));
      entry.strokes = 8;
      entry.writing = review(i % 7 == 0 ? Rating::again : Rating::good);
      if (auto added = filling.add(entry, {}); !added) return added;
    }
    return {};
  };
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace nazori::study::test
