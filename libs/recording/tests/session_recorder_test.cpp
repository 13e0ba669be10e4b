// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/session_recorder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "../src/recording_output.h"
#include "../src/shared_ring.h"
#include "files_under_test.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/haptics/sample_ring.h"
#include "sessions.h"
#include "some_samples.h"

namespace nazori::recording {
namespace {

using haptics::DeviceSample;
using haptics::ServoSample;
using testing::HasSubstr;
namespace fs = std::filesystem;

using test::hand_at;
using test::Read;
using test::read;
using test::session_of;

TEST(SessionRecorder, RecordsEveryTickFromStartToFinish) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  std::vector<ServoSample> seen;
  for (int i = 0; i < 10; ++i) (void)servo.tick(hand_at(i));  // before the recording
  auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
  ASSERT_TRUE(recorder) << base::to_line(recorder.error());
  for (int i = 10; i < 100'010; ++i) {
    (void)servo.tick(hand_at(i));
    seen.push_back(servo.latest());
    (*recorder)->wait_for_room();
  }
  const auto ended = (*recorder)->finish();
  ASSERT_TRUE(ended) << base::to_line(ended.error());
  EXPECT_EQ(ended->samples, seen.size());
  EXPECT_EQ(ended->written, seen.size());
  EXPECT_EQ(ended->lost, 0U);
  for (int i = 0; i < 10; ++i) (void)servo.tick(hand_at(200'000 + i));  // after it

  const Read got = read(folder / "a.nzr");
  ASSERT_EQ(got.samples.size(), seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) ASSERT_TRUE(test::same(got.samples[i], seen[i])) << i;
  EXPECT_TRUE(got.end.finished);
  EXPECT_EQ(got.end.lost, 0U);
}

TEST(SessionRecorder, CountsWhatItLosesWhereNobodyWaits) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  auto ring = std::make_unique<haptics::SampleRing>();
  servo.set_recording(ring.get());
  constexpr int kTicks = static_cast<int>(haptics::SampleRing::kCapacity) + 1000;
  for (int i = 0; i < kTicks; ++i) (void)servo.tick(hand_at(i));
  servo.set_recording(nullptr);
  EXPECT_EQ(ring->pushed.load(), haptics::SampleRing::kCapacity);
  EXPECT_EQ(ring->lost.load(), 1000U);
}

TEST(SessionRecorder, RecordsALiveServoAndLetsGoOfItWhileItRuns) {
  const test::TemporaryFolder folder;
  devices::SimulatedDevice device;
  haptics::Servo servo(device.describe());
  ASSERT_TRUE(device.start(servo));
  for (int round = 0; round < 5; ++round) {
    auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of(device.describe()));
    ASSERT_TRUE(recorder) << base::to_line(recorder.error());
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    const auto ended = (*recorder)->finish();
    ASSERT_TRUE(ended);
    const Read got = read(folder / "a.nzr");
    ASSERT_GT(got.samples.size(), 0U);
    EXPECT_EQ(got.samples.size(), ended->samples);
    for (std::size_t i = 1; i < got.samples.size(); ++i)
      ASSERT_EQ(got.samples[i].tick, got.samples[i - 1].tick + 1);
  }
  device.stop();
}

TEST(SessionRecorder, WritesCsvWhereTheNameAsksForIt) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  auto recorder = SessionRecorder::start(servo, folder / "a.csv", session_of({}));
  ASSERT_TRUE(recorder);
  for (int i = 0; i < 5; ++i) (void)servo.tick(hand_at(i));
  ASSERT_TRUE((*recorder)->finish());
  const std::string text = test::text_of(folder / "a.csv");
  EXPECT_TRUE(text.starts_with("t,x,y,z,proxy_x")) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6);
  EXPECT_FALSE(fs::exists(folder / "a.csv.nzr"));
}

TEST(SessionRecorder, RefusesOtherExtensionsAndFoldersThatAreNotThere) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  EXPECT_EQ(SessionRecorder::start(servo, folder / "a.txt", {}).error().code, base::Errc::bad_argument);
  EXPECT_EQ(SessionRecorder::start(servo, folder / "none" / "a.nzr", {}).error().code, base::Errc::io);
}

TEST(SessionRecorder, WhileItRunsTheFileSaysSo) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
  ASSERT_TRUE(recorder);
  (void)servo.tick(hand_at(0));
  EXPECT_EQ(recover(folder / "a.nzr").value(), Recovery::in_progress);
  ASSERT_TRUE((*recorder)->finish());
  EXPECT_EQ(recover(folder / "a.nzr").value(), Recovery::not_needed);
}

