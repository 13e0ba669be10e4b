// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace nazori::base {

/// A task for some thread.
using Task = std::function<void()>;

/// Tasks that other threads post to one thread, the owner, such as the thread of a window. Tasks run in the
/// order in which they were posted.
class Inbox {
 public:
  /// @param wake  makes the owner call run_one() soon, once for each call of `wake`. Called by any thread,
  /// also
  ///   more often than there are tasks. Empty where the owner waits with run_until().
  explicit Inbox(Task wake = {});
  ~Inbox();
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  /// Asks the owner to run `task` later. Any thread.
  void post(Task task);
  /// Runs the oldest task, if there is one. A task may call run_one() itself, as a nested event loop does.
  /// Thread: the owner.
  /// @return whether there was a task.
  bool run_one();
  /// Runs tasks and waits for more until `enough` returns true. It is called before each task. For an owner
  /// without an event loop. Thread: the owner.
  void run_until(const std::function<bool()>& enough);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// One thread that runs tasks in the order in which they are posted.
/// The destructor finishes the task that is running, drops the others and joins the thread.
class Executor {
 public:
  /// @param name  for debuggers; 15 bytes of it are shown.
  explicit Executor(const std::string& name);
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// Runs `task` on the executor's thread, later. Nothing happens once the destructor has begun. Any thread.
  void post(Task task);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Background work for the thread that owns this object: an executor for the work, and results that the owner
/// runs through its inbox. The destructor finishes the task that is running. Results that have not run by
/// then never run. So both may use other members of the object that owns this one, if that object declares
/// this one last.
class Background {
 public:
  /// @param name  for debuggers; 15 bytes of it are shown.
  /// @param inbox  of the thread that makes and destroys this object; outlives it.
  Background(const std::string& name, Inbox& inbox);
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Runs `task` on a thread of its own, later. Any thread.
  void post(Task task);
  /// Asks the owner's thread to run `task` later. A task may destroy this object. Any thread.
  void answer(Task task);

 private:
  Inbox& inbox_;
  std::shared_ptr<const int> alive_;  ///< read by the owner's thread only
  std::weak_ptr<const int>
      watch_;          ///< how the executor refers to `alive_`; never written after the constructor
  Executor executor_;  // declared last, so that its thread ends first
};

}  // namespace nazori::base
