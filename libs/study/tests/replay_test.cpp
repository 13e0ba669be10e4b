// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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

/// One history of two answers, with its own numbers.
std::string with_numbers(const std::string& member, const std::string& value) {
  // The output of the program itself, without one member.
  const auto own = replay_histories(R"({"cases": [{"request_retention": 0.9, "steps": [
      {"at": "2026-01-01T09:00Z", "rating": 4}, {"at": "2026-01-09T10:00Z", "rating": 3}]}]})");
  EXPECT_TRUE(own);
  auto json = nlohmann::ordered_json::parse(to_json(*own));
  if (!member.empty()) {
    if (value.empty())
      json["cases"][0]["steps"][1].erase(member);
    else
      json["cases"][0]["steps"][1][member] = nlohmann::ordered_json::parse(value);
  }
  return json.dump();
}

ReplayDifferences differences(const std::string& member, const std::string& value) {
  const std::string text = with_numbers(member, value);
  const auto found = compare_with_own_numbers(text, *replay_histories(text));
  EXPECT_TRUE(found) << base::to_line(found.error());
  return found.value_or(ReplayDifferences());
}

TEST(ReplayComparison, TellsTheDifferenceOfEachNumber) {
  const ReplayDifferences none = differences("", "");
  EXPECT_EQ(none.steps, 2);
  EXPECT_EQ(none.stability + none.difficulty + none.retrievability + none.due_s, 0);
  EXPECT_EQ(none.scheduled_days + none.states, 0);
  EXPECT_EQ(none.first, "");
  const auto own = *replay_histories(with_numbers("", ""));
  const ReplayStep& step = own.cases[0].steps[1];
  ASSERT_EQ(step.after.due, step.at + std::chrono::days(step.after.scheduled_days));
  const auto number = [](double value) { return nlohmann::ordered_json(value).dump(); };
  ReplayDifferences one = differences("stability", number(step.after.stability + 0.5));
  EXPECT_NEAR(one.stability, 0.5, 1e-12);
  EXPECT_EQ(one.first, "case 1, step 2");
  one = differences("difficulty", number(step.after.difficulty + 0.25));
  EXPECT_NEAR(one.difficulty, 0.25, 1e-12);
  EXPECT_EQ(one.stability, 0);
  EXPECT_EQ(one.first, "case 1, step 2");
  one = differences("retrievability_before", number(*step.retrievability_before - 0.125));
  EXPECT_NEAR(one.retrievability, 0.125, 1e-12);
  EXPECT_EQ(one.first, "case 1, step 2");
  one = differences("scheduled_days", std::to_string(step.after.scheduled_days + 3));
  EXPECT_EQ(one.scheduled_days, 3);
  EXPECT_EQ(one.first, "case 1, step 2");
  one = differences("due", "\"" + to_text(step.after.due + std::chrono::seconds(90)) + "\"");
  EXPECT_EQ(one.due_s, 90);
  EXPECT_EQ(one.first, "case 1, step 2");
  for (const auto& [member, value] :
       {std::pair("state", "\"learning\""), std::pair("reps", "3"), std::pair("lapses", "1")}) {
    one = differences(member, value);
    EXPECT_EQ(one.states, 1) << member;
    EXPECT_EQ(one.first, "case 1, step 2") << member;
  }
}

TEST(ReplayComparison, AChanceBeforeTheFirstAnswerIsADifferenceWhateverItIs) {
  for (const double chance : {0.0, 1.0}) {
    auto json = nlohmann::ordered_json::parse(with_numbers("", ""));
    json["cases"][0]["steps"][0]["retrievability_before"] = chance;
    const std::string text = json.dump();
    const auto found = compare_with_own_numbers(text, *replay_histories(text));
    ASSERT_TRUE(found) << base::to_line(found.error());
    EXPECT_EQ(found->first, "case 1, step 1") << chance;
  }
}

TEST(ReplayComparison, IsToTheEighthDecimal) {
  const auto own = *replay_histories(with_numbers("", ""));
  const double stability = own.cases[0].steps[1].after.stability;
  EXPECT_EQ(differences("stability", nlohmann::ordered_json(stability + 0.4e-8).dump()).first, "");
  EXPECT_EQ(differences("stability", nlohmann::ordered_json(stability + 0.6e-8).dump()).first,
            "case 1, step 2");
}

