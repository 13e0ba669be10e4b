// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/worker.h"

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

/// A thread that can be woken, as that of a window.
class Owner {
 public:
  [[nodiscard]] Worker::Work wake() {
    return [this] {
      const std::lock_guard lock(mutex_);
      ++calls_;
      woken_.notify_all();
    };
  }
  /// Hears what it is woken for until `enough` says so.
  template <class Enough>
  void hear(Worker& worker, Enough enough) {
    while (!enough()) {
      {
        std::unique_lock lock(mutex_);
        woken_.wait(lock, [this] { return calls_ > 0; });
        --calls_;
      }
      worker.hear_one();
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable woken_;
  int calls_ = 0;
};

TEST(Worker, DoesWorkInOrderAndItsAnswersAreHeardInOrderByTheOwner) {
  Owner owner;
  Worker worker("a name longer than fifteen bytes", owner.wake());
  std::vector<int> done, heard;  // of the worker's thread, and of this one
  const auto here = std::this_thread::get_id();
  bool wrong_thread = false;
  for (int i = 0; i < 1000; ++i) {
    worker.post([&, i] {
      done.push_back(i);
      wrong_thread = wrong_thread || std::this_thread::get_id() == here;
      worker.answer(
          [&, i, text = std::string(100, 'x')] { heard.push_back(i + static_cast<int>(text.size()) - 100); });
    });
  }
  owner.hear(worker, [&] { return heard.size() == 1000; });
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(done[static_cast<std::size_t>(i)], i);
    ASSERT_EQ(heard[static_cast<std::size_t>(i)], i);
  }
  EXPECT_FALSE(wrong_thread);
}

TEST(Worker, ItsEndFinishesThePieceAtHandAndDropsTheRest) {
  Owner owner;
  std::atomic<bool> begun{false};
  std::atomic<int> finished{0};
  int heard = 0;
  const auto held = std::make_shared<int>(1);
  {
    std::optional<Worker> worker(std::in_place, "test", owner.wake());
    worker->post([&, held, &one = *worker] {
      one.answer([&heard, held] { ++heard; });
      begun = true;
      // Until its end has begun: from then on nothing more is taken.
      for (bool is_taken = true; is_taken; std::this_thread::yield()) {
        const auto probe = std::make_shared<int>(1);
        one.post([probe] {});
        is_taken = probe.use_count() > 1;
      }
      ++finished;
    });
    for (int i = 0; i < 10; ++i) worker->post([&finished, held] { ++finished; });
    while (!begun) std::this_thread::yield();
    worker.reset();
  }
  EXPECT_EQ(finished, 1);
  EXPECT_EQ(heard, 0);
  EXPECT_EQ(held.use_count(), 1) << "what was dropped still holds something";
}

TEST(Worker, AnAnswerMayEndTheWorker) {
  Owner owner;
  auto worker = std::make_unique<Worker>("test", owner.wake());
  Worker& one = *worker;
  one.post([&] {
    one.answer([&, text = std::string(1000, 'x')] {
      worker.reset();
      EXPECT_EQ(text.size(), 1000U);
    });
    one.answer([] { FAIL() << "it is gone"; });
  });
  owner.hear(one, [&] { return worker == nullptr; });
}

TEST(Worker, HearingNothingAndBeingWokenTooOftenDoNoHarm) {
  Owner owner;
  Worker worker("test", owner.wake());
  worker.hear_one();
  int heard = 0;
  worker.post([&] { worker.answer([&] { ++heard; }); });
  owner.hear(worker, [&] { return heard == 1; });
  worker.hear_one();
  EXPECT_EQ(heard, 1);
}

TEST(Worker, ItsThreadHasTheFirstFifteenBytesOfItsName) {
  Owner owner;
  Worker worker("a name longer than fifteen bytes", owner.wake());
  std::string name(16, '\0');
  bool heard = false;
  worker.post([&] {
    (void)pthread_getname_np(pthread_self(), name.data(), name.size());
    worker.answer([&] { heard = true; });
  });
  owner.hear(worker, [&] { return heard; });
  EXPECT_STREQ(name.c_str(), "a name longer t");
}

TEST(Worker, WhatAPieceOfWorkHeldGoesOnTheWorkersThreadAndMayPostThen) {
  Owner owner;
  Worker worker("test", owner.wake());
  bool heard = false;
  std::thread::id gone_on;
  const auto tell = [&](const int* held) {
    delete held;
    gone_on = std::this_thread::get_id();
    worker.post([&] { worker.answer([&] { heard = true; }); });
  };
  std::thread::id worked_on;
  worker.post([&worked_on, held = std::shared_ptr<const int>(new int(1), tell)] {
    worked_on = std::this_thread::get_id();
  });
  owner.hear(worker, [&] { return heard; });
  EXPECT_EQ(gone_on, worked_on);
}

TEST(Worker, ManyThreadsMayPost) {
  Owner owner;
  Worker worker("test", owner.wake());
  int sum = 0, heard = 0;
  std::vector<std::thread> posting;
  for (int t = 0; t < 4; ++t) {
    posting.emplace_back([&] {
      for (int i = 0; i < 500; ++i) {
        worker.post([&] {
          ++sum;
          worker.answer([&] { ++heard; });
        });
      }
    });
  }
  owner.hear(worker, [&] { return heard == 2000; });
  for (std::thread& thread : posting) thread.join();
  EXPECT_EQ(heard, 2000);
  worker.post([&] { worker.answer([&] { heard = sum; }); });
  owner.hear(worker, [&] { return heard == sum && heard == 2000; });
}

}  // namespace
}  // namespace nazori::base