TEST(SessionRecorder, ABrokenOffFileWithoutItsMemoryStaysAsItIs) {
  const test::TemporaryFolder folder;
  haptics::Servo servo({});
  auto recorder = SessionRecorder::start(servo, folder / "a.nzr", session_of({}));
  for (int i = 0; i < 5; ++i) (void)servo.tick(hand_at(i));
  ASSERT_TRUE((*recorder)->finish());
  const std::string whole = test::text_of(folder / "a.nzr");
  const std::string part = whole.substr(0, kHeaderBytes + 3 * kRecordBytes + 50);
  test::write(folder / "b.nzr", part);
  EXPECT_EQ(recover(folder / "b.nzr").value(), Recovery::nothing_left);
  EXPECT_EQ(test::text_of(folder / "b.nzr"), part);
}

/// Data from a process that will be killed, in memory that outlives it.
struct Witness {
  static constexpr std::uint64_t kMost = 60'000;
  std::atomic<std::uint64_t> ticks{0};
  std::array<ServoSample, kMost> samples;
};

/// A servo that is watched from another process: each sample is put down as soon as its tick has ended.
class WatchedServo final : public haptics::ServoCallback {
 public:
  WatchedServo(haptics::Servo& servo, Witness& witness) : servo_(servo), witness_(witness) {}
  haptics::Vec3 tick(const DeviceSample& sample) noexcept override {
    const haptics::Vec3 force = servo_.tick(sample);
    const std::uint64_t n = witness_.ticks.load(std::memory_order_relaxed);
    if (n < Witness::kMost) witness_.samples[n] = servo_.latest();
    witness_.ticks.store(n + 1, std::memory_order_release);
    return force;
  }
  [[nodiscard]] std::uint16_t events() const noexcept override { return servo_.events(); }

 private:
  haptics::Servo& servo_;
  Witness& witness_;
};

