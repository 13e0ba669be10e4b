// SPDX-License-Identifier: Apache-2.0
// What holds for the files that every verb is given: names, "-", and files that are the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstring>
#include <filesystem>

#include "nazori/surface/height_map.h"
#include "program.h"

namespace nazori::cli::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kHand = "t,x,y,z\n0,0,0,0.01\n0.001,0,0,0.01\n0.002,0,0,0.01\n";

/// The first bytes of a file, and of the standard output.
bool is_png(const std::string& bytes) { return bytes.starts_with("\x89PNG\r\n"); }

TEST(Files, AnInputIsNeverOverwritten) {
  const TemporaryFolder folder;
  write(folder / "h.csv", kHand);
  fs::create_symlink(folder / "h.csv", folder / "link.csv");
  fs::create_hard_link(folder / "h.csv", folder / "same.csv");
  for (const std::string& name :
       {folder / "h.csv", folder / "link.csv", folder / "same.csv", folder.path().string() + "/./h.csv"}) {
    expect_one_line(nazori_cli({"feel", "休", "--input", folder / "h.csv", "--output", name}), 2,
                    {"--output", "is the same file as --input", "write to another file"});
  }
  EXPECT_EQ(bytes_of(folder / "h.csv").size(), std::strlen(kHand));
  const Outcome other = nazori_cli({"feel", "休", "--input", folder / "h.csv", "--output", folder / "f.csv"});
  EXPECT_EQ(other.code, 0) << other.err;
}

TEST(Files, TwoOutputsAreNeverOneFile) {
  const TemporaryFolder folder;
  const std::string n = folder / "n.png";
  expect_one_line(nazori_cli({"plot", "y=x", "--output", n, "--mask", n}), 2,
                  {"--mask", "is the same file as --output"});
  expect_one_line(
      nazori_cli({"plot", "y=x", "--mask", n, "--print",
                  folder.path().string() + "/../" + folder.path().filename().string() + "/n.png"}),
      2, {"--print", "is the same file as --mask"});
  expect_one_line(nazori_cli({"plot", "y=x", "--output", "-", "--mask", "-"}), 2,
                  {"--mask", "standard output is taken by --output"});
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Files, ABackupIsNotWrittenOverTheLearner) {
  const TemporaryFolder folder;
  const std::string learners = folder.path().string();
  ASSERT_EQ(nazori_cli({"study", "review", "休", "--rating", "good", "--learners", learners}).code, 0);
  const std::string file = folder / "learner/learner.db";
  expect_one_line(nazori_cli({"study", "backup", "--output", file, "--learners", learners}), 2,
                  {"--output", "which is read"});
}

TEST(Files, EachPairOfBracesInANameBecomesTheCharacter) {
  const TemporaryFolder folder;
  ASSERT_EQ(nazori_cli({"carve", "休木", "--size", "16", "-o", folder / "{}-{}.png"}).code, 0);
  EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("休-休.png", "木-木.png"));
}

TEST(Files, AFolderIsNoFile) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "d.png");
  expect_one_line(nazori_cli({"plot", "y=x", "--output", folder / "d.png"}), 2,
                  {"d.png: is a folder, not a file", "give a file name"});
  expect_one_line(nazori_cli({"plot", "y=x", "--output", folder / "none/d.png"}), 2,
                  {"the folder " + (folder / "none") + " does not exist"});
  expect_one_line(nazori_cli({"plot", "y=x", "--output", folder / "d.txt"}), 2,
                  {"has an unsupported file type", "use a name that ends in .png or .raw"});
}

TEST(Files, ALongAnswerIsTheSameInAFileAndOnStandardOutput) {
  const TemporaryFolder folder;
  // 20,001 rows are more than two megabytes, so they are sent in several pieces.
  write(folder / "h.csv", "t,x,y,z\n0,0,0,0.01\n1,0.02,0,0.005\n");
  std::vector<std::string> feel{"feel",           "一",     "--map-size", "64", "--input",
                                folder / "h.csv", "--rate", "20000"};
  feel.insert(feel.end(), {"--output", folder / "f.csv"});
  ASSERT_EQ(nazori_cli(feel).code, 0);
  feel.back() = "-";
  const Outcome run = nazori_cli(feel);
  EXPECT_EQ(run.code, 0) << run.err;
  const auto bytes = bytes_of(folder / "f.csv");
  EXPECT_GT(bytes.size(), std::size_t{1} << 20);
  EXPECT_EQ(std::count(bytes.begin(), bytes.end(), '\n'), 20'002);
  EXPECT_TRUE(run.out == std::string(bytes.begin(), bytes.end()));
}

TEST(Files, ADashIsStandardOutput) {
  const TemporaryFolder folder;
  const Outcome carved = nazori_cli({"carve", "休", "--output", "-"}, {}, folder.path());
  EXPECT_EQ(carved.code, 0) << carved.err;
  ASSERT_TRUE(is_png(carved.out));
  ASSERT_EQ(nazori_cli({"carve", "休", "--output", folder / "a.png"}).code, 0);
  const auto bytes = bytes_of(folder / "a.png");
  EXPECT_EQ(carved.out, std::string(bytes.begin(), bytes.end())) << "the same bytes as in a file";

  const Outcome plotted = nazori_cli({"plot", "y=x", "--mask", "-", "--size", "64"}, {}, folder.path());
  EXPECT_EQ(plotted.code, 0) << plotted.err;
  EXPECT_TRUE(is_png(plotted.out));
  const Outcome drawn = nazori_cli({"render", "休", "-o", "-", "--size", "64"}, {}, folder.path());
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(is_png(drawn.out));
  const Outcome traced = nazori_cli({"demo", "一", "-o", "-", "--size", "64"}, {}, folder.path());
  EXPECT_EQ(traced.code, 0) << traced.err;
  EXPECT_TRUE(is_png(traced.out));
  EXPECT_THAT(folder.names(), ElementsAre("a.png"));
}

TEST(Files, ADashIsStandardOutputForRecordingsAndStudyToo) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      nazori_cli({"demo", "一", "-o", folder / "a.png", "--size", "64", "--record", folder / "a.nzr"}).code,
      0);
  const Outcome table = nazori_cli({"record", "export", folder / "a.nzr", "-o", "-"}, {}, folder.path());
  EXPECT_EQ(table.code, 0) << table.err;
  EXPECT_TRUE(table.out.starts_with("t,")) << table.out.substr(0, 80);
  const Outcome learner =
      nazori_cli({"study", "export", "-o", "-", "--learners", folder / "learners"}, {}, folder.path());
  EXPECT_EQ(learner.code, 0) << learner.err;
  EXPECT_TRUE(learner.out.starts_with("{")) << learner.out.substr(0, 80);
  EXPECT_THAT(folder.names(), ElementsAre("a.nzr", "a.png"));
}

