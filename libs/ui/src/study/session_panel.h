// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>

#include "nazori/practice/study_session.h"

class QLabel;

namespace nazori::ui {

class InkGallery;

/// The first part of the information beside the tablet during a session: why the character is asked, what
/// went wrong with it before, and earlier writings beside today's.
class SessionPanel final : public QWidget {
  Q_OBJECT
 public:
  SessionPanel(const practice::StudySession& session, practice::Learner& learner, QWidget* parent);

  void show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet);
  /// Shows the same in the current colours and text size.
  void refresh();

 private:
  [[nodiscard]] QString why() const;
  [[nodiscard]] QString history() const;
  [[nodiscard]] QString hard_strokes() const;
  void show_ink();

  const practice::StudySession& session_;
  practice::Learner& learner_;
  std::shared_ptr<const practice::CharacterSheet> sheet_;  ///< shown last
  QLabel* kind_;
  QLabel* history_;
  QLabel* mistakes_;
  QLabel* parts_;
  QLabel* ink_heading_;
  InkGallery* gallery_;
};

}  // namespace nazori::ui
