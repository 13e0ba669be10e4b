// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study_program.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class Study : public StudyProgram {
 protected:
  Json answer(std::vector<std::string> arguments, const std::string& now = kFirst) {
    arguments.emplace_back("--json");
    const Outcome run = study(std::move(arguments), now);
    EXPECT_EQ(run.code, 0) << run.err;
    return Json::parse(run.out, nullptr, false);
  }
};

TEST_F(Study, AWeekIsActedOutWithAMovedClock) {
  EXPECT_EQ(answer({"due"})["new"], 5);
  for (int i = 0; i < 5; ++i) {
    const Json next = answer({"next"});
    EXPECT_EQ(next["kind"], "new");
    const std::string character = next["character"];
    EXPECT_EQ(answer({"review", character, "--rating", "easy", "--seconds", "20"})["due_day"], "2026-01-09");
  }
  EXPECT_EQ(answer({"due"})["new"], 0);
  EXPECT_EQ(study({"next"}).code, 1);
  const std::string later = "2026-01-09T09:00:00Z";
  EXPECT_EQ(answer({"due"}, later)["reviews"], 5);
  EXPECT_EQ(answer({"due"}, later)["new"], 5);
  const std::string character = answer({"next"}, later)["character"];
  EXPECT_EQ(answer({"review", character, "--score", "95"}, later)["rating"], "good");
  EXPECT_EQ(answer({"due"}, later)["reviews"], 4);
  EXPECT_EQ(answer({"undo"}, later)[0]["characters"], character);
  EXPECT_EQ(answer({"due"}, later)["reviews"], 5);
  const Json statistics = answer({"stats"}, later);
  EXPECT_EQ(statistics["reviews"], 5);
  EXPECT_EQ(statistics["forecast"].size(), 30U);
  EXPECT_EQ(answer({"rebuild"}, later)["differences"], 0);
}

TEST_F(Study, WhatIsDueIsListedByKindWithItsCharacters) {
  const std::string known = answer({"next"})["character"];
  ASSERT_EQ(study({"review", known, "--rating", "easy", "--seconds", "20"}).code, 0);
  const std::string later = "2026-01-09T09:00:00Z", soon = "2026-01-09T09:30:00Z";
  std::vector<std::string> fresh;
  const Json due = answer({"due"}, later);
  for (const Json& task : due["now"])
    if (task["kind"] == "new") fresh.push_back(task["character"]);
  ASSERT_EQ(fresh.size(), 5U);
  ASSERT_EQ(study({"review", fresh[0], "--rating", "good", "--seconds", "20"}, later).code, 0);
  const Outcome run = study({"due"}, soon);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("2026-01-09: 6 due, about "));
  EXPECT_THAT(run.out, HasSubstr("\nsteps      1  " + fresh[0] + "\n"));
  EXPECT_THAT(run.out, HasSubstr("\nreviews    1  " + known + "\n"));
  EXPECT_THAT(run.out, HasSubstr("\nnew        4  " + fresh[1] + " " + fresh[2] + " " + fresh[3] + " " +
                                 fresh[4] + "\n"));
}

TEST_F(Study, TheRatingFollowsFromTheWriting) {
  EXPECT_EQ(answer({"review", "休", "--score", "72", "--fault", "wrong:3"})["rating"], "hard");
  EXPECT_EQ(answer({"review", "休", "--rejected"})["rating"], "again");
  EXPECT_EQ(answer({"review", "休", "--stage", "trace"})["next_stage"], "guided");
}

TEST_F(Study, ExportAndImportAreExact) {
  (void)answer({"review", "休", "--rating", "good"});
  const std::string file = folder_ / "me.json";
  EXPECT_EQ(study({"export", "--output", file}).code, 0);
  EXPECT_EQ(study({"import", file, "--profile", "Mari"}).code, 0);
  const std::string again = folder_ / "again.json";
  EXPECT_EQ(study({"export", "--output", again, "--profile", "Mari"}).code, 0);
  EXPECT_EQ(bytes_of(file), bytes_of(again));
  expect_one_line(study({"import", file, "--profile", "Mari"}), 2, {"not empty"});
  write(file, "{\"format\": \"nazori-learner\", \"version\": 1,\n\"entries\": [{}]}");
  expect_one_line(study({"import", file, "--profile", "Ken"}), 2, {"line 2", "missing"});
  EXPECT_EQ(Json::parse(study({"profiles", "--json"}).out), Json::array({"Mari", "learner"}));
  EXPECT_EQ(study({"export", "--output", folder_ / "t.csv"}).code, 0);
  EXPECT_EQ(study({"export", "--output", folder_ / "k.apkg", "--list", "休"}).code, 0);
  expect_one_line(study({"export", "--output", folder_ / "k.txt"}), 2, {"k.txt"});
}

