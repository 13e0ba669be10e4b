// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "nazori/base/signal.h"
#include "nazori/practice/character_library.h"
#include "nazori/practice/stage_feedback.h"
#include "nazori/practice/tablet_control.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/study/lesson.h"
#include "nazori/study/writing_result.h"

namespace nazori::practice {

/// What a stage works on.
struct StageSubject {
  std::shared_ptr<const CharacterSheet> sheet;  ///< null: a tablet of the learner's own
  Tablet tablet;                                ///< null: none yet
};

/// Something that a learner can ask of a stage by name: "undo", "hint".
struct StageCommand {
  std::string_view name;
  std::function<void()> run;
};

/// One way of practising a character: watching it, tracing it, being guided, writing it from memory, writing
/// a word that has it. stage_kinds() lists them. Between enter() and leave() it decides what is on the
/// tablet. Thread: the owner of the inbox.
class PracticeStage {
 public:
  explicit PracticeStage(TabletControl& tablet) : tablet_(tablet) {}
  virtual ~PracticeStage() = default;
  PracticeStage(const PracticeStage&) = delete;
  PracticeStage& operator=(const PracticeStage&) = delete;

  /// Its name in settings and data formats, as StageKind::id has it: "memory".
  [[nodiscard]] virtual std::string_view id() const = 0;
  /// Whether there is something to practise with a subject; most stages need a character of the database.
  [[nodiscard]] virtual bool can_practise(const StageSubject& subject) const {
    return subject.sheet != nullptr;
  }
  /// What can be asked of it now. Names are those of the command line.
  [[nodiscard]] virtual std::vector<StageCommand> commands() {
    return {{"undo", [this] { tablet_.undo_ink(); }}, {"clear", [this] { tablet_.clear_ink(); }}};
  }
  /// Whether it waits for something that another thread looks up or judges.
  [[nodiscard]] virtual bool is_busy() const { return false; }
  /// What belongs to one of its reports beyond the fields of StageFeedback, for data formats.
  [[nodiscard]] virtual StageDetails details(const StageFeedback& /*what*/) const { return {}; }
  /// Another learner: nothing that was written is shown to them.
  virtual void forget() {}
  /// Begins with a subject; called again for each new one.
  void enter(const StageSubject& subject) {
    subject_ = subject;
    is_entered_ = true;
    begin();
    changed();
  }
  void leave() {
    if (!is_entered_) return;
    end();
    is_entered_ = false;
    changed();
  }
  [[nodiscard]] bool is_entered() const { return is_entered_; }
  [[nodiscard]] const StageSubject& subject() const { return subject_; }
  /// The answer must not be shown beside the tablet.
  [[nodiscard]] virtual bool hides_character() const { return false; }

  /// What to do after a mistake in a stroke, counted from 0. Empty: outside of a lesson mistakes are only
  /// reported.
  using OnMistake = std::function<study::MissReply(int stroke)>;
  void set_on_mistake(OnMistake on_mistake) { on_mistake_ = std::move(on_mistake); }

  /// Whether the stage is part of a lesson.
  [[nodiscard]] bool is_lesson() const { return static_cast<bool>(on_mistake_); }

  base::Signal<const StageFeedback&> feedback;
  /// hides_character() may have changed.
  base::Signal<> hiding_changed;
  /// What the stage shows of itself, such as which of its actions can be used, may have changed.
  base::Signal<> changed;
  /// The character was practised to its end, with what the stage knows of how.
  base::Signal<const study::WritingResult&> finished;

 protected:
  /// The stage has a new subject.
  virtual void begin() = 0;
  virtual void end() {}

  [[nodiscard]] study::MissReply reply_to_mistake(int stroke) const {
    return on_mistake_ ? on_mistake_(stroke) : study::MissReply::try_again;
  }
  [[nodiscard]] TabletControl& tablet() const { return tablet_; }
  [[nodiscard]] int stroke_count() const {
    return subject_.tablet ? static_cast<int>(subject_.tablet->lines().size()) : 0;
  }
  void report(const StageFeedback& what) { feedback(what); }

 private:
  TabletControl& tablet_;
  StageSubject subject_;
  OnMistake on_mistake_;
  bool is_entered_ = false;
};

}  // namespace nazori::practice
