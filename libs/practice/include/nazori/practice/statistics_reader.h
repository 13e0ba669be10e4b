// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "nazori/base/latest.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/study/statistics.h"

namespace nazori::practice {

/// Immutable statistics that several readers share.
using SharedStatistics = std::shared_ptr<const study::Statistics>;

/// Computes statistics of a learner's study history on a separate thread, through a second connection that
/// only reads. Of several requests the newest is answered; the work for an older one stops. Thread: the owner
/// of the inbox.
class StatisticsReader {
 public:
  explicit StatisticsReader(base::Inbox& inbox);

  /// @param now  the present time of the learner's clock.
  void request(const std::filesystem::path& learner, study::Time now);
  /// Drops the request, if there is one: its answer never arrives.
  void cancel() { work_.cancel(); }
  [[nodiscard]] bool is_busy() const { return work_.is_busy(); }

  /// Progress of the newest request, 0..1.
  base::Signal<double> progressed;
  base::Signal<const SharedStatistics&> ready;
  base::Signal<const base::Error&> failed;

 private:
  struct Request {
    std::filesystem::path learner;
    study::Time now{};
  };
  using Answer = base::Result<SharedStatistics>;

  base::Latest<Request, Answer> work_;  // declared last, so that it is destroyed before the members it uses
};

}  // namespace nazori::practice
