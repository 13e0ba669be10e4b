// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/learning_choices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <map>

#include "learner_under_test.h"
#include "nazori/kanji/kana.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using study::NewOrder;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using Kind = KnownAlready::Kind;

class LearningChoices : public LearnerTest {
 protected:
  [[nodiscard]] LearningPlan plan(const LearningAnswers& answers) {
    auto made = plan_learning(*learner_, answers);
    EXPECT_TRUE(made) << (made ? "" : base::to_line(made.error()));
    return made.value_or(LearningPlan{});
  }
  [[nodiscard]] const study::Settings& settings() { return learner_->store().settings(); }
  static std::vector<char32_t> characters(const LearningPlan& plan) {
    std::vector<char32_t> all;
    for (const auto& one : plan.choices.known) all.push_back(one.character);
    return all;
  }
  static LearningAnswers goal(LearningGoal goal) {
    LearningAnswers answers;
    answers.goal = goal;
    return answers;
  }
  static LearningAnswers own(const std::string& text) {
    LearningAnswers answers = goal(LearningGoal::own_list);
    answers.own_text = text;
    answers.list_name = "My list";
    return answers;
  }
  static KnownAlready known(Kind kind, int level = 0) { return {kind, level, {}}; }
};

TEST_F(LearningChoices, EachGoalBeginsWithItsFirstCharacter) {
  const std::pair<LearningGoal, char32_t> firsts[] = {{LearningGoal::hiragana, U'あ'},
                                                      {LearningGoal::katakana, U'ア'},
                                                      {LearningGoal::kanji_by_grade, U'日'},
                                                      {LearningGoal::kanji_by_frequency, U'日'}};
  for (const auto& [what, first] : firsts) EXPECT_EQ(plan(goal(what)).first, first);
  EXPECT_EQ(plan(own("読んでください：鬱病")).first, U'読');
  const auto jlpt = plan(goal(LearningGoal::kanji_by_jlpt));
  EXPECT_EQ(learner_->lists()->facts(jlpt.first)->old_jlpt_level, 4);
}

TEST_F(LearningChoices, NoAnswersChangeNothing) {
  const auto before = settings();
  const auto nothing = plan({});
  EXPECT_EQ(nothing.choices.settings, before);
  EXPECT_FALSE(nothing.choices.list);
  EXPECT_THAT(nothing.choices.known, IsEmpty());
  EXPECT_NE(nothing.first, 0U);
}

TEST_F(LearningChoices, AnAnswerAloneLeavesTheOthersAsTheyAre) {
  auto own_settings = settings();
  own_settings.new_lists = {"grade-2", "list:street", "tag:hard"};
  own_settings.new_order = NewOrder::strokes;
  own_settings.new_per_day = 11;
  own_settings.reviews_per_day = 77;
  ASSERT_TRUE(learner_->store().change_settings(own_settings));
  LearningAnswers minutes;
  minutes.minutes = 20;
  auto changed = plan(minutes).choices.settings;
  EXPECT_EQ(changed.new_lists, own_settings.new_lists);
  EXPECT_EQ(changed.new_order, NewOrder::strokes);
  EXPECT_NE(changed.new_per_day, 11);
  LearningAnswers knows;
  knows.known = known(Kind::kana);
  EXPECT_EQ(plan(knows).choices.settings, own_settings);
  changed = plan(goal(LearningGoal::hiragana)).choices.settings;
  EXPECT_THAT(changed.new_lists, ElementsAre("hiragana", "list:street", "tag:hard"));
  EXPECT_EQ(changed.new_order, NewOrder::strokes);
  EXPECT_EQ(changed.new_per_day, 11);
  EXPECT_EQ(changed.reviews_per_day, 77);
  EXPECT_EQ(plan(goal(LearningGoal::kanji_by_frequency)).choices.settings.new_order, NewOrder::frequency);
}

TEST_F(LearningChoices, TheMinutesOfADayAreNotExceededInTheLongRun) {
  for (const bool kana : {true, false})
    for (const int minutes : daily_minutes()) {
      const auto amount = amount_for(minutes, kana);
      const double per_new_s = kana ? 60 + 6 * 10 : 180 + 10 * 24;
      EXPECT_LE(amount.reviews * 24, minutes * 60) << "reviews alone fit";
      if (minutes * 60 >= per_new_s) {
        EXPECT_NEAR(amount.new_characters * per_new_s, minutes * 60, per_new_s / 2);
      }
    }
  EXPECT_EQ(amount_for(10, true), (DailyAmount{5, 25})) << "あいうえお on the first day";
  EXPECT_EQ(amount_for(5, false).new_characters, 1);
}

