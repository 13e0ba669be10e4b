// SPDX-License-Identifier: Apache-2.0
// What the commands of study say to people, word by word.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "study_program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

class StudyText : public StudyProgram {
 protected:
  std::string said(std::vector<std::string> arguments, const std::string& now = kFirst) {
    const Outcome run = study(std::move(arguments), now);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    return run.out;
  }
  /// Makes a list of these characters the only one that new characters come from.
  void study_only(const std::string& characters) {
    write(folder_ / "few.txt", characters);
    ASSERT_EQ(study({"lists", "--import", folder_ / "few.txt", "--as", "few"}).code, 0);
    ASSERT_EQ(study({"settings", "new_lists=[\"list:few\"]", "new_order=own"}).code, 0);
  }
};

TEST_F(StudyText, AReviewTellsTheRatingTheSuggestionAndWhenItComesBack) {
  // FSRS-6: an easy first review has a stability of 8.2956 days; steps are 1 and 10 minutes.
  EXPECT_EQ(said({"review", "休", "--rating", "easy"}), "休  easy (suggested: good), comes back in 8 days\n");
  EXPECT_EQ(said({"review", "木", "--rating", "good"}), "木  good (suggested: good), comes back in 10 min\n");
  EXPECT_EQ(said({"review", "人", "--rating", "again"}),
            "人  again (suggested: again), comes back in 1 min\n");
  EXPECT_EQ(said({"review", "本", "--score", "69"}), "本  hard (suggested: hard), comes back in 6 min\n");
  EXPECT_EQ(said({"review", "火", "--stage", "trace"}), "火  practised (trace), next: guided\n");
}

TEST_F(StudyText, EachThingThatHappenedInAWritingDecidesTheSuggestion) {
  const auto suggested = [this](std::vector<std::string> options) {
    options.insert(options.begin(), {"review", "休", "--json"});
    const Outcome run = study(options);
    EXPECT_EQ(run.code, 0) << run.err;
    return nlohmann::json::parse(run.out)["rating"].get<std::string>();
  };
  // The table of docs/study.md.
  EXPECT_EQ(suggested({}), "good");
  EXPECT_EQ(suggested({"--score", "70"}), "good");
  EXPECT_EQ(suggested({"--score", "69"}), "hard");
  EXPECT_EQ(suggested({"--rejected"}), "again");
  EXPECT_EQ(suggested({"--shown", "1"}), "again");
  EXPECT_EQ(suggested({"--hints", "1"}), "hard");
  EXPECT_EQ(suggested({"--hints", "2"}), "again");
  EXPECT_EQ(suggested({"--misses", "1"}), "hard");
  EXPECT_EQ(suggested({"--help-level", "0.1"}), "good");
  EXPECT_EQ(suggested({"--help-level", "0.11"}), "hard");
  EXPECT_EQ(suggested({"--help-level", "0.51"}), "again");
  EXPECT_EQ(suggested({"--fault", "ending:6"}), "good");
  EXPECT_EQ(suggested({"--fault", "wrong:1"}), "hard");
}

TEST_F(StudyText, AMistakeHasAKindAndAStrokeOfTheCharacter) {
  const auto refused = [this](const std::string& fault) {
    const Outcome run = study({"review", "休", "--fault", fault});
    EXPECT_EQ(run.code, 2) << fault;
    return run.err;
  };
  for (const char* bad : {"wrong:0", "wrong:-1", "wrong:1001", "wrong:", "wrong:1x", ":1", "bent:1", "wrong"})
    EXPECT_THAT(refused(bad), HasSubstr(std::string(bad) + ": is not a valid stroke mistake")) << bad;
  EXPECT_THAT(refused("missing:7"), HasSubstr("missing:7: 休 has 6 strokes (give a stroke from 1 to 6)"));
  EXPECT_EQ(study({"review", "休", "--fault", "wrong:6"}).code, 0);
  // An extra stroke is counted among those that were written.
  EXPECT_EQ(study({"review", "休", "--fault", "extra:7"}).code, 0);
  EXPECT_EQ(study({"review", "休", "--fault", "extra:1000"}).code, 0);
  EXPECT_THAT(study({"review", "一", "--fault", "missing:2"}).err, HasSubstr("一 has 1 stroke ("));
}

