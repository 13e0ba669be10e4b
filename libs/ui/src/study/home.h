// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include "workplace.h"

namespace nazori::ui {

class HomePage;

/// What can be done at home.
class HomeActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit HomeActions(QWidget* window);
  QAction *start, *leeches, *undo, *settings;
};

/// The first workplace: what today holds, and the beginning of a session.
class Home final : public Workplace {
  Q_OBJECT
 public:
  explicit Home(Desk& desk);
  ~Home() override;

  [[nodiscard]] QString id() const override;
  [[nodiscard]] QString name() const override;
  [[nodiscard]] QString purpose() const override;
  [[nodiscard]] Icon drawing() const override;
  [[nodiscard]] QWidget* page() const override;
  [[nodiscard]] ActionSet* actions() const override { return actions_; }
  [[nodiscard]] QList<Tool> tools() const override;

  void enter() override;
  void leave() override;

 private:
  void start(bool leeches);
  void refresh();

  HomeActions* actions_;
  HomePage* page_;
  QTimer look_;
  bool entered_ = false;
};

}  // namespace nazori::ui