TEST_F(LearningChoices, TheAnswersAreToldFromTheSettingsTheyLedTo) {
  for (const auto what : {LearningGoal::hiragana, LearningGoal::katakana, LearningGoal::kanji_by_grade,
                          LearningGoal::kanji_by_jlpt, LearningGoal::kanji_by_frequency})
    for (const int minutes : daily_minutes()) {
      auto answers = goal(what);
      answers.minutes = minutes;
      const auto told = answers_of(plan(answers).choices.settings);
      EXPECT_EQ(told.goal, what);
      EXPECT_EQ(told.minutes, minutes);
    }
  EXPECT_EQ(answers_of(plan(own("休")).choices.settings).goal, LearningGoal::own_list);
  auto others = study::Settings();
  others.new_lists = {"grade-3", "jinmeiyou"};
  others.new_per_day = 17;
  EXPECT_FALSE(answers_of(others).goal);
  EXPECT_FALSE(answers_of(others).minutes);
}

TEST_F(LearningChoices, KanjiUpToAGradeAreKnownWithKanaAndComeInTheOrderOfDoubt) {
  auto answers = goal(LearningGoal::kanji_by_grade);
  answers.known = known(Kind::up_to_grade, 2);
  answers.minutes = 10;
  const auto made = plan(answers);
  const auto all = characters(made);
  EXPECT_THAT(all, Contains(U'日'));
  EXPECT_THAT(all, Contains(U'語'));
  EXPECT_THAT(all, Contains(U'あ'));
  EXPECT_THAT(all, Not(Contains(U'駅'))) << "grade 3";
  EXPECT_EQ(learner_->lists()->facts(made.first)->grade, 3);
  EXPECT_EQ(learner_->lists()->facts(all.front())->grade, 2) << "the hardest is asked first";
  std::map<study::Day, int> a_day;
  for (const auto& one : made.choices.known) ++a_day[*one.due];
  EXPECT_EQ(a_day.begin()->first, learner_->store().today() + days(7));
  for (const auto& [day, count] : a_day) EXPECT_LE(count, made.choices.settings.reviews_per_day / 2);
}

TEST_F(LearningChoices, ALevelOfTheOldJlptIsKnownWithTheEasierOnes) {
  auto answers = goal(LearningGoal::kanji_by_jlpt);
  answers.known = known(Kind::up_to_jlpt, 3);
  const auto made = plan(answers);
  std::map<int, int> levels;
  for (const char32_t one : characters(made))
    if (kanji::script_of(one) == kanji::Script::other)
      ++levels[*learner_->lists()->facts(one)->old_jlpt_level];
  EXPECT_THAT(levels, SizeIs(2));
  EXPECT_GT(levels[3], 0);
  EXPECT_GT(levels[4], 0);
  EXPECT_EQ(learner_->lists()->facts(made.first)->old_jlpt_level, 2);
}

TEST_F(LearningChoices, TheSyllabaryThatIsTheGoalIsNeverMarkedAsKnown) {
  auto answers = goal(LearningGoal::katakana);
  for (const auto& knows : {known(Kind::kana), known(Kind::up_to_grade, 1), known(Kind::up_to_jlpt, 4)}) {
    answers.known = knows;
    const auto made = plan(answers);
    EXPECT_EQ(made.first, U'ア');
    EXPECT_THAT(characters(made), Not(Contains(U'ア')));
    EXPECT_THAT(characters(made), Contains(U'あ'));
  }
}

TEST_F(LearningChoices, TheFirstCharacterIsNoneThatIsKnownOrWasStudied) {
  write(U'あ');
  EXPECT_EQ(plan(goal(LearningGoal::hiragana)).first, U'い');
  auto answers = goal(LearningGoal::hiragana);
  answers.known = KnownAlready{Kind::checked, 0, {U'あ', U'い', U'う'}};
  const auto made = plan(answers);
  EXPECT_EQ(made.first, U'え');
  EXPECT_THAT(characters(made), ElementsAre(U'う', U'い')) << "あ keeps its schedule";
  answers.known->characters = *learner_->lists()->members("hiragana", learner_->store());
  EXPECT_EQ(plan(answers).first, 0U) << "nothing new is left";
}

TEST_F(LearningChoices, TextIsReadForItsKanjiOrElseForItsKana) {
  const auto all = [](char32_t) { return true; };
  EXPECT_THAT(characters_in("休日は, OK 休み。", all), ElementsAre(U'休', U'日'));
  EXPECT_THAT(characters_in("あいア", all), ElementsAre(U'あ', U'い', U'ア'));
  EXPECT_THAT(characters_in("only words", all), IsEmpty());
  EXPECT_THAT(characters_in("休日", [](char32_t one) { return one == U'日'; }), ElementsAre(U'日'));
  EXPECT_FALSE(plan_learning(*learner_, own("abc")));
}

