// SPDX-License-Identifier: Apache-2.0
#include "big_learner.h"

#include <cmath>
#include <cstdlib>
#include <random>

#include "nazori/base/utf8.h"

namespace nazori::study::test {
namespace {

/// Eight strokes of a hand that trembles, as large as those of a real kanji when they are packed.
Handwriting written_ink(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> tremble(-0.2, 0.2);
  Handwriting ink;
  double time_ms = 0;
  for (int stroke = 0; stroke < 8; ++stroke) {
    HandwritingStroke points;
    for (int i = 0; i < 45; ++i, time_ms += 8) {
      const geometry::GlyphPoint at{10 + 2.0 * i + tremble(random), 10 + 11.0 * stroke + tremble(random)};
      points.push_back({at, time_ms / 1000, 0.6 + tremble(random)});
    }
    time_ms += 250;
    ink.push_back(points);
  }
  return ink;
}

/// The ink as in an export.
std::string in_base64(const Handwriting& ink) {
  auto store = LearnerStore::in_memory([] { return Time{}; });
  Writing writing;
  if (!store || !store->add_writing(U'休', 6, writing, ink)) std::abort();
  const auto text = export_json(*store);
  if (!text) std::abort();
  constexpr std::string_view kMember = "\"ink\":\"";
  const std::size_t begin = text->find(kMember) + kMember.size();
  return text->substr(begin, text->find('"', begin) - begin);
}

}  // namespace

BigLearner::BigLearner(std::int64_t entries) : entries_(entries) {
  for (unsigned i = 0; i < inks_.size(); ++i) inks_[i] = in_base64(written_ink(i));
}

std::string BigLearner::entry(std::int64_t id) const {
  constexpr std::int64_t kADay = 120;
  constexpr std::int64_t kCharacters = 2'000;
  const std::int64_t day = (id - 1) / kADay;
  const Time at = *parse_time("2016-01-01T19:00:00Z") + std::chrono::days(day) +
                  std::chrono::seconds(30 * ((id - 1) % kADay));
  const auto character = static_cast<char32_t>(U'一' + (id - 1) % kCharacters);
  const auto number = std::to_string(id);
  std::string json = "{\"id\":" + number + ",\"action\":" + number + ",\"at\":\"" + to_text(at) +
                     "\",\"day\":\"" + to_text(utc_day(at)) + "\",\"kind\":\"writing\",\"character\":\"" +
                     base::encode_utf8(character) +
                     "\",\"stage\":\"memory\",\"rating\":\"good\",\"proposed\":\"good\",\"accepted\":true,"
                     "\"score\":85,\"faults\":[{\"kind\":\"ending\",\"stroke\":1}],\"hints\":0,\"misses\":0,"
                     "\"shown_strokes\":0,\"help\":0.0,\"duration_ms\":9000,\"strokes\":8";
  if (id % 25 > 1) json += ",\"ink\":\"" + inks_[static_cast<std::size_t>(id) % inks_.size()] + "\"";
  return json + "}";
}

std::string BigLearner::piece() {
  const std::int64_t id = next_++;
  if (id == 0) return "{\"format\": \"nazori-learner\", \"version\": 1,\n\"entries\": [";
  if (entries_ == 0 || id <= entries_) return (id == 1 ? "\n" : ",\n") + entry(id);
  if (id == entries_ + 1)
    return "\n],\n\"lists\": [\n{\"name\":\"trees\",\"characters\":\"木林森\"}\n],\n\"tags\": [\n]}\n";
  return {};
}

TextSource BigLearner::json() {
  next_ = 0;
  rest_.clear();
  const auto read = [this](std::span<char> room) -> base::Result<std::size_t> {
    if (rest_.empty()) rest_ = piece();
    const std::size_t count = rest_.copy(room.data(), room.size());
    rest_.erase(0, count);
    return count;
  };
  return {read, entries_ > 0 ? static_cast<std::uintmax_t>(entries_) * 2'000 : 0};
}

}  // namespace nazori::study::test
