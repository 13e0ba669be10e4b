// SPDX-License-Identifier: Apache-2.0
#include "link_thread.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include "link_exchange.h"

namespace nazori::devices {
namespace {

TEST(LinkThread, RunsNoHandlersOfSignalsThatEndTheProgram) {
  std::atomic<int> blocked{-1};
  LinkThread thread;
  ASSERT_TRUE(thread.start("arm", [&](const std::stop_token&) {
    sigset_t mask;
    pthread_sigmask(SIG_SETMASK, nullptr, &mask);
    blocked = sigismember(&mask, SIGTERM) == 1 && sigismember(&mask, SIGINT) == 1 ? 1 : 0;
  }));
  thread.stop();
  EXPECT_EQ(blocked, 1);
  sigset_t mask;
  pthread_sigmask(SIG_SETMASK, nullptr, &mask);
  EXPECT_EQ(sigismember(&mask, SIGTERM), 0) << "the thread that starts it still runs them";
}

TEST(LinkThread, RunsUntilItIsStoppedAndCanRunAgain) {
  LinkThread thread;
  EXPECT_FALSE(thread.is_running());
  thread.stop();
  std::atomic<int> runs{0};
  for (int i = 1; i <= 2; ++i) {
    ASSERT_TRUE(thread.start("arm", [&runs](const std::stop_token& stop) {
      while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++runs;
    }));
    EXPECT_TRUE(thread.is_running());
    thread.stop();
    EXPECT_FALSE(thread.is_running());
    EXPECT_EQ(runs, i);
  }
}

struct Pose {
  std::uint64_t number = 0;
  haptics::DeviceState state = haptics::DeviceState::running;
  haptics::DeviceTrouble trouble = haptics::DeviceTrouble::none;
  double delay_s = 0;
  std::chrono::steady_clock::time_point at;
};

struct Command {
  std::uint64_t answers = 0;
  double force_n = 0;
  std::chrono::steady_clock::time_point at;
};

TEST(LinkExchange, TheCommandForAPoseIsAwaitedAndOneForAnotherIsNoForce) {
  LinkExchange<Pose, Command> exchange;
  exchange.commands.back() = {7, 2.5, std::chrono::steady_clock::now()};
  exchange.commands.publish();
  EXPECT_EQ(exchange.await(7).force_n, 2.5);
  EXPECT_EQ(exchange.await(8).force_n, 0) << "the servo does not tick";
  std::jthread servo([&exchange] {
    exchange.commands.back() = {9, 1.5, std::chrono::steady_clock::now()};
    exchange.commands.publish();
  });
  while (exchange.await(9).answers != 9) continue;
  servo.join();
  exchange.reset();
  EXPECT_EQ(exchange.await(9).force_n, 0) << "it belongs to the run before";
}

}  // namespace
}  // namespace nazori::devices
