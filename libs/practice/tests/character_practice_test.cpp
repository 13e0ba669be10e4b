// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_practice.h"

#include "nazori/practice/character_choice.h"
#include "nazori/practice/dictation_stage.h"
#include "session_under_test.h"
#include "stage_under_test.h"

namespace nazori::practice {
namespace {

using study::Stage;

/// The practice of characters with a learner and a session, without a device.
class CharacterPracticeTest : public LearnerTest {
 protected:
  CharacterPracticeTest() {
    practice_.character_shown.connect([this](char32_t character) { shown_.push_back(character); });
    practice_.character_missing.connect([this](char32_t character) { missing_.push_back(character); });
    practice_.own_shown.connect([this] { ++own_shown_; });
    practice_.wanted.connect([this] {
      if (enters_when_wanted_) practice_.enter();
    });
    practice_.feedback.connect([this](const PracticeStage& stage, const StageFeedback& what) {
      reports_.emplace_back(stage.id(), what.event);
    });
  }
  void show(char32_t character) {
    const auto before = shown_.size();
    practice_.show(character);
    inbox_.run_until([&] { return shown_.size() > before; });
  }
  [[nodiscard]] Stage stage() const { return *study::stage_named(practice_.current_stage().id()); }
  /// The strokes of the character, one after the other, with a simulated hand.
  void write() {
    const auto subject = practice_.current_stage().subject();
    for (const auto& path : subject.tablet->paths()) {
      std::vector<geometry::TabletPoint> line;
      for (const auto& p : path.points) line.push_back({p.x, p.y});
      hand_.write(line);
    }
  }
  /// A new character, from watching to its rating.
  void study_character() {
    ASSERT_EQ(stage(), Stage::watch);
    practice_.watch().step(+1);
    while (session_.state() == StudySession::State::doing) practice_.watch().step(+1);
    session_.go_on();
    ASSERT_EQ(stage(), Stage::trace);
    write();
    session_.go_on();
    ASSERT_EQ(stage(), Stage::guided);
    write();
    session_.go_on();
    ASSERT_EQ(stage(), Stage::memory);
    write();
    inbox_.run_until([&] { return session_.state() == StudySession::State::judged; });
    session_.rate(study::Rating::good);
  }

