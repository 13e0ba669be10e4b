// SPDX-License-Identifier: Apache-2.0
// The ring in shared memory, and what recover() makes of it.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "../../base/tests/failing_calls.h"
#include "../src/recording_output.h"
#include "../src/shared_ring.h"
#include "files_under_test.h"
#include "nazori/recording/session_recorder.h"
#include "some_samples.h"

namespace nazori::recording {
namespace {

using base::Errc;
using base::test::FailingCalls;
using haptics::SampleRing;
namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

/// An id that no other test process has.
SessionId some_id(std::uint8_t number) {
  SessionId id{};
  const auto process = static_cast<std::uint32_t>(::getpid());
  for (std::size_t i = 0; i < 4; ++i) id[i] = static_cast<std::uint8_t>(process >> (8 * i));
  id[15] = number;
  return id;
}

TEST(SharedRing, BelongsToOneUntilItIsLetGo) {
  const SessionId id = some_id(1);
  const long open = base::test::open_descriptors();
  {
    const auto made = SharedRing::create(id);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->ring().pushed.load(), 0U);
    made->ring().push(test::some_samples(3)[2]);
    const auto twice = SharedRing::create(id);
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().code, Errc::io);
    EXPECT_EQ(twice.error().what, "no shared memory: " + reason(EEXIST));
    EXPECT_EQ(SharedRing::adopt(id).error().code, Errc::device) << "it is being recorded into";
    EXPECT_EQ(base::test::open_descriptors(), open + 1);
    struct stat status {};
    ASSERT_EQ(::stat(("/dev/shm" + twice.error().where).c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0600U) << "nobody else reads it";
  }
  EXPECT_EQ(base::test::open_descriptors(), open);
  {
    auto left = SharedRing::adopt(id);
    ASSERT_TRUE(left);
    const SharedRing moved(std::move(*left));
    EXPECT_EQ(moved.ring().pushed.load(), 1U);
    EXPECT_TRUE(test::same(moved.ring().slots[0], test::some_samples(3)[2]));
    moved.remove();
  }
  EXPECT_EQ(base::test::open_descriptors(), open);
  EXPECT_EQ(SharedRing::adopt(id).error().code, Errc::not_found);
}

TEST(SharedRing, ThatCannotBeMadeLeavesNothing) {
  const SessionId id = some_id(2);
  const long open = base::test::open_descriptors();
  for (const char* call : {"flock", "posix_fallocate"}) {
    const FailingCalls calls({{call, ENOSPC}});
    const auto made = SharedRing::create(id);
    ASSERT_FALSE(made) << call;
    EXPECT_EQ(made.error().code, Errc::io);
    EXPECT_EQ(made.error().what, "no shared memory to record into: " + reason(ENOSPC));
    // Whole mebibytes, rounded up.
    const std::string mebibytes = std::to_string((sizeof(SampleRing) + 4096) / (1U << 20U) + 1);
    EXPECT_EQ(made.error().remedy, mebibytes + " MiB are needed");
  }
  EXPECT_EQ(SharedRing::adopt(id).error().code, Errc::not_found);
  EXPECT_EQ(base::test::open_descriptors(), open);
}

TEST(SharedRing, ThatIsNotOneOfOursIsRefused) {
  const SessionId id = some_id(3);
  std::string name;
  {
    const auto made = SharedRing::create(id);
    ASSERT_TRUE(made);
    name = SharedRing::adopt(id).error().where;
  }
  const long open = base::test::open_descriptors();
  const int memory = ::shm_open(name.c_str(), O_RDWR | O_CLOEXEC, 0);
  ASSERT_GE(memory, 0);
  // The magic word, the layout, the size of a sample, the id.
  for (const off_t field : {0, 8, 12, 16, 31}) {
    char is = 0;
    ASSERT_EQ(::pread(memory, &is, 1, field), 1);
    const char other = static_cast<char>(is ^ 1);
    ASSERT_EQ(::pwrite(memory, &other, 1, field), 1);
    const auto adopted = SharedRing::adopt(id);
    ASSERT_FALSE(adopted) << field;
    EXPECT_EQ(
        adopted.error(),
        (base::Error{Errc::schema, "a ring was left behind by another version of the program", name, ""}));
    ASSERT_EQ(::pwrite(memory, &is, 1, field), 1);
  }
  EXPECT_TRUE(SharedRing::adopt(id));
  {
    const FailingCalls calls({{"fstat", EIO}});
    EXPECT_EQ(SharedRing::adopt(id).error().code, Errc::schema);
  }
  struct stat status {};
  ASSERT_EQ(::fstat(memory, &status), 0);
  for (const off_t more : {-1, 1}) {
    ASSERT_EQ(::ftruncate(memory, status.st_size + more), 0);
    EXPECT_EQ(SharedRing::adopt(id).error().what, "a ring was left behind that this program did not make");
  }
  ::close(memory);
  EXPECT_EQ(base::test::open_descriptors(), open);
  ::shm_unlink(name.c_str());
}

/// A recording whose program has crashed: a file with some of the records, and its ring.
class Recover : public testing::Test {
 protected:
  /// Pushes all samples. The ring marks `taken` of them as stored; the file contains `written` of them.
  void die(const std::vector<haptics::ServoSample>& samples, std::uint64_t taken, std::size_t written,
           bool closed = false) {
    session_.id = some_id(4);
    const auto shared = SharedRing::create(session_.id);
    ASSERT_TRUE(shared);
    auto output = RecordingOutput::create(path_, session_);
    ASSERT_TRUE(output);
    for (const auto& sample : samples) {
      if (shared->ring().pushed - shared->ring().taken == SampleRing::kCapacity) {
        ASSERT_TRUE(output->take(shared->ring()));
      }
      shared->ring().push(sample);
    }
    ASSERT_TRUE(output->take(shared->ring()));
    shared->ring().taken = taken;
    shared->ring().lost = 5;
    if (closed) {
      ASSERT_TRUE(output->close(5, RecordingOutput::Ending::regular));
    } else {
      fs::resize_file(path_, kHeaderBytes + written * kRecordBytes);
    }
  }
  [[nodiscard]] std::vector<std::uint64_t> ticks() {
    auto reader = RecordingReader::open(path_);
    EXPECT_TRUE(reader);
    std::vector<haptics::ServoSample> samples(100'000);
    samples.resize(reader->read(samples).value());
    std::vector<std::uint64_t> out;
    for (const auto& sample : samples) out.push_back(sample.tick);
    end_ = reader->end();
    return out;
  }
  [[nodiscard]] static std::vector<std::uint64_t> from_to(std::uint64_t from, std::uint64_t to) {
    std::vector<std::uint64_t> out;
    for (std::uint64_t i = from; i < to; ++i) out.push_back(i);
    return out;
  }

  test::TemporaryFolder folder_;
  fs::path path_ = folder_ / "a.nzr";
  Session session_;
  RecordingEnd end_;
};

TEST_F(Recover, BringsInWhatIsNotInTheFile) {
  // Neither the file nor the ring need be right about how far the writer was; the farther one is.
  const std::pair<std::uint64_t, std::size_t> stands[] = {{100, 100}, {100, 150}, {0, 0}, {200, 200}};
  for (const auto& [taken, written] : stands) {
    die(test::some_samples(200), taken, written);
    EXPECT_EQ(recover(path_).value(), Recovery::recovered);
    EXPECT_EQ(ticks(), from_to(0, 200)) << taken << " " << written;
    EXPECT_TRUE(end_.finished);
    EXPECT_TRUE(end_.recovered);
    EXPECT_EQ(end_.lost, 5U);
    EXPECT_EQ(SharedRing::adopt(session_.id).error().code, Errc::not_found) << "the memory is free again";
    EXPECT_EQ(recover(path_).value(), Recovery::not_needed);
  }
}

TEST_F(Recover, OfAFileThatLostRecordsBringsInWhatTheRingStillHas) {
  die(test::some_samples(SampleRing::kCapacity + 300), 0, 10);
  EXPECT_EQ(recover(path_).value(), Recovery::recovered);
  auto expected = from_to(0, 10);
  const auto rest = from_to(300, SampleRing::kCapacity + 300);
  expected.insert(expected.end(), rest.begin(), rest.end());
  EXPECT_EQ(ticks(), expected) << "300 were overwritten in the ring";
}

TEST_F(Recover, OfAFileWithMoreRecordsThanTheRingKnowsAddsNone) {
  die(test::some_samples(20), 20, 20);
  {
    auto output = RecordingOutput::reopen(path_);
    auto ring = std::make_unique<SampleRing>();
    ring->push(test::some_samples(1)[0]);
    ASSERT_TRUE(output->take(*ring));
  }
  EXPECT_EQ(recover(path_).value(), Recovery::recovered);
  EXPECT_EQ(ticks().size(), 21U);
}

TEST_F(Recover, OfACompleteFileOnlyFreesTheMemory) {
  die(test::some_samples(20), 20, 20, true);
  const std::string before = test::text_of(path_);
  EXPECT_EQ(recover(path_).value(), Recovery::not_needed);
  EXPECT_EQ(test::text_of(path_), before);
  EXPECT_EQ(SharedRing::adopt(session_.id).error().code, Errc::not_found);
}

TEST_F(Recover, ThatIsRefusedKeepsTheMemoryForAnotherTry) {
  for (const char* call : {"ftruncate", "write", "fsync"}) {
    die(test::some_samples(20), 0, 10);
    {
      const FailingCalls calls({{call, ENOSPC}});
      const auto recovered = recover(path_);
      ASSERT_FALSE(recovered) << call;
      EXPECT_EQ(recovered.error().code, Errc::io);
      EXPECT_EQ(recovered.error().what, "cannot be written: " + reason(ENOSPC));
    }
    // With its end written but not flushed the file is complete, which frees the memory.
    EXPECT_TRUE(recover(path_));
    EXPECT_EQ(ticks(), from_to(0, 20));
  }
}

TEST_F(Recover, OfWhatIsNoRecordingIsRefused) {
  EXPECT_EQ(recover(path_).error().code, Errc::not_found);
  test::write(path_, "t,x,y,z\n");
  EXPECT_EQ(recover(path_).error().code, Errc::schema);
}

}  // namespace
}  // namespace nazori::recording
