// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QWidget>
#include <vector>

#include "nazori/practice/learner.h"
#include "nazori/practice/statistics_reader.h"
#include "nazori/widgets/charts/chart_card.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;

namespace nazori::ui {

class CalendarCard;
class CharactersCard;
class HardStrokesCard;

/// The widget of the page for progress: how far the learner is, the calendar, the characters and the hardest
/// strokes; then, folded away, more figures and a card for each chart. Thread: interface.
class ProgressView final : public QWidget {
  Q_OBJECT
 public:
  /// How far back the charts go. The number is the number of days; everything: 0.
  enum class TimeShown { month = 31, season = 92, year = 366, everything = 0 };

  explicit ProgressView(practice::Learner& learner, QWidget* parent = nullptr);
  ~ProgressView() override;

  void show_statistics(const practice::SharedStatistics& statistics);
  /// Shows nothing of a learner, until the next show_statistics().
  void clear();
  /// Shows one sentence instead of everything; empty: the cards again.
  void show_trouble(const QString& sentence);
  /// Progress of reading the study history: 0..1; 1 hides it.
  void show_work(double done);
  void refresh_appearance();

  [[nodiscard]] TimeShown time_shown() const;
  void set_time_shown(TimeShown time);
  /// Longer (+1) or shorter (-1). @return false at the end.
  bool change_time_shown(int by);

  /// Whether the charts are shown.
  [[nodiscard]] bool shows_more() const;
  void set_shows_more(bool more);
  /// The characters of the hardest strokes, to be practised; at most four.
  [[nodiscard]] std::vector<char32_t> hardest() const;

  [[nodiscard]] CharactersCard& characters() const { return *characters_; }
  /// The card with this id. Never nullptr: if there is no such card, the first one.
  [[nodiscard]] ChartCard* card(const QString& id) const;
  /// The card that has the focus, or had it last.
  [[nodiscard]] ChartCard* card_at_hand() const;
  void go_to(const QString& id);

 signals:
  void opened(char32_t character);
  void copy_wanted(nazori::ui::ChartCard* card);
  void time_changed();
  void more_changed(bool more);
  void practise_wanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  void arrange();
  void show_way();
  void show_figures();
  /// @param all  also those that do not look back.
  void show_charts(bool all);
  void show_characters();
  void note_focus(QWidget* now);
  void scroll_to(ChartCard* card);

  practice::Learner& learner_;
  practice::SharedStatistics statistics_;
  QScrollArea* scroll_;
  QWidget* content_;
  QLabel* trouble_;
  QLabel *title_, *way_;
  QProgressBar* work_;
  // In this order the Tab key goes through them.
  CalendarCard* calendar_;
  CharactersCard* characters_;
  HardStrokesCard* hard_strokes_;
  QPushButton *practise_, *more_;
  QWidget* more_box_;
  QLabel* figures_;
  QComboBox* time_;
  QGridLayout *first_grid_, *grid_;
  /// Those of practice::chart_kinds(), in its order.
  QList<ChartCard*> charts_;
  QList<ChartCard*> cards_;  ///< the others, then the charts
  ChartCard* at_hand_;
  int columns_ = 0;
};

}  // namespace nazori::ui
