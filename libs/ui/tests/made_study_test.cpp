// SPDX-License-Identifier: Apache-2.0
// What stands where on the pages and dialogs for study, and how each part is made.
#include <QAction>
#include <QSignalSpy>

#include "chosen_session_under_test.h"
#include "described_widget.h"
#include "study/home.h"
#include "study/home_parts.h"
#include "study/ink_gallery.h"
#include "study/known_dialog.h"
#include "study/new_list_dialog.h"
#include "study/question_view.h"
#include "study/session_actions.h"
#include "study/session_answers.h"
#include "study/session_bar.h"
#include "study/session_panel.h"
#include "study/session_text_size.h"
#include "study/study_settings_dialog.h"

namespace nazori::ui {
namespace {

using test::expect_laid_out;
using test::expect_made;
using test::layout_words;
using test::made_words;

class MadeStudy : public ChosenSessionTest {
 protected:
  MadeStudy() {
    install_language(QStringLiteral("en"));
    test::use_plain_look();
  }
  static int em() { return QFontInfo(QApplication::font()).pixelSize(); }
  QAction* action(const char* name, const char* text, Qt::Key key) {
    auto* made = new QAction(QString::fromLatin1(text), &window_);
    made->setObjectName(QString::fromLatin1(name));
    made->setShortcut(key);
    made->setToolTip(QStringLiteral("tip of %1").arg(QString::fromLatin1(name)));
    return made;
  }
  QWidget window_;
};

class MadeSettings : public MadeStudy {
 protected:
  std::string page(int number) {
    const auto* tabs = dialog_.findChild<QTabWidget*>();
    const auto* area = qobject_cast<QScrollArea*>(tabs->widget(number));
    EXPECT_EQ(made_words(*area).toStdString(),
              std::string("frameShape NoFrame; ") + (number == tabs->currentIndex() ? "" : "hidden; ") +
                  "horizontalScrollBarPolicy ScrollBarAlwaysOff; widgetResizable")
        << number;
    return layout_words(*area->widget()).toStdString();
  }
  StudySettingsDialog dialog_{*learner_, Preferences(), nullptr};
};

TEST_F(MadeSettings, EachPageIsAFormWithItsFieldsInTheirOrder) {
  expect_laid_out(dialog_, {{"study_settings_dialog",
                             "column 16 16 16 12: study_settings_tabs*1, study_settings_buttons"}});
  const std::string form = "form 12 16 12 12 gap 10 10 wraps: ";
  EXPECT_EQ(page(0), form +
                         "NumberSlider, study_workload, “&New characters per day (maximum)” | study_new, "
                         "“&Reviews per day (maximum)” | study_reviews, "
                         "“Characters with the &brush per day (maximum)” | study_brush, study_brush_words, "
                         "“A study &day starts at (hour)” | study_day_starts, “Time &zone” | study_zone");
  EXPECT_EQ(page(1), form + "“&Order of new characters” | study_order, study_lists, study_choice, QWidget");
  EXPECT_EQ(page(2), form +
                         "“Mistakes on a stroke before a &hint is offered” | study_hint_after, "
                         "“Mistakes before the stroke is &shown” | study_show_after, "
                         "“&Lapses before a character must be relearned” | study_leech, study_fuzz, "
                         "study_balance, study_weights, QWidget");
  EXPECT_EQ(page(3), form +
                         "study_at_home, study_by_words, study_left_handed, "
                         "“One-handed &keys” | study_one_hand");
  expect_laid_out(dialog_,
                  {{"around list_new",
                    "flow 0 0 0 0 gap 6 6: list_new, list_remove, list_up, list_down, list_know, "
                    "list_postpone, list_pause, list_resume, list_reset"},
                   {"around weights_import", "flow 0 0 0 0 gap 6 6: weights_import, weights_default"}});
}

TEST_F(MadeSettings, EachFieldHasItsNameItsBoundsAndItsChoices) {
  expect_made(
      dialog_,
      {{"study_settings_dialog", "windowTitle Study settings"},
       {"study_settings_tabs", "documentMode"},
       {"study_brush",
        "accessibleName Characters with the brush per day (maximum); maximum 100; specialValueText off"},
       {"study_hint_after",
        "accessibleName Mistakes on a stroke before a hint is offered; maximum 20; minimum 1; value "
        "2"},
       {"study_show_after",
        "accessibleName Mistakes before the stroke is shown; maximum 20; minimum 1; value 3"},
       {"study_zone", "accessibleName Time zone; sizeAdjustPolicy AdjustToMinimumContentsLengthWithIcon"},
       {"study_one_hand",
        "accessibleName One-handed keys; sizeAdjustPolicy AdjustToMinimumContentsLengthWithIcon"},
       {"study_order", "accessibleName Order of new characters"},
       {"study_at_home", "checked; text Start Nazori on &Home"},
       {"study_by_words", "checked; text Sometimes ask with a &word that leaves out the character"},
       {"study_left_handed", "text &Left-handed: panels, next button, brush and light change sides"},
       {"study_fuzz", "text &Vary review intervals a little"},
       {"study_balance", "text Pref&er days with fewer reviews"},
       {"list_new", "autoDefault; text New list…"},
       {"list_reset", "autoDefault; text Start all over"},
       {"weights_default", "autoDefault; text Default parameters"}});
  const auto* keys = dialog_.findChild<QComboBox*>(QStringLiteral("study_one_hand"));
  ASSERT_EQ(keys->count(), 3);
  const std::pair<const char*, OneHand> hands[] = {
      {"none", OneHand::none},
      {"left hand: 1 2 3 4, E next, W hint, X undo", OneHand::left},
      {"right hand: 7 8 9 0, K next, U hint, Backspace undo", OneHand::right}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(keys->itemText(i), QString::fromLatin1(hands[i].first));
    EXPECT_EQ(keys->itemData(i).toInt(), static_cast<int>(hands[i].second));
  }
  const auto* zones = dialog_.findChild<QComboBox*>(QStringLiteral("study_zone"));
  EXPECT_EQ(zones->itemText(0), QStringLiteral("same as the computer"));
  EXPECT_EQ(zones->itemData(0).toString(), QString());
  EXPECT_GT(zones->count(), 100);
  for (int i = 1; i < zones->count(); ++i) {
    EXPECT_EQ(zones->itemData(i).toString(), zones->itemText(i));
    EXPECT_TRUE(zones->itemText(i).contains(u'/') || i == zones->count() - 1) << "the learner's own is UTC";
  }
  EXPECT_EQ(zones->currentText(), QStringLiteral("UTC"));
  const auto* lists = dialog_.findChild<QListWidget*>(QStringLiteral("study_lists"));
  EXPECT_EQ(lists->minimumHeight(), 9 * QFontMetrics(dialog_.font()).height());
  EXPECT_EQ(lists->accessibleName(), QStringLiteral("Lists to learn from"));
}

TEST_F(MadeSettings, ItIsAsLargeAsItsLettersWantInTheWindow) {
  window_.resize(4000, 4000);
  const StudySettingsDialog inside(*learner_, Preferences(), &window_);
  EXPECT_EQ(inside.size(), QSize(44 * em(), 38 * em()));
  window_.resize(400, 300);
  const StudySettingsDialog narrow(*learner_, Preferences(), &window_);
  EXPECT_EQ(narrow.size(), QSize(380, 285)) << "a twentieth less than the window";
}

TEST_F(MadeSettings, WhatIsSetWithTheBrushAndInALessonIsKeptApart) {
  auto wanted = learner_->store().settings();
  wanted.brush_per_day = 17;
  wanted.lesson.hint_after_misses = 4;
  wanted.lesson.show_after_misses = 9;
  wanted.leech_lapses = 6;
  dialog_.findChild<QSpinBox*>(QStringLiteral("study_brush"))->setValue(17);
  dialog_.findChild<QSpinBox*>(QStringLiteral("study_hint_after"))->setValue(4);
  dialog_.findChild<QSpinBox*>(QStringLiteral("study_show_after"))->setValue(9);
  dialog_.findChild<QSpinBox*>(QStringLiteral("study_leech"))->setValue(6);
  EXPECT_EQ(dialog_.settings(), wanted);
}

TEST_F(MadeStudy, ATextOfWhatIsKnownIsCountedOrItIsSaidWhyNot) {
  KnownDialog dialog(*learner_, nullptr);
  expect_laid_out(dialog,
                  {{"known_dialog", "column 20 20 20 16 gap 12: known_text, known_found, QDialogButtonBox"}});
  expect_made(
      dialog,
      {{"known_dialog", "windowTitle I know these"},
       {"known_text",
        "accessibleName Text with the characters you know; placeholderText Paste any text or list, from "
        "another program for example. Every kanji and kana in it counts as known.; tabChangesFocus"},
       {"known_mark", "autoDefault; no enabled; text Mark as known"},
       {"known_file", "autoDefault; text From a file…"}});
  const auto found = [&](const char* text) {
    dialog.findChild<QPlainTextEdit*>()->setPlainText(QString::fromUtf8(text));
    return dialog.findChild<QLabel*>(QStringLiteral("known_found"))->text().toStdString();
  };
  EXPECT_EQ(found("nothing here"), "");
  EXPECT_EQ(found("一"), "1 character will be marked as known. What you have studied stays as it is.");
  EXPECT_EQ(dialog.plan().choices.known.size(), 1U);
  know(U'一');
  EXPECT_EQ(found("一 一"), "You have studied all of these characters.");
  EXPECT_FALSE(dialog.findChild<QPushButton*>(QStringLiteral("known_mark"))->isEnabled());
  EXPECT_TRUE(dialog.plan().choices.known.empty());
  QSignalSpy accepted(&dialog, &QDialog::accepted), rejected(&dialog, &QDialog::rejected);
  found("二");
  dialog.findChild<QPushButton*>(QStringLiteral("known_mark"))->click();
  EXPECT_EQ(accepted.count(), 1);
  dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
  EXPECT_EQ(rejected.count(), 1);
}

TEST_F(MadeStudy, AListNeedsANameAndCharactersThatAreThere) {
  NewListDialog dialog(*learner_, nullptr);
  expect_laid_out(dialog, {{"new_list_dialog",
                            "form 20 20 20 16 gap 12 12: “&Name” | new_list_name, "
                            "“&Characters” | new_list_text, new_list_trouble, QDialogButtonBox"}});
  expect_made(dialog, {{"new_list_dialog", "windowTitle New list"},
                       {"new_list_text",
                        "accessibleName Characters; placeholderText 休日月火水木金土\n# text after # is a "
                        "comment; tabChangesFocus"},
                       {"new_list_file", "autoDefault; text From a file…"}});
  QSignalSpy accepted(&dialog, &QDialog::accepted), rejected(&dialog, &QDialog::rejected);
  const auto says = [&](const QString& name, const char* text) {
    dialog.findChild<QLineEdit*>(QStringLiteral("new_list_name"))->setText(name);
    dialog.findChild<QPlainTextEdit*>()->setPlainText(QString::fromUtf8(text));
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    return dialog.findChild<QLabel*>(QStringLiteral("new_list_trouble"))->text().toStdString();
  };
  const std::string no_name = "Give the list a name of at most 100 letters (33 in Japanese).";
  EXPECT_EQ(says(QStringLiteral("  "), "一"), no_name);
  EXPECT_EQ(says(QString(101, u'a'), "一"), no_name);
  EXPECT_TRUE(says(QStringLiteral("a"), "一\n국").starts_with("line 2: "))
      << says(QStringLiteral("a"), "一\n국");
  EXPECT_EQ(accepted.count(), 0);
  says(QStringLiteral(" mine "), "二一 # two\n二");
  EXPECT_EQ(accepted.count(), 1);
  EXPECT_EQ(dialog.list().name, "mine");
  EXPECT_EQ(dialog.list().characters, (std::vector<char32_t>{U'二', U'一'}));
  dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
  EXPECT_EQ(rejected.count(), 1);
}

TEST_F(MadeStudy, ThePanelOfASessionTellsFromTopToBottom) {
  SessionPanel panel(*session_, *learner_, &window_);
  expect_laid_out(panel, {{"session_panel",
                           "column 0 0 0 0 gap 10: session_kind, session_history, session_faults, "
                           "session_parts, session_ink_heading, ink_gallery"}});
  expect_made(
      panel, {{"session_panel", "accessibleName Character being studied; hidden"},
              {"session_ink_heading", "role heading; text Earlier writing; textFormat PlainText; wordWrap"},
              {"ink_gallery",
               "accessibleName Earlier writing beside today's; sizePolicy Expanding Preferred with height"}});
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  panel.show_state(nullptr);
  EXPECT_FALSE(panel.isHidden());
  expect_made(panel, {{"session_kind", "text Review; textFormat PlainText; weight 600; wordWrap"}});
  bring(U'雨');
  panel.show_state(nullptr);
  EXPECT_TRUE(panel.isHidden()) << "another character is shown";
}

TEST_F(MadeStudy, TheBarOfASessionLeavesOutWhatHasNoRoom) {
  SessionActions actions(&window_);
  SessionBar bar(*session_, actions, &window_);
  expect_laid_out(bar,
                  {{"session_bar",
                    "row 16 4 16 4 gap 12: session_progress, session_line*1, session_time, session_note, "
                    "button_study_undo, session_menu"}});
  const std::string high = std::to_string(std::max(6, em() / 3));
  expect_made(
      bar,
      {{"session_bar", "accessibleName Study session; sizePolicy Preferred Fixed"},
       {"session_progress", "role muted"},
       {"session_line", ("accessibleName Session progress; maximumHeight " + high + "; minimumHeight " +
                         high + "; no textVisible")
                            .c_str()},
       {"session_time", "hidden; role muted"},
       {"button_study_undo",
        "accessibleName Undo last review; role compact; text Undo; toolTip Undo the last saved review or "
        "change; repeat to go further back, even to earlier days (Ctrl+Shift+Z)"},
       {"session_menu",
        "accessibleName More for this character; popupMode InstantPopup; text ⋯; toolTip More for this "
        "character"}});
  learn_from({U'一', U'二'});
  ASSERT_TRUE(session_->start());
  learn();
  session_->rate(study::Rating::easy);
  const auto shown = [&](int width) {
    test::resize_unseen(bar, {width, 40});
    QString all;
    for (const char* name : {"session_line", "session_time", "session_note"})
      all += bar.findChild<QWidget*>(QString::fromLatin1(name))->isHidden() ? QLatin1Char('-')
                                                                            : QLatin1Char(name[8]);
    return all.toStdString();
  };
  bar.show_state();
  EXPECT_EQ(shown(56 * em()), "ltn");
  EXPECT_EQ(shown(56 * em() - 1), "lt-");
  EXPECT_EQ(shown(26 * em()), "lt-");
  EXPECT_EQ(shown(26 * em() - 1), "l--");
  EXPECT_EQ(bar.findChild<QPushButton*>()->accessibleDescription(),
            QStringLiteral("Saved: 一, Easy. Next review in 8 days."));
  bar.set_short(true);
  EXPECT_EQ(shown(60 * em()), "---");
  EXPECT_EQ(bar.sizePolicy().horizontalPolicy(), QSizePolicy::Maximum);
  bar.set_short(false);
  EXPECT_EQ(shown(60 * em()), "ltn");
  EXPECT_EQ(bar.sizePolicy().horizontalPolicy(), QSizePolicy::Preferred);
  session_->end();
  bar.show_state();
  EXPECT_TRUE(bar.isHidden());
}

TEST_F(MadeStudy, TheButtonThatUndoesFollowsItsAction) {
  SessionActions actions(&window_);
  const SessionBar bar(*session_, actions, &window_);
  const auto* undo = bar.findChild<QPushButton*>();
  actions.undo->setEnabled(false);
  EXPECT_FALSE(undo->isEnabled());
  actions.undo->setEnabled(true);
  EXPECT_TRUE(undo->isEnabled());
}

TEST_F(MadeStudy, TheRowUnderTheTabletIsAsHighForTheHelpAsForTheRatings) {
  SessionActions actions(&window_);
  auto* hint = action("hint", "Hint", Qt::Key_H);
  auto* done = action("done", "Finish", Qt::Key_Return);
  SessionAnswers answers(*session_, actions, *learner_, {hint}, &window_);
  actions.set_one_hand(OneHand::none, hint, hint, done);
  expect_laid_out(answers, {{"session_answers", "column 16 6 16 6 gap 0: QWidget, QWidget"},
                            {"around session_next", "row 0 0 0 0: button_hint, stretch*1, session_next"},
                            {"around button_rate_good", "grid 0 0 0 0: "}});
  expect_made(answers,
              {{"session_answers", "accessibleName Next step; hidden"},
               {"session_next", "role primary"},
               {"button_hint", "accessibleName Hint; role compact; toolTip tip of hint"},
               {"button_rate_again",
                "is_rating true; sizePolicy Expanding Fixed; toolTip Forgotten: comes back soon (1)"}});
  answers.set_left_handed(true);
  expect_laid_out(
      answers, {{"around session_next", "row from the right 0 0 0 0: button_hint, stretch*1, session_next"}});
  answers.set_left_handed(false);
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  window_.resize(4000, 4000);
  const QFontMetrics metrics(QApplication::font());
  const int high = metrics.lineSpacing() * 4 / 3 + 4;
  const auto least = [&](int rows) {
    const int next = answers.findChild<QPushButton*>(QStringLiteral("session_next"))->sizeHint().height();
    return std::max(rows * high + (rows - 1) * 6, next) + 12;
  };
  const int wide = 30 * metrics.height();
  test::resize_unseen(answers, {wide, 60});
  answers.show_state();
  EXPECT_EQ(answers.minimumHeight(), least(1));
  test::resize_unseen(answers, {wide - 1, 60});
  EXPECT_EQ(answers.minimumHeight(), least(2));
  bring(U'八');
  write(true);
  answers.show_state();
  expect_laid_out(answers,
                  {{"around button_rate_good",
                    "grid 0 0 0 0: button_rate_again 0/0, button_rate_hard 0/1, button_rate_good 1/0, "
                    "button_rate_easy 1/1"}});
  test::resize_unseen(answers, {3000, 60});
  expect_laid_out(answers,
                  {{"around button_rate_good",
                    "grid 0 0 0 0: button_rate_again 0/0, button_rate_hard 0/1, button_rate_good 0/2, "
                    "button_rate_easy 0/3"}});
  for (const auto* rating : answers.findChildren<QPushButton*>())
    if (rating->objectName().startsWith(QStringLiteral("button_rate_"))) {
      EXPECT_EQ(rating->minimumHeight(), high);
      EXPECT_EQ(rating->maximumHeight(), high);
    }
  hint->setEnabled(false);
  EXPECT_FALSE(answers.findChild<QPushButton*>(QStringLiteral("button_hint"))->isEnabled());
}

TEST_F(MadeStudy, TheQuestionAndTheVerdictTakeEachOthersPlace) {
  window_.resize(1600, 4000);
  QuestionView view(*session_, action("show_right", "Show", Qt::Key_D), &window_);
  expect_laid_out(view, {{"question_view", "column 16 0 16 0: session_question*1, QWidget*1"},
                         {"around session_answer",
                          "row 0 0 0 0 gap 16: stretch*1, session_answer, (column gap 0: stretch*1, "
                          "session_verdict, session_reason, stretch*1), button_show_right, stretch*1"}});
  expect_made(view,
              {{"question_view", "accessibleName Question; hidden"},
               {"session_question", "alignment centre middle; textFormat RichText; wordWrap"},
               {"session_verdict", "role title"},
               {"session_reason", "role muted; textFormat PlainText"},
               {"button_show_right", "accessibleName Show; text ▶ Show  D; toolTip tip of show_right"}});
}

TEST_F(MadeStudy, TheTextOfASessionKeepsBehindTextThatIsLargerThan20Points) {
  const auto size = [](double points, practice::QuestionRoom room) {
    QFont font;
    font.setPointSizeF(points);
    QApplication::setFont(font);
    return session_font(room).pointSizeF();
  };
  using Room = practice::QuestionRoom;
  for (const Room room : {Room::full, Room::lines, Room::line}) EXPECT_DOUBLE_EQ(size(20, room), 20);
  EXPECT_DOUBLE_EQ(size(24, Room::full), 24 * 0.85);
  EXPECT_DOUBLE_EQ(size(24, Room::lines), 24 * 0.85);
  const double low = size(24, Room::line);
  EXPECT_NEAR(low, 24 * 0.72 / line_stretch(QApplication::font()), 1e-9);
  test::use_plain_look();
}

TEST_F(MadeStudy, ABarOfAListHasItsNumbersAboveAndItsTimeBelow) {
  const MilestoneBar bar(nullptr);
  EXPECT_EQ(layout_words(bar).toStdString(),
            "grid 0 0 0 0 gap 6 4: milestone_name 0/0, milestone_reached 0/1, milestone_bar 1/0 over 1/2, "
            "milestone_done 2/0 over 1/2, columns 1 1");
  expect_made(bar, {{"milestone_reached", "alignment right; role muted; textFormat PlainText; wordWrap"},
                    {"milestone_bar", "maximumHeight 8; minimumHeight 8; no textVisible"},
                    {"milestone_done", "role muted; textFormat PlainText; wordWrap"}});
}

}  // namespace
}  // namespace nazori::ui
