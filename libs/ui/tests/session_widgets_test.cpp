// SPDX-License-Identifier: Apache-2.0
// The bar under the tablet during a session, without a window around it.
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTextDocument>
#include <QWidget>

#include "chosen_session_under_test.h"
#include "study/session_bar.h"
#include "words/study_words.h"

namespace nazori::ui {
namespace {

using study::Rating;
using study::Stage;

class SessionWidgets : public ChosenSessionTest {
 protected:
  struct Bar {
    Bar(practice::StudySession& session, practice::Learner& learner)
        : actions(&window), bar(session, actions, learner, &window) {
      window.resize(1600, 600);
      bar.resize(1500, 200);
      window.show();
    }
    template <class T>
    T* find(const char* name) {
      return window.findChild<T*>(QString::fromLatin1(name));
    }
    QString question() {
      QTextDocument text;
      text.setHtml(find<QLabel>("session_question")->text());
      return text.toPlainText().replace(QChar::Nbsp, QLatin1Char(' ')).simplified();
    }
    QPushButton* rating(const char* name) {
      return find<QPushButton>((std::string("button_rate_") + name).c_str());
    }
    QWidget window;
    SessionActions actions;
    SessionBar bar;
  };
};

TEST_F(SessionWidgets, TheBarIsThereOnlyWhileASessionRuns) {
  Bar all(*session_, *learner_);
  all.bar.show_state(nullptr);
  EXPECT_TRUE(all.bar.isHidden());
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  all.bar.show_state(sheet());
  EXPECT_FALSE(all.bar.isHidden());
}

TEST_F(SessionWidgets, TheBarCountsCharactersAndTime) {
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  Bar all(*session_, *learner_);
  all.bar.show_state(sheet());
  EXPECT_EQ(all.find<QLabel>("session_progress")->text(),
            QStringLiteral("1 of 2 · %1 left").arg(StudyWords::about(session_->time_left())));
  auto* line = all.find<QProgressBar>("session_line");
  EXPECT_EQ(line->minimum(), 0);
  EXPECT_EQ(line->maximum(), 2);
  EXPECT_EQ(line->value(), 0);
  learn();
  session_->rate(Rating::easy);
  all.bar.show_state(sheet());
  EXPECT_TRUE(all.find<QLabel>("session_progress")->text().startsWith(QStringLiteral("2 of 2 ")));
  EXPECT_EQ(line->value(), 1);
}

TEST_F(SessionWidgets, TheQuestionHasFourMeaningsAndTwoReadingsOfEachKindAndNoCharacterFromMemory) {
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  auto asked = bare_sheet();
  auto& entry = asked->character.entry;
  entry.meanings = {{"fr", "un"}, {"en", "one"}, {"en", "a < b"}, {"en", "c"}, {"en", "d"}, {"en", "e"}};
  entry.on_readings = {"イチ", "イツ", "イ"};
  entry.kun_readings = {"ひと-", "-ひ", "ひと.つ", "ふた", "み"};
  Bar all(*session_, *learner_);
  all.bar.show_state(asked);
  const QString words = QStringLiteral("one, a < b, c, d イチ、イツ、ひと・つ、ふた");
  EXPECT_EQ(all.question(), QStringLiteral("一 ") + words);
  practise();
  all.bar.show_state(asked);
  EXPECT_EQ(all.question(), words);
  all.bar.show_state(nullptr);
  EXPECT_EQ(all.question(), QString()) << "it is on its way";
  auto other = std::make_shared<practice::CharacterSheet>(*asked);
  other->character.code_point = U'雨';
  all.bar.show_state(other);
  EXPECT_EQ(all.question(), QString());
}

TEST_F(SessionWidgets, AKanaIsAskedForByItsSoundAndWhatHasNoWordsByItsStrokes) {
  for (const auto& [character, words] :
       {std::pair(U'あ', "hiragana: a"), std::pair(U'ん', "hiragana: n"), std::pair(U'ツ', "katakana: tsu"),
        std::pair(U'ぢ', "hiragana: ji (typed di)"), std::pair(U'ー', "katakana: the long vowel mark"),
        std::pair(U'ァ', "katakana: small a"), std::pair(U'一', "a character with 1 stroke"),
        std::pair(U'二', "a character with 2 strokes")}) {
    learn_from({character});
    ASSERT_TRUE(session_->start()) << words;
    ASSERT_EQ(session_->character(), character);
    practise();
    Bar all(*session_, *learner_);
    all.bar.show_state(bare_sheet());
    EXPECT_EQ(all.question(), QString::fromUtf8(words));
    session_->end();
    ASSERT_TRUE(learner_->store().reset(std::span(&character, 1)));
  }
}

TEST_F(SessionWidgets, AWordAsksWithAGapItsReadingAndThreeMeanings) {
  know(U'八');
  learn_from({});
  session_->set_asks_by_words(true);
  ASSERT_TRUE(session_->start());
  ASSERT_EQ(session_->character(), U'八');
  auto asked = sheet();
  const auto word = [](const char* text, bool common, std::vector<std::string> glosses) {
    kanji::Word made;
    made.text = text;
    made.reading = "はち<";
    made.glosses = std::move(glosses);
    made.common = common;
    return made;
  };
  asked->words = {word("八月", false, {"rare"}),
                  word("八日", true, {}),
                  word("八", true, {"alone"}),
                  word("八八", true, {"twice"}),
                  word("八百屋", true, {"a", "b > c", "d", "e"}),
                  word("八分", true, {"later"})};
  session_->set_sheet(asked);
  ASSERT_NE(session_->word(), nullptr);
  EXPECT_EQ(session_->word()->text, "八百屋");
  Bar all(*session_, *learner_);
  all.bar.show_state(asked);
  EXPECT_EQ(all.question(), QStringLiteral("◯百屋 はち< a; b > c; d"));
  write(true);
  EXPECT_NE(session_->word(), nullptr);
  session_->set_asks_by_words(false);
  session_->set_sheet(asked);
  EXPECT_EQ(session_->word(), nullptr);
}

TEST_F(SessionWidgets, ACharacterIsAskedForByAWordAtEveryThirdReviewAndNeverWhenNew) {
  learn_from({U'八'});
  session_->set_asks_by_words(true);
  ASSERT_TRUE(session_->start());
  auto asked = sheet();
  kanji::Word word;
  word.text = "八月";
  word.glosses = {"August"};
  word.common = true;
  asked->words = {word};
  session_->set_sheet(asked);
  EXPECT_EQ(session_->word(), nullptr) << "it is new";
  session_->end();
  std::vector<bool> by_word;
  for (int review = 0; review < 6; ++review) {
    know(U'八');
    ASSERT_TRUE(session_->start());
    session_->set_sheet(asked);
    by_word.push_back(session_->word() != nullptr);
    session_->end();
  }
  EXPECT_EQ(std::count(by_word.begin(), by_word.end(), true), 2);
  EXPECT_EQ(by_word[0], by_word[3]);
  EXPECT_EQ(by_word[2], by_word[5]);
}

TEST_F(SessionWidgets, TheNextStepIsNamedWhereThereIsOne) {
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  bring(session_->character());
  Bar all(*session_, *learner_);
  auto* next = all.find<QPushButton>("session_next");
  all.bar.show_state(sheet());
  EXPECT_TRUE(next->isHidden());
  session_->finish_stage(Stage::watch, {});
  all.bar.show_state(sheet());
  EXPECT_FALSE(next->isHidden());
  EXPECT_EQ(next->text(), QStringLiteral("Trace  ⏎"));
  bring(U'雨');
  all.bar.show_state(sheet());
  EXPECT_EQ(next->text(), QStringLiteral("Back to the session  ⏎"));
  EXPECT_EQ(all.question(), QStringLiteral("This is not the character you are being asked for."));
  all.actions.show_state(*session_, true);
  int gone_on = 0;
  QObject::connect(all.actions.go_on, &QAction::triggered, &all.window, [&] { ++gone_on; });
  next->click();
  EXPECT_EQ(gone_on, 1);
}

TEST_F(SessionWidgets, AfterAFailureTheNextStepIsTheNextCharacter) {
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  bring(U'八');
  write(false);
  session_->rate(Rating::again);
  ASSERT_EQ(session_->stage(), Stage::guided);
  session_->finish_stage(Stage::guided, {});
  ASSERT_TRUE(session_->is_over());
  Bar all(*session_, *learner_);
  all.bar.show_state(sheet());
  EXPECT_EQ(all.find<QPushButton>("session_next")->text(), QStringLiteral("Next character  ⏎"));
}

TEST_F(SessionWidgets, TheRatingsTakeThePlaceOfTheQuestionOnceItIsJudged) {
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  bring(session_->character());
  practise();
  Bar all(*session_, *learner_);
  all.bar.show_state(sheet());
  EXPECT_FALSE(all.find<QLabel>("session_question")->parentWidget()->isHidden());
  EXPECT_TRUE(all.rating("good")->parentWidget()->isHidden());
  write(true);
  all.bar.show_state(sheet());
  EXPECT_TRUE(all.find<QLabel>("session_question")->parentWidget()->isHidden());
  EXPECT_FALSE(all.rating("good")->parentWidget()->isHidden());
  EXPECT_EQ(all.rating("again")->text(), QStringLiteral("1  Again \nin 1 minute"));
  EXPECT_EQ(all.rating("hard")->text(), QStringLiteral("2  Hard \nin 6 minutes"));
  EXPECT_EQ(all.rating("good")->text(), QStringLiteral("3  Good  ⏎\nin 10 minutes"));
  EXPECT_EQ(all.rating("easy")->text(), QStringLiteral("4  Easy \nin 8 days"));
  EXPECT_EQ(all.rating("good")->accessibleName(), QStringLiteral("Good: in 10 minutes, suggested"));
  EXPECT_EQ(all.rating("easy")->accessibleName(), QStringLiteral("Easy: in 8 days"));
  EXPECT_EQ(all.rating("good")->property("role").toString(), QStringLiteral("primary"));
  EXPECT_EQ(all.rating("easy")->property("role").toString(), QStringLiteral("rating"));
  // In little room they are shorter, two in a row.
  all.bar.resize(300, 200);
  EXPECT_EQ(all.rating("good")->text(), QStringLiteral("3 Good ⏎ · 10 min"));
  EXPECT_EQ(all.rating("easy")->text(), QStringLiteral("4 Easy · 8 d"));
  QCoreApplication::processEvents();
  EXPECT_EQ(all.rating("again")->y(), all.rating("hard")->y());
  EXPECT_LT(all.rating("hard")->y(), all.rating("good")->y());
  EXPECT_LT(all.rating("again")->x(), all.rating("hard")->x());
  all.bar.resize(1500, 200);
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(all.rating("again")->y(), all.rating("easy")->y());
  all.actions.show_state(*session_, true);
  int rated = 0;
  QObject::connect(all.actions.rate[3], &QAction::triggered, &all.window, [&] { ++rated; });
  all.rating("easy")->click();
  EXPECT_EQ(rated, 1);
  bring(U'雨');
  all.bar.show_state(sheet());
  EXPECT_TRUE(all.rating("good")->parentWidget()->isHidden()) << "not while another is shown";
}

}  // namespace
}  // namespace nazori::ui
