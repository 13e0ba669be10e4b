// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_practice.h"

#include <algorithm>
#include <optional>

namespace nazori::practice {
namespace {

/// Shown where the character that was asked for has no strokes.
constexpr char32_t kFallback = U'休';

}  // namespace

CharacterPractice::CharacterPractice(const Parts& parts)
    : control_(parts.tablet), library_(parts.library), workshop_(parts.workshop), session_(parts.session) {
  const StageParts with{parts.inbox,   parts.clock, parts.tablet,
                        parts.library, parts.judge, [this](char32_t one) { return session_.knows(one); }};
  for (const auto& kind : stage_kinds()) stages_.push_back(kind.make(with));
  stage_ = &trace();
  connect_stages();
  connect_session();
  connect_work();
}

CharacterPractice::~CharacterPractice() = default;

void CharacterPractice::connect_stages() {
  for (const auto& made : stages_) {
    auto* const stage = made.get();
    connections_.emplace_back(
        stage->feedback.connect([this, stage](const StageFeedback& what) { feedback(*stage, what); }));
    connections_.emplace_back(stage->hiding_changed.connect([this] { hiding_changed(); }));
    if (const auto lesson = lesson_stage(*stage))
      connections_.emplace_back(
          stage->finished.connect([this, lesson = *lesson](const study::WritingResult& result) {
            session_.finish_stage(lesson, result);
          }));
  }
  auto& memory = this->memory();
  connections_.emplace_back(memory.judged.connect(
      [this, &memory](const writing::Grade& grade) { session_.judge(grade, memory.strokes()); }));
  connections_.emplace_back(
      memory.answer_was_shown.connect([this, &memory] { session_.give_up(memory.strokes()); }));
  connections_.emplace_back(memory.continued.connect([this] { session_.reopen(); }));
  connections_.emplace_back(memory.stroke_added.connect([this] { session_.add_stroke(); }));
  connections_.emplace_back(memory.hint_given.connect([this] { session_.add_hint(); }));
}

void CharacterPractice::connect_session() {
  connections_.emplace_back(session_.character_wanted.connect([this](char32_t character) {
    // What is on the tablet already is studied at once.
    if (sheet_ && tablet_ && sheet_->character.code_point == character) {
      awaited_ = character;
      coming_ = sheet_;
      looks_up_ = false;
      wanted();
      present();
      return;
    }
    show(character, false);
    wanted();
  }));
  connections_.emplace_back(session_.stage_wanted.connect([this](study::Stage stage) {
    if (is_entered_) enter_stage(stage_for(stage));
  }));
  connections_.emplace_back(session_.ended.connect([this] {
    if (is_entered_) begin_stage();
  }));
}

void CharacterPractice::connect_work() {
  connections_.emplace_back(library_.sheet_ready.connect(
      [this](const std::shared_ptr<const CharacterSheet>& sheet) { use_sheet(sheet); }));
  connections_.emplace_back(library_.sheet_missing.connect([this](char32_t character) {
    character_missing(character);
    if (!tablet_ && character != kFallback) show(kFallback, false);
  }));
  connections_.emplace_back(workshop_.carved.connect(
      [this](char32_t character, const Tablet& tablet) { use_tablet(character, tablet); }));
  connections_.emplace_back(workshop_.loaded.connect([this](const OwnTablet& own) { use_own(own); }));
  connections_.emplace_back(
      workshop_.failed.connect([this](const std::filesystem::path&, const base::Error&) {
        // Files that could not be opened leave the tablet as it was; there is none yet at the beginning.
        if (is_entered_ && !tablet_ && awaited_ == 0) show(first_);
      }));
}

PracticeStage* CharacterPractice::stage_named(std::string_view id) const {
  for (const auto& one : stages_)
    if (one->id() == id) return one.get();
  return nullptr;
}

std::optional<study::Stage> CharacterPractice::lesson_stage(const PracticeStage& stage) {
  const auto* const kind = stage_kind(stage.id());
  return kind != nullptr ? kind->lesson : std::nullopt;
}

PracticeStage& CharacterPractice::stage_for(study::Stage stage) const {
  for (const auto& one : stages_)
    if (lesson_stage(*one) == stage) return *one;
  return *stage_;
}

char32_t CharacterPractice::studied_character() const {
  if (session_.is_running() && !session_.is_away()) return session_.character();
  return sheet_ ? sheet_->character.code_point : 0;
}

void CharacterPractice::enter() {
  is_entered_ = true;
  // Back from something else: what was written goes on.
  returns_ = true;
  enter_stage(session_.is_running() && !session_.is_away() ? stage_for(session_.stage()) : *stage_);
  returns_ = false;
  if (!tablet_ && path_.empty() && !session_.is_running()) show(first_);
}

void CharacterPractice::leave() {
  stage_->leave();
  control_.set_guides({});
  is_entered_ = false;
}

void CharacterPractice::enter_stage(PracticeStage& stage) {
  stage_->leave();
  stage_ = &stage;
  stage_changed();
  if (!is_entered_) return;
  if (const auto lesson = lesson_stage(stage))
    session_.enter_stage(*lesson);
  else
    session_.leave_lesson();
  begin_stage();
  hiding_changed();
}

void CharacterPractice::begin_stage() {
  const bool is_lesson = session_.is_running() && !session_.is_away();
  guided().set_help(is_lesson ? std::optional(session_.help()) : std::nullopt);
  for (const auto& stage : stages_)
    stage->set_on_mistake(is_lesson && lesson_stage(*stage)
                              ? [this](int stroke) { return session_.add_mistake(stroke); }
                              : PracticeStage::OnMistake());
  const bool is_unrated = session_.state() == StudySession::State::judged;
  memory().set_resumes(returns_ || (is_lesson && is_unrated), is_unrated);
  stage_->enter({sheet_, tablet_});
}

void CharacterPractice::show(char32_t character, bool remember) {
  if (remember && (path_.empty() || path_[step_] != character)) {
    // A new way from here: what lay ahead is forgotten.
    if (!path_.empty()) path_.resize(step_ + 1);
    path_.push_back(character);
    step_ = path_.size() - 1;
  }
  awaited_ = character;
  looks_up_ = false;
  library_.request_sheet(character);
}

void CharacterPractice::look_up(char32_t character) {
  show(character);
  looks_up_ = true;
}

bool CharacterPractice::asks_for_character(const PracticeStage& stage) {
  const auto lesson = lesson_stage(stage);
  return !lesson || lesson == study::Stage::memory;
}

void CharacterPractice::travel(int by) {
  const auto to = static_cast<std::ptrdiff_t>(step_) + by;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(path_.size())) return;
  step_ = static_cast<std::size_t>(to);
  show(path_[step_], false);
}

