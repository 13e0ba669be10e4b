// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <atomic>
#include <filesystem>

#include "nazori/study/backups.h"
#include "worker.h"

namespace nazori::ui {

/// Checks a learner's file and makes the backup of the day on a thread of its own, so that the window never
/// waits for them. Thread: interface.
class StoreUpkeep final : public QObject {
  Q_OBJECT
 public:
  explicit StoreUpkeep(QObject* parent = nullptr);
  ~StoreUpkeep() override;

  void request(const std::filesystem::path& learner, study::Day day);
  /// Breaks off what was requested and waits until its file is let go of. Nothing is emitted for it.
  void stop();
  [[nodiscard]] bool is_busy() const { return busy_; }

 signals:
  /// The file is sound; the report says whether it could be backed up.
  void done(nazori::study::UpkeepReport report);
  /// The file is damaged or cannot be read.
  void failed(nazori::base::Error error);

 private:
  std::atomic<std::uint64_t> newest_{0};
  bool busy_ = false;
  Worker worker_{QStringLiteral("upkeep")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
