// SPDX-License-Identifier: Apache-2.0
// The questions of the first start: what stands where, how each part is made, and which answer each one
// gives.
#include <QSignalSpy>
#include <QTest>

#include "described_widget.h"
#include "nazori/practice/learning_choices.h"
#include "print_qt.h"
#include "start/start_view.h"

namespace nazori::ui {
namespace {

using test::expect_laid_out;
using test::expect_made;
using test::layout_words;

class MadeStart : public testing::Test {
 protected:
  static int em() { return QFontInfo(QApplication::font()).pixelSize(); }
  std::string laid_out(const char* name) { return layout_words(*test::part_of(view_, name)).toStdString(); }
  std::unique_ptr<StartView> made_ = [] {
    install_language(QStringLiteral("en"));
    test::use_plain_look();
    return std::make_unique<StartView>();
  }();
  StartView& view_ = *made_;
};

TEST_F(MadeStart, QuestionsStandAboveTheirAnswers) {
  view_.show();
  QCoreApplication::processEvents();
  // High enough for all questions: without a scroll bar.
  for (const int height : {1999, 2000}) {
    view_.resize(60 * em() + 400, height);
    QCoreApplication::processEvents();
  }
  const auto* area = view_.findChild<QScrollArea*>(QStringLiteral("start_questions"));
  const int width = area->viewport()->width();
  const int beside = std::max(28, (width - std::min(width - 56, 60 * em())) / 2);
  ASSERT_GT(beside, 28);
  const std::string sides = std::to_string(beside);
  expect_laid_out(
      view_,
      {{"start_page", "column 0 0 0 0 gap 0: start_questions*1, start_end, stretch"},
       {"start_content",
        ("column " + sides + " 28 " + sides +
         " 28 gap 12: start_welcome, start_about, space 6, start_question, start_goal, start_order, "
         "start_own_text, start_own_found, space 6, start_question, start_known, start_level left, "
         "start_known_text, start_known_found, start_result, start_result_row, space 6, start_question, "
         "start_minutes, start_input, stretch*1")
            .c_str()},
       {"start_end", ("column " + sides + " 12 " + sides + " 12 gap 12: start_trouble, QWidget").c_str()},
       {"around start_write", "flow 0 0 0 0 gap 12 12: start_write, start_skip"},
       {"start_goal", "flow 0 0 0 0 gap 12 12: start_hiragana, start_katakana, start_kanji, start_own"},
       {"start_known",
        "flow 0 0 0 0 gap 12 12: start_nothing, start_kana, start_some_kanji, start_listed, "
        "start_check"}});
  EXPECT_EQ(area->maximumHeight(), area->widget()->layout()->heightForWidth(width));
  view_.resize(30 * em(), 2000);
  QCoreApplication::processEvents();
  EXPECT_TRUE(laid_out("start_end").starts_with("column 28 12 28 12 gap 12")) << laid_out("start_end");
}

TEST_F(MadeStart, EachPartIsMadeForWhatItIs) {
  view_.show_answers({}, true);
  const QFontMetrics metrics(view_.findChild<QPlainTextEdit*>()->font());
  const std::string high = std::to_string(3 * metrics.lineSpacing() + em());
  const std::string text = "textFormat PlainText; wordWrap";
  expect_made(
      view_,
      {{"start_page", "accessibleName What to learn; keyboard to start_write"},
       {"start_welcome", ("letters 1.7; text Welcome. ようこそ。; " + text).c_str()},
       {"start_about",
        ("role muted; text Three questions, then you write. You can change every answer later.; " + text)
            .c_str()},
       {"start_question", ("text What would you like to write?; " + text).c_str()},
       {"start_trouble",
        "hidden; role trouble; textFormat PlainText; textInteractionFlags TextSelectableByMouse; wordWrap"},
       {"start_write", "autoDefault; letters 1.3; role primary"},
       {"start_skip", "autoDefault; text Skip (Esc)"},
       {"start_own_text",
        ("accessibleName Text with the characters you want to write; hidden; maximumHeight " + high +
         "; minimumHeight " + high +
         "; placeholderText Type or paste any text. Its kanji become your list.; tabChangesFocus")
            .c_str()},
       {"start_known_text", ("accessibleName Text with the characters you know; hidden; maximumHeight " +
                             high + "; minimumHeight " + high +
                             "; placeholderText Paste any text or list, from another program for example. "
                             "Every kanji and kana in "
                             "it counts as known.; tabChangesFocus")
                                .c_str()},
       {"start_level",
        "accessibleName How many kanji do you know?; hidden; minimumContentsLength 16; sizeAdjustPolicy "
        "AdjustToMinimumContentsLengthWithIcon"},
       {"start_order", "accessibleName Which kanji first?; hidden"},
       {"start_result_row", "accessibleName The result of the test; hidden"}});
  const auto* area = view_.findChild<QScrollArea*>(QStringLiteral("start_questions"));
  EXPECT_EQ(area->frameShape(), QFrame::NoFrame);
  view_.show_answers({}, false);
  expect_made(view_,
              {{"start_welcome", ("letters 1.7; text What do you want to learn?; " + text).c_str()},
               {"start_about", ("role muted; text Only what you change here is changed.; " + text).c_str()},
               {"start_skip", "autoDefault; text Back (Esc)"}});
  EXPECT_EQ(view_.findChild<QRadioButton*>(QStringLiteral("start_nothing"))->text(),
            QStringLiteral("Mark nothing"));
  const auto* level = view_.findChild<QComboBox*>(QStringLiteral("start_level"));
  QStringList levels;
  for (int i = 0; i < level->count(); ++i) levels.append(level->itemText(i));
  EXPECT_EQ(
      levels.join(QLatin1Char('|')).toStdString(),
      "up to grade 1|up to grade 2|up to grade 3|up to grade 4|up to grade 5|up to grade 6|all school "
      "kanji|up to old JLPT level 4|up to old JLPT level 3|up to old JLPT level 2|up to old JLPT level 1");
}

TEST_F(MadeStart, EveryAnswerIsTaken) {
  using Goal = practice::LearningGoal;
  using Known = practice::KnownAlready::Kind;
  view_.show_answers({}, true);
  EXPECT_FALSE(view_.answers().goal);
  EXPECT_FALSE(view_.answers().minutes);
  QSignalSpy changed(&view_, &StartView::changed);
  const auto choose = [&](const char* name) {
    view_.findChild<QRadioButton*>(QString::fromLatin1(name))->setChecked(true);
    return view_.answers();
  };
  const auto sees = [&](const char* name) { return !test::part_of(view_, name)->isHidden(); };
  EXPECT_EQ(choose("start_hiragana").goal, Goal::hiragana);
  EXPECT_EQ(view_.findChild<QRadioButton*>(QStringLiteral("start_kana"))->text(),
            QStringLiteral("I know katakana"));
  EXPECT_EQ(view_.findChild<QRadioButton*>(QStringLiteral("start_kana"))->accessibleName(),
            QStringLiteral("What can you write already?: I know katakana"));
  EXPECT_EQ(choose("start_katakana").goal, Goal::katakana);
  EXPECT_EQ(view_.findChild<QRadioButton*>(QStringLiteral("start_kana"))->text(),
            QStringLiteral("I know hiragana"));
  EXPECT_FALSE(sees("start_order"));
  EXPECT_EQ(choose("start_kanji").goal, Goal::kanji_by_grade);
  EXPECT_EQ(view_.findChild<QRadioButton*>(QStringLiteral("start_kana"))->text(),
            QStringLiteral("I know kana"));
  EXPECT_TRUE(sees("start_order"));
  EXPECT_EQ(choose("start_by_jlpt").goal, Goal::kanji_by_jlpt);
  EXPECT_EQ(choose("start_by_frequency").goal, Goal::kanji_by_frequency);
  EXPECT_EQ(choose("start_by_grade").goal, Goal::kanji_by_grade);
  view_.findChild<QPlainTextEdit*>(QStringLiteral("start_own_text"))->setPlainText(QStringLiteral("雨"));
  EXPECT_TRUE(view_.answers().own_text.empty()) << "it is not asked for";
  EXPECT_FALSE(sees("start_own_text"));
  EXPECT_EQ(choose("start_own").own_text, "雨");
  EXPECT_EQ(view_.answers().goal, Goal::own_list);
  EXPECT_EQ(view_.answers().list_name, "My list");
  EXPECT_TRUE(sees("start_own_text") && sees("start_own_found"));
  EXPECT_EQ(choose("start_kana").known->kind, Known::kana);
  auto* level = view_.findChild<QComboBox*>(QStringLiteral("start_level"));
  EXPECT_FALSE(sees("start_level"));
  choose("start_some_kanji");
  EXPECT_TRUE(sees("start_level"));
  for (int i = 0; i < 11; ++i) {
    level->setCurrentIndex(i);
    EXPECT_EQ(view_.answers().known->kind, i < 7 ? Known::up_to_grade : Known::up_to_jlpt);
    EXPECT_EQ(view_.answers().known->level, i < 7 ? i + 1 : 11 - i);
  }
  view_.findChild<QPlainTextEdit*>(QStringLiteral("start_known_text"))->setPlainText(QStringLiteral("日"));
  EXPECT_TRUE(view_.answers().known_text.empty());
  EXPECT_EQ(choose("start_listed").known_text, "日");
  EXPECT_EQ(view_.answers().known->kind, Known::listed);
  EXPECT_TRUE(sees("start_known_text") && sees("start_known_found"));
  EXPECT_FALSE(view_.wants_check());
  choose("start_check");
  EXPECT_TRUE(view_.wants_check());
  EXPECT_FALSE(sees("start_result") || sees("start_result_row"));
  for (const int minutes : practice::daily_minutes())
    EXPECT_EQ(choose(("start_minutes_" + std::to_string(minutes)).c_str()).minutes, minutes);
  const auto before = changed.count();
  choose("start_check");
  EXPECT_EQ(changed.count(), before) << "it was chosen";
  choose("start_nothing");
  EXPECT_EQ(changed.count(), before + 1);
}

TEST_F(MadeStart, AResultIsTakenUnlessItIsRefusedAndGoesWithAnotherGoal) {
  using Known = practice::KnownAlready::Kind;
  view_.show_answers({}, true);
  const auto press = [&](const char* name) {
    view_.findChild<QRadioButton*>(QString::fromLatin1(name))->setChecked(true);
  };
  const auto sees = [&](const char* name) { return !test::part_of(view_, name)->isHidden(); };
  press("start_hiragana");
  practice::PlacementResult result;
  result.known = {U'あ', U'い'};
  result.characters = 46;
  QSignalSpy changed(&view_, &StartView::changed);
  view_.show_result(result);
  EXPECT_EQ(changed.count(), 0);
  EXPECT_FALSE(view_.wants_check());
  EXPECT_TRUE(sees("start_result") && sees("start_result_row"));
  EXPECT_EQ(view_.findChild<QLabel*>(QStringLiteral("start_result"))->text(),
            QStringLiteral("You can write about 2 of the 46 hiragana, up to い."));
  EXPECT_EQ(view_.answers().known->kind, Known::checked);
  EXPECT_EQ(view_.answers().known->characters, result.known);
  press("start_refuse");
  EXPECT_EQ(view_.answers().known->kind, practice::KnownAlready().kind);
  press("start_take");
  EXPECT_EQ(view_.answers().known->kind, Known::checked);
  press("start_katakana");
  EXPECT_FALSE(sees("start_result"));
  EXPECT_TRUE(view_.wants_check()) << "another syllabary is another test";
  result.known.clear();
  view_.show_result(result);
  EXPECT_TRUE(sees("start_result"));
  EXPECT_FALSE(sees("start_result_row")) << "there is nothing to take";
  view_.show_result({});
  EXPECT_FALSE(sees("start_result"));
}

TEST_F(MadeStart, TheButtonSaysWhatComesAndEnterPressesItWhereItCan) {
  view_.show_answers({}, true);
  auto* write = view_.findChild<QPushButton*>(QStringLiteral("start_write"));
  const auto* trouble = view_.findChild<QLabel*>(QStringLiteral("start_trouble"));
  QSignalSpy wanted(&view_, &StartView::write_wanted), skipped(&view_, &StartView::skip_wanted);
  view_.show_plan(U'雨', {}, {U'雨', U'雪'});
  EXPECT_EQ(write->text(), QStringLiteral("Write 雨"));
  EXPECT_EQ(write->toolTip(), QStringLiteral("Enter: start"));
  EXPECT_TRUE(trouble->isHidden());
  EXPECT_EQ(view_.findChild<QLabel*>(QStringLiteral("start_own_found"))->text(),
            QStringLiteral("2 characters: 雨雪"));
  QTest::keyClick(&view_, Qt::Key_Return);
  QTest::keyClick(&view_, Qt::Key_Enter, Qt::KeypadModifier);
  QTest::keyClick(&view_, Qt::Key_Space);
  EXPECT_EQ(wanted.count(), 2);
  view_.show_plan(0, {}, {});
  EXPECT_EQ(write->text(), QStringLiteral("Save"));
  EXPECT_EQ(
      trouble->text(),
      QStringLiteral("You know every character of this choice already. Choose something else to write."));
  EXPECT_FALSE(trouble->isHidden());
  EXPECT_EQ(view_.findChild<QLabel*>(QStringLiteral("start_own_found"))->text(), QString());
  view_.show_plan(U'雨', QStringLiteral("No."), std::vector<char32_t>(31, U'雨'));
  EXPECT_FALSE(write->isEnabled());
  EXPECT_EQ(trouble->text(), QStringLiteral("No."));
  EXPECT_EQ(view_.findChild<QLabel*>(QStringLiteral("start_own_found"))->text(),
            QStringLiteral("31 characters: ") + QString(30, QChar(0x96E8)) + QStringLiteral("…"));
  QTest::keyClick(&view_, Qt::Key_Return);
  EXPECT_EQ(wanted.count(), 2);
  view_.show_plan(U'雨', {}, std::vector<char32_t>(30, U'雨'));
  EXPECT_FALSE(view_.findChild<QLabel*>(QStringLiteral("start_own_found"))->text().contains(u'…'));
  view_.findChild<QRadioButton*>(QStringLiteral("start_check"))->setChecked(true);
  view_.show_plan(0, {}, {});
  EXPECT_EQ(write->text(), QStringLiteral("Start the test"));
  EXPECT_TRUE(trouble->isHidden());
  view_.findChild<QPushButton*>(QStringLiteral("start_skip"))->click();
  EXPECT_EQ(skipped.count(), 1);
  const auto* known = view_.findChild<QLabel*>(QStringLiteral("start_known_found"));
  view_.show_known({U'一', U'二'}, 0);
  EXPECT_EQ(known->text(), QStringLiteral("2 characters will be marked as known: 一二"));
  view_.show_known({U'一'}, 3);
  EXPECT_EQ(known->text(), QStringLiteral("1 character will be marked as known: 一\n3 characters are already "
                                          "studied and stay as they are."));
  view_.show_known({}, 0);
  EXPECT_EQ(known->text(), QString());
}

}  // namespace
}  // namespace nazori::ui
