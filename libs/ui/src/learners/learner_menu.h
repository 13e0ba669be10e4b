// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "nazori/practice/learner_exchange.h"

namespace nazori::ui {

class Desk;
class ExchangeProgress;
class LearnerActions;

/// The menu "Learner": opens its dialogs, asks for files, and says how it went.
class LearnerMenu final : public QObject {
  Q_OBJECT
 public:
  explicit LearnerMenu(Desk& desk);

  [[nodiscard]] LearnerActions& actions() const { return *actions_; }

 private:
  void show_learners();
  void show_backups();
  void ask_and_write(practice::LearnerExchange::Format format);
  void ask_and_read();
  [[nodiscard]] QString folder() const;
  void remember_folder_of(const QString& path);

  Desk& desk_;
  LearnerActions* actions_;
  ExchangeProgress* progress_;
};

}  // namespace nazori::ui