TEST(ReplayComparison, PassesOverWhatIsNotThere) {
  EXPECT_EQ(differences("stability", "").steps, 1) << "a step without numbers of its own";
  EXPECT_EQ(differences("retrievability_before", "").first, "");
  for (const char* member : {"difficulty", "state", "scheduled_days", "due", "reps", "lapses"}) {
    const std::string text = with_numbers(member, "");
    EXPECT_THAT(base::to_line(compare_with_own_numbers(text, *replay_histories(text)).error()),
                testing::AllOf(HasSubstr(member), HasSubstr("missing")));
  }
  for (const auto& [member, value] :
       {std::pair("due", "\"noon\""), std::pair("stability", "-1"), std::pair("difficulty", "1000001"),
        std::pair("retrievability_before", "1.5"), std::pair("scheduled_days", "1000001"),
        std::pair("scheduled_days", "-1"), std::pair("reps", "-1"), std::pair("lapses", "1000001")}) {
    const std::string text = with_numbers(member, value);
    EXPECT_THAT(base::to_line(compare_with_own_numbers(text, *replay_histories(text)).error()),
                HasSubstr(member));
  }
  // More cases or steps than were replayed.
  const std::string text = with_numbers("", "");
  EXPECT_EQ(compare_with_own_numbers(text, Replay())->steps, 0);
  Replay shorter = *replay_histories(text);
  shorter.cases[0].steps.resize(1);
  EXPECT_EQ(compare_with_own_numbers(text, shorter)->steps, 1);
  EXPECT_FALSE(compare_with_own_numbers("[", Replay()));
}

TEST(Replay, CountsDatesInUtcForTheStepAndFullDaysForTheChance) {
  const auto replay =
      replay_histories(R"({"cases": [{"request_retention": 0.85, "short_term_steps": false, "steps": [
      {"at": "2026-01-01T23:00Z", "rating": 4}, {"at": "2026-01-02T01:00Z", "rating": 3},
      {"at": "2026-01-03T00:59Z", "rating": 3}, {"at": "2026-01-03T00:59Z", "rating": 3}]}]})");
  ASSERT_TRUE(replay) << base::to_line(replay.error());
  const ReplayCase& one = replay->cases[0];
  EXPECT_EQ(one.desired_retention, 0.85);
  EXPECT_FALSE(one.short_term_steps);
  FsrsSettings settings;
  settings.desired_retention = 0.85;
  settings.short_term_steps = false;
  const Fsrs fsrs = *Fsrs::create(settings);
  ASSERT_EQ(one.steps.size(), 4U);
  EXPECT_FALSE(one.steps[0].retrievability_before);
  // Two hours later, but on another date; then less than a day later, again on another date.
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(one.steps[i].retrievability_before, 1) << i;
    EXPECT_EQ(one.steps[i].after, fsrs.next(one.steps[i - 1].after, Rating::good, one.steps[i].at, 1)) << i;
  }
  EXPECT_EQ(one.steps[3].after, fsrs.next(one.steps[2].after, Rating::good, one.steps[3].at, 0));
}

TEST(Replay, HasItsLimitsAndDefaults) {
  const auto fits = [](const std::string& member) {
    return replay_histories("{\"cases\": [{" + member + ", \"steps\": []}]}").has_value();
  };
  EXPECT_TRUE(fits(R"("request_retention": 0.8)"));
  EXPECT_TRUE(fits(R"("request_retention": 0.97)"));
  EXPECT_FALSE(fits(R"("request_retention": 0.79)"));
  EXPECT_FALSE(fits(R"("request_retention": 0.98)"));
  EXPECT_FALSE(fits(R"("short_term_steps": true)"));
  EXPECT_EQ(refusal(R"({"at": "2026-01-01T09:00:00Z", "rating": 1})"), "");
  EXPECT_EQ(refusal(R"({"at": "2026-01-01T09:00:00Z", "rating": 4})"), "");
  EXPECT_THAT(refusal(R"({"at": "2026-01-01T09:00:00Z", "rating": 0})"), HasSubstr("1 to 4"));
  EXPECT_THAT(refusal("{\"at\": \"" + std::string(41, '1') + "\", \"rating\": 4}"),
              HasSubstr("longer than 40"));
  EXPECT_EQ(ReplayCase().desired_retention, 0.9);
  EXPECT_TRUE(ReplayCase().short_term_steps);
  EXPECT_EQ(Replay().weights, kDefaultWeights);
  const auto replay = replay_histories(R"({"weights": [1,1,1,1,1,1,1,0.5,1,0.5,1,1,0.2,0.5,1,1,1,1,1,0.5,0.5],
                                           "cases": [{"request_retention": 0.9, "steps": []}]})");
  ASSERT_TRUE(replay) << base::to_line(replay.error());
  EXPECT_EQ(replay->weights[20], 0.5);
  EXPECT_TRUE(replay->cases[0].short_term_steps);
  EXPECT_THAT(base::to_line(replay_histories(R"({"weights": ["x"], "cases": []})").error()),
              HasSubstr("finite"));
}

TEST(Replay, TellsHowFarItIsAndStops) {
  std::vector<double> told;
  const std::string text = R"({"cases": [{"request_retention": 0.9, "steps": []},
                                         {"request_retention": 0.9, "steps": []}]})";
  ASSERT_TRUE(replay_histories(text, [&](double done, std::string_view) {
    told.push_back(done);
    return true;
  }));
  EXPECT_EQ(told, (std::vector{0.0, 0.5}));
  EXPECT_EQ(replay_histories(text, [](double, std::string_view) { return false; }).error().code,
            base::Errc::cancelled);
}

}  // namespace
}  // namespace nazori::study