TEST_F(LearningChoices, EveryKanjiAndKanaOfAPastedTextIsKnown) {
  const auto all = [](char32_t) { return true; };
  EXPECT_THAT(kanji_and_kana_in("休日は, OK 休み。", all), ElementsAre(U'休', U'日', U'は', U'み'));
  EXPECT_THAT(kanji_and_kana_in("only words", all), IsEmpty());
  write(U'木');
  auto answers = goal(LearningGoal::hiragana);
  answers.known = known(Kind::listed);
  answers.known_text = "1. 木\t日 (ひ), 鬱";
  const auto made = plan(answers);
  EXPECT_THAT(characters(made), ElementsAre(U'鬱', U'日', U'ひ'))
      << "the hardest first; 木 keeps its schedule; kana that are named are known, whatever is learned";
  ASSERT_TRUE(take_plan(*learner_, made));
  EXPECT_TRUE(learner_->store().card(U'ひ').introduced);
  ASSERT_TRUE(learner_->store().undo());
  EXPECT_FALSE(learner_->store().card(U'ひ').introduced);
  answers.known_text = "nothing to study";
  EXPECT_FALSE(plan_learning(*learner_, answers));
}

TEST_F(LearningChoices, ASecondOwnListGetsItsOwnName) {
  ASSERT_TRUE(take_plan(*learner_, plan(own("休"))));
  ASSERT_TRUE(take_plan(*learner_, plan(own("木林"))));
  EXPECT_THAT(*learner_->store().lists(), ElementsAre(study::CustomList{"My list", {U'休'}},
                                                      study::CustomList{"My list 2", {U'木', U'林'}}));
  EXPECT_THAT(settings().new_lists, ElementsAre("list:My list 2", "list:My list"));
  EXPECT_EQ(plan({}).first, U'木');
}

TEST_F(LearningChoices, TakenInOneStepTheyAreUndoneInOneStep) {
  const auto before = settings();
  auto answers = own("木道");
  answers.minutes = 40;
  answers.known = known(Kind::up_to_grade, 1);
  const auto made = plan(answers);
  EXPECT_EQ(made.first, U'道') << "木 is of grade 1";
  ASSERT_TRUE(take_plan(*learner_, made));
  ASSERT_FALSE(learner_->plan()->now.empty());
  EXPECT_EQ(learner_->plan()->now.front().character, made.first);
  EXPECT_TRUE(is_new(*study::LearnerStore::in_memory()));
  EXPECT_FALSE(is_new(learner_->store()));
  ASSERT_TRUE(learner_->store().undo());
  EXPECT_EQ(settings(), before);
  EXPECT_THAT(*learner_->store().lists(), IsEmpty());
  EXPECT_THAT(learner_->store().cards(), IsEmpty());
}

TEST_F(LearningChoices, ThatCannotBeSavedAreAnnouncedAndNothingIsHalfDone) {
  auto answers = own("木林森");
  answers.known = known(Kind::up_to_grade, 6);
  const auto made = plan(answers);
  const auto before = settings();
  SQLite::Database other(learner_->file().string(), SQLite::OPEN_READWRITE, 1'000);
  other.exec(
      "CREATE TRIGGER full BEFORE INSERT ON log WHEN NEW.kind = 8 BEGIN SELECT RAISE(ABORT, 'full'); END");
  EXPECT_FALSE(take_plan(*learner_, made));
  ASSERT_FALSE(announced_.empty());
  EXPECT_EQ(announced_.back().kind, LearnerEvent::Kind::not_saved);
  EXPECT_EQ(settings(), before);
  EXPECT_THAT(*learner_->store().lists(), IsEmpty());
  EXPECT_THAT(learner_->store().cards(), IsEmpty());
  other.exec("DROP TRIGGER full");
  EXPECT_TRUE(take_plan(*learner_, made)) << "the same plan can be tried again";
}

TEST_F(LearningChoices, ACheckGoesFromEasyToHard) {
  const auto kanji = characters_to_check(*learner_, goal(LearningGoal::kanji_by_grade));
  ASSERT_TRUE(kanji);
  EXPECT_THAT(*kanji, SizeIs(2'136)) << "the jōyō kanji";
  int grade = 1;
  for (const char32_t one : *kanji) {
    const int now = *learner_->lists()->facts(one)->grade;
    EXPECT_GE(now, grade);
    grade = now;
  }
  const auto kana = characters_to_check(*learner_, goal(LearningGoal::katakana));
  ASSERT_TRUE(kana);
  EXPECT_EQ(kana->front(), U'ア');
  EXPECT_EQ(kana->at(5), U'カ');
  const auto frequent = characters_to_check(*learner_, goal(LearningGoal::kanji_by_frequency));
  ASSERT_TRUE(frequent);
  EXPECT_EQ(frequent->front(), U'日');
  const auto levels = characters_to_check(*learner_, goal(LearningGoal::kanji_by_jlpt));
  ASSERT_TRUE(levels);
  EXPECT_EQ(learner_->lists()->facts(levels->front())->old_jlpt_level, 4);
  EXPECT_EQ(learner_->lists()->facts(levels->back())->old_jlpt_level, 1);
  EXPECT_THAT(*characters_to_check(*learner_, own("鬱一駅")), ElementsAre(U'一', U'駅', U'鬱'));
}

}  // namespace
}  // namespace nazori::practice
