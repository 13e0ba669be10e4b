// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <atomic>
#include <filesystem>
#include <memory>

#include "nazori/base/result.h"
#include "nazori/study/statistics.h"
#include "worker.h"

namespace nazori::ui {

using SharedStatistics = std::shared_ptr<const study::Statistics>;

/// Adds a learner's log up on a thread of its own, through a second connection that only reads, so that the
/// window never waits. Of several requests the newest is answered; what runs for an older one stops.
/// Thread: interface.
class StatisticsReader final : public QObject {
  Q_OBJECT
 public:
  explicit StatisticsReader(QObject* parent = nullptr);
  ~StatisticsReader() override;

  /// @param now  the present of the learner's clock.
  void request(const std::filesystem::path& learner, study::Time now);
  [[nodiscard]] bool is_busy() const { return busy_; }

 signals:
  void came_along(double done);
  void ready(nazori::ui::SharedStatistics statistics);
  void failed(nazori::base::Error error);

 private:
  std::atomic<std::uint64_t> newest_{0};
  bool busy_ = false;
  Worker worker_{QStringLiteral("statistics")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
