// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "nazori/kanji/character.h"
#include "nazori/practice/brush_session.h"
#include "nazori/practice/session_question.h"

class QAction;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace nazori::ui {

class BrushActions;
class SpokenLine;

/// The question of a review with the brush above the paper, and the buttons for what can be done; after the
/// advice the four ratings. Hidden without a session.
class BrushReviewBar final : public QFrame {
  Q_OBJECT
 public:
  /// @param session  outlives this, as `learner` and `actions` do.
  BrushReviewBar(const practice::BrushSession& session, const practice::Learner& learner,
                 const BrushActions& actions, QWidget* parent);

  /// @param character  of the session, once it was read.
  void show_state(const std::optional<kanji::Character>& character);

  /// The question in words, without the character while the learner must know it.
  [[nodiscard]] static QString question_words(const kanji::Character& character, bool is_secret,
                                              practice::QuestionRoom room = practice::QuestionRoom::full);

 private:
  void show_ratings();

  const practice::BrushSession& session_;
  const practice::Learner& learner_;
  QStackedWidget* words_;  ///< the question, then the verdict
  QLabel *question_, *verdict_;
  QStackedWidget* steps_;  ///< the button for advice, then the ratings
  QPushButton* advice_;
  QWidget* ratings_;
  std::vector<std::pair<QPushButton*, const QAction*>> others_;  ///< what else can be done
  QLabel* progress_;
  std::array<QPushButton*, 4> rating_{};
  SpokenLine* spoken_;
  QString said_;
};

}  // namespace nazori::ui
