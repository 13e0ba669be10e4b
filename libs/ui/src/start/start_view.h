// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "nazori/practice/learning_choices.h"
#include "nazori/practice/placement_run.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QScrollArea;

namespace nazori::ui {

class ChoiceButton;

/// The three questions of the first start, and below them the button that begins. The button is visible
/// however far the questions are scrolled.
class StartView final : public QWidget {
  Q_OBJECT
 public:
  explicit StartView(QWidget* parent = nullptr);

  /// Shows answers; what is missing is not chosen. @param is_first  welcomes the learner.
  void show_answers(const practice::LearningAnswers& answers, bool is_first);
  /// The answers that are chosen now.
  [[nodiscard]] practice::LearningAnswers answers() const;
  /// Whether the learner wants to find out what is known, and there is no result yet.
  [[nodiscard]] bool wants_check() const;
  /// What a check found, which the learner may take or refuse; nullopt: none.
  void show_result(const std::optional<practice::PlacementResult>& result);
  /// What the button begins with. @param first  a new character; 0: none is left. @param trouble  why
  /// nothing can be begun; empty: nothing is wrong. @param own_list  the characters of the learner's own
  /// text.
  void show_plan(char32_t first, const QString& trouble, const std::vector<char32_t>& own_list);
  /// What the pasted text of known characters comes to. @param known  which would be marked. @param studied
  /// how many others were studied already.
  void show_known(const std::vector<char32_t>& known, int studied);
  /// What the learner writes with.
  void show_input(const QString& sentence);

 signals:
  /// An answer is different.
  void changed();
  void write_wanted();
  void skip_wanted();

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// The ids of the first row of answers; kanji has a row of its own.
  enum Goal : std::uint8_t { hiragana, katakana, kanji, own };
  /// The ids of the row about what is known.
  enum Known : std::uint8_t { nothing, kana, some_kanji, listed, check };
  enum Result : std::uint8_t { take, refuse };

  static Goal goal_id(practice::LearningGoal goal);
  QLabel* add_question(const QString& words);
  /// A row of answers, of which one is chosen. @param spoken  the question.
  QButtonGroup* add_row(const QList<ChoiceButton*>& buttons, const char* name, const QString& spoken);
  void add_goals();
  void add_known();
  void add_levels();
  /// A field for a text, and below it what was found in it.
  QPlainTextEdit* add_text(const char* name, const QString& spoken, const QString& example, QLabel*& found);
  void add_minutes();
  void add_end();
  void order_tabs();
  void choose(QButtonGroup* group, int id);
  void note_change();
  /// What "I know kana" would mark beside this goal: the syllabary that is being learned is not known yet.
  void name_kana();
  void show_parts();
  void fit();

  QScrollArea* area_;
  QWidget *content_, *end_;
  QLabel *welcome_, *about_;
  QButtonGroup *goal_, *kanji_, *known_, *result_, *minutes_;
  QWidget* kanji_row_;
  QWidget* result_row_;
  QPlainTextEdit *own_text_, *known_text_;
  QLabel *own_found_, *known_found_;
  QComboBox* level_;
  QLabel* result_words_;
  QPushButton *write_, *skip_;
  QLabel *trouble_, *input_;
  std::optional<practice::PlacementResult> found_;
  bool is_first_ = true;
};

}  // namespace nazori::ui
