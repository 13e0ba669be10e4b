// SPDX-License-Identifier: Apache-2.0
#include "../src/recording_output.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "../../base/tests/failing_calls.h"
#include "files_under_test.h"
#include "some_samples.h"

namespace nazori::recording {
namespace {

using base::test::FailingCalls;
using Ending = RecordingOutput::Ending;
namespace fs = std::filesystem;

std::string refusal(int error) { return "cannot be written: " + std::generic_category().message(error); }

/// The bytes of a recording of these samples.
std::string bytes_of(const std::vector<haptics::ServoSample>& samples) {
  const auto header = encode_header(Session{});
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  for (const auto& sample : samples) encode_record(sample, bytes);
  return {bytes.begin(), bytes.end()};
}
std::string end_of(std::uint64_t samples, std::uint64_t lost, bool recovered) {
  std::vector<std::uint8_t> bytes;
  encode_end(samples, lost, recovered, bytes);
  return {bytes.begin(), bytes.end()};
}

std::unique_ptr<haptics::SampleRing> ring_of(const std::vector<haptics::ServoSample>& samples) {
  auto ring = std::make_unique<haptics::SampleRing>();
  for (const auto& sample : samples) ring->push(sample);
  return ring;
}

TEST(RecordingOutput, TakesWhatTheRingHoldsInItsOrder) {
  const test::TemporaryFolder folder;
  const auto samples = test::some_samples(5000);
  const auto ring = ring_of(samples);
  auto output = RecordingOutput::create(folder / "a.nzr", Session{});
  ASSERT_TRUE(output);
  EXPECT_EQ(output->path(), folder / "a.nzr");
  EXPECT_EQ(output->records(), 0U);
  ASSERT_TRUE(output->take(*ring));
  EXPECT_EQ(output->records(), 5000U);
  EXPECT_EQ(ring->taken.load(), 5000U);
  ASSERT_TRUE(output->take(*ring)) << "nothing is left";
  EXPECT_EQ(test::text_of(folder / "a.nzr"), bytes_of(samples));
  ASSERT_TRUE(output->close(7, Ending::regular));
  EXPECT_EQ(test::text_of(folder / "a.nzr"), bytes_of(samples) + end_of(5000, 7, false));
}

TEST(RecordingOutput, TakesFromARingThatHasGoneRound) {
  const test::TemporaryFolder folder;
  const auto samples = test::some_samples(haptics::SampleRing::kCapacity + 100);
  auto ring = std::make_unique<haptics::SampleRing>();
  auto output = RecordingOutput::create(folder / "a.nzr", Session{});
  ASSERT_TRUE(output);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i == haptics::SampleRing::kCapacity - 50) {
      ASSERT_TRUE(output->take(*ring));
    }
    ring->push(samples[i]);
  }
  ASSERT_TRUE(output->take(*ring));
  EXPECT_EQ(test::text_of(folder / "a.nzr"), bytes_of(samples));
}

TEST(RecordingOutput, GoesOnAfterTheLastWholeRecord) {
  const test::TemporaryFolder folder;
  const auto samples = test::some_samples(3);
  const std::string whole = bytes_of(samples);
  const fs::path path = folder / "a.nzr";
  // Cut off within the second and the third record, at a record's end, at the header's end.
  for (const std::size_t length : {kHeaderBytes + kRecordBytes + 1, kHeaderBytes + 3 * kRecordBytes - 1,
                                   kHeaderBytes + 2 * kRecordBytes, kHeaderBytes, kHeaderBytes + 1}) {
    test::write(path, whole.substr(0, length));
    const std::size_t records = (length - kHeaderBytes) / kRecordBytes;
    auto output = RecordingOutput::reopen(path);
    ASSERT_TRUE(output);
    EXPECT_EQ(output->records(), records) << length;
    EXPECT_EQ(fs::file_size(path), kHeaderBytes + records * kRecordBytes);
    RecordingOutput moved(std::move(*output));
    ASSERT_TRUE(
        moved.take(*ring_of({samples.begin() + static_cast<std::ptrdiff_t>(records), samples.end()})));
    EXPECT_EQ(moved.records(), 3U);
    EXPECT_EQ(test::text_of(path), whole);
    ASSERT_TRUE(moved.close(0, Ending::recovered));
    EXPECT_EQ(test::text_of(path), whole + end_of(3, 0, true));
  }
}

