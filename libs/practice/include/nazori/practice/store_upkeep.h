// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "nazori/base/latest.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/study/backups.h"

namespace nazori::practice {

/// Checks a learner's file and makes the backup of the day on a separate thread, because both read the whole
/// file. Thread: the owner of the inbox.
class StoreUpkeep {
 public:
  explicit StoreUpkeep(base::Inbox& inbox);

  /// Of several requests only the newest is answered.
  /// @param day  the learner's study day.
  void request(const std::filesystem::path& learner, study::Day day);
  /// Cancels the request and waits until its file is closed. No signal follows.
  void stop();
  [[nodiscard]] bool is_busy() const { return work_.is_busy(); }

  /// The file is sound; the report says whether it could be backed up.
  base::Signal<const study::UpkeepReport&> done;
  /// The file is damaged or cannot be read.
  base::Signal<const base::Error&> failed;

 private:
  struct Request {
    std::filesystem::path learner;
    study::Day day{};
  };
  using Answer = base::Result<study::UpkeepReport>;

  base::Latest<Request, Answer> work_;  // declared last, so that it is destroyed before the members it uses
};

}  // namespace nazori::practice
