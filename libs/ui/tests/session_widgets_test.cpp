// SPDX-License-Identifier: Apache-2.0
// What stands above and under the tablet during a session, without a window around it.
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>
#include <QTextDocument>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include "chosen_session_under_test.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/words/study_words.h"
#include "study/question_view.h"
#include "study/session_answers.h"
#include "study/session_bar.h"

namespace nazori::ui {
namespace {

using study::Rating;
using study::Stage;

class SessionWidgets : public ChosenSessionTest {
 protected:
  struct Bar {
    Bar(practice::StudySession& session, practice::Learner& learner)
        : actions(&window),
          bar(session, actions, &window),
          question_view(session, action("show_right", "Show", Qt::Key_D), &window),
          answers(session, actions, learner, {action("hint", "Hint", Qt::Key_H)}, &window),
          show(window.findChild<QAction*>(QStringLiteral("show_right"))),
          finish(action("done", "Finish", Qt::Key_Return)) {
      auto* hint = window.findChild<QAction*>(QStringLiteral("hint"));
      actions.set_one_hand(OneHand::none, hint, hint, finish);
      auto* column = new QVBoxLayout(&window);
      column->setContentsMargins(0, 0, 0, 0);
      column->addWidget(&bar);
      column->addWidget(&question_view);
      column->addStretch(1);
      column->addWidget(&answers);
      window.resize(1600, 800);
      window.show();
      for (auto* line : question_view.findChildren<SpokenLine*>())
        QObject::connect(line, &SpokenLine::spoken, &window,
                         [this](const QString& text) { spoken.append(text); });
    }
    void show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet) {
      bar.show_state();
      question_view.show_state(
          sheet, {QStringLiteral("Not quite"), QStringLiteral("Not quite."), QStringLiteral("Not")});
      answers.show_state();
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
    QAction* action(const char* name, const char* text, Qt::Key key) {
      auto* made = new QAction(QString::fromLatin1(text), &window);
      made->setObjectName(QString::fromLatin1(name));
      made->setShortcut(key);
      return made;
    }
    QWidget window;
    SessionActions actions;
    SessionBar bar;
    QuestionView question_view;
    SessionAnswers answers;
    QAction* show;
    QAction* finish;
    QStringList spoken;
  };
};

TEST_F(SessionWidgets, TheBarIsThereOnlyWhileASessionRuns) {
  Bar all(*session_, *learner_);
  all.show_state(nullptr);
  EXPECT_TRUE(all.bar.isHidden());
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  all.show_state(sheet());
  EXPECT_FALSE(all.bar.isHidden());
}

TEST_F(SessionWidgets, TheBarCountsCharactersAndTime) {
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  Bar all(*session_, *learner_);
  all.show_state(sheet());
  EXPECT_EQ(all.find<QLabel>("session_progress")->text(), QStringLiteral("1 of 2"));
  EXPECT_EQ(all.find<QLabel>("session_time")->text(), QStringLiteral("6 min left")) << "three minutes each";
  auto* line = all.find<QProgressBar>("session_line");
  EXPECT_EQ(line->minimum(), 0);
  EXPECT_EQ(line->maximum(), 2);
  EXPECT_EQ(line->value(), 0);
  learn();
  session_->rate(Rating::easy);
  all.show_state(sheet());
  EXPECT_TRUE(all.find<QLabel>("session_progress")->text().startsWith(QStringLiteral("2 of 2")));
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
  all.show_state(asked);
  const QString words = QStringLiteral("one, a < b, c, d イチ、イツ、ひと・つ、ふた");
  EXPECT_EQ(all.question(), QStringLiteral("一 ") + words);
  practise();
  all.show_state(asked);
  EXPECT_EQ(all.question(), words);
  all.show_state(nullptr);
  EXPECT_EQ(all.question(), QString()) << "it is on its way";
  auto other = std::make_shared<practice::CharacterSheet>(*asked);
  other->character.code_point = U'雨';
  all.show_state(other);
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
    all.show_state(bare_sheet());
    EXPECT_EQ(all.question(), QString::fromUtf8(words));
    EXPECT_EQ(all.find<QLabel>("session_question")->accessibleName(), QString::fromUtf8(words));
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
  all.show_state(asked);
  EXPECT_EQ(all.question(), QStringLiteral("＿百屋 はち< a; b > c; d"));
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
  all.show_state(sheet());
  EXPECT_TRUE(next->isHidden());
  session_->finish_stage(Stage::watch, {});
  all.show_state(sheet());
  EXPECT_FALSE(next->isHidden());
  EXPECT_EQ(next->text(), QStringLiteral("Trace  ⏎"));
  bring(U'雨');
  all.show_state(sheet());
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
  all.show_state(sheet());
  EXPECT_EQ(all.find<QPushButton>("session_next")->text(), QStringLiteral("Next character  ⏎"));
}

TEST_F(SessionWidgets, TheVerdictTakesThePlaceOfTheQuestionAndTheRatingsThatOfTheHelp) {
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  bring(session_->character());
  practise();
  Bar all(*session_, *learner_);
  all.show_state(sheet());
  EXPECT_FALSE(all.find<QLabel>("session_question")->isHidden());
  EXPECT_TRUE(all.find<QPushButton>("session_next")->isVisible());
  EXPECT_EQ(all.find<QPushButton>("session_next")->text(), QStringLiteral("Finish  ⏎"));
  EXPECT_EQ(all.find<QPushButton>("button_hint")->text(), QStringLiteral("Hint  H"));
  EXPECT_FALSE(all.rating("good")->isVisible());
  const QString question = all.question();
  const int height = all.question_view.height();
  int finished = 0;
  QObject::connect(all.finish, &QAction::triggered, &all.window, [&] { ++finished; });
  all.find<QPushButton>("session_next")->click();
  EXPECT_EQ(finished, 1) << "the button does what its key does";
  write(true);
  all.show->setEnabled(false);
  all.show_state(sheet());
  QCoreApplication::processEvents();
  EXPECT_TRUE(all.find<QLabel>("session_question")->isHidden());
  EXPECT_FALSE(all.find<QPushButton>("button_show_right")->isVisible()) << "nothing is wrong";
  all.show->setEnabled(true);
  EXPECT_TRUE(all.find<QPushButton>("button_show_right")->isVisible());
  EXPECT_EQ(all.find<QPushButton>("button_show_right")->text(), QStringLiteral("▶ Show  D"));
  EXPECT_TRUE(all.find<QLabel>("session_verdict")->text().contains(QStringLiteral("✓")));
  EXPECT_EQ(all.find<QLabel>("session_verdict")->accessibleName(), QStringLiteral("Not quite."));
  EXPECT_EQ(all.find<QLabel>("session_answer")->text().toUcs4().value(0), session_->character());
  EXPECT_EQ(all.question_view.height(), height) << "the tablet does not move";
  EXPECT_EQ(all.rating("again")->text(), QStringLiteral("1  Again  in 1 minute"));
  EXPECT_EQ(all.rating("hard")->text(), QStringLiteral("2  Hard  in 6 minutes"));
  EXPECT_EQ(all.rating("good")->text(), QStringLiteral("3  Good  in 10 minutes  ⏎"));
  EXPECT_EQ(all.rating("easy")->text(), QStringLiteral("4  Easy  in 8 days"));
  EXPECT_EQ(all.rating("good")->accessibleName(), QStringLiteral("Good: in 10 minutes, suggested"));
  EXPECT_EQ(all.rating("easy")->accessibleName(), QStringLiteral("Easy: in 8 days"));
  EXPECT_EQ(all.rating("good")->property("role").toString(), QStringLiteral("primary"));
  EXPECT_EQ(all.rating("easy")->property("role").toString(), QStringLiteral("rating"));
  // In little room they are shorter, two in a row.
  all.window.resize(320, 800);
  QCoreApplication::processEvents();
  EXPECT_EQ(all.rating("good")->text(), QStringLiteral("3  Good  10 min  ⏎"));
  EXPECT_EQ(all.rating("easy")->text(), QStringLiteral("4  Easy  8 d"));
  EXPECT_EQ(all.rating("again")->y(), all.rating("hard")->y());
  EXPECT_LT(all.rating("hard")->y(), all.rating("good")->y());
  EXPECT_LT(all.rating("again")->x(), all.rating("hard")->x());
  all.window.resize(1600, 800);
  QCoreApplication::processEvents();
  EXPECT_EQ(all.rating("again")->y(), all.rating("easy")->y());
  all.actions.show_state(*session_, true);
  int rated = 0;
  QObject::connect(all.actions.rate[3], &QAction::triggered, &all.window, [&] { ++rated; });
  all.rating("easy")->click();
  EXPECT_EQ(rated, 1);
  bring(U'雨');
  all.show_state(sheet());
  EXPECT_FALSE(all.rating("good")->isVisible()) << "not while another is shown";
}

TEST_F(SessionWidgets, AQuestionIsSpokenOnceAndWithoutTheCharacter) {
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  bring(U'八');
  Bar all(*session_, *learner_);
  for (int i = 0; i < 3; ++i) all.show_state(sheet());
  all.window.resize(1600, 500);
  all.window.resize(900, 900);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !all.spoken.isEmpty(); }, 20000));
  QTest::qWait(0);
  ASSERT_EQ(all.spoken.size(), 1) << all.spoken.join(QLatin1Char('|')).toStdString();
  EXPECT_TRUE(all.spoken[0].startsWith(QStringLiteral("eight")));
  EXPECT_FALSE(all.spoken[0].contains(QStringLiteral("八")));
}