TEST_F(Study, BackupsAreMadeDailyAndRestored) {
  (void)answer({"review", "休", "--rating", "good"});
  (void)answer({"review", "木", "--rating", "good"}, "2026-01-02T09:00:00Z");
  EXPECT_EQ(answer({"restore", "--list"}).size(), 1U);
  EXPECT_EQ(study({"restore"}).code, 0);
  EXPECT_EQ(answer({"stats"})["reviews"], 1);
  expect_one_line(study({"restore", folder_ / "none.db"}), 2, {"this backup does not exist"});
}

TEST_F(Study, ABackupThatFailsIsSaidAndTheReviewIsKept) {
  (void)answer({"review", "休", "--rating", "good"});
  write(folder_ / "learners/learner/backups", "a file where the folder belongs");
  const Outcome run = study({"review", "木", "--rating", "good"}, "2026-01-02T09:00:00Z");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("today's backup could not be made"));
  EXPECT_THAT(run.err, HasSubstr("backups"));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  EXPECT_EQ(answer({"stats"})["reviews"], 2);
}

TEST_F(Study, ListsAreImportedAndChosen) {
  write(folder_ / "list.txt", "木 林 # trees\n森\n");
  EXPECT_EQ(study({"lists", "--import", folder_ / "list.txt", "--as", "trees"}).code, 0);
  EXPECT_EQ(answer({"lists", "list:trees"}), Json::array({"木", "林", "森"}));
  EXPECT_EQ(study({"settings", "new_lists=[\"list:trees\"]", "new_order=own"}).code, 0);
  EXPECT_EQ(answer({"next"})["character"], "木");
  write(folder_ / "bad.txt", "木\n木😀\n");
  expect_one_line(study({"lists", "--import", folder_ / "bad.txt", "--as", "bad"}), 2,
                  {"bad.txt", "line 2", "😀"});
  EXPECT_EQ(study({"lists", "list:bad"}).code, 1);
}

TEST_F(Study, BadQuestionsAreRefusedAndChangeNothing) {
  expect_one_line(study({"review", "休", "--rating", "fine"}), 2, {"--rating"});
  expect_one_line(study({"review", "休", "--fault", "wrong"}), 2, {"wrong:3"});
  expect_one_line(study({"review", "休木"}), 2, {"one at a time"});
  expect_one_line(study({"review", "\xF0\x9F\x98\x80"}), 2, {"😀"});
  expect_one_line(study({"settings", "desired_retention=0.5"}), 2, {"desired_retention", "0.8"});
  expect_one_line(study({"settings", "colour=red"}), 2, {"colour=red"});
  expect_one_line(study({"due"}, "yesterday"), 2, {"yesterday"});
  expect_one_line(study({"due", "--profile", "a/b"}), 2, {"a/b"});
  expect_one_line(study({"review", "休", "--fault", "wrong:7"}), 2, {"wrong:7", "休 has 6 strokes"});
  EXPECT_EQ(answer({"stats"})["reviews"], 0);
  // A name that was mistyped does not become a learner.
  EXPECT_EQ(study({"undo", "--profile", "Mray"}).code, 1);
  EXPECT_EQ(study({"rebuild", "--profile", "Mray"}).code, 1);
  EXPECT_EQ(Json::parse(study({"profiles", "--json"}).out), Json::array({"learner"}));
}

TEST_F(Study, ReplayPrintsTheFormItReads) {
  const std::string file = folder_ / "h.json";
  write(file,
        "{\"cases\": [{\"request_retention\": 0.9, \"short_term_steps\": true, \"steps\": [\n"
        "{\"at\": \"2026-01-01T09:00:00.000Z\", \"rating\": 4, \"stability\": 8.2956, \"difficulty\": 1,\n"
        "\"state\": \"review\", \"scheduled_days\": 8, \"due\": \"2026-01-09T09:00:00.000Z\", \"reps\": 1,\n"
        "\"lapses\": 0, \"retrievability_before\": null}]}]}");
  const Outcome run = nazori_cli({"study", "replay", file});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["cases"][0]["steps"][0]["stability"], 8.2956);
  EXPECT_EQ(nazori_cli({"study", "replay", file, "--check"}).code, 0);
  EXPECT_EQ(study({"replay", file, "--profile", "Mari", "--json"}).out, run.out);
  EXPECT_EQ(answer({"replay", file, "--check"})["steps"], 1);
  write(file, "{\"cases\": [\n{\"request_retention\": 2, \"steps\": []}]}");
  expect_one_line(nazori_cli({"study", "replay", file}), 2, {"line 2", "request_retention"});
}

}  // namespace
}  // namespace nazori::cli::test
