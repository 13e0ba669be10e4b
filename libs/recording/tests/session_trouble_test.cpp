// SPDX-License-Identifier: Apache-2.0
// How a session begins and ends, and what becomes of it where the system refuses.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

#include "../../base/tests/failing_calls.h"
#include "../src/shared_ring.h"
#include "files_under_test.h"
#include "nazori/haptics/sample_ring.h"
#include "nazori/recording/session_recorder.h"
#include "sessions.h"

namespace nazori::recording {
namespace {

namespace fs = std::filesystem;
using test::hand_at;
using test::Read;
using test::read;
using test::session_of;

TEST(SessionRecorder, SaysWhenItBeganAndHasAnIdentityOfItsOwn) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  const auto now_ns = [] {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
  };
  std::array<std::array<std::uint8_t, 16>, 2> ids{};
  for (auto& id : ids) {
    const auto before = now_ns();
    auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
    ASSERT_TRUE(recorder);
    EXPECT_EQ((*recorder)->raw_path(), folder / "a.nzr");
    ASSERT_TRUE((*recorder)->close());
    const auto reader = RecordingReader::open(folder / "a.nzr");
    ASSERT_TRUE(reader);
    EXPECT_GE(reader->session().start_ns, before);
    EXPECT_LE(reader->session().start_ns, now_ns());
    EXPECT_EQ(reader->session().character, "休");
    id = reader->session().id;
  }
  EXPECT_NE(ids[0], ids[1]);
}

/// The rings of this machine.
std::set<std::string> rings() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator("/dev/shm"))
    if (const std::string name = entry.path().filename(); name.starts_with("nazori-")) names.insert(name);
  return names;
}

TEST(SessionRecorder, ThatCannotBeginOrHasEndedLeavesNoMemoryBehind) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  // Other tests run in parallel: their rings are distinguished by the id of the session.
  const auto left = [](const std::array<std::uint8_t, 16>& id) {
    return SharedRing::adopt(id).has_value() || SharedRing::adopt(id).error().code != base::Errc::not_found;
  };
  {
    auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
    ASSERT_TRUE(recorder);
    const auto id = RecordingReader::open(folder / "a.nzr")->session().id;
    EXPECT_TRUE(left(id));
    ASSERT_TRUE((*recorder)->finish());
    EXPECT_FALSE(left(id));
    (void)servo.tick(hand_at(1));
    EXPECT_EQ((*recorder)->status().samples, 0U) << "the servo has let go of the ring";
    EXPECT_TRUE((*recorder)->finish()) << "once more is as good";
  }
  for (int attempt = 0; attempt < 20; ++attempt) {
    const auto before = rings();
    EXPECT_FALSE(SessionRecorder::start(servo, folder / "none" / "a.nzr", {}));
    if (rings() == before) return;
  }
  FAIL() << "a ring was left each time";
}

TEST(SessionRecorder, WithoutRandomNumbersThereIsNoSession) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  const base::test::FailingCalls calls({{"getrandom", ENOSYS}});
  const auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.error().what, "the system has no random numbers");
  EXPECT_FALSE(fs::exists(folder / "a.nzr"));
}

TEST(SessionRecorder, WithoutSharedMemoryThereIsNoSession) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  const base::test::FailingCalls calls({{"posix_fallocate", ENOSPC}});
  const auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.error().code, base::Errc::io);
  EXPECT_FALSE(fs::exists(folder / "a.nzr"));
}

TEST(SessionRecorder, ThatCannotWriteSaysSoAndKeepsWhatIsWhole) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
  ASSERT_TRUE(recorder);
  (void)servo.tick(hand_at(0));
  while ((*recorder)->status().written < 1) std::this_thread::yield();
  EXPECT_EQ((*recorder)->status().samples, 1U);
  EXPECT_EQ((*recorder)->status().error.what, "");
  {
    const base::test::FailingCalls calls({{"write", ENOSPC}});
    for (int i = 1; i < 25'000; ++i) (void)servo.tick(hand_at(i));
    while ((*recorder)->status().error.what.empty()) std::this_thread::yield();
    EXPECT_EQ((*recorder)->status().error.code, base::Errc::io);
    (*recorder)->wait_for_room();  // which will not come
  }
  const auto ended = (*recorder)->finish();
  ASSERT_FALSE(ended) << "the disk has room again, but ticks are missing";
  EXPECT_EQ(ended.error().where, (folder / "a.nzr").string());
  const Read got = read(folder / "a.nzr");
  EXPECT_EQ(got.samples.size(), 1U);
  EXPECT_FALSE(got.end.finished);
}

TEST(SessionRecorder, ThatCannotCloseItsFileSaysSo) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  auto recorder = SessionRecorder::start(servo, folder / "a.csv", session_of({}));
  ASSERT_TRUE(recorder);
  {
    const base::test::FailingCalls calls({{"fsync", EIO}});
    EXPECT_FALSE((*recorder)->finish());
  }
  EXPECT_FALSE((*recorder)->finish()) << "that stays so";
  EXPECT_FALSE(fs::exists(folder / "a.csv"));
  EXPECT_TRUE(fs::exists(folder / "a.csv.nzr"));
}

TEST(SessionRecorder, ACsvThatCannotBeWrittenKeepsTheRecording) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  fs::create_directories(folder / "a.csv");
  auto recorder = SessionRecorder::start(servo, folder / "a.csv", session_of({}));
  ASSERT_TRUE(recorder);
  EXPECT_EQ((*recorder)->raw_path(), folder / "a.csv.nzr");
  for (int i = 0; i < 5; ++i) (void)servo.tick(hand_at(i));
  const auto ended = (*recorder)->finish();
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().remedy, "the recording is kept as " + (folder / "a.csv.nzr").string());
  EXPECT_EQ((*recorder)->status().error, ended.error());
  EXPECT_EQ(read(folder / "a.csv.nzr").samples.size(), 5U);
}

TEST(SessionRecorder, AtItsEndItFinishesByItselfUnlessItWasClosed) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  {
    auto recorder = SessionRecorder::start(servo, folder / "a.csv", session_of({}));
    ASSERT_TRUE(recorder);
    (void)servo.tick(hand_at(0));
  }
  EXPECT_TRUE(fs::exists(folder / "a.csv"));
  EXPECT_FALSE(fs::exists(folder / "a.csv.nzr"));
  {
    auto recorder = SessionRecorder::start(servo, folder / "b.csv", session_of({}));
    ASSERT_TRUE(recorder);
    (void)servo.tick(hand_at(1));
    const auto closed = (*recorder)->close();
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->samples, 1U);
    EXPECT_EQ(closed->written, 1U);
  }
  EXPECT_FALSE(fs::exists(folder / "b.csv"));
  EXPECT_TRUE(read(folder / "b.csv.nzr").end.finished);
}

TEST(SessionRecorder, WaitsUntilHalfOfTheRingIsFree) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
  ASSERT_TRUE(recorder);
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < 16'384; ++i) (void)servo.tick(hand_at(i));
    (*recorder)->wait_for_room();
    const RecorderStatus status = (*recorder)->status();
    EXPECT_LE(status.samples - status.written, haptics::SampleRing::kCapacity / 2);
  }
  const auto ended = (*recorder)->finish();
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->lost, 0U);
}

}  // namespace
}  // namespace nazori::recording