  TabletControl tablet_{inbox_, clock_, {}};
  TestHand hand_{tablet_};
  CharacterLibrary library_{inbox_, kanji_db()};
  TabletWorkshop workshop_{inbox_};
  WritingJudge judge_{inbox_, kanji_db()};
  StudySession session_{*learner_, clock_};
  CharacterPractice practice_{{inbox_, clock_, tablet_, library_, workshop_, judge_, session_}};
  std::vector<char32_t> shown_, missing_;
  std::vector<std::pair<std::string_view, StageEvent>> reports_;
  int own_shown_ = 0;
  bool enters_when_wanted_ = true;
};

TEST_F(CharacterPracticeTest, LookingUpShowsTheCharacterWhateverStageWasUsedLast) {
  practice_.enter();
  inbox_.run_until([&] { return !shown_.empty(); });
  const auto look_up = [this](char32_t character) {
    const auto before = shown_.size();
    practice_.look_up(character);
    inbox_.run_until([&] { return shown_.size() > before; });
  };
  for (PracticeStage* asking : {static_cast<PracticeStage*>(&practice_.memory()),
                                static_cast<PracticeStage*>(&practice_.get<DictationStage>())}) {
    practice_.enter_stage(*asking);
    look_up(U'木');
    EXPECT_EQ(stage(), Stage::trace) << asking->id();
    EXPECT_FALSE(practice_.current_stage().hides_character());
  }
  practice_.enter_stage(practice_.watch());
  look_up(U'林');
  EXPECT_EQ(stage(), Stage::watch) << "it shows the character";
  practice_.enter_stage(practice_.memory());
  show(U'木');
  EXPECT_EQ(stage(), Stage::memory) << "the next of a list is asked for as before";
}

TEST_F(CharacterPracticeTest, LookingUpDuringASessionDoesNotChangeItsStage) {
  ASSERT_TRUE(mark_known(*learner_, U'木'));
  ASSERT_TRUE(session_.start_with({U'木'}));
  inbox_.run_until([&] { return !shown_.empty(); });
  ASSERT_EQ(stage(), Stage::memory);
  practice_.look_up(U'林');
  inbox_.run_until([&] { return shown_.size() > 1; });
  EXPECT_TRUE(session_.is_away());
  EXPECT_EQ(stage(), Stage::trace);
  session_.go_on();
  inbox_.run_until([&] { return shown_.size() > 2; });
  EXPECT_EQ(shown_.back(), U'木');
  EXPECT_EQ(stage(), Stage::memory);
}

TEST_F(CharacterPracticeTest, EnteringShowsTheFirstCharacterToBeTraced) {
  practice_.set_first_character(U'木');
  practice_.enter();
  inbox_.run_until([&] { return !shown_.empty(); });
  EXPECT_EQ(shown_, std::vector{U'木'});
  EXPECT_EQ(stage(), Stage::trace);
  EXPECT_EQ(tablet_.stroke_count(), 4);
  EXPECT_EQ(practice_.sheet()->character.code_point, U'木');
  EXPECT_EQ(reports_.back(), std::pair(std::string_view("trace"), StageEvent::draw_from_one));
}

TEST_F(CharacterPracticeTest, TravelsBackAndForwardAlongWhatWasShown) {
  practice_.enter();
  for (const char32_t character : {U'木', U'人', U'休'}) show(character);
  const auto travel = [&](int by) {
    const auto before = shown_.size();
    practice_.travel(by);
    inbox_.run_until([&] { return shown_.size() > before; });
    return shown_.back();
  };
  EXPECT_EQ(travel(-1), U'人');
  EXPECT_EQ(travel(-1), U'木');
  EXPECT_EQ(travel(+1), U'人');
  show(U'永');
  practice_.travel(+1);
  EXPECT_EQ(travel(-1), U'人') << "what lay ahead is forgotten";
}

TEST_F(CharacterPracticeTest, ACharacterWithoutStrokesLeavesTheTabletAsItIs) {
  practice_.enter();
  show(U'木');
  practice_.show(U'☃');
  inbox_.run_until([&] { return !missing_.empty(); });
  EXPECT_EQ(practice_.sheet()->character.code_point, U'木');
}

TEST_F(CharacterPracticeTest, TheFallbackIsShownWhereTheFirstCharacterHasNoStrokes) {
  practice_.set_first_character(U'☃');
  practice_.enter();
  inbox_.run_until([&] { return !shown_.empty(); });
  EXPECT_EQ(shown_, std::vector{U'休'});
  EXPECT_EQ(missing_, std::vector{U'☃'});
}

TEST_F(CharacterPracticeTest, ChangingTheStageLeavesTheOldOneAndBeginsTheNew) {
  practice_.enter();
  show(U'木');
  practice_.enter_stage(practice_.memory());
  EXPECT_FALSE(practice_.trace().is_entered());
  EXPECT_TRUE(practice_.memory().is_entered());
  EXPECT_TRUE(practice_.current_stage().hides_character());
  practice_.leave();
  EXPECT_FALSE(practice_.memory().is_entered());
  practice_.enter();
  EXPECT_EQ(stage(), Stage::memory);
}

TEST_F(CharacterPracticeTest, WhileSomethingElseHasTheTabletAStageIsOnlyChosen) {
  practice_.enter_stage(practice_.guided());
  EXPECT_EQ(stage(), Stage::guided);
  EXPECT_FALSE(practice_.guided().is_entered());
  practice_.show(U'木');
  inbox_.run_until([&] { return practice_.sheet() != nullptr; });
  EXPECT_TRUE(shown_.empty());
  EXPECT_FALSE(practice_.guided().is_entered());
  practice_.enter();
  EXPECT_TRUE(practice_.guided().is_entered());
  EXPECT_EQ(tablet_.stroke_count(), 4);
}

TEST_F(CharacterPracticeTest, ATabletOfTheLearnersOwnIsTraced) {
  practice_.enter();
  show(U'木');
  practice_.enter_stage(practice_.memory());
  OwnTablet own;
  own.name = "own.str";
  own.tablet = StageSubject{nullptr, practice_.tablet()}.tablet;
  workshop_.loaded(own);
  EXPECT_EQ(own_shown_, 1);
  EXPECT_EQ(stage(), Stage::trace);
  EXPECT_TRUE(practice_.trace().is_entered());
  EXPECT_EQ(practice_.sheet(), nullptr);
  EXPECT_EQ(practice_.own().name, "own.str");
  show(U'人');
  EXPECT_FALSE(practice_.own().tablet);
}

TEST_F(CharacterPracticeTest, FilesThatAreLoadedMeanwhileAreNotReplacedByACharacterThatWasAskedForBefore) {
  practice_.enter();
  show(U'木');
  practice_.show(U'人');
  practice_.expect_files();
  bool is_answered = false;
  library_.sheet_ready.connect([&](const auto&) { is_answered = true; });
  inbox_.run_until([&] { return is_answered; });
  EXPECT_EQ(practice_.sheet()->character.code_point, U'木');
}

TEST_F(CharacterPracticeTest, ASessionGoesThroughTheStagesOfANewCharacterAndOnToTheNext) {
  ASSERT_TRUE(learner_->store().save_list({"few", {U'一', U'二'}}));
  auto settings = learner_->store().settings();
  settings.new_lists = {"list:few"};
  settings.new_order = study::NewOrder::own;
  settings.new_per_day = 2;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  learner_->renew_order();
  session_.set_asks_by_words(false);
  ASSERT_TRUE(session_.start());
  inbox_.run_until([&] { return !shown_.empty(); });
  EXPECT_EQ(shown_, std::vector{U'一'});
  EXPECT_EQ(practice_.studied_character(), U'一');
  EXPECT_TRUE(practice_.is_entered()) << "the session has asked for the tablet";
  study_character();
  inbox_.run_until([&] { return shown_.size() == 2; });
  EXPECT_EQ(shown_.back(), U'二');
  study_character();
  EXPECT_EQ(*learner_->store().reviewed_on(learner_->store().today()), (std::vector<char32_t>{U'一', U'二'}));
  EXPECT_TRUE(learner_->store().card(U'一').introduced);
}

TEST_F(CharacterPracticeTest, AStageThatIsNoPartOfTheLessonLeavesTheSessionWhereItIs) {
  ASSERT_TRUE(learner_->store().save_list({"few", {U'一'}}));
  auto settings = learner_->store().settings();
  settings.new_lists = {"list:few"};
  ASSERT_TRUE(learner_->store().change_settings(settings));
  learner_->renew_order();
  ASSERT_TRUE(session_.start());
  inbox_.run_until([&] { return !shown_.empty(); });
  auto& dictation = practice_.get<DictationStage>();
  const auto before = learner_->store().last_entry();
  practice_.enter_stage(dictation);
  inbox_.run_until([&] { return !dictation.is_busy(); });
  EXPECT_TRUE(dictation.is_entered());
  EXPECT_FALSE(dictation.is_lesson());
  EXPECT_EQ(reports_.back().first, DictationStage::kId);
  for (std::size_t i = 0; i < dictation.boxes().size(); ++i) {
    dictation.show_answer();
    dictation.finish_writing();
  }
  EXPECT_EQ(dictation.state(), DictationStage::State::judged);
  EXPECT_EQ(session_.state(), StudySession::State::doing) << "what was written is not saved in the session";
  EXPECT_EQ(session_.stage(), Stage::watch);
  EXPECT_EQ(learner_->store().last_entry(), before);
  practice_.enter_stage(practice_.watch());
  while (session_.state() == StudySession::State::doing) practice_.watch().step(+1);
  EXPECT_EQ(session_.stage(), Stage::trace);
}

TEST_F(CharacterPracticeTest, LookingAtAnotherCharacterLeavesTheSessionWhereItIs) {
  ASSERT_TRUE(learner_->store().save_list({"few", {U'一'}}));
  auto settings = learner_->store().settings();
  settings.new_lists = {"list:few"};
  ASSERT_TRUE(learner_->store().change_settings(settings));
  learner_->renew_order();
  ASSERT_TRUE(session_.start());
  inbox_.run_until([&] { return !shown_.empty(); });
  show(U'木');
  EXPECT_TRUE(session_.is_away());
  EXPECT_EQ(practice_.studied_character(), U'木');
  session_.go_on();
  inbox_.run_until([&] { return shown_.back() == U'一'; });
  EXPECT_FALSE(session_.is_away());
  session_.end();
  EXPECT_FALSE(session_.is_running());
  EXPECT_TRUE(practice_.current_stage().is_entered());
}

}  // namespace
}  // namespace nazori::practice
