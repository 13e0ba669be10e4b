// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/file_lock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "temporary_folder.h"

namespace nazori::base {
namespace {

using std::chrono::milliseconds;

TEST(FileLock, IsHeldByOneUntilItIsGone) {
  const nazori::test::TemporaryFolder folder;
  bool is_locked = true;
  {
    const auto first = FileLock::take(folder / "a.lock", is_locked);
    ASSERT_TRUE(first);
    EXPECT_FALSE(is_locked);
    const auto second = FileLock::take(folder / "a.lock", is_locked);
    ASSERT_FALSE(second);
    EXPECT_TRUE(is_locked);
    EXPECT_TRUE(FileLock::take(folder / "b.lock", is_locked));
    EXPECT_FALSE(is_locked);
  }
  EXPECT_TRUE(FileLock::take(folder / "a.lock", is_locked));
  is_locked = true;
  const auto nowhere = FileLock::take(folder / "none" / "a.lock", is_locked);
  ASSERT_FALSE(nowhere);
  EXPECT_FALSE(is_locked);
  EXPECT_EQ(nowhere.error().code, Errc::io);
  EXPECT_EQ(nowhere.error().where, (folder / "none").string());
}

TEST(FileLock, IsWaitedForUntilTheOtherGivesItBack) {
  const nazori::test::TemporaryFolder folder;
  bool is_locked = true;
  auto first = FileLock::take(folder / "a.lock", is_locked);
  ASSERT_TRUE(first);
  const auto refused = FileLock::wait(folder / "a.lock", milliseconds(0));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Errc::in_use);
  EXPECT_EQ(refused.error().where, folder.path().string());
  std::optional<Result<FileLock>> second;
  std::thread other([&] { second = FileLock::wait(folder / "a.lock", std::chrono::hours(1)); });
  { const FileLock gone = *std::move(first); }
  other.join();
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->has_value());
}

TEST(FileLock, IsNotWaitedForWhereItCannotBeTaken) {
  const nazori::test::TemporaryFolder folder;
  const auto nowhere = FileLock::wait(folder / "none" / "a.lock", std::chrono::hours(1));
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, Errc::io);
}

}  // namespace
}  // namespace nazori::base
