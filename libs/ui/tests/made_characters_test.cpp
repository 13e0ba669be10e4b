// SPDX-License-Identifier: Apache-2.0
// What stands where in the parts of the page for characters, and how each part is made.
#include <QAction>
#include <QSignalSpy>
#include <QTest>
#include <QTextDocument>

#include "characters/compare_view.h"
#include "characters/confusable_view.h"
#include "characters/drawing_pad.h"
#include "characters/drill_dialog.h"
#include "characters/glyph_view.h"
#include "characters/standing_bar.h"
#include "characters/strictness_slider.h"
#include "characters/word_boxes.h"
#include "characters/word_label.h"
#include "characters/writing_panel.h"
#include "characters/writing_report.h"
#include "made_widgets.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

using test::expect_laid_out;
using test::expect_made;
using test::layout_words;
using test::made_words;

using MadeCharacters = test::MadeWidgets;

TEST_F(MadeCharacters, ThePanelOfAWritingScrollsBelowItsSlider) {
  const WritingPanel panel(nullptr);
  expect_laid_out(
      panel,
      {{"writing_content", "column 12 12 12 12 gap 10: StrictnessSlider, compare_view, writing_report"},
       {"writing_report", "column 0 0 0 0: report_verdict, report_faults, report_parts, report_pen"}});
  const std::string sentence = "textFormat PlainText; textInteractionFlags TextSelectableByMouse; wordWrap";
  expect_made(panel, {{"writing_panel",
                       "accessibleName Your writing; focusPolicy TabFocus; frameShape NoFrame; "
                       "horizontalScrollBarPolicy ScrollBarAlwaysOff; sizePolicy Preferred Maximum; "
                       "widgetResizable"},
                      {"compare_view",
                       "accessibleName Your writing beside the model; hidden; sizePolicy Expanding Fixed"},
                      {"writing_report", "accessibleName Feedback on your writing; hidden"},
                      {"report_verdict", ("role title; " + sentence).c_str()},
                      {"report_parts", ("role muted; " + sentence).c_str()}});
}

TEST_F(MadeCharacters, ThePanelOfAWritingHasAtMost62OfAHundredOfTheHeightAndSevenLinesAtLeast) {
  QWidget side;
  side.resize(300, 1000);
  WritingPanel panel(&side);
  panel.set_report_shown(true);
  panel.set_compare_shown(true);
  const int wanted = panel.widget()->layout()->totalHeightForWidth(panel.viewport()->width());
  ASSERT_GT(wanted, 7 * em());
  side.resize(300, 10 * wanted);
  EXPECT_EQ(panel.sizeHint(), QSize(280, wanted));
  EXPECT_EQ(panel.minimumSizeHint().height(), 7 * em());
  side.resize(300, 100 * 7 * em() / 62 + 200);
  EXPECT_EQ(panel.sizeHint().height(), std::min(wanted, side.height() * 62 / 100));
  side.resize(300, 10);
  EXPECT_EQ(panel.sizeHint().height(), 7 * em());
}

TEST_F(MadeCharacters, TheSliderOfStrictnessHasItsNamesBelow) {
  const StrictnessSlider slider(nullptr);
  EXPECT_EQ(layout_words(slider).toStdString(),
            "column 0 0 0 0 gap 0: (flow gap 12 0: “Str&ictness”, strictness_words), strictness, "
            "(row gap 4: “lenient”*1, “normal”*1, “strict”*1)");
  expect_made(
      slider,
      {{"strictness",
        "accessibleDescription normal; accessibleName Strictness; maximum 20; pageStep 5; tickInterval 10; "
        "tickPosition TicksBelow; toolTip How strictly your writing is checked (Ctrl+[ and Ctrl+]); value "
        "10"},
       {"strictness_words", "text normal; textFormat PlainText; wordWrap"}});
  QStringList marks;
  for (const auto* label : slider.findChildren<QLabel*>())
    if (label->objectName().isEmpty()) marks.append(made_words(*label));
  EXPECT_EQ(marks.join(QLatin1Char('\n')).toStdString(),
            "of strictness; text Str&ictness\n"
            "alignment left top; role muted; sizePolicy Ignored Preferred; text lenient\n"
            "alignment centre top; role muted; sizePolicy Ignored Preferred; text normal\n"
            "alignment right top; role muted; sizePolicy Ignored Preferred; text strict");
}

kanji::Character confusable(char32_t character) {
  kanji::Character made;
  made.code_point = character;
  made.entry.meanings = {{"fr", "autre"}, {"en", "meaning"}, {"en", "second"}};
  return made;
}

