// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/executor.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace nazori::base {
namespace {

TEST(Inbox, RunsTasksInTheOrderInWhichTheyWerePosted) {
  Inbox inbox;
  std::vector<int> ran;
  for (int i = 0; i < 3; ++i) inbox.post([&ran, i] { ran.push_back(i); });
  EXPECT_TRUE(ran.empty());
  EXPECT_TRUE(inbox.run_one());
  EXPECT_EQ(ran, std::vector{0});
  EXPECT_TRUE(inbox.run_one());
  EXPECT_TRUE(inbox.run_one());
  EXPECT_EQ(ran, (std::vector{0, 1, 2}));
  EXPECT_FALSE(inbox.run_one());
}

TEST(Inbox, WakesItsOwnerOnceForEachTaskWhenTheTaskIsThere) {
  Inbox* there = nullptr;
  int woken = 0, ran = 0;
  Inbox inbox([&] {
    ++woken;
    EXPECT_TRUE(there->run_one());
  });
  there = &inbox;
  inbox.post([&] { ++ran; });
  inbox.post([&] { ++ran; });
  EXPECT_EQ(woken, 2);
  EXPECT_EQ(ran, 2);
}

TEST(Inbox, ATaskMayRunTheNextAsANestedEventLoopDoes) {
  Inbox inbox;
  std::vector<int> ran;
  inbox.post([&] {
    ran.push_back(1);
    EXPECT_TRUE(inbox.run_one());
    ran.push_back(3);
  });
  inbox.post([&] { ran.push_back(2); });
  EXPECT_TRUE(inbox.run_one());
  EXPECT_EQ(ran, (std::vector{1, 2, 3}));
}

TEST(Inbox, StopsAsSoonAsItIsEnoughAndLeavesTheOtherTasks) {
  Inbox inbox;
  int ran = 0;
  for (int i = 0; i < 5; ++i) inbox.post([&] { ++ran; });
  inbox.run_until([&] { return ran == 2; });
  EXPECT_EQ(ran, 2);
  EXPECT_TRUE(inbox.run_one());
}

TEST(Inbox, WhatItDropsAtItsEndMayPost) {
  bool has_posted = false;
  {
    Inbox inbox;
    const auto on_end = [&](const int* number) {
      delete number;
      inbox.post([] { FAIL() << "nobody runs it"; });
      has_posted = true;
    };
    inbox.post([held = std::shared_ptr<const int>(new int(1), on_end)] {});
  }
  EXPECT_TRUE(has_posted);
}

TEST(Executor, RunsTasksInOrderOnOneOtherThread) {
  Inbox inbox;
  std::vector<int> done;
  bool wrong_thread = false;
  const auto here = std::this_thread::get_id();
  bool finished = false;
  Executor executor("test");
  for (int i = 0; i < 1000; ++i) {
    executor.post([&, i] {
      done.push_back(i);
      wrong_thread = wrong_thread || std::this_thread::get_id() == here;
    });
  }
  executor.post([&] { inbox.post([&] { finished = true; }); });
  inbox.run_until([&] { return finished; });
  ASSERT_EQ(done.size(), 1000U);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(done[static_cast<std::size_t>(i)], i);
  EXPECT_FALSE(wrong_thread);
}

TEST(Executor, ItsThreadHasTheFirstFifteenBytesOfItsName) {
  Inbox inbox;
  std::string name(16, '\0');
  bool done = false;
  Executor executor("a name longer than fifteen bytes");
  executor.post([&] {
    (void)pthread_getname_np(pthread_self(), name.data(), name.size());
    inbox.post([&] { done = true; });
  });
  inbox.run_until([&] { return done; });
  EXPECT_STREQ(name.c_str(), "a name longer t");
}

TEST(Background, ItsAnswersRunInOrderOnTheOwnersThread) {
  Inbox inbox;
  Background background("test", inbox);
  const auto here = std::this_thread::get_id();
  std::vector<int> received;
  for (int i = 0; i < 1000; ++i) {
    background.post([&, i] {
      background.answer([&, i] {
        EXPECT_EQ(std::this_thread::get_id(), here);
        received.push_back(i);
      });
    });
  }
  inbox.run_until([&] { return received.size() == 1000; });
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(received[static_cast<std::size_t>(i)], i);
}

TEST(Background, ItsEndFinishesTheTaskThatRunsAndDropsTheRest) {
  Inbox inbox;
  std::atomic<bool> begun{false};
  std::atomic<int> finished{0};
  int received = 0;
  const auto held = std::make_shared<int>(1);
  {
    std::optional<Background> background(std::in_place, "test", inbox);
    background->post([&, held, &one = *background] {
      one.answer([&received, held] { ++received; });
      begun = true;
      // Runs until the end has begun: from then on nothing more is accepted.
      for (bool is_accepted = true; is_accepted; std::this_thread::yield()) {
        const auto probe = std::make_shared<int>(1);
        one.post([probe] {});
        is_accepted = probe.use_count() > 1;
      }
      ++finished;
    });
    for (int i = 0; i < 10; ++i) background->post([&finished, held] { ++finished; });
    while (!begun) std::this_thread::yield();
    background.reset();
  }
  EXPECT_EQ(finished, 1);
  while (inbox.run_one()) {
  }
  EXPECT_EQ(received, 0);
  EXPECT_EQ(held.use_count(), 1) << "what was dropped still holds something";
}

TEST(Background, AnAnswerMayEndIt) {
  Inbox inbox;
  auto background = std::make_unique<Background>("test", inbox);
  Background& one = *background;
  bool posted = false;
  one.post([&] {
    one.answer([&, text = std::string(1000, 'x')] {
      background.reset();
      EXPECT_EQ(text.size(), 1000U);
    });
    one.answer([] { FAIL() << "the object is gone"; });
    inbox.post([&] { posted = true; });
  });
  inbox.run_until([&] { return posted; });
  EXPECT_EQ(background, nullptr);
}

TEST(Background, OfTwoWithOneInboxTheEndOfOneLeavesTheOther) {
  Inbox inbox;
  auto first = std::make_unique<Background>("first", inbox);
  Background second("second", inbox);
  bool received = false;
  first->post([&one = *first] { one.answer([] { FAIL() << "it is gone"; }); });
  first.reset();
  second.post([&] { second.answer([&] { received = true; }); });
  inbox.run_until([&] { return received; });
}

TEST(Background, WhatATaskHeldGoesOnTheExecutorsThreadAndMayPostThen) {
  Inbox inbox;
  Background background("test", inbox);
  bool received = false;
  std::thread::id gone_on;
  const auto on_end = [&](const int* held) {
    delete held;
    gone_on = std::this_thread::get_id();
    background.post([&] { background.answer([&] { received = true; }); });
  };
  std::thread::id worked_on;
  background.post([&worked_on, held = std::shared_ptr<const int>(new int(1), on_end)] {
    worked_on = std::this_thread::get_id();
  });
  inbox.run_until([&] { return received; });
  EXPECT_EQ(gone_on, worked_on);
}

TEST(Background, ManyThreadsMayPost) {
  Inbox inbox;
  Background background("test", inbox);
  int sum = 0, received = 0;
  std::vector<std::jthread> posting;
  for (int t = 0; t < 4; ++t) {
    posting.emplace_back([&] {
      for (int i = 0; i < 500; ++i) {
        background.post([&] {
          ++sum;
          background.answer([&] { ++received; });
        });
      }
    });
  }
  inbox.run_until([&] { return received == 2000; });
  posting.clear();
  bool is_summed = false;
  background.post([&] { background.answer([&] { is_summed = sum == 2000; }); });
  inbox.run_until([&] { return is_summed; });
}

}  // namespace
}  // namespace nazori::base
