// SPDX-License-Identifier: Apache-2.0
// What is left when Ctrl+C or a request to end comes in the middle of the work.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "nazori/surface/height_map.h"
#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Long enough into the work that options have been read and long loops have begun.
constexpr double kUnderWay_s = 0.25;

/// Waits until the program works, stops it and waits for its end.
Outcome stopped_at_work(RunningProgram& program, int signal) {
  EXPECT_TRUE(becomes_true([&program] { return program.processor_s() > kUnderWay_s; }));
  program.signal(signal);
  return program.wait();
}

/// The lock by which another program has a learner open.
class OpenLearner {
 public:
  explicit OpenLearner(const std::string& learners) {
    std::filesystem::create_directories(learners + "/learner");
    lock_ = ::open((learners + "/learner/learner.db.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    EXPECT_EQ(::flock(lock_, LOCK_EX | LOCK_NB), 0);
  }
  ~OpenLearner() { close(); }
  OpenLearner(const OpenLearner&) = delete;
  OpenLearner& operator=(const OpenLearner&) = delete;
  void close() {
    if (lock_ >= 0) (void)::close(lock_);
    lock_ = -1;
  }

 private:
  int lock_ = -1;
};

TEST(Stop, WhatWaitsForInputForEverEndsBySignal) {
  for (const int signal : {SIGINT, SIGTERM}) {
    RunningProgram grade({"grade"});
    grade.write("{\"char\":\"一\",\"strokes\":[[[0.1,0.5],[0.9,0.5]]]}\n");
    ASSERT_TRUE(becomes_true([&grade] { return !grade.out().empty(); }));
    grade.signal(signal);
    const Outcome run = grade.wait();
    EXPECT_EQ(run.code, 128 + signal);
    EXPECT_EQ(run.err, "");
  }
}

TEST(Stop, WorkThatHangsIsEndedAndItsUnfinishedFileRemoved) {
  const TemporaryFolder folder;
  write(folder / "h.csv", "the old one");
  RunningProgram feel({"feel", "休", "--input", "-", "--rate", "1000", "--output", folder / "h.csv"});
  feel.write("t,x,y,z\n0,0,0,0.01\n0.001,0,0,0.01\n");
  // The temporary file exists, and the next row never comes.
  ASSERT_TRUE(becomes_true([&folder] { return folder.names().size() == 2; }));
  feel.signal(SIGTERM);
  EXPECT_EQ(feel.wait().code, 143);
  EXPECT_THAT(folder.names(), ElementsAre("h.csv"));
  EXPECT_EQ(bytes_of(folder / "h.csv").size(), 11U);
}

TEST(Stop, APictureThatTakesLongIsNotWritten) {
  const TemporaryFolder folder;
  RunningProgram render({"render", "休", "--size", "8192x8192", "--output", folder / "a.png"});
  const Outcome run = stopped_at_work(render, SIGINT);
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Stop, OfSeveralMapsThoseThatAreThereAreWhole) {
  const TemporaryFolder folder;
  RunningProgram carve({"carve", "一二三四五六七八九十百千万円口目耳手足力男女子休木林森山川", "--size",
                        "2048", "--output", folder.path().string()});
  ASSERT_TRUE(becomes_true([&folder] {
    const auto names = folder.names();
    return std::any_of(names.begin(), names.end(),
                       [](const std::string& name) { return name.ends_with(".png"); });
  }));
  carve.signal(SIGTERM);
  EXPECT_EQ(carve.wait().code, 143);
  const std::vector<std::string> names = folder.names();
  EXPECT_LT(names.size(), 30U);
  for (const std::string& name : names) {
    EXPECT_TRUE(name.ends_with(".png")) << name;
    EXPECT_TRUE(surface::load_png(folder / name)) << name;
  }
}

TEST(Stop, AGraphThatTakesLongIsNotWritten) {
  const TemporaryFolder folder;
  RunningProgram plot({"plot", "sin(x^2 + y^2) = cos(x*y)", "--window=-60,60,-60,60", "--size", "4096",
                       "--output", folder / "a.png", "--mask", folder / "b.png"});
  const Outcome run = stopped_at_work(plot, SIGTERM);
  EXPECT_EQ(run.code, 143) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Stop, ARecordingThatIsStoppedLeavesTheOldOne) {
  for (const char* name : {"d.csv", "d.nzr"}) {
    const TemporaryFolder folder;
    write(folder / name, "the old one");
    RunningProgram demo(
        {"demo", "休", "--real-time", "--record", folder / name, "--output", folder / "d.png"});
    ASSERT_TRUE(becomes_true([&folder] { return folder.names().size() > 1; }));
    demo.signal(SIGTERM);
    const Outcome run = demo.wait();
    EXPECT_EQ(run.code, 143) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(folder.names(), ElementsAre(name));
    EXPECT_EQ(bytes_of(folder / name).size(), 11U);
  }
}

TEST(Stop, ATestOfADeviceTellsWhatItMeasuredAndEndsBySignal) {
  RunningProgram devices({"devices", "--test", "3600", "--device", "simulated:touch", "--json"});
  // The program, the one that waits for signals, and the servo's, whose running time is too short to measure.
  EXPECT_TRUE(becomes_true([&devices] { return devices.threads() >= 3; }));
  devices.signal(SIGINT);
  const Outcome run = devices.wait();
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_THAT(run.out, testing::HasSubstr("\"ticks\""));
}

TEST(Stop, ADatabaseThatIsBeingBuiltLeavesTheOldOne) {
  const TemporaryFolder folder;
  const std::string output = folder / "kanji.db";
  write(output, "the old one");
  RunningProgram build({"database", "build", "--force", "--output", output});
  ASSERT_TRUE(becomes_true([&folder] { return folder.names().size() > 1; }));
  build.signal(SIGINT);
  EXPECT_EQ(build.wait().code, 130);
  EXPECT_EQ(bytes_of(output).size(), 11U);
  EXPECT_THAT(folder.names(), ElementsAre("kanji.db"));
}

/// An export with this many reviews of one character.
void write_long_export(const std::string& file, int reviews) {
  const TemporaryFolder learners;
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(nazori_cli({"study", "review", "休", "--rating", "good", "--now", "2026-01-01T09:00Z",
                          "--learners", learners.path().string()})
                  .code,
              0);
  ASSERT_EQ(nazori_cli({"study", "export", "--output", file, "--learners", learners.path().string()}).code,
            0);
  const auto bytes = bytes_of(file);
  nlohmann::ordered_json all = nlohmann::ordered_json::parse(bytes.begin(), bytes.end());
  const nlohmann::ordered_json one = all["entries"].back();
  for (int id = 3; id <= reviews; ++id) {
    nlohmann::ordered_json next = one;
    next["id"] = id;
    next["action"] = id;
    all["entries"].push_back(std::move(next));
  }
  write(file, all.dump());
}

TEST(Stop, AnImportThatIsStoppedLeavesNoLearner) {
  const TemporaryFolder folder;
  write_long_export(folder / "long.json", 12'000);
  for (const int signal : {SIGINT, SIGTERM}) {
    RunningProgram import({"study", "import", folder / "long.json", "--learners", folder / "learners"});
    ASSERT_TRUE(
        becomes_true([&folder] { return std::filesystem::exists(folder / "learners/learner/learner.db"); }));
    import.signal(signal);
    EXPECT_EQ(import.wait().code, 128 + signal);
    EXPECT_FALSE(std::filesystem::exists(folder / "learners/learner"));
  }
  RunningProgram whole({"study", "import", folder / "long.json", "--learners", folder / "learners"});
  EXPECT_EQ(whole.wait().code, 0);
}

TEST(Stop, AnExportThatIsStoppedLeavesTheOldOne) {
  const TemporaryFolder folder;
  write_long_export(folder / "long.json", 12'000);
  ASSERT_EQ(nazori_cli({"study", "import", folder / "long.json", "--learners", folder / "learners"}).code, 0);
  for (const std::string name : {"out.json", "out.csv"}) {
    write(folder / name, "the old one");
    const auto before = folder.names();
    RunningProgram export_({"study", "export", "--output", folder / name, "--learners", folder / "learners"});
    ASSERT_TRUE(becomes_true([&] { return folder.names().size() > before.size(); }));
    export_.signal(SIGTERM);
    EXPECT_EQ(export_.wait().code, 143);
    EXPECT_EQ(bytes_of(folder / name).size(), 11U);
    EXPECT_EQ(folder.names(), before);
  }
}

TEST(Stop, ARebuildThatIsStoppedLeavesTheLearnerAsItWas) {
  const TemporaryFolder folder;
  const std::string learners = folder / "learners";
  write_long_export(folder / "long.json", 12'000);
  ASSERT_EQ(nazori_cli({"study", "import", folder / "long.json", "--learners", learners}).code, 0);
  const std::string before =
      nazori_cli({"study", "next", "--json", "--now", "2026-01-01T09:00Z", "--learners", learners}).out;
  RunningProgram rebuild({"study", "rebuild", "--learners", learners});
  ASSERT_TRUE(becomes_true([&rebuild] { return rebuild.has_open("learner.db"); }));
  rebuild.signal(SIGINT);
  EXPECT_EQ(rebuild.wait().code, 130);
  EXPECT_EQ(nazori_cli({"study", "next", "--json", "--now", "2026-01-01T09:00Z", "--learners", learners}).out,
            before);
}

TEST(Stop, ALearnerInUseHasACodeOfItsOwn) {
  const TemporaryFolder learners;
  const OpenLearner open(learners.path().string());
  for (const std::vector<std::string>& verb :
       std::vector<std::vector<std::string>>{{"study", "review", "休"},
                                             {"study", "settings", "new_per_day=3"},
                                             {"study", "tag", "休", "--with", "a"}}) {
    std::vector<std::string> arguments = verb;
    arguments.insert(arguments.end(), {"--learners", learners.path().string()});
    expect_one_line(nazori_cli(arguments), 3, {"is open in another Nazori window"});
    arguments.insert(arguments.end(), {"--wait", "0.05"});
    expect_one_line(nazori_cli(arguments), 3, {"is open in another Nazori window"});
  }
}

TEST(Stop, WaitingForALearnerEndsWhenItIsFreeOrBySignal) {
  const TemporaryFolder learners;
  OpenLearner open(learners.path().string());
  const std::vector<std::string> review{
      "study", "review", "休", "--rating", "good", "--learners", learners.path().string(), "--wait", "3600"};
  {
    RunningProgram waiting(review);
    ASSERT_TRUE(becomes_true([&waiting] { return waiting.has_open("kanji.db"); }));
    waiting.signal(SIGTERM);
    const Outcome run = waiting.wait();
    EXPECT_EQ(run.code, 143);
    EXPECT_EQ(run.err, "");
  }
  RunningProgram waiting(review);
  ASSERT_TRUE(becomes_true([&waiting] { return waiting.has_open("kanji.db"); }));
  open.close();
  const Outcome run = waiting.wait();
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, testing::HasSubstr("休  good"));
}

}  // namespace
}  // namespace nazori::cli::test