TEST(RecordingOutput, IsCompleteOnlyWithItsEndWhole) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / "a.nzr";
  const auto complete = [&path](const std::string& bytes) {
    test::write(path, bytes);
    return RecordingOutput::is_complete(path);
  };
  const std::string part = bytes_of(test::some_samples(2));
  EXPECT_TRUE(complete(part + end_of(2, 0, false)));
  EXPECT_TRUE(complete(part + end_of(2, 0, true)));
  EXPECT_TRUE(complete(bytes_of({}) + end_of(0, 0, false))) << "without any tick";
  EXPECT_FALSE(complete(part));
  EXPECT_FALSE(complete(part + end_of(2, 0, false).substr(0, kRecordBytes - 1)));
  EXPECT_FALSE(complete(part + end_of(2, 0, false) + part.substr(kHeaderBytes, kRecordBytes)));
  EXPECT_FALSE(complete(bytes_of({})));
  EXPECT_FALSE(complete(bytes_of({}).substr(1) + end_of(0, 0, false)));
  EXPECT_FALSE(complete("short"));
  EXPECT_FALSE(complete(""));
  std::string damaged = part + end_of(2, 0, false);
  damaged.back() ^= 1;
  EXPECT_FALSE(complete(damaged));
  const long open = base::test::open_descriptors();
  EXPECT_FALSE(RecordingOutput::is_complete(folder / "none"));
  EXPECT_FALSE(RecordingOutput::is_complete(path));
  EXPECT_EQ(base::test::open_descriptors(), open);
}

TEST(RecordingOutput, GoesOnAfterInterruptionsAndShortWrites) {
  const test::TemporaryFolder folder;
  const auto samples = test::some_samples(5);
  FailingCalls calls;
  calls.interruptions = 3;
  calls.most_bytes = 100;
  auto output = RecordingOutput::create(folder / "a.nzr", Session{});
  ASSERT_TRUE(output);
  calls.interruptions = 3;
  calls.empty_writes = 2;
  ASSERT_TRUE(output->take(*ring_of(samples)));
  EXPECT_EQ(output->records(), 5U);
  output->flush();
  EXPECT_EQ(calls.flushes, 1);
  ASSERT_TRUE(output->close(0, Ending::regular));
  EXPECT_EQ(test::text_of(folder / "a.nzr"), bytes_of(samples) + end_of(5, 0, false));
}

TEST(RecordingOutput, ThatTheSystemRefusesSaysWhy) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / "a.nzr";
  const base::Error full{base::Errc::io, refusal(ENOSPC), path.string(), ""};
  const long open = base::test::open_descriptors();
  {
    const FailingCalls calls({{"write", ENOSPC}});
    EXPECT_EQ(RecordingOutput::create(path, Session{}).error(), full);
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_EQ(RecordingOutput::reopen(path).error(),
            (base::Error{base::Errc::io, refusal(ENOENT), path.string(), ""}));
  for (const char* call : {"fstat", "ftruncate", "lseek"}) {
    test::write(path, bytes_of({}));
    const FailingCalls calls({{call, ENOSPC}});
    EXPECT_EQ(RecordingOutput::reopen(path).error(), full) << call;
  }
  for (const char* call : {"write", "fsync", "close"}) {
    auto output = RecordingOutput::create(path, Session{});
    ASSERT_TRUE(output);
    const FailingCalls calls({{call, ENOSPC}});
    const auto closed = output->close(0, Ending::regular);
    ASSERT_FALSE(closed) << call;
    EXPECT_EQ(closed.error(), full) << call;
  }
  {
    auto output = RecordingOutput::create(path, Session{});
    ASSERT_TRUE(output);
    const FailingCalls calls({{"fsync", ENOSPC}, {"close", EIO}});
    EXPECT_EQ(output->close(0, Ending::regular).error(), full) << "the first refusal is told";
  }
  EXPECT_EQ(base::test::open_descriptors(), open);
}

}  // namespace
}  // namespace nazori::recording
