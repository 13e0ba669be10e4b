// SPDX-License-Identifier: Apache-2.0
// What the commands of study say about the files of a learner.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "study_program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

class StudyFiles : public StudyProgram {
 protected:
  std::string said(std::vector<std::string> arguments, const std::string& now = kFirst) {
    const Outcome run = study(std::move(arguments), now);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  }
  nlohmann::json answer(std::vector<std::string> arguments, const std::string& now = kFirst) {
    arguments.emplace_back("--json");
    return nlohmann::json::parse(said(std::move(arguments), now));
  }
  std::string text_of(const std::string& name) const {
    const auto bytes = bytes_of(folder_ / name);
    return {bytes.begin(), bytes.end()};
  }
};

TEST_F(StudyFiles, AnExportIsNamedAndAnImportCounted) {
  (void)said({"review", "休", "--rating", "good"});
  const std::string file = folder_ / "me.json";
  EXPECT_EQ(said({"export", "--output", file}), file + "\n");
  EXPECT_EQ(answer({"export", "--output", file})["file"], file);
  EXPECT_EQ(said({"import", file, "--profile", "Mari"}), "1 entry, 1 character\n");
  (void)said({"review", "木", "--rating", "good"});
  (void)said({"export", "--output", file});
  const auto imported = answer({"import", file, "--profile", "Ken"});
  EXPECT_EQ(imported["entries"], 2);
  EXPECT_EQ(imported["characters"], 2);
  EXPECT_EQ(said({"rebuild", "--profile", "Ken"}),
            "2 entries, 2 characters (2 of them studied), 0 differed from the saved states\n");
  expect_one_line(study({"import", folder_ / "none.json", "--profile", "New"}), 2, {"none.json"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "learners/New"));
}

TEST_F(StudyFiles, AnExportIsATableOrAPackageAsItsNameSays) {
  (void)said({"review", "休", "--rating", "good", "--fault", "wrong:3"});
  EXPECT_EQ(said({"export", "--output", folder_ / "t.CSV"}), folder_ / "t.CSV" + "\n");
  EXPECT_THAT(text_of("t.CSV"), HasSubstr("\"休\""));
  EXPECT_THAT(text_of("t.CSV"), HasSubstr("wrong:3"));
  (void)said({"export", "--output", folder_ / "a.apkg"});
  EXPECT_TRUE(text_of("a.apkg").starts_with("PK"));
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--words", "0"},
                                                 {"--deck", "Kanji"},
                                                 {"--list", "木"},
                                                 {"--list", "grade-1"}}) {
    std::vector<std::string> arguments{"export", "--output", folder_ / "b.apkg"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    (void)said(arguments);
    EXPECT_TRUE(text_of("b.apkg") != text_of("a.apkg")) << option.front();
  }
  EXPECT_GT(text_of("b.apkg").size(), text_of("a.apkg").size());
  expect_one_line(study({"export", "--output", folder_ / "c.apkg", "--profile", "New"}), 2,
                  {"nothing studied yet", "--list"});
}

TEST_F(StudyFiles, ABackupIsNamedAndEachOneIsListedWithWhatItHolds) {
  expect_one_line(study({"backup"}), 1, {"nothing studied yet"});
  expect_one_line(study({"restore", "--list"}), 1, {"there is no backup"});
  expect_one_line(study({"restore"}), 1, {"there is no backup"});
  (void)said({"review", "休", "--rating", "good"});
  EXPECT_EQ(said({"backup", "--output", folder_ / "b.db"}), folder_ / "b.db" + "\n");
  EXPECT_EQ(answer({"backup", "--output", folder_ / "c.db"})["file"], folder_ / "c.db");
  EXPECT_EQ(bytes_of(folder_ / "b.db").size(), bytes_of(folder_ / "c.db").size());
  const std::string made = said({"backup"});
  EXPECT_THAT(made, StartsWith(folder_ / "learners/learner/backups/"));
  EXPECT_TRUE(std::filesystem::exists(made.substr(0, made.size() - 1)));
  EXPECT_EQ(said({"restore", "--list"}),
            made.substr(0, made.size() - 1) + "  1 writing of 1 character, last study day 2026-01-01\n");
  const auto listed = answer({"restore", "--list"});
  EXPECT_EQ(listed[0]["writings"], 1);
  EXPECT_EQ(listed[0]["characters"], 1);
  EXPECT_EQ(listed[0]["last_day"], "2026-01-01");
  EXPECT_EQ(listed[0]["sound"], true);
  EXPECT_EQ(listed[0]["automatic"], false);
  // Only a daily one is restored unasked.
  expect_one_line(study({"restore"}), 1, {"there is no backup"});
}

