// SPDX-License-Identifier: Apache-2.0
// The first start: three questions, the test of what is known, and the first character.
#include <QAbstractButton>
#include <QAccessible>
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>

#include <SQLiteCpp/SQLiteCpp.h>

#include "characters/characters.h"
#include "hand_under_test.h"
#include "nazori/widgets/controls/input_pause.h"
#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/page/window_parts.h"
#include "pointing_under_test.h"
#include "start/check_page.h"
#include "start/start_page.h"
#include "study/home.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

class WindowStart : public WindowTest {
 protected:
  WindowStart() {
    pages_ = {make_home,
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); },
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<StartPage>(parts); },
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<CheckPage>(parts); }};
    clock_ = [] { return *study::parse_time("2026-03-02T10:00Z"); };
  }
  void SetUp() override {
    install_language(QStringLiteral("en"));
    open();
  }
  static std::unique_ptr<Page> make_home(WindowParts& parts) {
    the_parts = &parts;
    return std::make_unique<Home>(parts);
  }

  void open() {
    window_.reset();
    window_ = std::make_unique<MainWindow>(setup(), appearance_);
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    ASSERT_TRUE(opened.count() > 0 || opened.wait(20000));
    window_->resize(1280, 800);
    QCoreApplication::processEvents();
  }
  void choose(const char* button) { find<QAbstractButton>(button)->click(); }
  [[nodiscard]] bool is_shown() { return find("start_page")->isVisible(); }
  QString button() { return find<QPushButton>("start_write")->text(); }
  static study::LearnerStore& store() { return the_parts->learner().store(); }
  static practice::StudySession& session() { return the_parts->session(); }
  static practice::PlacementRun& placement() { return the_parts->placement(); }
  [[nodiscard]] std::filesystem::path file() {
    return std::filesystem::path(folder_.filePath(QStringLiteral("learners")).toStdString()) / "learner" /
           "learner.db";
  }
  void start_check() {
    choose("start_check");
    EXPECT_EQ(button(), QStringLiteral("Start the test"));
    press(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(find("check_bar")->isVisible());
  }
  /// Answers as a learner who can write nothing.
  void know_nothing() {
    while (placement().is_running()) action("check_unknown")->trigger();
  }
  /// After a test no press counts for a moment.
  [[nodiscard]] bool listens_again() {
    return QTest::qWaitFor([this] { return !find("start_page")->findChild<InputPause*>()->is_on(); }, 20'000);
  }

  static inline WindowParts* the_parts = nullptr;
};

TEST_F(WindowStart, ComesFirstAndOneKeyBeginsTheFirstCharacter) {
  ASSERT_TRUE(is_shown());
  EXPECT_EQ(button(), QStringLiteral("Write あ"));
  EXPECT_TRUE(find("start_write")->hasFocus());
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  QTest::keyClick(find("start_write"), Qt::Key_Return);
  ASSERT_TRUE(session().is_running());
  EXPECT_EQ(session().character(), U'あ');
  ASSERT_TRUE(shown.wait(20000));
  EXPECT_FALSE(is_shown());
  EXPECT_TRUE(action("watch")->isChecked()) << "the lesson begins";
  EXPECT_EQ(store().settings().new_per_day, 5);
  EXPECT_EQ(store().settings().new_lists, std::vector<std::string>{"hiragana"});
}

TEST_F(WindowStart, IsNotAmongThePagesOfTheRailAndNotAskedAgain) {
  EXPECT_EQ(action("go_start"), nullptr);
  press(Qt::Key_Return);
  open();
  EXPECT_FALSE(is_shown());
  EXPECT_TRUE(find("home_page")->isVisible());
}

TEST_F(WindowStart, SkippedLeavesTheDefaultsAndComesOnlyWithTheMenu) {
  press(Qt::Key_Escape);
  EXPECT_TRUE(find("home_page")->isVisible());
  EXPECT_EQ(store().settings(), study::Settings());
  EXPECT_EQ(store().last_entry(), 0);
  window_->close();
  open();
  EXPECT_TRUE(find("home_page")->isVisible());
  ASSERT_EQ(action("home_choices")->shortcut(), QKeySequence(QStringLiteral("Ctrl+Shift+G")));
  action("home_choices")->trigger();
  EXPECT_TRUE(is_shown());
  EXPECT_EQ(button(), QStringLiteral("Write あ"));
}

TEST_F(WindowStart, KeysAloneChooseEveryAnswer) {
  find("start_hiragana")->setFocus();
  press(Qt::Key_Right);
  EXPECT_EQ(button(), QStringLiteral("Write ア"));
  press(Qt::Key_Right);
  EXPECT_EQ(button(), QStringLiteral("Write 日"));
  EXPECT_TRUE(find("start_by_jlpt")->isVisible());
  press(Qt::Key_Tab);
  EXPECT_TRUE(find("start_by_grade")->hasFocus());
  press(Qt::Key_Tab);
  EXPECT_TRUE(find("start_nothing")->hasFocus()) << "one stop for each row";
  press(Qt::Key_Right);
  press(Qt::Key_Right);
  EXPECT_TRUE(find("start_some_kanji")->hasFocus());
  press(Qt::Key_Tab);
  ASSERT_TRUE(find("start_level")->hasFocus());
  press(Qt::Key_Down);
  EXPECT_NE(button(), QStringLiteral("Write 日")) << "grade 2 is known";
  press(Qt::Key_Tab);
  EXPECT_TRUE(find("start_minutes_10")->hasFocus()) << window_->focusWidget()->objectName().toStdString();
  press(Qt::Key_Right);
  EXPECT_TRUE(find("start_minutes_20")->hasFocus());
  press(Qt::Key_Return);
  EXPECT_TRUE(session().is_running());
  EXPECT_EQ(store().settings().new_per_day, 3);
  EXPECT_EQ(the_parts->learner().lists()->facts(session().character())->grade, 3);
}

TEST_F(WindowStart, TabGoesFromTheButtonToTheQuestions) {
  ASSERT_TRUE(find("start_write")->hasFocus());
  for (const char* next : {"start_hiragana", "start_nothing", "start_minutes_10", "start_skip"}) {
    press(Qt::Key_Tab);
    EXPECT_TRUE(find(next)->hasFocus())
        << next << ", not " << window_->focusWidget()->objectName().toStdString();
  }
}

TEST_F(WindowStart, EveryAnswerIsSpokenWithItsQuestion) {
  const auto spoken = [this](const char* name) {
    auto* access = QAccessible::queryAccessibleInterface(find(name));
    EXPECT_EQ(access->role(), QAccessible::RadioButton) << name;
    return access->text(QAccessible::Name);
  };
  EXPECT_EQ(spoken("start_katakana"), QStringLiteral("What would you like to write?: Katakana"));
  EXPECT_EQ(spoken("start_kana"), QStringLiteral("What can you write already?: I know katakana"));
  EXPECT_EQ(spoken("start_minutes_40"), QStringLiteral("How long a day?: 40 min"));
  EXPECT_FALSE(find("start_level")->accessibleName().isEmpty());
  EXPECT_FALSE(find("start_own_text")->accessibleName().isEmpty());
}

TEST_F(WindowStart, TheWholeChoiceIsOneUndo) {
  choose("start_own");
  find<QPlainTextEdit>("start_own_text")->setPlainText(QStringLiteral("道に車がいっぱい"));
  EXPECT_EQ(text("start_own_found"), QStringLiteral("2 characters: 道車"));
  choose("start_some_kanji");
  press(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(session().is_running());
  EXPECT_EQ(session().character(), U'道');
  EXPECT_GT(store().cards().size(), 80U);
  session().undo();
  EXPECT_TRUE(store().cards().empty());
  EXPECT_EQ(store().settings(), study::Settings());
  EXPECT_TRUE(store().lists()->empty());
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Undone: what you chose to learn")))
      << feedback().toStdString();
}

TEST_F(WindowStart, APastedTextIsKnownAndCountedBeforeItIsSaved) {
  choose("start_kanji");
  choose("start_listed");
  EXPECT_FALSE(find("start_write")->isEnabled()) << "nothing is pasted yet";
  EXPECT_EQ(text("start_trouble"), QStringLiteral("Type or paste the characters that you know."));
  find<QPlainTextEdit>("start_known_text")->setPlainText(QStringLiteral("日\t1\n一, sun 日の"));
  EXPECT_EQ(text("start_known_found"), QStringLiteral("3 characters will be marked as known: の日一"));
  EXPECT_EQ(button(), QStringLiteral("Write 人"));
  press(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(session().is_running());
  EXPECT_EQ(session().character(), U'人');
  EXPECT_EQ(store().cards().size(), 3U);
  session().end();
  action("home_choices")->trigger();
  choose("start_listed");
  find<QPlainTextEdit>("start_known_text")->setPlainText(QStringLiteral("日本"));
  EXPECT_EQ(
      text("start_known_found"),
      QStringLiteral(
          "1 character will be marked as known: 本\n1 character is already studied and stays as it is."));
  press(Qt::Key_Escape);
  session().undo();
  EXPECT_TRUE(store().cards().empty()) << "one undo for all";
}

TEST_F(WindowStart, AFailureKeepsThePageWithItsAnswers) {
  choose("start_katakana");
  choose("start_some_kanji");
  SQLite::Database other(file().string(), SQLite::OPEN_READWRITE, 1'000);
  other.exec(
      "CREATE TRIGGER full BEFORE INSERT ON log WHEN NEW.kind = 8 BEGIN SELECT RAISE(ABORT, 'full'); END");
  press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(is_shown());
  EXPECT_FALSE(session().is_running());
  EXPECT_FALSE(feedback().isEmpty());
  EXPECT_TRUE(find<QAbstractButton>("start_katakana")->isChecked());
  EXPECT_TRUE(find<QAbstractButton>("start_some_kanji")->isChecked());
  EXPECT_TRUE(store().cards().empty());
  other.exec("DROP TRIGGER full");
  press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(session().is_running());
  EXPECT_EQ(session().character(), U'ア');
}

TEST_F(WindowStart, AnOwnListWithoutCharactersSaysWhatIsMissing) {
  choose("start_own");
  EXPECT_FALSE(find("start_write")->isEnabled());
  EXPECT_TRUE(find("start_trouble")->isVisible());
  find<QPlainTextEdit>("start_own_text")->setPlainText(QStringLiteral("鬱"));
  EXPECT_TRUE(find("start_write")->isEnabled());
  EXPECT_FALSE(find("start_trouble")->isVisible());
  EXPECT_EQ(button(), QStringLiteral("Write 鬱"));
}

TEST_F(WindowStart, AskedAgainOnlyWhatIsChangedChanges) {
  choose("start_own");
  find<QPlainTextEdit>("start_own_text")->setPlainText(QStringLiteral("道"));
  press(Qt::Key_Return, Qt::ControlModifier);
  auto settings = store().settings();
  settings.new_per_day = 17;
  ASSERT_TRUE(store().change_settings(settings));
  session().end();
  action("home_choices")->trigger();
  ASSERT_TRUE(is_shown());
  EXPECT_TRUE(find<QAbstractButton>("start_own")->isChecked());
  EXPECT_FALSE(find<QAbstractButton>("start_minutes_10")->isChecked());
  EXPECT_EQ(button(), QStringLiteral("Write 道")) << "the list of before";
  choose("start_hiragana");
  press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(store().settings().new_per_day, 17);
  EXPECT_EQ(store().settings().new_lists, (std::vector<std::string>{"hiragana", "list:My list"}));
  EXPECT_EQ(session().character(), U'あ');
}

TEST_F(WindowStart, TheTestEndsWithAResultThatCanBeTakenOrRefused) {
  choose("start_kanji");
  start_check();
  EXPECT_FALSE(text("check_question").isEmpty());
  EXPECT_FALSE(find("session_bar")->isVisible()) << "there is no session";
  EXPECT_EQ(feedback(), QStringLiteral("Write: %1").arg(text("check_question")));
  QStringList said;
  QObject::connect(the_parts, &WindowParts::announced, window_.get(),
                   [&said](Feedback, const QString& sentence) { said.append(sentence); });
  int questions = 0;
  // A learner who can write the kanji of grade 1 and 2.
  auto& lists = *the_parts->learner().lists();
  const auto all = *practice::characters_to_check(the_parts->learner(), {});
  while (placement().is_running() && questions < 30) {
    const auto asked = std::find_if(all.begin(), all.end(), [&](char32_t one) {
      return practice::question_about(*the_parts->learner().database()->find(one)) == *placement().question();
    });
    ASSERT_NE(asked, all.end());
    ++questions;
    if (*lists.facts(*asked)->grade > 2) {
      action("check_unknown")->trigger();
      continue;
    }
    const auto before = placement().answered();
    double time_s = 0;
    for (const auto& line : test::model(*asked)) {
      const practice::HandStroke stroke = test::hand_stroke(line, time_s);
      time_s = stroke.back().time_s.value_or(0);
      placement().add_stroke(stroke);
    }
    action("check_done")->trigger();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return !placement().is_running() || placement().answered() > before; }, 20000));
  }
  EXPECT_GE(questions, 12);
  EXPECT_LE(questions, 14);
  ASSERT_TRUE(is_shown()) << "the result comes with the questions";
  EXPECT_TRUE(text("start_result").contains(QStringLiteral("of the 2,136 school kanji, up to grade")))
      << text("start_result").toStdString();
  EXPECT_FALSE(said.join(QLatin1Char(' ')).contains(QStringLiteral("Session")))
      << "no session was there to be summed up: " << said.join(QLatin1Char('\n')).toStdString();
  EXPECT_TRUE(store().cards().empty()) << "nothing is marked before it is taken";
  choose("start_refuse");
  EXPECT_EQ(button(), QStringLiteral("Write 日"));
  choose("start_take");
  ASSERT_TRUE(listens_again());
  press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_NEAR(static_cast<double>(store().cards().size()), 240, 60);
  EXPECT_TRUE(store().study_days()->empty()) << "nothing of it was written today";
}

TEST_F(WindowStart, TheTestCanBeEndedFromItsMenuWithoutAResult) {
  choose("start_kanji");
  start_check();
  bool in_menu = false;
  for (auto* menu : window_->menuBar()->actions())
    in_menu = in_menu || menu->menu()->actions().contains(action("check_end"));
  EXPECT_TRUE(in_menu);
  ASSERT_TRUE(action("check_end")->isEnabled());
  action("check_unknown")->trigger();
  action("check_end")->trigger();
  EXPECT_FALSE(placement().is_running());
  ASSERT_TRUE(is_shown());
  EXPECT_TRUE(find<QAbstractButton>("start_kanji")->isChecked()) << "the answers are still there";
  EXPECT_EQ(button(), QStringLiteral("Start the test"));
  EXPECT_FALSE(find("start_result")->isVisible());
  EXPECT_EQ(store().last_entry(), 0);
}

TEST_F(WindowStart, GoingToAnotherPageEndsTheTest) {
  start_check();
  action("go_home")->trigger();
  EXPECT_FALSE(placement().is_running());
  EXPECT_TRUE(find("home_page")->isVisible());
  EXPECT_FALSE(find("check_buttons")->isVisible());
}

TEST_F(WindowStart, ABeginnerIsToldSoAndNothingIsMarked) {
  start_check();
  know_nothing();
  ASSERT_TRUE(is_shown());
  EXPECT_EQ(text("start_result"), QStringLiteral("You are at the beginning. Nothing is marked as known."));
  EXPECT_EQ(feedback(), text("start_result")) << "a screen reader says it";
  ASSERT_TRUE(listens_again());
  press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(session().character(), U'あ');
  EXPECT_TRUE(store().cards().empty());
}

TEST_F(WindowStart, OnePressTooManyInTheTestDoesNotTakeItsResult) {
  start_check();
  know_nothing();
  ASSERT_TRUE(is_shown());
  QTest::mouseClick(find("start_write"), Qt::LeftButton);
  QTest::mouseDClick(find("start_write"), Qt::LeftButton);
  QTest::keyClick(find("start_write"), Qt::Key_Return);
  press(Qt::Key_Return, Qt::ControlModifier);
  press(Qt::Key_Escape);
  EXPECT_TRUE(is_shown());
  EXPECT_FALSE(session().is_running());
  EXPECT_FALSE(text("start_result").isEmpty());
  ASSERT_TRUE(listens_again());
  QTest::mouseClick(find("start_write"), Qt::LeftButton);
  EXPECT_TRUE(session().is_running());
}

TEST_F(WindowStart, KanaKnownBesideASyllabaryThatIsLearnedMeansTheOtherOne) {
  const auto known = [this] { return find<QAbstractButton>("start_kana")->text(); };
  EXPECT_EQ(known(), QStringLiteral("I know katakana"));
  choose("start_katakana");
  EXPECT_EQ(known(), QStringLiteral("I know hiragana"));
  EXPECT_EQ(find("start_kana")->accessibleName(),
            QStringLiteral("What can you write already?: I know hiragana"));
  choose("start_kana");
  EXPECT_EQ(button(), QStringLiteral("Write ア"));
  press(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(session().is_running());
  EXPECT_TRUE(store().card(U'あ').introduced);
  EXPECT_FALSE(store().card(U'ア').introduced);
  session().undo();
  session().end();
  action("home_choices")->trigger();
  choose("start_kanji");
  EXPECT_EQ(known(), QStringLiteral("I know kana"));
}

TEST_F(WindowStart, TheButtonIsInSightHoweverLittleRoomThereIs) {
  for (const char* goal : {"start_hiragana", "start_kanji", "start_own"}) {
    choose(goal);
    set_text_size(28, 800, 600);
    for (const char* name : {"start_write", "start_skip"}) {
      const QWidget& one = *find(name);
      EXPECT_EQ(one.visibleRegion().boundingRect(), one.rect()) << name << " beside " << goal;
    }
    EXPECT_TRUE(window_->rect().contains(
        QRect(find("start_write")->mapTo(window_.get(), QPoint()), find("start_write")->size())));
  }
  choose("start_hiragana");
  set_text_size(12, 1600, 1400);
  const auto y_of = [this](const char* name) { return find(name)->mapTo(window_.get(), QPoint()).y(); };
  EXPECT_LT(y_of("start_write") - y_of("start_input"), 100) << "near the questions where they all fit";
}

TEST_F(WindowStart, ANewLearnerIsAskedToo) {
  press(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_FALSE(is_shown());
  session().end();
  the_parts->learner().switch_profile("aiko");
  EXPECT_TRUE(is_shown());
  the_parts->learner().switch_profile("learner");
  EXPECT_TRUE(find("home_page")->isVisible());
}

TEST_F(WindowStart, WhatTheLearnerWritesWithIsSaid) {
  const QString mouse = QStringLiteral("You are writing with the mouse. A pen tablet works better.");
  test::move_mouse(*find("start_page"));
  EXPECT_EQ(text("start_input"), mouse);
  EXPECT_EQ(text("device"), mouse);
  EXPECT_FALSE(find("device")->isVisible()) << "the page says it already";
  test::move_pen(*find("start_page"));
  EXPECT_EQ(text("start_input"), QStringLiteral("You are writing with the pen."));
  EXPECT_EQ(text("device"), QStringLiteral("You are writing with the pen."));
  test::move_mouse(*find("start_page"));
  EXPECT_EQ(text("start_input"), mouse);
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(find("device")->isVisible());
}

/// Words that are wider or higher than their widget are cut off.
void expect_no_clipped_words(const QWidget& page, const char* at) {
  for (const auto* button : page.findChildren<QAbstractButton*>())
    if (button->isVisible()) {
      EXPECT_GE(button->width(), button->minimumSizeHint().width()) << at << button->text().toStdString();
      EXPECT_GE(button->height(), button->minimumSizeHint().height()) << at << button->text().toStdString();
      EXPECT_LE(button->mapTo(&page, QPoint(button->width(), 0)).x(), page.width())
          << at << button->text().toStdString();
    }
  for (const auto* label : page.findChildren<QLabel*>())
    if (label->isVisible() && !label->text().isEmpty()) {
      const int needed =
          label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
      EXPECT_GE(label->height(), needed) << at << label->text().toStdString();
      EXPECT_LE(label->mapTo(&page, QPoint(label->width(), 0)).x(), page.width())
          << at << label->text().toStdString();
    }
}

TEST_F(WindowStart, NoWordIsClippedInASmallWindowWithLargeTextInBothLanguages) {
  for (const char* language : {"en", "ja"}) {
    install_language(QString::fromLatin1(language));
    open();
    ASSERT_TRUE(is_shown());
    for (const char* goal : {"start_hiragana", "start_kanji", "start_own"}) {
      choose(goal);
      choose("start_some_kanji");
      set_text_size(28, 800, 600);
      expect_no_clipped_words(*find("start_content"), language);
      EXPECT_LE(find("start_content")->width(), find("start_page")->width());
      set_text_size(12);
      expect_no_clipped_words(*find("start_content"), language);
    }
  }
  install_language(QStringLiteral("en"));
}

}  // namespace
}  // namespace nazori::ui
