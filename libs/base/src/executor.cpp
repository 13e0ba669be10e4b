// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/executor.h"

#include <pthread.h>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace nazori::base {

struct Inbox::Inside {
  std::mutex mutex;
  std::condition_variable posted;
  std::deque<Task> tasks;
  Task wake;
};

Inbox::Inbox(Task wake) : inside_(std::make_unique<Inside>()) { inside_->wake = std::move(wake); }

Inbox::~Inbox() {
  // Destroyed without the lock: the destructor of what a task captured may post a task.
  std::deque<Task> dropped;
  const std::lock_guard lock(inside_->mutex);
  dropped.swap(inside_->tasks);
}

void Inbox::post(Task task) {
  {
    const std::lock_guard lock(inside_->mutex);
    inside_->tasks.push_back(std::move(task));
    inside_->posted.notify_one();
  }
  if (inside_->wake) inside_->wake();
}

bool Inbox::run_one() {
  Task task;
  {
    const std::lock_guard lock(inside_->mutex);
    if (inside_->tasks.empty()) return false;
    task = std::move(inside_->tasks.front());
    inside_->tasks.pop_front();
  }
  task();
  return true;
}

void Inbox::run_until(const std::function<bool()>& enough) {
  while (!enough()) {
    {
      std::unique_lock lock(inside_->mutex);
      inside_->posted.wait(lock, [this] { return !inside_->tasks.empty(); });
    }
    run_one();
  }
}

struct Executor::Inside {
  void run(const std::stop_token& stop);

  std::mutex mutex;
  std::condition_variable_any posted;
  std::deque<Task> tasks;
  bool ends = false;
  std::jthread thread;
};

void Executor::Inside::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  while (posted.wait(lock, stop, [this] { return !tasks.empty(); }) && !ends) {
    Task task = std::move(tasks.front());
    tasks.pop_front();
    lock.unlock();
    task();
    task = nullptr;  // what it captured may be large, and is freed on the thread that used it
    lock.lock();
  }
}

Executor::Executor(const std::string& name) : inside_(std::make_unique<Inside>()) {
  Inside& in = *inside_;
  in.thread = std::jthread([&in](const std::stop_token& stop) { in.run(stop); });
  pthread_setname_np(in.thread.native_handle(), name.substr(0, 15).c_str());
}

Executor::~Executor() {
  Inside& in = *inside_;
  std::deque<Task> dropped;
  {
    const std::lock_guard lock(in.mutex);
    in.ends = true;
    dropped.swap(in.tasks);
  }
  in.thread.request_stop();
  in.thread.join();
}

void Executor::post(Task task) {
  Inside& in = *inside_;
  const std::lock_guard lock(in.mutex);
  if (in.ends) return;
  in.tasks.push_back(std::move(task));
  in.posted.notify_one();
}

Background::Background(const std::string& name, Inbox& inbox)
    : inbox_(inbox), alive_(std::make_shared<const int>(0)), watch_(alive_), executor_(name) {}

Background::~Background() = default;

void Background::post(Task task) { executor_.post(std::move(task)); }

void Background::answer(Task task) {
  // The owner both destroys this object and runs the inbox, so the object cannot be destroyed between the two
  // steps.
  inbox_.post([watch = watch_, task = std::move(task)] {
    if (!watch.expired()) task();
  });
}

}  // namespace nazori::base