TEST_F(MadeCharacters, ConfusableCharactersStandAboveTheButtonThatTellsThemApart) {
  QWidget window;
  QAction tell(QStringLiteral("&Tell apart"), &window);
  tell.setObjectName(QStringLiteral("tell_apart"));
  tell.setIconText(QStringLiteral("Tell apart"));
  tell.setToolTip(QStringLiteral("a tip"));
  tell.setEnabled(false);
  ConfusableView view({&tell}, &window);
  practice::CharacterSheet sheet;
  sheet.character = confusable(U'土');
  sheet.confusables = {confusable(U'士'), confusable(U'上')};
  view.show_sheet(sheet);
  EXPECT_EQ(layout_words(view).toStdString(), "column 0 0 0 0: QWidget, (flow: button_tell_apart)");
  expect_laid_out(
      view, {{"around confusable_土", "flow 0 0 0 0 gap 8 8: confusable_土, confusable_士, confusable_上"}});
  const std::string side = std::to_string(5 * em());
  expect_made(view,
              {{"confusable_士", ("accessibleName 士, meaning; cursor PointingHandCursor; maximumHeight " +
                                  side + "; maximumWidth " + side + "; minimumHeight " + side +
                                  "; minimumWidth " + side + "; toolTip 士, meaning")
                                     .c_str()},
               {"button_tell_apart", "no enabled; role compact; text Tell apart; toolTip a tip"}});
  tell.setEnabled(true);
  const auto* button = view.findChild<QPushButton*>(QStringLiteral("button_tell_apart"));
  EXPECT_TRUE(button->isEnabled());
  const QSignalSpy triggered(&tell, &QAction::triggered);
  view.findChild<QPushButton*>(QStringLiteral("button_tell_apart"))->click();
  EXPECT_EQ(triggered.count(), 1);
  sheet.confusables = {confusable(U'工')};
  view.show_sheet(sheet);
  EXPECT_EQ(layout_words(*view.findChild<QPushButton*>(QStringLiteral("confusable_工"))->parentWidget())
                .toStdString(),
            "flow 0 0 0 0 gap 8 8: confusable_土, confusable_工")
      << "the others are gone";
}

TEST_F(MadeCharacters, TheStandingStandsAboveItsButtons) {
  QWidget window;
  QAction know(QStringLiteral("I &know this"), &window), study(QStringLiteral("St&udy this"), &window);
  know.setObjectName(QStringLiteral("know_this"));
  know.setIconText(QStringLiteral("I know this"));
  know.setToolTip(QStringLiteral("a tip"));
  study.setObjectName(QStringLiteral("study_this"));
  StandingBar bar({&study, &know}, &window);
  EXPECT_EQ(layout_words(bar).toStdString(),
            "column 0 0 0 0: standing, (flow gap 6 6: button_study_this, button_know_this)");
  expect_made(bar, {{"standing", "textFormat PlainText; wordWrap"},
                    {"button_know_this", "role compact; text I know this; toolTip a tip"}});
  const auto* button = bar.findChild<QPushButton*>(QStringLiteral("button_know_this"));
  know.setEnabled(false);
  EXPECT_FALSE(button->isEnabled());
  practice::CharacterStanding standing;
  standing.strength = study::Strength::mature;
  standing.comes_again = true;
  standing.is_due = true;
  standing.card.brush.due_day = standing.today + std::chrono::days(3);
  EXPECT_EQ(StandingBar::words(standing).toStdString(),
            "● well known · due today · with the brush in 3 days");
  standing.card.brush.due_day = standing.today;
  EXPECT_EQ(StandingBar::words(standing).toStdString(), "● well known · due today · due with the brush");
  standing.comes_again = false;
  EXPECT_EQ(StandingBar::words(standing).toStdString(), "● well known") << "it is suspended";
  bar.show_standing(standing);
  EXPECT_EQ(bar.findChild<QLabel*>()->text(), QStringLiteral("● well known"));
}

TEST_F(MadeCharacters, ThePadAndTheBoxesTakeTheRoomOfTheirShape) {
  const DrawingPad pad(nullptr);
  EXPECT_EQ(made_words(pad).toStdString(),
            "accessibleName Draw the character here; cursor CrossCursor; focusPolicy StrongFocus; "
            "sizePolicy Expanding Preferred with height");
  WordBoxes boxes(nullptr);
  EXPECT_EQ(made_words(boxes).toStdString(),
            "accessibleName The characters of the word; sizePolicy Fixed Fixed");
  WordBoxes::Box right, wrong, current;
  right.is_finished = right.is_right = wrong.is_finished = current.is_current = true;
  boxes.show_boxes({right, wrong, current, {}});
  EXPECT_EQ(boxes.accessibleDescription(),
            QStringLiteral("Character 1: right; Character 2: not right; Character 3: being written; "
                           "Character 4: empty"));
  EXPECT_EQ(made_words(GlyphView(nullptr)).toStdString(), "sizePolicy Fixed Fixed");
}

