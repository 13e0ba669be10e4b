// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <utility>

#include "nazori/base/executor.h"
#include "nazori/base/progress.h"
#include "nazori/base/signal.h"

namespace nazori::practice {

/// One piece of work at a time that takes seconds: done behind the thread that owns it, with how far it is
/// and a way to stop. Work that is stopped still answers, with Errc::cancelled, so that what was closed for
/// it can be opened again. Work may have several steps. Thread: the owner of the inbox.
class LongWork {
 public:
  /// @param name  of the thread, for debuggers.
  LongWork(const std::string& name, base::Inbox& inbox);
  /// Stops what is running and waits until it has; it is not answered then.
  ~LongWork();
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;

  /// Begins. @return false where something is running already.
  [[nodiscard]] bool begin();
  /// Runs `work(progress)` behind, then `done(its answer)` on the owner's thread. Between begin() and end().
  template <class Work, class Done>
  void run(Work work, Done done) {
    background_.post([this, work = std::move(work), done = std::move(done)] {
      background_.answer([done, answer = work(progress())] { done(answer); });
    });
  }
  /// The last step is done.
  void end() { is_busy_ = false; }
  [[nodiscard]] bool is_busy() const { return is_busy_; }
  /// Asks what is running to stop.
  void stop() { is_wanted_ = false; }
  /// Whether it was not asked to stop. Any thread.
  [[nodiscard]] bool is_wanted() const { return is_wanted_; }

  /// Whole percents of the present step, each once, up to 99. Not after stop().
  base::Signal<int> progressed;

 private:
  /// For one step. Thread: that of the work.
  [[nodiscard]] base::Progress progress();

  bool is_busy_ = false;
  std::atomic<bool> is_wanted_{false};
  base::Background background_;  // declared last, so that its thread ends first
};

}  // namespace nazori::practice