TEST_F(StudyText, TheStatisticsNameCountsRetentionAndHardStrokes) {
  EXPECT_EQ(said({"stats"}), "nothing studied yet; nazori-cli study due shows what to start with\n");
  (void)said({"review", "休", "--rating", "easy", "--seconds", "50", "--fault", "wrong:3"});
  (void)said({"review", "木", "--rating", "easy", "--seconds", "50"});
  const std::string day = "2026-01-09T09:00:00Z";
  EXPECT_EQ(said({"review", "休", "--rating", "good", "--seconds", "200", "--fault", "wrong:3"}, day)
                .substr(0, std::string("休  good (suggested: hard), comes back in ").size()),
            "休  good (suggested: hard), comes back in ");
  const std::string text = said({"stats"}, day);
  EXPECT_THAT(text, StartsWith("reviews     3 in 5 min\nstreak      1 day (longest 1)\n"));
  EXPECT_THAT(text, HasSubstr("\nretention   100.0 % of 1 reviews (predicted 90.2 %)\n"));
  EXPECT_THAT(text, HasSubstr("\ncharacters  1 mature 1 young\n"));
  EXPECT_THAT(text, HasSubstr("\nhard        休 stroke 3: 2 of 2 writings, wrong 2\n"));
  // Thirty days, on the first of them the one that is still due.
  const std::size_t forecast = text.find("\nforecast    1 ");
  ASSERT_NE(forecast, std::string::npos) << text;
  const std::string line = text.substr(forecast + 1, text.find('\n', forecast + 1) - forecast - 1);
  EXPECT_EQ(std::count(line.begin(), line.end(), ' '), 3 + 30);
  EXPECT_THAT(said({"stats"}, "2026-01-10T09:00:00Z"), HasSubstr("1 day (longest 1), not yet today\n"));
}

TEST_F(StudyText, WhatIsDueIsToldWithWhatComesLaterAndWhenNothingIs) {
  study_only("休木");
  EXPECT_THAT(said({"due"}), MatchesRegex("2026-01-01: 2 due, about [0-9]+ min\nnew +2  休 木\n"));
  (void)said({"review", "休", "--rating", "easy"});
  (void)said({"review", "木", "--rating", "again"});
  EXPECT_EQ(said({"review", "木", "--rating", "again"}),
            "木  again (suggested: again), comes back in 1 min\n");
  (void)said({"review", "木", "--rating", "easy"}, "2026-01-01T09:02:00Z");
  EXPECT_EQ(said({"due"}, "2026-01-01T10:00:00Z"), "2026-01-01: nothing is due\n");
  expect_one_line(study({"next"}, "2026-01-01T10:00:00Z"), 1, {"nothing is due"});
}

