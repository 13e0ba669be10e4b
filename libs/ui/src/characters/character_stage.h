// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <utility>

#include "characters/character_actions.h"
#include "desk.h"
#include "nazori/practice/character_library.h"
#include "nazori/study/lesson.h"
#include "workplace.h"

namespace nazori::ui {

/// What a stage works on.
struct Lesson {
  std::shared_ptr<const practice::CharacterSheet> sheet;  ///< null: a tablet of the learner's own
  practice::Tablet tablet;
};

/// One way of meeting the character on the desk: watching, tracing, being led, writing from memory. Between
/// enter() and leave() it decides what is on the tablet. Thread: interface.
class CharacterStage : public QObject {
  Q_OBJECT
 public:
  CharacterStage(Desk& desk, CharacterActions& actions) : desk_(desk), actions_(actions) {}

  /// Takes the tablet for a lesson; again for each new one.
  void enter(const Lesson& lesson) {
    lesson_ = lesson;
    entered_ = true;
    begin();
  }
  void leave() {
    if (!entered_) return;
    end();
    entered_ = false;
  }
  /// Actions that mean something in this stage only, in the order of the toolbar (nullptr: a gap).
  [[nodiscard]] virtual QList<QAction*> own_actions() const = 0;
  [[nodiscard]] virtual QList<Tool> tools() const = 0;
  /// What the learner shall find out must not stand beside the tablet.
  [[nodiscard]] virtual bool hides_character() const { return false; }

  /// What to do after a miss of a stroke, counted from 0; nothing: misses are only told.
  using OnMiss = std::function<study::MissReply(int stroke)>;
  void set_on_miss(OnMiss on_miss) { on_miss_ = std::move(on_miss); }

 signals:
  void hiding_changed();
  /// The character was gone through to its end; what the stage knows of how.
  void finished(nazori::study::WritingResult result);

 protected:
  /// The lesson begins, or begins anew with another character.
  virtual void begin() = 0;
  virtual void end() {}

  [[nodiscard]] study::MissReply reply_to_miss(int stroke) const {
    return on_miss_ ? on_miss_(stroke) : study::MissReply::try_again;
  }
  [[nodiscard]] bool is_taught() const { return static_cast<bool>(on_miss_); }
  [[nodiscard]] Desk& desk() const { return desk_; }
  [[nodiscard]] CharacterActions& actions() const { return actions_; }
  [[nodiscard]] TabletController& controller() const { return desk_.controller(); }
  [[nodiscard]] const Lesson& lesson() const { return lesson_; }
  [[nodiscard]] bool is_entered() const { return entered_; }
  [[nodiscard]] int stroke_count() const {
    return lesson_.tablet ? static_cast<int>(lesson_.tablet->lines().size()) : 0;
  }

 private:
  Desk& desk_;
  CharacterActions& actions_;
  Lesson lesson_;
  OnMiss on_miss_;
  bool entered_ = false;
};

}  // namespace nazori::ui
