// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <utility>

#include "nazori/base/worker.h"

namespace nazori::ui {

/// One thread that does pieces of work in the order they are posted, so that the window never waits for them:
/// base::Worker, whose answers the event loop of Qt hears.
/// The destructor finishes the piece at hand, drops the rest and what was answered but not yet heard, and
/// joins the thread.
class Worker {
 public:
  using Work = std::function<void()>;

  /// Answers are heard on the thread that makes the worker.
  explicit Worker(const QString& name);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Runs `work` on the worker's thread, later.
  void post(Work work) { worker_->post(std::move(work)); }
  /// From a piece of work: runs `work` on the thread that made the worker, later.
  void answer(Work work) { worker_->answer(std::move(work)); }

 private:
  class Bell;
  std::unique_ptr<Bell> bell_;
  std::unique_ptr<base::Worker> worker_;  // last: nobody rings once the bell is gone
};

}  // namespace nazori::ui
