// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "nazori/practice/guided_stage.h"
#include "nazori/practice/memory_stage.h"
#include "nazori/practice/stage_table.h"
#include "nazori/practice/study_session.h"
#include "nazori/practice/trace_stage.h"
#include "nazori/practice/watch_stage.h"

namespace nazori::practice {

/// Practising characters: which character is on the tablet, at which stage, freely or as a study session
/// wants it. Something else may have the tablet meanwhile: between enter() and leave() it is used here. What
/// is practised stays over that. Thread: the owner of the inbox.
class CharacterPractice {
 public:
  /// What it works with; all of it outlives the practice.
  struct Parts {
    base::Inbox& inbox;
    const base::Clock& clock;
    TabletControl& tablet;
    CharacterLibrary& library;
    TabletWorkshop& workshop;
    WritingJudge& judge;
    StudySession& session;
  };

  explicit CharacterPractice(const Parts& parts);
  ~CharacterPractice();
  CharacterPractice(const CharacterPractice&) = delete;
  CharacterPractice& operator=(const CharacterPractice&) = delete;

  // The stages of a lesson.
  [[nodiscard]] WatchStage& watch() { return get<WatchStage>(); }
  [[nodiscard]] TraceStage& trace() { return get<TraceStage>(); }
  [[nodiscard]] GuidedStage& guided() { return get<GuidedStage>(); }
  [[nodiscard]] MemoryStage& memory() { return get<MemoryStage>(); }
  /// The stage of a class.
  template <class Kind>
  [[nodiscard]] Kind& get() const {
    return static_cast<Kind&>(*stage_named(Kind::kId));
  }
  /// All stages, in the order of stage_kinds().
  [[nodiscard]] const std::vector<std::unique_ptr<PracticeStage>>& stages() const { return stages_; }
  /// @return nullptr for a name that no stage has.
  [[nodiscard]] PracticeStage* stage_named(std::string_view id) const;
  [[nodiscard]] PracticeStage& stage_for(study::Stage stage) const;
  /// The stage at which characters are practised now.
  [[nodiscard]] PracticeStage& current_stage() const { return *stage_; }
  /// Goes to a stage. Before the first enter() it is only chosen.
  void enter_stage(PracticeStage& stage);

  /// Uses the tablet from now on: a writing that was under way goes on. Asks for the first character where
  /// there is nothing on the tablet yet.
  void enter();
  /// Something else uses the tablet from now on.
  void leave();
  [[nodiscard]] bool is_entered() const { return is_entered_; }
  /// The character to begin with.
  void set_first_character(char32_t character) { first_ = character; }

  /// Asks for a character; `character_shown` or `character_missing` follows.
  /// @param remember  whether go_back() leads to it later.
  void show(char32_t character, bool remember = true);
  /// As show(), to look at the character: a stage that hides it gives way to tracing.
  void look_up(char32_t character);
  /// Along the characters that were shown: -1 back, +1 forward. Nothing happens at the end of them.
  void travel(int by);
  /// Files are being loaded: a character that was asked for before must not come after them.
  void expect_files() { awaited_ = 0; }

  /// The character on the tablet; null: none, or a tablet of the learner's own.
  [[nodiscard]] const std::shared_ptr<const CharacterSheet>& sheet() const { return sheet_; }
  /// The tablet that is practised, also while something else has the place of it; null: none yet.
  [[nodiscard]] const Tablet& tablet() const { return tablet_; }
  /// The learner's own tablet; without a tablet while a character is practised.
  [[nodiscard]] const OwnTablet& own() const { return own_; }
  /// The character that a study action is about: that of the session, unless the learner looks at another
  /// one; 0: none.
  [[nodiscard]] char32_t studied_character() const;

  /// Another stage is current; it has not begun yet.
  base::Signal<> stage_changed;
  /// A character has come and will be practised; the stage has not begun yet.
  base::Signal<char32_t> character_arrived;
  /// A character is on the tablet.
  base::Signal<char32_t> character_shown;
  base::Signal<char32_t> character_missing;
  /// A tablet of the learner's own will be practised; only tracing is possible.
  base::Signal<> own_arrived;
  /// It is on the tablet.
  base::Signal<> own_shown;
  /// Whether the character is hidden, or what is on the tablet, may have changed.
  base::Signal<> hiding_changed;
  /// The tablet should be used here: enter() is wanted.
  base::Signal<> wanted;
  /// What the stages report.
  base::Signal<const PracticeStage&, const StageFeedback&> feedback;

 private:
  void connect_stages();
  void connect_session();
  void connect_work();
  void use_sheet(const std::shared_ptr<const CharacterSheet>& sheet);
  void use_tablet(char32_t character, const Tablet& tablet);
  /// Begins with the character on the tablet: in a session at the stage that is due, else at the present one.
  void present();
  void use_own(const OwnTablet& loaded);
  void begin_stage();
  /// Whether a stage asks for the character without showing it.
  [[nodiscard]] static bool asks_for_character(const PracticeStage& stage);
  /// The stage of a lesson that it is; nothing: only the learner chooses it.
  [[nodiscard]] static std::optional<study::Stage> lesson_stage(const PracticeStage& stage);

  TabletControl& control_;
  CharacterLibrary& library_;
  TabletWorkshop& workshop_;
  StudySession& session_;
  std::vector<std::unique_ptr<PracticeStage>> stages_;
  PracticeStage* stage_;

  bool is_entered_ = false;
  bool returns_ = false;  ///< during enter()
  char32_t first_ = U'休';
  std::shared_ptr<const CharacterSheet> sheet_;
  bool looks_up_ = false;                         ///< the awaited character must be seen
  char32_t awaited_ = 0;                          ///< whose sheet was asked for last, 0 for none
  std::shared_ptr<const CharacterSheet> coming_;  ///< of the one that is being carved
  Tablet tablet_;
  OwnTablet own_;
  std::vector<char32_t> path_;  ///< characters that were shown
  std::size_t step_ = 0;        ///< where in `path_` the learner is
  std::vector<base::Connection> connections_;
};

}  // namespace nazori::practice
