// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/long_work.h"
#include "nazori/study/settings.h"

namespace nazori::practice {

/// Saves settings by which every card is worked out again, on a thread of its own, with how far it is and a
/// way to stop: with a history of years that takes seconds. Meanwhile the learner has no store.
/// Thread: the owner of the inbox.
class SettingsChange {
 public:
  /// Whether so much has to be worked out that whoever asks would wait for it.
  [[nodiscard]] static bool takes_long(const study::LearnerStore& store, const study::Settings& wanted);

  /// @param learner  outlives this.
  SettingsChange(base::Inbox& inbox, Learner& learner);

  /// Begins; nothing where it runs already.
  void start(const study::Settings& wanted);
  /// The settings stay as they were, unless it is too late; `finished` follows in any case.
  void stop() { work_.stop(); }
  [[nodiscard]] bool is_busy() const { return work_.is_busy(); }

  /// Whole percents.
  [[nodiscard]] base::Signal<int>& progressed() { return work_.progressed; }
  /// The learner has a store again; Errc::cancelled after stop().
  base::Signal<const base::Result<void>&> finished;

 private:
  Learner& learner_;
  LongWork work_;  // declared last, so that it ends before what it uses
};

}  // namespace nazori::practice
