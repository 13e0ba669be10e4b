// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "nazori/practice/learner_exchange.h"

namespace nazori::ui {

class WindowParts;
class ExchangeProgress;
class LearnerActions;

/// The menu "Learner": opens its dialogs, asks for files, and announces the result.
class LearnerMenu final : public QObject {
  Q_OBJECT
 public:
  explicit LearnerMenu(WindowParts& parts);

  [[nodiscard]] LearnerActions& actions() const { return *actions_; }

 private:
  void show_learners();
  void show_backups();
  void ask_and_write(practice::LearnerExchange::Format format);
  void ask_and_read();
  void remember_folder_of(const QString& path);

  WindowParts& parts_;
  LearnerActions* actions_;
  ExchangeProgress* progress_;
};

}  // namespace nazori::ui
