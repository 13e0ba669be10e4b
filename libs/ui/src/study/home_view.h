// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QScrollArea>
#include <vector>

#include "nazori/practice/day_record.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/study_session.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace nazori::ui {

class HomeActions;
class InkRow;
class StartButton;

/// The widget of Home: what is due now and one button to start; how far the learner is; what is new, what was
/// written last, and what needs care.
class HomeView final : public QScrollArea {
  Q_OBJECT
 public:
  /// @param actions  that its buttons trigger.
  HomeView(practice::Learner& learner, const practice::StudySession& session, const HomeActions& actions,
           QWidget* parent = nullptr);

  /// Reads the day of the learner again.
  void refresh();
  /// Whether the last refresh() found something to start or to continue.
  [[nodiscard]] bool can_start() const { return can_start_; }
  /// What needs care: what was not right today, else what often fails.
  [[nodiscard]] const std::vector<char32_t>& hard() const { return hard_; }
  /// Shows all of the last day's handwriting, or one row of it.
  void show_all_ink(bool all);

 signals:
  void character_wanted(char32_t character);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Rows of tiles, made again where they are to show others.
  struct Tiles {
    QWidget* box = nullptr;
    std::vector<char32_t> shown;
  };
  QPushButton* button(QAction* action, const char* name, const QString& text, const char* role = nullptr);
  /// The key of an action beside the words of its button, also after it was changed.
  static void show_key(QPushButton* button, const QAction* action, const QString& text);
  QWidget* card(const char* name, std::initializer_list<QWidget*> parts);
  void set_text(QLabel* label, const QString& text);
  void show_tiles(Tiles& tiles, const std::vector<char32_t>& characters, bool captions);
  void show_header();
  void show_work(const study::DayPlan& plan);
  void show_way();
  void show_last_day(const study::DayPlan& plan);
  void show_care(const study::DayPlan& plan, const practice::WritingRecord& today);
  void move_focus(QWidget* keyboard);
  void fit();

  practice::Learner& learner_;
  const practice::StudySession& session_;
  bool can_start_ = false;
  std::vector<char32_t> hard_;
  QWidget* content_;
  QLabel *greeting_, *day_, *trouble_, *advice_, *leeches_;
  QPushButton* again_;
  StartButton* start_;
  QPushButton *reviews_, *choose_, *settings_, *more_, *ahead_, *brush_;
  QString brush_key_;
  QLabel* way_title_;
  QWidget* way_card_;
  QVBoxLayout* way_;
  QLabel* new_title_;
  Tiles new_;
  QLabel* ink_title_;
  QWidget* ink_card_;
  InkRow* ink_;
  QLabel *ink_figures_, *ink_empty_;
  QPushButton *all_ink_, *week_, *month_;
  QLabel* care_title_;
  QWidget* care_card_;
  Tiles care_;
  QLabel* care_words_;
  QPushButton *practise_, *relearn_;
  QGridLayout* header_;
  QGridLayout* grid_;
  QWidget *left_, *right_;
};

}  // namespace nazori::ui
