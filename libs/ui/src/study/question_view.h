// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <memory>

#include "nazori/practice/session_question.h"
#include "nazori/practice/study_session.h"

class QAction;
class QLabel;
class QPushButton;

namespace nazori::ui {

class SpokenLine;

/// What stands above the tablet during a session: the question, large, and after the writing the verdict in
/// its place. As high for the one as for the other, so that the tablet does not move. Says a question to the
/// screen reader once.
class QuestionView final : public QFrame {
  Q_OBJECT
 public:
  /// The verdict on a writing, in words.
  struct Verdict {
    QString words;   ///< "Correct. Form: ★★★★☆"
    QString spoken;  ///< for a screen reader, which does not count stars
    QString brief;   ///< where there is little room: "★★★★☆"
  };

  /// @param show  shows on the tablet what should have been written.
  QuestionView(const practice::StudySession& session, QAction* show, QWidget* parent);

  /// @param sheet  of the session's character; null while it is loading.
  void show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet, const Verdict& verdict);
  /// Shows the same in the current colours, text size and room.
  void refresh();

 signals:
  /// There is another room for the question than before.
  void room_changed(nazori::practice::QuestionRoom room);

 public:
  /// The question in words, for those who do not see it.
  [[nodiscard]] static QString spoken(const practice::SessionQuestion& asks);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_question();
  void show_verdict();
  void say_question(const practice::SessionQuestion& asks);
  void fit();

  const practice::StudySession& session_;
  std::shared_ptr<const practice::CharacterSheet> sheet_;  ///< shown last
  Verdict verdict_;
  practice::QuestionRoom room_ = practice::QuestionRoom::full;
  QString said_;  ///< the question that was spoken last
  QLabel* question_;
  QWidget* answer_;  ///< the verdict, and what was asked
  QLabel* character_;
  QLabel* verdict_line_;
  QLabel* reason_;
  QPushButton* show_;
  SpokenLine* spoken_;
};

}  // namespace nazori::ui
