// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/long_work.h"
#include "nazori/study/settings.h"

namespace nazori::practice {

/// Saves settings after which every card has to be computed again, on a separate thread, with progress and a
/// way to stop, because a history of years takes seconds. Meanwhile the learner has no store. Thread: the
/// owner of the inbox.
class SettingsChange {
 public:
  /// Whether the computation takes so long that it should run on a separate thread.
  [[nodiscard]] static bool takes_long(const study::LearnerStore& store, const study::Settings& wanted);

  /// @param learner  outlives this.
  SettingsChange(base::Inbox& inbox, Learner& learner);

  /// Begins; does nothing if it is already running.
  void start(const study::Settings& wanted);
  /// Stops: the settings are unchanged, unless it is too late; `finished` follows in any case.
  void stop() { work_.stop(); }
  [[nodiscard]] bool is_busy() const { return work_.is_busy(); }

  /// Whole percents.
  [[nodiscard]] base::Signal<int>& progressed() { return work_.progressed; }
  /// The learner has a store again; the result is Errc::cancelled after stop().
  base::Signal<const base::Result<void>&> finished;

 private:
  Learner& learner_;
  LongWork work_;  // declared last, so that it is destroyed before the members it uses
};

}  // namespace nazori::practice