TEST_F(StudyFiles, ARestoredBackupIsInPlaceAndWhatStoodThereIsKept) {
  (void)said({"review", "休", "--rating", "good"});
  (void)said({"backup", "--output", folder_ / "b.db"});
  (void)said({"review", "木", "--rating", "good"});
  const std::string text = said({"restore", folder_ / "b.db"});
  EXPECT_THAT(text, StartsWith("restored " + (folder_ / "b.db") + "\nthe previous data was saved as "));
  EXPECT_EQ(answer({"stats"})["reviews"], 1);
  const std::string start = "saved as ";
  std::string kept = text.substr(text.find(start) + start.size());
  kept.pop_back();
  (void)said({"restore", kept});
  EXPECT_EQ(answer({"stats"})["reviews"], 2);
  const auto json = answer({"restore", folder_ / "b.db"});
  EXPECT_EQ(json["restored"], folder_ / "b.db");
  EXPECT_TRUE(std::filesystem::exists(json["kept"].get<std::string>()));
  EXPECT_EQ(said({"restore", folder_ / "b.db", "--profile", "New"}), "restored " + (folder_ / "b.db") + "\n");
}

TEST_F(StudyFiles, AReplayTellsTheLargestDifferences) {
  const auto history = [this](const std::string& stability) {
    write(folder_ / "h.json",
          "{\"cases\": [{\"request_retention\": 0.9, \"short_term_steps\": true, \"steps\": [\n"
          "{\"at\": \"2026-01-01T09:00:00.000Z\", \"rating\": 4, \"stability\": " +
              stability +
              ", \"difficulty\": 1,\n\"state\": \"review\", \"scheduled_days\": 8, \"due\": "
              "\"2026-01-09T09:00:00.000Z\", \"reps\": 1,\n\"lapses\": 0, \"retrievability_before\": "
              "null}]}]}");
  };
  history("8.2956");
  EXPECT_EQ(
      said({"replay", folder_ / "h.json", "--check"}),
      "1 steps; largest differences: stability 0, difficulty 0, retrievability 0, interval 0 days, due 0 "
      "s; 0 different states\n");
  history("8.5");
  const Outcome run = study({"replay", folder_ / "h.json", "--check"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("1 steps; largest differences: stability 0.204"));
  EXPECT_THAT(run.err, HasSubstr("differs within 8 decimal places"));
  const Outcome json = study({"replay", folder_ / "h.json", "--check", "--json"});
  EXPECT_EQ(json.code, 1);
  EXPECT_NEAR(nlohmann::json::parse(json.out)["stability"].get<double>(), 0.2044, 1e-9);
}

TEST_F(StudyFiles, TheWorkloadOfEachRetentionIsALineOfATable) {
  const std::string text = said({"workload"});
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    lines.push_back(text.substr(at, text.find('\n', at) - at));
  ASSERT_EQ(lines.size(), 19U);
  EXPECT_EQ(lines[0], "retention  reviews a day  minutes a day  known after a year");
  for (std::size_t i = 1; i < lines.size(); ++i)
    EXPECT_THAT(lines[i], MatchesRegex("0\\.[89][0-9] +[0-9]+\\.[0-9] +[0-9]+\\.[0-9] +[0-9]+"));
  EXPECT_TRUE(lines[1].starts_with("0.80 "));
  EXPECT_TRUE(lines[18].starts_with("0.97 "));
  const auto json = answer({"workload"});
  ASSERT_EQ(json.size(), 18U);
  EXPECT_LT(json[0]["reviews_per_day"], json[17]["reviews_per_day"]);
}

TEST_F(StudyFiles, SettingsAreShownChangedAndRefusedByName) {
  const std::string text = said({"settings"});
  EXPECT_THAT(text, HasSubstr("\nnew_per_day=5\n"));
  EXPECT_THAT(text, HasSubstr("reviews_per_day=100\n"));
  EXPECT_THAT(text, HasSubstr("learning_steps_min=[1,10]\n"));
  EXPECT_THAT(said({"settings", "new_per_day=7", "new_order=frequency"}),
              testing::AllOf(HasSubstr("new_per_day=7\n"), HasSubstr("new_order=\"frequency\"\n")));
  EXPECT_EQ(answer({"settings"})["new_per_day"], 7);
  expect_one_line(study({"settings", "new_per_day"}), 2, {"new_per_day: is not a setting", "NAME=VALUE"});
  expect_one_line(study({"settings", "new_per_day=many"}), 2, {"new_per_day"});
  write(folder_ / "w.txt", "1, 2, 3");
  expect_one_line(study({"settings", "--weights", folder_ / "w.txt"}), 2, {"w.txt"});
  write(folder_ / "w.txt",
        "0.212, 1.2931, 2.3065, 8.2956, 6.4133, 0.8334, 3.0194, 0.001, 1.8722, 0.1666, 0.796, 1.4835, "
        "0.0614, 0.2629, 1.6483, 0.6014, 1.8729, 0.5425, 0.0912, 0.0658, 0.2");
  const auto changed = answer({"settings", "--weights", folder_ / "w.txt"});
  EXPECT_NEAR(changed["weights"][20].get<double>(), 0.2, 1e-12);
  EXPECT_EQ(changed["new_per_day"], 7);
}

}  // namespace
}  // namespace nazori::cli::test