class Crash : public testing::Test {
 protected:
  void SetUp() override {
    void* memory =
        ::mmap(nullptr, sizeof(Witness), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    witness_ = new (memory) Witness;
  }
  void TearDown() override { ::munmap(witness_, sizeof(Witness)); }

  /// Records at the simulated device in a process of its own, in real time, until it is killed.
  pid_t record_live(const fs::path& path) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    devices::SimulatedDevice device;
    haptics::Servo servo(device.describe());
    WatchedServo watched(servo, *witness_);
    auto recorder = SessionRecorder::start(servo, path, session_of(device.describe()));
    if (!recorder || !device.start(watched)) ::_exit(1);
    for (int i = 0;; ++i) {
      device.set_target({0.01 * std::sin(0.1 * i), 0, 0.005});
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  /// Records stepped ticks in a process that then dies by `signal`.
  void record_and_die(const fs::path& path, int ticks, int signal) {
    const pid_t child = ::fork();
    if (child == 0) {
      haptics::Servo servo({});
      WatchedServo watched(servo, *witness_);
      auto recorder = SessionRecorder::start(servo, path, session_of({}));
      if (!recorder) ::_exit(1);
      for (int i = 0; i < ticks; ++i) (void)watched.tick(hand_at(i));
      (void)std::signal(signal, SIG_DFL);
      (void)::kill(::getpid(), signal);
      ::_exit(1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(WTERMSIG(status), signal);
  }

  /// Every tick that ended is there, in order, and at most the one that was under way besides.
  void expect_complete(const fs::path& path) {
    const std::uint64_t ticks = witness_->ticks.load(std::memory_order_acquire);
    const Read got = read(path);
    EXPECT_TRUE(got.end.finished);
    EXPECT_TRUE(got.end.recovered);
    EXPECT_EQ(got.end.lost, 0U);
    EXPECT_EQ(got.end.damaged, 0U);
    ASSERT_GE(got.samples.size(), ticks);
    ASSERT_LE(got.samples.size(), ticks + 1);
    for (std::size_t i = 0; i < got.samples.size(); ++i) {
      ASSERT_EQ(got.samples[i].tick, i);
      if (i < ticks) {
        ASSERT_TRUE(test::same(got.samples[i], witness_->samples[i])) << i;
      }
    }
  }

  test::TemporaryFolder folder_;
  Witness* witness_ = nullptr;
};

TEST_F(Crash, AfterAKillInMidSessionEveryTickIsThereUpToTheLast) {
  for (const int milliseconds : {35, 111, 205}) {
    witness_->ticks = 0;
    const fs::path path = folder_ / "live.nzr";
    const pid_t child = record_live(path);
    ASSERT_GT(child, 0);
    while (witness_->ticks.load(std::memory_order_acquire) < static_cast<std::uint64_t>(milliseconds))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(recover(path).value(), Recovery::in_progress);
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(recover(path).value(), Recovery::recovered);
    expect_complete(path);
    EXPECT_EQ(recover(path).value(), Recovery::not_needed);
  }
}

TEST_F(Crash, WhatTheWriterHadNotSeenYetIsBroughtInFromMemory) {
  for (const int signal : {SIGKILL, SIGSEGV, SIGABRT}) {
    witness_->ticks = 0;
    const fs::path path = folder_ / "stepped.nzr";
    record_and_die(path, 20'000, signal);
    ASSERT_EQ(recover(path).value(), Recovery::recovered);
    EXPECT_EQ(read(path).samples.size(), 20'000U);
    expect_complete(path);
  }
}

TEST_F(Crash, HalfARecordAtTheEndIsWrittenAgain) {
  const fs::path path = folder_ / "torn.nzr";
  record_and_die(path, 3000, SIGKILL);
  // As if the writer had died within a write.
  std::ofstream(path, std::ios::binary | std::ios::app) << "half a record";
  ASSERT_EQ(recover(path).value(), Recovery::recovered);
  expect_complete(path);
}

TEST_F(Crash, WhatIsInTheFileAlreadyIsNotWrittenTwice) {
  const fs::path path = folder_ / "unsaid.nzr";
  record_and_die(path, 3000, SIGKILL);
  {
    // As if the writer had died between writing the last 100 and saying so.
    auto shared = SharedRing::adopt(RecordingReader::open(path)->session().id);
    ASSERT_TRUE(shared);
    auto output = RecordingOutput::reopen(path);
    ASSERT_TRUE(output);
    ASSERT_TRUE(output->take(shared->ring()));
    ASSERT_EQ(shared->ring().taken.load(), 3000U);
    shared->ring().taken.store(2900);
  }
  ASSERT_EQ(recover(path).value(), Recovery::recovered);
  expect_complete(path);
}

TEST_F(Crash, MemoryOfAnotherVersionIsNotTakenForSamples) {
  const fs::path path = folder_ / "other.nzr";
  record_and_die(path, 300, SIGKILL);
  const auto id = RecordingReader::open(path)->session().id;
  std::string name;
  {
    // Held twice it is refused by its name.
    const auto held = SharedRing::adopt(id);
    ASSERT_TRUE(held);
    name = SharedRing::adopt(id).error().where;
  }
  const int memory = ::shm_open(name.c_str(), O_RDWR | O_CLOEXEC, 0);
  ASSERT_GE(memory, 0) << name;
  // The magic word, then the layout of the ring and the size of a sample.
  for (const off_t field : {8, 12}) {
    std::uint32_t is = 0;
    ASSERT_EQ(::pread(memory, &is, sizeof is, field), 4);
    const std::uint32_t other = is + 1;
    ASSERT_EQ(::pwrite(memory, &other, sizeof other, field), 4);
    const auto recovered = recover(path);
    ASSERT_FALSE(recovered) << field;
    EXPECT_EQ(recovered.error().code, base::Errc::schema);
    ASSERT_EQ(::pwrite(memory, &is, sizeof is, field), 4);
  }
  ::close(memory);
  ASSERT_EQ(recover(path).value(), Recovery::recovered);
}

TEST(RecordingOutput, ThatCannotGoOnEndsWithAWholeRecord) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / "full.nzr";
  const pid_t child = ::fork();
  if (child == 0) {
    // The file may grow by three and a half records.
    (void)std::signal(SIGXFSZ, SIG_IGN);
    auto output = RecordingOutput::create(path, session_of({}));
    const auto ring = std::make_unique<haptics::SampleRing>();
    for (const ServoSample& sample : test::some_samples(10)) ring->push(sample);
    const rlimit most{kHeaderBytes + 3 * kRecordBytes + kRecordBytes / 2, RLIM_INFINITY};
    if (!output || ::setrlimit(RLIMIT_FSIZE, &most) != 0) ::_exit(1);
    const auto done = output->take(*ring);
    ::_exit(done || done.error().code != base::Errc::io ? 2 : output->records() == 3 ? 0 : 3);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(fs::file_size(path), kHeaderBytes + 3 * kRecordBytes);
}

}  // namespace
}  // namespace nazori::recording
