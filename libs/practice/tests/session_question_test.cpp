// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/session_question.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nazori/base/utf8.h"
#include "session_under_test.h"

namespace nazori::practice {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Question : public SessionTest {
 protected:
  [[nodiscard]] CharacterSheet sheet() const {
    CharacterSheet made;
    made.character = *learner_->database()->find(session_->character());
    return made;
  }
  static kanji::DictionaryEntry entry() {
    kanji::DictionaryEntry made;
    made.on_readings = {"キュウ", "ク", "コウ"};
    made.kun_readings = {"-やす", "やす.む", "やす-", "やす.まる", "いこ.う"};
    for (const char* text : {"rest", "day off", "retire", "sleep", "halt"}) {
      kanji::Meaning meaning;
      meaning.language = "en";
      meaning.text = text;
      made.meanings.push_back(meaning);
    }
    made.meanings.front().language = "fr";
    return made;
  }
};

TEST_F(Question, IsTheCharacterWithItsMeaningsAndReadingsUntilItIsAskedFromMemory) {
  learn_from({U'休'});
  ASSERT_TRUE(session_->start());
  CharacterSheet shown = sheet();
  shown.character.entry = entry();
  const auto question = question_of(*session_, shown);
  EXPECT_EQ(question.shown, U'休');
  EXPECT_THAT(question.meanings, ElementsAre("day off", "retire", "sleep", "halt"));
  EXPECT_THAT(question.readings, ElementsAre("キュウ", "ク", "やす・む", "やす・まる"));
  EXPECT_EQ(question.strokes, 6);
  EXPECT_EQ(question.gap, "");
  EXPECT_FALSE(question.sound);
  practise();
  const auto asked = question_of(*session_, shown);
  EXPECT_EQ(asked.shown, 0U) << "what the learner must know is not shown";
  EXPECT_EQ(asked.meanings, question.meanings);
  write(true);
  EXPECT_EQ(question_of(*session_, shown).shown, U'休');
}

TEST_F(Question, OfAKanaIsItsSoundAndItsSyllabary) {
  learn_from({U'ぬ', U'ヌ'});
  for (const auto script : {kanji::Script::hiragana, kanji::Script::katakana}) {
    ASSERT_TRUE(session_->start());
    EXPECT_EQ(question_of(*session_, sheet()).lookalikes.front(),
              script == kanji::Script::hiragana ? U'め' : U'ス')
        << "beside the kana itself";
    practise();
    const auto question = question_of(*session_, sheet());
    ASSERT_TRUE(question.sound);
    EXPECT_EQ(question.sound->romaji, "nu");
    EXPECT_EQ(question.script, script);
    EXPECT_EQ(question.shown, 0U);
    EXPECT_THAT(question.lookalikes, IsEmpty()) << "they would give it away";
    EXPECT_THAT(question.meanings, IsEmpty());
    EXPECT_THAT(question.readings, IsEmpty());
    write(true);
    session_->rate(study::Rating::easy);
    session_->end();
  }
}

TEST_F(Question, OfAKanaMayBeAWordWhoseOtherKanaAreKnown) {
  session_->set_asks_by_words(true);
  learn_from({U'い', U'ぬ'});
  auto given = std::make_shared<CharacterSheet>();
  given->character = *learner_->database()->find(U'ぬ');
  for (const char* reading : {"ぬの", "いぬ"}) {
    DictationWord one;
    one.word.text = one.word.reading = reading;
    one.word.glosses = {"gloss"};
    const auto kana = base::decode_utf8(reading);
    ASSERT_TRUE(kana);
    for (const char32_t c : *kana) one.characters.push_back(c);
    given->dictation.push_back(one);
  }
  study::Writing writing;
  writing.rating = study::Rating::easy;
  ASSERT_TRUE(learner_->store().add_writing(U'い', 2, writing));
  int by_word = 0;
  for (int review = 0; review < 3; ++review) {
    ASSERT_TRUE(learner_->store().add_writing(U'ぬ', 2, writing));
    const auto& store = learner_->store();
    clock_.advance(*store.card(U'ぬ').due_day - store.today() + std::chrono::days(1));
    ASSERT_TRUE(session_->start());
    while (session_->character() != U'ぬ') session_->postpone();
    session_->set_sheet(given);
    const auto question = question_of(*session_, *given);
    if (session_->word() != nullptr) {
      ++by_word;
      EXPECT_EQ(question.gap, "い◯") << "の is not known";
      EXPECT_EQ(question.reading, "inu") << "kana would show the answer";
    }
    session_->end();
  }
  EXPECT_EQ(by_word, 1) << "one in three";
}

TEST_F(Question, WithoutAnyOfTheseIsANumberOfStrokes) {
  learn_from({U'休'});
  ASSERT_TRUE(session_->start());
  CharacterSheet bare = sheet();
  bare.character.entry = {};
  const auto question = question_of(*session_, bare);
  EXPECT_FALSE(question.sound);
  EXPECT_EQ(question.strokes, 6);
}

TEST_F(Question, OfAReviewMayBeAWordWithAGap) {
  session_->set_asks_by_words(true);
  learn_from({U'休'});
  auto given = std::make_shared<CharacterSheet>();
  given->character = *learner_->database()->find(U'休');
  kanji::Word word;
  word.text = "夏休み";
  word.reading = "なつやすみ";
  word.glosses = {"a", "b", "c", "d"};
  word.common = true;
  given->words = {word};
  int by_word = 0;
  for (int review = 0; review < 3; ++review) {
    study::Writing writing;
    writing.rating = study::Rating::easy;
    ASSERT_TRUE(learner_->store().add_writing(U'休', 6, writing));
    const auto& store = learner_->store();
    clock_.advance(*store.card(U'休').due_day - store.today() + std::chrono::days(1));
    ASSERT_TRUE(session_->start());
    session_->set_sheet(given);
    const auto question = question_of(*session_, *given);
    if (session_->word() != nullptr) {
      ++by_word;
      EXPECT_EQ(question.gap, "夏◯み");
      EXPECT_EQ(question.reading, "なつやすみ");
      EXPECT_THAT(question.meanings, ElementsAre("a", "b", "c"));
    } else {
      EXPECT_EQ(question.gap, "");
    }
    EXPECT_EQ(question.shown, 0U);
    session_->end();
  }
  EXPECT_EQ(by_word, 1) << "one in three";
}

}  // namespace
}  // namespace nazori::practice
