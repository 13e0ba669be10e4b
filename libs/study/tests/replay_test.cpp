// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nazori/base/file.h"
#include "test_paths.h"

namespace nazori::study {
namespace {

using testing::HasSubstr;

std::string vectors() {
  const auto bytes = base::read_file(std::string(test_paths::kFixtures) + "/fsrs6-vectors.json", 1 << 20);
  return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
}

TEST(Replay, ReproducesTheReferenceToEightDecimals) {
  const std::string text = vectors();
  const auto replay = replay_histories(text);
  ASSERT_TRUE(replay) << base::to_line(replay.error());
  const auto differences = compare_with_own_numbers(text, *replay);
  ASSERT_TRUE(differences) << base::to_line(differences.error());
  EXPECT_GT(differences->steps, 100);
  EXPECT_LT(differences->stability, 0.5e-8);
  EXPECT_LT(differences->difficulty, 0.5e-8);
  EXPECT_LT(differences->retrievability, 0.5e-8);
  EXPECT_EQ(differences->scheduled_days, 0);
  EXPECT_EQ(differences->due_s, 0);
  EXPECT_EQ(differences->states, 0);
  EXPECT_EQ(differences->first, "");
}

TEST(Replay, WritesTheFormItReads) {
  const auto replay = replay_histories(vectors());
  ASSERT_TRUE(replay);
  const std::string text = to_json(*replay);
  const auto again = replay_histories(text);
  ASSERT_TRUE(again) << base::to_line(again.error());
  EXPECT_EQ(to_json(*again), text);
  EXPECT_EQ(compare_with_own_numbers(text, *again)->stability, 0);
}

TEST(Replay, ADifferentNumberIsFound) {
  std::string text = vectors();
  const std::size_t at = text.find("\"stability\": ") + 13;
  text[at] = text[at] == '9' ? '8' : static_cast<char>(text[at] + 1);
  const auto differences = compare_with_own_numbers(text, *replay_histories(text));
  ASSERT_TRUE(differences);
  EXPECT_GT(differences->stability, 0.5);
  EXPECT_EQ(differences->first, "case 1, step 1");
}

std::string refusal(const std::string& steps) {
  const auto replay = replay_histories("{\"cases\": [\n {\"request_retention\": 0.9, \"steps\": [\n  " +
                                       steps + "\n ]}\n]}\n");
  return replay ? "" : base::to_line(replay.error());
}

TEST(Replay, RefusesBadInputWithLineAndReason) {
  EXPECT_EQ(refusal(R"({"at": "2026-01-01T09:00:00Z", "rating": 3})"), "");
  EXPECT_THAT(refusal(R"({"at": "2026-01-01T09:00:00Z",)"
                      "\n"
                      R"("rating": 5})"),
              testing::AllOf(HasSubstr("line 4"), HasSubstr("rating"), HasSubstr("1 to 4")));
  EXPECT_THAT(refusal(R"({"at": "yesterday", "rating": 3})"),
              testing::AllOf(HasSubstr("line 3"), HasSubstr("yesterday")));
  EXPECT_THAT(refusal(R"({"rating": 3})"), testing::AllOf(HasSubstr("line 3"), HasSubstr("at: is missing")));
  EXPECT_THAT(refusal(R"({"at": "2026-01-02T09:00:00Z", "rating": 3},)"
                      "\n"
                      R"({"at": "2026-01-01T09:00:00Z", "rating": 3})"),
              testing::AllOf(HasSubstr("line 4"), HasSubstr("before")));
  EXPECT_THAT(refusal("[1"), HasSubstr("is not JSON"));
  EXPECT_THAT(base::to_line(replay_histories("").error()), HasSubstr("line 1"));
  EXPECT_THAT(base::to_line(replay_histories("{}").error()), HasSubstr("cases"));
  EXPECT_THAT(base::to_line(replay_histories(R"({"weights": [1, 2], "cases": []})").error()),
              HasSubstr("2 numbers"));
  EXPECT_FALSE(replay_histories(std::string(100'000, '[')));
}

}  // namespace
}  // namespace nazori::study
