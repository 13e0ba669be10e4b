// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace nazori::base {

/// One thread that does pieces of work in the order they are posted, and hands their answers back to the
/// thread that owns it. Free of any window toolkit: whoever owns it says how its thread is woken.
/// The destructor finishes the piece at hand, drops the rest and what was answered but not yet heard, and
/// joins the thread.
class Worker {
 public:
  using Work = std::function<void()>;

  /// @param name  for debuggers; 15 bytes of it are shown.
  /// @param wake  makes the owner's thread call hear_one() soon, once for each call of it; called by any
  ///   thread, also once more than there is to hear.
  Worker(const std::string& name, Work wake);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Runs `work` on the worker's thread, later. Any thread.
  void post(Work work);
  /// From a piece of work: has `work` run on the owner's thread, later. Any thread.
  void answer(Work work);
  /// Runs the oldest answer that has not been heard; nothing where there is none. An answer may destroy the
  /// worker. Thread: the owner.
  void hear_one();

 private:
  struct Inside;
  std::shared_ptr<Inside> inside_;
};

}  // namespace nazori::base
