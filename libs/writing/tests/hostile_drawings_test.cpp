// SPDX-License-Identifier: Apache-2.0
// Drawings that no hand makes. A few by default; NAZORI_HOSTILE_DRAWINGS says how many.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "drawing.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/model_library.h"

namespace nazori::writing::test {
namespace {

class Hostile {
 public:
  explicit Hostile(std::uint32_t seed) : random_(seed) {}

  WrittenCharacter draw(const WrittenCharacter& model) {
    WrittenCharacter ink;
    if (below(3) == 0) ink = model;
    if (ink.strokes.empty() || below(2) == 0) add_strokes(ink, 1 + below(below(8) == 0 ? 40 : 6));
    if (below(4) == 0) std::shuffle(ink.strokes.begin(), ink.strokes.end(), random_);
    if (below(2) == 0) ink.box = WritingBox{{0, 0}, below(2) == 0 ? 109 : 1e-3};
    return ink;
  }
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

 private:
  double number() {
    constexpr std::array kOdd{0.0, -0.0, 1e-300, 1e-9, 1e9, -1e9, 1e8, 54.5, 109.0, -1.0};
    if (below(6) == 0) return kOdd.at(below(kOdd.size()));
    return std::uniform_real_distribution<double>(-20, 130)(random_);
  }
  void add_strokes(WrittenCharacter& ink, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      auto& stroke = ink.strokes.emplace_back();
      const std::size_t points = 1 + below(below(16) == 0 ? 300 : 5);
      const bool still = below(5) == 0;
      for (std::size_t i = 0; i < points; ++i)
        stroke.push_back(still && i > 0 ? stroke.front() : WrittenPoint{{number(), number()}});
    }
  }
  std::mt19937 random_;
};

/// Whether all that a grade says is finite and in its range.
bool is_sound(const Grade& grade, const WrittenCharacter& ink) {
  bool sound = grade.strokes.size() == ink.strokes.size() && grade.accepted == grade.mistakes.empty() &&
               grade.score >= 0 && grade.score <= 100 && grade.probability >= 0 && grade.probability <= 1;
  for (const auto& s : grade.strokes)
    sound = sound && std::isfinite(s.offset_x) && std::isfinite(s.offset_y) && std::isfinite(s.size) &&
            std::isfinite(s.angle_rad) && std::isfinite(s.shape) && std::isfinite(s.deviation);
  return sound;
}

TEST(HostileDrawings, AreRefusedOrJudgedInFiniteNumbers) {
  const char* folder = std::getenv("NAZORI_DATA");             // NOLINT(concurrency-mt-unsafe): one thread
  const char* asked = std::getenv("NAZORI_HOSTILE_DRAWINGS");  // NOLINT(concurrency-mt-unsafe): one thread
  ASSERT_NE(folder, nullptr);
  const auto database = kanji::KanjiDatabase::open(std::filesystem::path(folder) / "kanji.db");
  ASSERT_TRUE(database);
  ModelLibrary library(*database);
  const int count = asked == nullptr ? 2000 : std::atoi(asked);  // NOLINT(cert-err34-c): a count for people
  constexpr std::u32string_view kAsked = U"一三土休番語ぽゐ議鬱j";
  std::vector<WrittenCharacter> models;
  for (const char32_t c : kAsked) models.push_back(trace(*database->find(c)));
  Hostile hostile(16);
  double longest_ms = 0;
  for (int i = 0; i < count; ++i) {
    const std::size_t k = hostile.below(kAsked.size());
    const auto entry = library.find(kAsked[k]);
    ASSERT_TRUE(entry);
    const auto ink = hostile.draw(models[k]);
    const GradeOptions options{static_cast<double>(hostile.below(5)) / 4, hostile.below(4) == 0};
    const auto begin = std::clock();
    const auto grade = writing::grade(ink, (*entry)->model, options, (*entry)->lookalikes);
    longest_ms = std::max(longest_ms, 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (!grade)
      ASSERT_EQ(grade.error().code, base::Errc::bad_argument) << "drawing " << i;
    else
      ASSERT_TRUE(is_sound(*grade, ink)) << "drawing " << i;
  }
  RecordProperty("longest_ms", std::to_string(longest_ms));
  if (asked != nullptr) std::printf("%d drawings, the longest took %.2f ms\n", count, longest_ms);
}

}  // namespace
}  // namespace nazori::writing::test
