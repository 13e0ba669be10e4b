// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <array>

#include "nazori/practice/learner.h"
#include "nazori/practice/study_session.h"
#include "nazori/study/statistics.h"

class QFrame;
class QGridLayout;
class QLabel;
class QPushButton;

namespace nazori::ui {

/// The widget of Home: what is due now, how long it takes, and one button to start.
class HomeView final : public QScrollArea {
  Q_OBJECT
 public:
  HomeView(practice::Learner& learner, const practice::StudySession& session, QWidget* parent = nullptr);

  /// Reads the plan of the day again.
  void refresh();
  /// Whether the last refresh() found something to start or to continue.
  [[nodiscard]] bool can_start() const { return can_start_; }
  /// Shows the summary of the last session on top, until the next one starts.
  void show_summary(const practice::SessionSummary& summary);

 signals:
  void start_wanted();
  void leeches_wanted();
  void settings_wanted();
  void free_writing_wanted();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Tile {
    QFrame* frame = nullptr;
    QLabel* number = nullptr;
    QLabel* words = nullptr;
  };
  enum TileName : std::uint8_t { due, fresh, minutes, streak, tile_count };

  Tile make_tile(const char* name);
  void show_tile(TileName which, const QString& number, const QString& words);
  [[nodiscard]] QString advice(const study::DayPlan& plan) const;
  [[nodiscard]] QString after_the_work(const study::DayPlan& plan) const;
  void set_text(QLabel* label, const QString& text);
  void fit();

  practice::Learner& learner_;
  const practice::StudySession& session_;
  bool can_start_ = false;
  QWidget* content_;
  QLabel* day_;
  QLabel* trouble_;
  QPushButton* again_;
  QLabel* summary_;
  QGridLayout* grid_;
  std::array<Tile, tile_count> tiles_;
  QPushButton* start_;
  QLabel* advice_;
  QLabel* leeches_;
  QPushButton* leech_button_;
  QPushButton* settings_;
  QPushButton* free_writing_;
};

}  // namespace nazori::ui
