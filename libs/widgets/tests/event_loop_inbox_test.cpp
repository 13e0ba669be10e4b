// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/events/event_loop_inbox.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTest>
#include <memory>
#include <thread>
#include <vector>

namespace nazori::ui {
namespace {

TEST(EventLoopInbox, TasksOfOtherThreadsRunInOrderOnTheThreadThatMadeIt) {
  EventLoopInbox loop;
  std::vector<int> ran;
  bool is_wrong_thread = false;
  const auto here = std::this_thread::get_id();
  std::jthread other([&] {
    for (int i = 0; i < 200; ++i)
      loop.inbox().post([&, i] {
        ran.push_back(i);
        is_wrong_thread = is_wrong_thread || std::this_thread::get_id() != here;
      });
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return ran.size() == 200; }, 60'000));
  for (int i = 0; i < 200; ++i) EXPECT_EQ(ran[static_cast<std::size_t>(i)], i);
  EXPECT_FALSE(is_wrong_thread);
}

TEST(EventLoopInbox, TasksAlsoRunWhileAnotherOneWaitsForThemAsADialogDoes) {
  EventLoopInbox loop;
  bool second = false, done = false;
  loop.inbox().post([&] { done = QTest::qWaitFor([&] { return second; }, 60'000); });
  loop.inbox().post([&] { second = true; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return done; }, 60'000));
}

TEST(EventLoopInbox, ATaskMayEndTheInboxAndNothingRunsAfterwards) {
  auto loop = std::make_unique<EventLoopInbox>();
  bool after = false;
  loop->inbox().post([&] { loop.reset(); });
  loop->inbox().post([&] { after = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return loop == nullptr; }, 60'000));
  for (int i = 0; i < 20; ++i) QCoreApplication::processEvents();
  EXPECT_FALSE(after);
}

}  // namespace
}  // namespace nazori::ui