TEST_F(SessionWidgets, AWindowThatIsMadeLowerAsksInOneLine) {
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  auto asked = bare_sheet();
  asked->character.entry.meanings = {{"en", "eight"}, {"en", "eight radical"}};
  asked->character.entry.on_readings = {"ハチ", "ハツ"};
  Bar all(*session_, *learner_);
  all.show_state(asked);
  QCoreApplication::processEvents();
  EXPECT_TRUE(all.question().contains(QStringLiteral("eight radical")));
  const int high = all.question_view.height();
  all.window.resize(1600, 16 * QFontInfo(all.window.font()).pixelSize());
  QCoreApplication::processEvents();
  EXPECT_EQ(all.question(), QStringLiteral("eight ハツ"));
  EXPECT_LT(all.question_view.height(), high / 2);
  all.window.resize(1600, 800);
  QCoreApplication::processEvents();
  EXPECT_TRUE(all.question().contains(QStringLiteral("eight radical")));
  EXPECT_EQ(all.question_view.height(), high);
}

TEST_F(SessionWidgets, TheMenuHoldsWhatElseCanBeDoneWithTheCharacter) {
  learn_from({U'一'});
  ASSERT_TRUE(session_->start());
  Bar all(*session_, *learner_);
  const auto* menu = all.find<QToolButton>("session_menu")->menu();
  QStringList names;
  for (const auto* action : menu->actions())
    if (!action->isSeparator()) {
      names.append(action->objectName());
      EXPECT_FALSE(action->shortcut().isEmpty()) << action->objectName().toStdString();
    }
  EXPECT_EQ(names, (QStringList{QStringLiteral("study_reset"), QStringLiteral("study_postpone"),
                                QStringLiteral("study_pause"), QStringLiteral("study_tags"),
                                QStringLiteral("study_settings"), QStringLiteral("study_end")}));
}

}  // namespace
}  // namespace nazori::ui
