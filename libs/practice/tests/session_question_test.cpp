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
  EXPECT_EQ(question.prompt, Prompt::character);
  EXPECT_FALSE(question.word);
  EXPECT_FALSE(question.sound);
  practise();
  const auto asked = question_of(*session_, shown);
  EXPECT_EQ(asked.shown, 0U) << "what the learner must know is not shown";
  EXPECT_EQ(asked.prompt, Prompt::meaning);
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
    EXPECT_EQ(question.prompt, Prompt::sound);
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
      ASSERT_TRUE(question.word);
      EXPECT_EQ(question.prompt, Prompt::word);
      EXPECT_EQ(question.word->text, "い＿") << "の is not known";
      EXPECT_EQ(question.word->reading, "inu") << "kana would show the answer";
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
  practise();
  EXPECT_EQ(question_of(*session_, bare).prompt, Prompt::strokes);
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
      ASSERT_TRUE(question.word);
      EXPECT_EQ(question.prompt, Prompt::word);
      EXPECT_EQ(question.word->reason, WordReason::asked);
      EXPECT_EQ(question.word->text, "夏＿み");
      EXPECT_EQ(question.word->reading, "なつやすみ");
      EXPECT_THAT(question.word->meanings, ElementsAre("a", "b", "c"));
      EXPECT_THAT(question.meanings, IsEmpty()) << "the word alone is the question";
      EXPECT_THAT(question.readings, IsEmpty());
    } else {
      EXPECT_FALSE(question.word);
    }
    EXPECT_EQ(question.shown, 0U);
    session_->end();
  }
  EXPECT_EQ(by_word, 1) << "one in three";
}

/// 学 with words in the order of their use.
HelpfulWord helpful(const char* text, const char* reading, const char* meaning,
                    std::vector<char32_t> others) {
  HelpfulWord made;
  made.word.text = text;
  made.word.reading = reading;
  made.meanings = {meaning, "more"};
  made.others = std::move(others);
  return made;
}

TEST_F(Question, HasAShortWordWithTheCharacterLeftOutThatTheLearnerKnowsTheRestOf) {
  learn_from({U'学'});
  CharacterSheet given;
  given.character = *learner_->database()->find(U'学');
  given.helpful.words = {
      helpful("学", "がく", "learning", {}),          // alone it asks for too little
      helpful("学ぶ", "まなぶ", "to learn", {}),      // its kun reading asks for it already
      helpful("学々", "がくがく", "again", {U'々'}),  // a sign that repeats it would show where it is
      helpful("大学入学試験", "だいがくにゅうがくしけん", "examination", {U'大', U'入', U'試', U'験'}),
      helpful("学校", "がっこう", "school", {U'校'}),
      helpful("学生", "がくせい", "student", {U'生'}),
  };
  ASSERT_TRUE(session_->start_with({U'学'}));
  session_->enter_stage(study::Stage::memory);
  auto question = question_of(*session_, given);
  ASSERT_TRUE(question.word);
  EXPECT_EQ(question.word->text, "＿校");
  EXPECT_EQ(question.word->reading, "がっこう");
  EXPECT_THAT(question.word->meanings, ElementsAre("school"));
  EXPECT_EQ(question.word->reason, WordReason::helps);
  EXPECT_EQ(question_of(*session_, given), question) << "the same question each time";
  study::Writing writing;
  writing.rating = study::Rating::easy;
  ASSERT_TRUE(learner_->store().add_writing(U'生', 5, writing));
  question = question_of(*session_, given);
  ASSERT_TRUE(question.word);
  EXPECT_EQ(question.word->text, "＿生");
  EXPECT_EQ(question.word->reason, WordReason::known);
  write(true);
  EXPECT_EQ(question_of(*session_, given).word->text, "学生") << "the verdict shows it whole";
}

TEST_F(Question, NeverContainsTheCharacterThatIsAskedFor) {
  const auto database = learner_->database();
  const auto all = database->list(kanji::List::all);
  ASSERT_GT(all.size(), 6000U);
  int with_word = 0;
  // Every tenth with its words; the others differ only in meanings and readings.
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char32_t asked = all[i].code_point;
    auto sheet = std::make_shared<CharacterSheet>();
    sheet->character = *database->find(asked);
    if (i % 10 == 0 || i < 100) sheet->helpful = words_that_help(*database, sheet->character);
    ASSERT_TRUE(session_->start_with({asked}));
    session_->set_sheet(sheet);
    session_->enter_stage(study::Stage::memory);
    ASSERT_TRUE(session_->asks_from_memory());
    for (const auto room : {QuestionRoom::full, QuestionRoom::lines, QuestionRoom::line}) {
      const auto question = shortened(question_of(*session_, *sheet), room);
      EXPECT_EQ(question.shown, 0U);
      std::string text;
      for (const auto& one : question.meanings) text += one + "\n";
      for (const auto& one : question.readings) text += one + "\n";
      if (question.word) {
        with_word += room == QuestionRoom::full ? 1 : 0;
        text += question.word->text + "\n" + question.word->reading + "\n";
        for (const auto& one : question.word->meanings) text += one + "\n";
        EXPECT_NE(question.word->text.find(SessionQuestion::kGap), std::string::npos);
      }
      if (question.sound) {
        for (const char32_t other :
             {asked, static_cast<char32_t>(asked + 0x60), static_cast<char32_t>(asked - 0x60)})
          EXPECT_EQ(text.find(base::encode_utf8(other)), std::string::npos) << text;
      } else {
        EXPECT_EQ(text.find(base::encode_utf8(asked)), std::string::npos) << text;
      }
    }
    session_->end();
  }
  EXPECT_GT(with_word, 300);
}

TEST(QuestionRoom, KeepsWhatTheQuestionNeedsInALowWindow) {
  SessionQuestion question;
  question.prompt = Prompt::meaning;
  question.meanings = {"rest", "day off", "retire"};
  question.readings = {"キュウ", "ク", "やす・む", "やす・まる"};
  question.word = QuestionWord{"＿日", "きゅうじつ", {"holiday", "day off"}, WordReason::helps};
  EXPECT_EQ(shortened(question, QuestionRoom::full), question);
  const auto lines = shortened(question, QuestionRoom::lines);
  EXPECT_THAT(lines.meanings, ElementsAre("rest", "day off"));
  EXPECT_THAT(lines.readings, ElementsAre("キュウ", "ク", "やす・む"));
  EXPECT_THAT(lines.word->meanings, ElementsAre("holiday"));
  const auto line = shortened(question, QuestionRoom::line);
  EXPECT_THAT(line.meanings, ElementsAre("rest"));
  EXPECT_EQ(line.readings.size(), 1U);
  EXPECT_FALSE(line.word);
  question.prompt = Prompt::word;
  EXPECT_TRUE(shortened(question, QuestionRoom::line).word) << "it is the question";
}

TEST(QuestionRoom, GrowsWithTheHeightOfTheWindow) {
  EXPECT_EQ(room_for_question(800.0 / 16), QuestionRoom::full);
  EXPECT_EQ(room_for_question(600.0 / 16), QuestionRoom::full);
  EXPECT_EQ(room_for_question(768.0 / 37), QuestionRoom::line);
  EXPECT_EQ(room_for_question(600.0 / 37), QuestionRoom::line) << "the largest text in the smallest window";
  EXPECT_EQ(room_for_question(1200.0 / 37), QuestionRoom::lines);
}

}  // namespace
}  // namespace nazori::practice
