// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <utility>

#include "nazori/base/executor.h"
#include "nazori/base/progress.h"
#include "nazori/base/signal.h"

namespace nazori::practice {

/// Runs one operation at a time that takes seconds, on a separate thread, with progress and a way to stop. A
/// stopped operation still answers, with Errc::cancelled, so that files that were closed for it can be opened
/// again. An operation may have several steps. Thread: the owner of the inbox.
class LongWork {
 public:
  /// @param name  of the thread, for debuggers.
  LongWork(const std::string& name, base::Inbox& inbox);
  /// Stops the running operation and waits for its end; it is not answered then.
  ~LongWork();
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;

  /// Begins an operation. @return false if one is already running.
  [[nodiscard]] bool begin();
  /// Runs `work(progress)` on the other thread, then `done(its answer)` on the owner's thread. Between
  /// begin() and end().
  template <class Work, class Done>
  void run(Work work, Done done) {
    background_.post([this, work = std::move(work), done = std::move(done)] {
      background_.answer([done, answer = work(progress())] { done(answer); });
    });
  }
  /// The last step is done.
  void end() { is_busy_ = false; }
  [[nodiscard]] bool is_busy() const { return is_busy_; }
  /// Asks the running operation to stop.
  void stop() { is_wanted_ = false; }
  /// Whether it has not been asked to stop. Any thread.
  [[nodiscard]] bool is_wanted() const { return is_wanted_; }

  /// Progress of the present step in whole percent, each value once, up to 99. Not emitted after stop().
  base::Signal<int> progressed;

 private:
  /// The progress function of one step. Thread: the one that does the work.
  [[nodiscard]] base::Progress progress();

  bool is_busy_ = false;
  std::atomic<bool> is_wanted_{false};
  base::Background background_;  // declared last, so that its thread ends first
};

}  // namespace nazori::practice