TEST_F(StudyText, TheTimeThatItTakesIsInMinutesOrFromSixtyOnInHours) {
  // Three minutes for each new character.
  const auto about = [this](int characters) {
    (void)said({"settings", "new_per_day=" + std::to_string(characters)});
    const std::string text = said({"due"});
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(about(1), "2026-01-01: 1 due, about 3 min");
  EXPECT_EQ(about(19), "2026-01-01: 19 due, about 57 min");
  EXPECT_EQ(about(20), "2026-01-01: 20 due, about 1 h 0 min");
  EXPECT_EQ(about(41), "2026-01-01: 41 due, about 2 h 3 min");
}

TEST_F(StudyText, AStepOfMinutesIsToldAsLater) {
  study_only("休木");
  (void)said({"settings", "learning_steps_min=[1,60]"});
  (void)said({"review", "休", "--rating", "good"});
  EXPECT_THAT(said({"due"}), HasSubstr("\n1 later today, the next in 60 min\n"));
  EXPECT_THAT(said({"due"}, "2026-01-01T09:10:30Z"), HasSubstr("\n1 later today, the next in 50 min\n"));
}

TEST_F(StudyText, TheNextCharacterHasItsStageAndAPreviewOfEachRating) {
  study_only("休");
  EXPECT_EQ(said({"next"}), "休  watch\nagain in 1 min · hard in 6 min · good in 10 min · easy in 8 days\n");
}

TEST_F(StudyText, AReturnAfterALongAbsenceIsGentle) {
  for (const char* one : {"一", "二", "三", "四", "五"}) (void)said({"review", one, "--rating", "easy"});
  (void)said({"settings", "reviews_per_day=4"});
  const std::string text = said({"due"}, "2026-02-01T09:00:00Z");
  // Half of four on the first day back.
  EXPECT_THAT(text, HasSubstr("2026-02-01: 2 due, about "));
  EXPECT_THAT(text, HasSubstr("5 waiting; do 2 today, and you will catch up by 2026-02-"));
  EXPECT_THAT(text, HasSubstr("; nothing new until then\n"));
}

TEST_F(StudyText, DifficultCharactersAreNamedAndPutBack) {
  (void)said({"settings", "leech_lapses=2"});
  EXPECT_EQ(study({"leech"}).code, 1);
  (void)said({"review", "休", "--rating", "easy"});
  EXPECT_THAT(said({"review", "休", "--rating", "again"}, "2026-01-10T09:00:00Z"), Not(HasSubstr("often")));
  (void)said({"review", "休", "--rating", "easy"}, "2026-01-10T10:00:00Z");
  EXPECT_THAT(said({"review", "休", "--rating", "again"}, "2026-03-10T09:00:00Z"),
              HasSubstr("; forgotten too often, taken out of reviews\n"));
  EXPECT_EQ(said({"leech"}, "2026-03-10T10:00:00Z"), "休  forgotten 2 times\n");
  EXPECT_THAT(said({"due"}, "2026-03-10T10:00:00Z"),
              HasSubstr("1 difficult, forgotten too often: nazori-cli study leech\n"));
  EXPECT_EQ(said({"leech", "休"}, "2026-03-10T10:00:00Z"), "back in reviews: 1 character\n");
  EXPECT_EQ(study({"leech"}, "2026-03-10T10:00:00Z").code, 1);
}

TEST_F(StudyText, EachChangeNamesWhatItDidToHowMany) {
  (void)said({"review", "休", "--rating", "easy"});
  EXPECT_EQ(said({"postpone", "休", "--days", "20"}), "postponed: 1 character\n");
  EXPECT_THAT(said({"due"}, "2026-01-20T09:00:00Z"), Not(HasSubstr("休")));
  EXPECT_THAT(said({"due"}, "2026-01-21T09:00:00Z"), HasSubstr("reviews    1  休\n"));
  EXPECT_EQ(said({"pause", "休", "木"}), "paused: 2 characters\n");
  EXPECT_THAT(said({"due"}, "2026-01-21T09:00:00Z"), Not(HasSubstr("休")));
  EXPECT_EQ(said({"resume", "休木"}), "resumed: 2 characters\n");
  EXPECT_THAT(said({"due"}, "2026-01-21T09:00:00Z"), HasSubstr("reviews    1  休\n"));
  EXPECT_EQ(said({"reset", "休"}), "started over: 1 character\n");
  EXPECT_THAT(said({"due"}, "2026-01-21T09:00:00Z"), Not(HasSubstr("reviews")));
  EXPECT_EQ(said({"undo", "-n", "2"}), "undone: reset 休\nundone: resume 休木\n");
  const Outcome all = study({"undo", "-n", "9"});
  EXPECT_EQ(all.code, 1);
  EXPECT_THAT(all.out, StartsWith("undone: pause 休木\nundone: postpone 休\nundone: "));
  EXPECT_THAT(all.err, HasSubstr("nothing left to undo"));
}

TEST_F(StudyText, WhatIsKnownIsMarkedOnceAndComesLater) {
  write(folder_ / "known.txt", "木と人、木。");
  EXPECT_EQ(said({"know", "休", "--text", folder_ / "known.txt"}), "known: 4 characters\n");
  const Outcome again = study({"know", "休木"});
  EXPECT_EQ(again.code, 1);
  EXPECT_EQ(again.out, "known: 0 characters\n");
  write(folder_ / "latin.txt", "nothing of that");
  expect_one_line(study({"know", "--text", folder_ / "latin.txt"}), 2, {"has no kanji or kana"});
  expect_one_line(study({"know"}), 2, {"the characters: are missing", "--text FILE"});
  expect_one_line(study({"know", "--text", folder_ / "none.txt"}), 2, {"none.txt"});
  EXPECT_THAT(said({"due"}, "2026-01-07T09:00:00Z"), Not(HasSubstr("reviews")));
  EXPECT_THAT(said({"due"}, "2026-01-15T09:00:00Z"), HasSubstr("reviews    4 "));
}

TEST_F(StudyText, ListsCountTheirMembersAndThoseThatWereStudied) {
  study_only("休木人");
  (void)said({"tag", "休", "日", "--with", "exam"});
  (void)said({"review", "休", "--rating", "easy"});
  (void)said({"review", "木", "--rating", "good"});
  const std::string text = said({"lists"});
  // 80 kanji of the first grade; 休 and 木 are among them.
  EXPECT_THAT(text, HasSubstr("grade-1                    80 characters,    2 studied  "));
  EXPECT_THAT(text, HasSubstr("\nlist:few                    3 characters,    2 studied  few\n"));
  EXPECT_THAT(text, HasSubstr("\ntag:exam                    2 characters,    1 studied  exam\n"));
  EXPECT_EQ(said({"lists", "list:few"}), "休 木 人\n");
  EXPECT_EQ(said({"lists", "tag:exam"}), "休 日\n");
  for (const auto& one : nlohmann::json::parse(said({"lists", "--json"})))
    EXPECT_TRUE(one["list"] != "list:few" || one["met"] == 2) << one;
  EXPECT_EQ(said({"lists", "--import", folder_ / "few.txt", "--as", "more"}), "list:more  3 characters\n");
  EXPECT_EQ(said({"lists", "--remove", "more"}), "removed list:more\n");
  EXPECT_EQ(study({"lists", "list:more"}).code, 1);
  expect_one_line(study({"lists", "--import", folder_ / "few.txt"}), 2, {"--as", "is missing"});
  expect_one_line(study({"lists", "--import", folder_ / "none.txt", "--as", "x"}), 2, {"none.txt"});
  EXPECT_EQ(said({"tag", "休"}), "tagged: 1 character\n");
  EXPECT_EQ(said({"lists", "tag:exam"}), "日\n");
  EXPECT_EQ(said({"pause", "list:few", "tag:exam", "火"}), "paused: 5 characters\n");
  expect_one_line(study({"tag", "休", "--with", std::string(101, 'a')}), 2,
                  {"cannot be a tag", "--with", "1 to 100 bytes"});
}

TEST_F(StudyText, ProfilesAreListedRenamedAndRemoved) {
  (void)said({"review", "休", "--rating", "good"});
  (void)said({"review", "休", "--rating", "good", "--profile", "Mari"});
  EXPECT_EQ(said({"profiles"}), "Mari\nlearner\n");
  EXPECT_EQ(said({"profiles", "--rename", "learner", "Ken"}), "Ken\nMari\n");
  const std::string removed = said({"profiles", "--remove", "Ken"});
  EXPECT_THAT(removed, StartsWith("moved to " + (folder_ / "learners")));
  EXPECT_THAT(removed, testing::EndsWith("\nMari\n"));
  const std::string moved = removed.substr(9, removed.find('\n') - 9);
  EXPECT_TRUE(std::filesystem::is_directory(moved)) << moved;
  EXPECT_EQ(study({"profiles", "--rename", "none", "x"}).code, 2);
  EXPECT_EQ(study({"profiles", "--remove", "none"}).code, 2);
}

}  // namespace
}  // namespace nazori::cli::test