TEST(Files, WhatCannotGoToStandardOutputIsRefused) {
  expect_one_line(nazori_cli({"carve", "休木", "-o", "-"}), 2, {"one file cannot hold 2 characters"});
  expect_one_line(nazori_cli({"carve", "休", "-o", "-", "--json"}), 2,
                  {"standard output cannot hold both the file and JSON"});
  expect_one_line(nazori_cli({"demo", "休", "--record", "-"}), 2, {"--record", "standard output"});
  expect_one_line(nazori_cli({"database", "build", "-o", "-"}), 2, {"--output", "standard output"});
  expect_one_line(nazori_cli({"study", "backup", "-o", "-"}), 2, {"--output", "standard output"});
}

TEST(Files, AFileForStandardOutputThatCannotBeWrittenIsNotDone) {
  expect_one_line(shell("\"$NAZORI\" carve 休 -o - > /dev/full"), 2, {"standard output"});
  const Outcome quiet = shell("\"$NAZORI\" carve 休 -o - --quiet | head -c 4 | tail -c 3");
  EXPECT_EQ(quiet.out, "PNG");
}

TEST(Files, ABareNameIsAFileHere) {
  const TemporaryFolder folder;
  write(folder / "empty.tgz", "");
  // Far enough to show that the name itself is not the problem.
  const Outcome run =
      nazori_cli({"database", "build", "-o", "k.db", "--kanjivg", folder / "empty.tgz"}, {}, folder.path());
  expect_one_line(run, 2, {"empty.tgz"});
  const Outcome carved = nazori_cli({"carve", "休", "-o", "k.png"}, {}, folder.path());
  EXPECT_EQ(carved.code, 0) << carved.err;
}

TEST(Files, APipeForADatabaseIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "kanji.db";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expect_one_line(nazori_cli({"info", "休", "--database", pipe}), 2, {"kanji.db", "is not a regular file"});
  expect_one_line(nazori_cli({"database", "check", pipe}), 1, {"is not a regular file"});
}

TEST(Files, AFolderOfLearnersThatIsAFileIsRefused) {
  const TemporaryFolder folder;
  write(folder / "a.png", "no folder");
  for (const char* verb : {"due", "stats", "profiles", "settings"}) {
    expect_one_line(nazori_cli({"study", verb, "--learners", folder / "a.png"}), 2,
                    {"a.png", "is a file, not a folder"});
  }
  expect_one_line(nazori_cli({"study", "due"}, {"NAZORI_LEARNERS=" + (folder / "a.png")}), 2,
                  {"is a file, not a folder"});
}

TEST(Files, AnswersThatCannotBeWrittenAreNotDone) {
  const std::string line = "'{\"char\":\"一\",\"strokes\":[[[0.1,0.5],[0.9,0.5]]]}'";
  for (const char* verb : {"grade", "recognise"}) {
    expect_one_line(shell("echo " + line + " | \"$NAZORI\" " + verb + " > /dev/full"), 2,
                    {"standard output"});
  }
}

TEST(Files, AHeightMapIsKnownByWhatItHolds) {
  const TemporaryFolder folder;
  ASSERT_EQ(nazori_cli({"carve", "休", "-o", folder / "a.png", "--size", "64"}).code, 0);
  fs::rename(folder / "a.png", folder / "a.raw");
  const Outcome run =
      nazori_cli({"render", "--height-map", folder / "a.raw", "-o", folder / "b.png", "--size", "64"});
  EXPECT_EQ(run.code, 0) << run.err;
}

}  // namespace
}  // namespace nazori::cli::test
