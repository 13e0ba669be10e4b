// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/worker.h"

#include <pthread.h>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace nazori::base {

struct Worker::Inside {
  void run();

  std::mutex mutex;
  std::condition_variable posted;
  std::deque<Work> tasks, answers;
  bool ends = false;
  Work wake;
  std::thread thread;
};

void Worker::Inside::run() {
  std::unique_lock lock(mutex);
  for (;;) {
    posted.wait(lock, [this] { return ends || !tasks.empty(); });
    if (ends) return;
    Work work = std::move(tasks.front());
    tasks.pop_front();
    lock.unlock();
    work();
    work = nullptr;  // what it holds may be large, and goes on the thread that used it
    lock.lock();
  }
}

Worker::Worker(const std::string& name, Work wake) : inside_(std::make_shared<Inside>()) {
  Inside& in = *inside_;
  in.wake = std::move(wake);
  in.thread = std::thread([&in] { in.run(); });
  pthread_setname_np(in.thread.native_handle(), name.substr(0, 15).c_str());
}

Worker::~Worker() {
  Inside& in = *inside_;
  std::deque<Work> dropped;
  {
    const std::lock_guard lock(in.mutex);
    in.ends = true;
    dropped.swap(in.tasks);
  }
  in.posted.notify_one();
  in.thread.join();
  // Nobody adds to them any more. What they hold may itself post or answer while it goes.
  std::deque<Work> unheard;
  {
    const std::lock_guard lock(in.mutex);
    unheard.swap(in.answers);
  }
}

void Worker::post(Work work) {
  Inside& in = *inside_;
  {
    const std::lock_guard lock(in.mutex);
    if (in.ends) return;
    in.tasks.push_back(std::move(work));
  }
  in.posted.notify_one();
}

void Worker::answer(Work work) {
  Inside& in = *inside_;
  {
    const std::lock_guard lock(in.mutex);
    in.answers.push_back(std::move(work));
  }
  in.wake();
}

void Worker::hear_one() {
  Work work;
  {
    const std::lock_guard lock(inside_->mutex);
    if (inside_->answers.empty()) return;
    work = std::move(inside_->answers.front());
    inside_->answers.pop_front();
  }
  work();
}

}  // namespace nazori::base