TEST_F(MadeCharacters, AWordIsWrittenLargeItsReadingBesideItAndItsMeaningBelow) {
  practice::HelpfulWord word;
  word.word.text = "休み";
  word.word.reading = "やすみ";
  word.meanings = {"vacationing", "a < b"};
  const auto text = [&](bool narrow) { return WordLabel(word, narrow, nullptr).text(); };
  const double points = QFontInfo(QApplication::font()).pointSizeF();
  const QString all =
      QStringLiteral(
          "<span style=\"font-family:'Klee One'; font-size:%1pt\">"
          "<a href=\"休\" style=\"color:%2; text-decoration:none\">休</a>み</span>"
          "&nbsp; <span style=\"font-family:'Klee One'; font-size:%3pt; color:%4\">やすみ</span>"
          "<br>%5; a &lt; b")
          .arg(points * 1.25)
          .arg(current_colours().ink.name())
          .arg(points)
          .arg(current_colours().muted.name());
  EXPECT_EQ(text(false), all.arg(QStringLiteral("vacationing")));
  // Four letters stay together at each end.
  QString broken;
  const QString whole = QStringLiteral("vacationing");
  for (qsizetype i = 0; i < whole.size(); ++i)
    broken += (i >= 4 && whole.size() - i >= 4 ? QString(QChar(0x200B)) : QString()) + whole[i];
  EXPECT_EQ(text(true), all.arg(broken));
  EXPECT_EQ(
      made_words(WordLabel(word, false, nullptr)).section(QStringLiteral("; text "), 0, 0).toStdString(),
      "accessibleName 休み, やすみ, vacationing; a < b; focusPolicy StrongFocus; mouseTracking");
  WordLabel label(word, false, nullptr);
  QSignalSpy chosen(&label, &WordLabel::character_chosen);
  emit label.linkActivated(QStringLiteral("休み"));
  EXPECT_EQ(chosen.count(), 0) << "a link is one character";
}

TEST_F(MadeCharacters, ADrillAsksAboveItsAnswersAndEndsWithItsButtons) {
  DrillDialog dialog({{U'待', "wait", "ま.つ", {}}, {U'持', "hold", "も.つ", {}}}, 1, nullptr);
  expect_laid_out(dialog, {{"drill_dialog",
                            "column gap 12: drill_progress, drill_word, drill_meaning, (row: stretch*1, "
                            "drill_choice_1, drill_choice_2, stretch*1), drill_verdict, (row: stretch*1, "
                            "drill_write, drill_close)"}});
  const auto* word = dialog.findChild<QLabel*>(QStringLiteral("drill_word"));
  const auto* meaning = dialog.findChild<QLabel*>(QStringLiteral("drill_meaning"));
  const bool waits = word->text() == QStringLiteral("ま・つ");
  EXPECT_EQ(meaning->text(), waits ? QStringLiteral("wait") : QStringLiteral("hold"));
  const std::string end = "; textFormat PlainText; wordWrap";
  expect_made(
      dialog,
      {{"drill_dialog",
        ("minimumWidth " + std::to_string(28 * em()) + "; windowTitle Which one is it?").c_str()},
       {"drill_progress", ("alignment centre middle; role muted; text 1 of 6" + end).c_str()},
       {"drill_word",
        ("alignment centre middle; " + letters(2.4) + "; text " + word->text().toStdString() + end).c_str()},
       {"drill_meaning",
        ("alignment centre middle; letters 1.3; text " + meaning->text().toStdString() + end).c_str()},
       {"drill_verdict",
        ("alignment centre middle; letters 1.1; text Which character belongs here? Press 1 to 2." + end)
            .c_str()},
       {"drill_choice_2",
        ("accessibleName 2: 持; " + letters(3) + "; shortcut 2; text 持; toolTip Key 2").c_str()},
       {"drill_write", "no enabled; text &Write them"},
       {"drill_close", "text &Close"}});
  auto* wrong = dialog.findChild<QPushButton*>(waits ? QStringLiteral("drill_choice_2")
                                                     : QStringLiteral("drill_choice_1"));
  const auto says = [&] { return dialog.findChild<QLabel*>(QStringLiteral("drill_verdict"))->text(); };
  wrong->click();
  EXPECT_EQ(says(), waits ? QStringLiteral("✗ It is 待 (wait), not 持.")
                          : QStringLiteral("✗ It is 持 (hold), not 待."));
  EXPECT_EQ(dialog.findChild<QLabel*>(QStringLiteral("drill_progress"))->text(), QStringLiteral("2 of 7"))
      << "it comes once more";
  QSignalSpy closed(&dialog, &QDialog::rejected);
  dialog.findChild<QPushButton*>(QStringLiteral("drill_close"))->click();
  EXPECT_EQ(closed.count(), 1);
  EXPECT_FALSE(dialog.wants_to_write());
}

}  // namespace
}  // namespace nazori::ui