void CharacterPractice::use_sheet(const std::shared_ptr<const CharacterSheet>& sheet) {
  if (sheet->character.code_point != awaited_) return;
  coming_ = sheet;
  workshop_.carve(sheet->character);
}

void CharacterPractice::use_tablet(char32_t character, const Tablet& tablet) {
  if (!coming_ || coming_->character.code_point != character) return;
  own_ = {};
  tablet_ = tablet;
  sheet_ = coming_;
  character_arrived(character);
  present();
}

void CharacterPractice::present() {
  session_.set_sheet(sheet_);
  if (is_entered_) {
    auto& due = stage_for(session_.stage());
    if (session_.is_running() && !session_.is_away() && &due != stage_) enter_stage(due);
    // Only now: before, the stage would count for the session's character.
    else if (looks_up_ && asks_for_character(*stage_) && (!session_.is_running() || session_.is_away()))
      enter_stage(trace());
    else
      begin_stage();
  }
  looks_up_ = false;
  hiding_changed();
  if (is_entered_) character_shown(sheet_->character.code_point);
}

void CharacterPractice::use_own(const OwnTablet& loaded) {
  own_ = loaded;
  tablet_ = own_.tablet;
  sheet_ = nullptr;
  wanted();
  // What no dictionary knows can only be traced.
  own_arrived();
  if (stage_ != &trace())
    enter_stage(trace());
  else if (is_entered_)
    begin_stage();
  session_.set_sheet(nullptr);
  own_shown();
  hiding_changed();
}

}  // namespace nazori::practice
