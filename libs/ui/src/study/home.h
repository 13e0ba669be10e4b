// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <vector>

#include "nazori/widgets/page/page.h"

namespace nazori::ui {

class HomeView;

/// The actions of Home.
class HomeActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit HomeActions(QWidget* window);
  QAction *start, *reviews, *more, *ahead, *practise, *brush, *leeches, *choose;
  QAction *all_ink, *week, *month, *undo, *settings, *choices;
};

/// The first page: what is due today and the button that starts a session, and what was written last.
class Home final : public Page {
  Q_OBJECT
 public:
  explicit Home(WindowParts& parts);
  ~Home() override;

  [[nodiscard]] QWidget* instead_of_tablet() const override;
  [[nodiscard]] ActionSet* actions() const override { return actions_; }
  [[nodiscard]] QList<Tool> tools() const override;

  void enter() override;
  void leave() override;

 private:
  void start(bool leeches);
  void start_with(const std::vector<char32_t>& characters, const QString& if_none);
  void save_picture(bool of_month);
  void refresh();

  HomeActions* actions_;
  HomeView* view_;
  QTimer look_;
  bool entered_ = false;
};

}  // namespace nazori::ui
