// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/unfinished_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "nazori/base/file.h"

namespace nazori::base {
namespace {

namespace fs = std::filesystem;

class UnfinishedFiles : public testing::Test {
 protected:
  UnfinishedFiles() {
    std::string pattern = (fs::temp_directory_path() / "nazori-unfinished-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~UnfinishedFiles() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path make(const std::string& name) const {
    std::ofstream(folder_ / name) << "half";
    return folder_ / name;
  }
  [[nodiscard]] long entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
};

TEST_F(UnfinishedFiles, AreGoneWithTheirObject) {
  { const UnfinishedFile file(make("a")); }
  EXPECT_EQ(entries(), 0);
}

TEST_F(UnfinishedFiles, StayOnceTheyAreFinished) {
  {
    UnfinishedFile file(make("a"));
    file.finish();
    file.finish();
  }
  EXPECT_EQ(entries(), 1);
}

TEST_F(UnfinishedFiles, BelongToTheObjectTheyWereMovedTo) {
  UnfinishedFile to;
  {
    UnfinishedFile from(make("a"));
    const UnfinishedFile between(std::move(from));
    EXPECT_EQ(entries(), 1);
  }
  EXPECT_EQ(entries(), 0);
  {
    UnfinishedFile from(make("b"));
    to = std::move(from);
  }
  EXPECT_EQ(entries(), 1);
  to.finish();
}

TEST_F(UnfinishedFiles, OfADatabaseTakeTheirJournalsAlong) {
  for (const char* suffix : {"-journal", "-wal", "-shm"}) (void)make(std::string("a") + suffix);
  { const UnfinishedFile file(make("a"), UnfinishedKind::database); }
  EXPECT_EQ(entries(), 0);
  (void)make("b-journal");
  { const UnfinishedFile file(make("b")); }
  EXPECT_EQ(entries(), 1) << "what lies beside another file is not touched";
}

TEST_F(UnfinishedFiles, ThatWereNotMadeAreNone) {
  const fs::path stays = make("a");
  {
    const auto none = UnfinishedFile::made_by([] { return fs::path(); });
  }
  {
    const auto made = UnfinishedFile::made_by([this] { return make("b"); });
  }
  EXPECT_EQ(entries(), 1);
  EXPECT_TRUE(fs::exists(stays));
}

using UnfinishedFilesDeathTest = UnfinishedFiles;

TEST_F(UnfinishedFilesDeathTest, AreRemovedBeforeAProgramEndsAtOnce) {
  ASSERT_TRUE(write_file(folder_ / "old", "old"));
  const auto end_at_once = [this] {
    auto file = OutputFile::create(folder_ / "old");
    (void)file->append("new");
    UnfinishedFile database(make("b.part"), UnfinishedKind::database);
    (void)make("b.part-journal");
    fs::create_directory(folder_ / "inner");
    UnfinishedFile inner(folder_ / "inner");
    UnfinishedFile within(make("inner/file"));
    UnfinishedFile whole(make("whole"));
    whole.finish();
    const auto lock = remove_unfinished_files();
    ::_exit(lock.owns_lock() ? 7 : 8);
  };
  EXPECT_EXIT(end_at_once(), testing::ExitedWithCode(7), "");
  EXPECT_EQ(entries(), 2);
  EXPECT_TRUE(fs::exists(folder_ / "whole"));
  const auto bytes = read_file(folder_ / "old", 100);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(std::string(bytes->begin(), bytes->end()), "old");
}

TEST_F(UnfinishedFilesDeathTest, ThatAreJustBeingMadeAreRemovedOnceTheyAreRegistered) {
  const auto end_while_making = [this] {
    auto making = making_files();
    std::atomic<bool> ends = false;
    std::thread ending([&ends] {
      ends = true;
      const auto lock = remove_unfinished_files();
      ::_exit(lock.owns_lock() ? 7 : 8);
    });
    while (!ends) std::this_thread::yield();
    for (int i = 0; i < 10'000; ++i) std::this_thread::yield();
    const UnfinishedFile late(make("late"));
    making.unlock();
    ending.join();
  };
  EXPECT_EXIT(end_while_making(), testing::ExitedWithCode(7), "");
  EXPECT_EQ(entries(), 0);
}

TEST_F(UnfinishedFilesDeathTest, CannotBeMadeAnyMoreOnceTheProgramEnds) {
  const auto end_at_once = [this] {
    const auto lock = remove_unfinished_files();
    std::thread([this] { (void)write_file(folder_ / "late", "text"); }).detach();
    // The other thread had time to run; it must still be waiting.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ::_exit(fs::exists(folder_ / "late") ? 8 : 7);
  };
  EXPECT_EXIT(end_at_once(), testing::ExitedWithCode(7), "");
  EXPECT_EQ(entries(), 0);
}

TEST_F(UnfinishedFilesDeathTest, EndTheProgramEvenWhereMakingOneHangs) {
  const auto end_at_once = [] {
    std::mutex busy;
    busy.lock();
    std::condition_variable_any begun;
    bool hangs = false;
    std::thread([&] {
      (void)UnfinishedFile::made_by([&]() -> fs::path {
        {
          const std::lock_guard lock(busy);
          hangs = true;
        }
        begun.notify_one();
        std::this_thread::sleep_for(std::chrono::hours(1));
        return {};
      });
    }).detach();
    begun.wait(busy, [&] { return hangs; });
    const auto lock = remove_unfinished_files();
    ::_exit(lock.owns_lock() ? 8 : 7);
  };
  EXPECT_EXIT(end_at_once(), testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace nazori::base
