// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/byte_source.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>
#include <system_error>

#include "../../base/tests/failing_calls.h"
#include "../src/recording_output.h"
#include "../src/shared_ring.h"
#include "files_under_test.h"

namespace nazori::recording {
namespace {

using base::Errc;
using base::test::FailingCalls;

std::string reason(int error) { return std::generic_category().message(error); }

std::string all_of(ByteSource& source) {
  std::string all;
  std::array<char, 3> room{};
  for (auto count = source.read(room); count && *count > 0; count = source.read(room))
    all.append(room.data(), *count);
  return all;
}

TEST(ByteSource, OfAFileIsItsBytesAndItsLength) {
  const test::TemporaryFolder folder;
  test::write(folder / "a", "0123456789");
  const long open = base::test::open_descriptors();
  {
    const auto source = open_source(folder / "a");
    ASSERT_TRUE(source);
    EXPECT_EQ((*source)->size(), 10U);
    EXPECT_EQ((*source)->name(), (folder / "a").string());
    EXPECT_EQ(all_of(**source), "0123456789");
    EXPECT_EQ(base::test::open_descriptors(), open + 1);
  }
  EXPECT_EQ(base::test::open_descriptors(), open);
}

TEST(ByteSource, OfMemoryIsItsBytesAndItsLength) {
  const auto source = memory_source("0123456789", "some bytes");
  EXPECT_EQ(source->size(), 10U);
  EXPECT_EQ(source->name(), "some bytes");
  EXPECT_EQ(all_of(*source), "0123456789");
  EXPECT_EQ(all_of(*source), "") << "the end stays the end";
}

TEST(ByteSource, OfStandardInputStaysOpenAndHasNoLengthWhereItIsAPipe) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  ASSERT_EQ(::write(pipe[1], "piped", 5), 5);
  ::close(pipe[1]);
  const int before = ::dup(STDIN_FILENO);
  ASSERT_EQ(::dup2(pipe[0], STDIN_FILENO), STDIN_FILENO);
  ::close(pipe[0]);
  const long open = base::test::open_descriptors();
  {
    const auto source = open_source("-");
    ASSERT_TRUE(source);
    EXPECT_EQ((*source)->name(), "standard input");
    EXPECT_EQ((*source)->size(), 0U);
    EXPECT_EQ(all_of(**source), "piped");
  }
  EXPECT_EQ(base::test::open_descriptors(), open) << "it is not ours to close";
  ASSERT_EQ(::dup2(before, STDIN_FILENO), STDIN_FILENO);
  ::close(before);
}

TEST(ByteSource, WhatCannotBeReadSaysWhy) {
  const test::TemporaryFolder folder;
  test::write(folder / "a", "0123456789");
  const long open = base::test::open_descriptors();
  EXPECT_EQ(
      open_source(folder / "none").error(),
      (base::Error{Errc::not_found, "cannot be read: " + reason(ENOENT), (folder / "none").string(), ""}));
  EXPECT_EQ(open_source(folder / "a" / "b").error(),
            (base::Error{Errc::io, "cannot be read: " + reason(ENOTDIR), (folder / "a" / "b").string(), ""}));
  EXPECT_EQ(open_source(folder / ".").error().what, "is a folder, not a file");
  {
    const auto source = open_source(folder / "a");
    ASSERT_TRUE(source);
    std::array<char, 20> room{};
    {
      const FailingCalls calls({{"read", EIO}});
      EXPECT_EQ((*source)->read(room).error(),
                (base::Error{Errc::io, "cannot be read: " + reason(EIO), (folder / "a").string(), ""}));
    }
    FailingCalls calls;
    calls.interruptions = 3;
    EXPECT_EQ(all_of(**source), "0123456789") << "an interruption is no error";
  }
  {
    const FailingCalls calls({{"fstat", EIO}});
    const auto source = open_source(folder / "a");
    ASSERT_TRUE(source);
    EXPECT_EQ((*source)->size(), 0U) << "not known";
  }
  EXPECT_EQ(base::test::open_descriptors(), open);
}

TEST(ByteSourceDeathTest, FilesAreReadAndWrittenWhereTheProgramHasNoStandardInput) {
  const test::TemporaryFolder folder;
  // The first file that is opened has number 0 then.
  const auto without_input = [&folder] {
    (void)::close(STDIN_FILENO);
    const long open = base::test::open_descriptors();
    bool good = true;
    {
      auto output = RecordingOutput::create(folder / "a.nzr", Session{});
      good = output.has_value() && output->close(0, RecordingOutput::Ending::regular).has_value();
      good = good && RecordingOutput::reopen(folder / "a.nzr").has_value();
      good = good && RecordingOutput::is_complete(folder / "a.nzr");
      good = good && open_source(folder / "a.nzr").has_value();
      // An id that no other test process has.
      SessionId id{7, 7, 7};
      const pid_t process = ::getpid();
      std::memcpy(id.data() + 4, &process, sizeof process);
      if (const auto ring = SharedRing::create(id); !ring) good = false;
      const auto left = SharedRing::adopt(id);
      good = good && left;
      if (left) left->remove();
    }
    ::_exit(!good ? 1 : base::test::open_descriptors() != open ? 2 : 7);
  };
  EXPECT_EXIT(without_input(), testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace nazori::recording
