// SPDX-License-Identifier: Apache-2.0
// What stands where on the page of progress and in the dialogs for learners, and how each part is made.
#include <QSignalSpy>
#include <QTest>

#include "chosen_session_under_test.h"
#include "described_widget.h"
#include "learners/anki_dialog.h"
#include "learners/backups_dialog.h"
#include "learners/exchange_progress.h"
#include "learners/learners_dialog.h"
#include "progress/calendar_card.h"
#include "progress/characters_card.h"
#include "progress/hard_strokes_card.h"
#include "progress/progress_view.h"
#include "progress/strength_grid.h"
#include "progress/year_view.h"

namespace nazori::ui {
namespace {

using test::expect_laid_out;
using test::expect_made;
using test::layout_words;
using test::made_words;

class MadePages : public ChosenSessionTest {
 protected:
  MadePages() {
    install_language(QStringLiteral("en"));
    test::use_plain_look();
  }
  static int em() { return QFontInfo(QApplication::font()).pixelSize(); }
};

class MadeProgress : public MadePages {
 protected:
  ProgressView view_{*learner_};
};

TEST_F(MadeProgress, ThePageHasItsCardsAndBelowThemTheChartsThatAreFoldedAway) {
  const int letter = QFontMetrics(view_.font()).averageCharWidth();
  const std::string charts_of_two =
      "(grid: forecast_card 0/0, retention_card 0/1, activity_card 1/0, motion_card 1/1, columns 1 "
      "1)";
  test::resize_unseen(view_, {100 * letter, 900});
  const int beside = std::max(16, (100 * letter - 100 * em()) / 2);
  expect_laid_out(
      view_,
      {{"progress_page", "column 0 0 0 0: progress_scroll*1, progress_trouble*1"},
       {"progress_content",
        QStringLiteral("column %1 16 %1 16 gap 14: progress_title, progress_way, progress_work, "
                       "(grid: calendar_card 0/0 over 1/2, characters_card 1/0, hard_strokes_card 1/1, "
                       "columns 1 1), progress_more_button left, progress_more_box, stretch*1")
            .arg(beside)
            .toStdString()
            .c_str()},
       {"progress_more_box", ("column 0 0 0 0 gap 14: progress_figures, (row gap 8: “Period s&hown”, "
                              "progress_time, stretch*1), " +
                              charts_of_two)
                                 .c_str()}});
  test::resize_unseen(view_, {100 * letter - 1, 900});
  EXPECT_TRUE(layout_words(*view_.findChild<QWidget*>(QStringLiteral("progress_content")))
                  .contains(QStringLiteral("(grid: calendar_card 0/0, characters_card 1/0, "
                                           "hard_strokes_card 2/0, columns 1 0)")));
  EXPECT_TRUE(layout_words(*view_.findChild<QWidget*>(QStringLiteral("progress_more_box")))
                  .contains(QStringLiteral("(grid: forecast_card 0/0, retention_card 1/0, activity_card "
                                           "2/0, motion_card 3/0, columns 1 0)")));
  test::resize_unseen(view_, {100 * em() + 400, 900});
  EXPECT_TRUE(layout_words(*view_.findChild<QWidget*>(QStringLiteral("progress_content")))
                  .startsWith(QStringLiteral("column 200 16 200 16")));
}

TEST_F(MadeProgress, EachPartIsMadeForWhatItIs) {
  expect_made(
      view_,
      {{"progress_page", "accessibleName Progress; focusPolicy StrongFocus"},
       {"progress_scroll",
        "focusPolicy NoFocus; horizontalScrollBarPolicy ScrollBarAlwaysOff; widgetResizable"},
       {"progress_trouble", "alignment centre middle; hidden; margin 48; textFormat PlainText; wordWrap"},
       {"progress_title", "letters 1.7; text Progress; textFormat PlainText; wordWrap"},
       {"progress_work",
        "accessibleName Calculating statistics; hidden; no textVisible; text 100%; value 100"},
       {"progress_practise_button",
        "autoDefault; hidden; role link; text Practise these, 1 min; toolTip Write these characters from "
        "memory "
        "once (P)"},
       {"progress_more_button",
        "accessibleName More charts and figures; autoDefault; role link; text ▸ More charts and figures; "
        "toolTip Show or hide the charts (M)"},
       {"progress_more_box", "hidden"}});
  EXPECT_EQ(view_.findChild<QLabel*>(QStringLiteral("progress_figures"))->textInteractionFlags(),
            Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  for (const auto* label : view_.findChildren<QLabel*>())
    if (label->text() == QStringLiteral("Period s&hown")) {
      EXPECT_EQ(made_words(*label).toStdString(), "of progress_time; text Period s&hown");
    }
  QSignalSpy changed(&view_, &ProgressView::more_changed);
  view_.findChild<QPushButton*>(QStringLiteral("progress_more_button"))->click();
  EXPECT_TRUE(view_.shows_more());
  expect_made(view_, {{"progress_more_button",
                       "accessibleName Less: hide the charts; autoDefault; role link; text ▾ More charts and "
                       "figures; toolTip Show or hide the charts (M)"},
                      {"progress_more_box", ""}});
  view_.set_shows_more(true);
  EXPECT_EQ(changed.count(), 1) << "nothing changes";
  view_.go_to(QStringLiteral("motion"));
  view_.set_shows_more(false);
  EXPECT_EQ(view_.card_at_hand()->objectName(), QStringLiteral("calendar_card")) << "the other is hidden";
  EXPECT_EQ(changed.count(), 2);
}

TEST_F(MadeProgress, OfTheHardestStrokesFourCharactersArePractised) {
  study::Statistics statistics;
  statistics.today = learner_->store().today();
  for (const char32_t one : std::u32string_view(U"休休人一休二三")) {
    study::HardStroke hard;
    hard.character = one;
    hard.mistakes = 2;
    hard.writings = 4;
    hard.kinds = {{kanji::MistakeKind::wrong, 2}};
    statistics.hard_strokes.push_back(hard);
  }
  view_.show_statistics(std::make_shared<const study::Statistics>(statistics));
  EXPECT_EQ(view_.hardest(), (std::vector<char32_t>{U'休', U'人', U'一', U'二'}));
  const auto* practise = view_.findChild<QPushButton*>(QStringLiteral("progress_practise_button"));
  EXPECT_FALSE(practise->isHidden());
  EXPECT_EQ(practise->parentWidget()->objectName(), QStringLiteral("hard_strokes_card"));
  learner_->let_go(practice::LearnerEvent::Kind::replacing);
  view_.show_statistics(std::make_shared<const study::Statistics>(statistics));
  EXPECT_TRUE(practise->isHidden()) << "nothing can be kept";
}

/// What the page says of the way to go, with one character learned.
class WayOfProgress : public MadeProgress {
 protected:
  std::string says(const char* name) {
    study::Statistics statistics;
    statistics.today = learner_->store().today();
    statistics.characters = {{U'一', study::Strength::young, 0.9}};
    view_.show_statistics(std::make_shared<const study::Statistics>(statistics));
    const auto* label = view_.findChild<QLabel*>(QString::fromLatin1(name));
    return (label->isHidden() ? QStringLiteral("(hidden)") : label->text()).toStdString();
  }
  /// A character is learned today. @param time  that it took; what took none counts for no pace.
  void learn_one(char32_t character, std::chrono::seconds time) {
    study::Writing writing;
    writing.rating = study::Rating::easy;
    writing.result.duration = time;
    ASSERT_TRUE(learner_->store().add_writing(character, 1, writing));
  }
};

TEST_F(WayOfProgress, IsThatOfTheSchoolKanjiAndThenOfEachList) {
  learn_from({U'一', U'二', U'三', U'四'});
  learn_one(U'一', std::chrono::seconds(0));
  EXPECT_EQ(says("progress_title"), "1 of 2,136 school kanji");
  EXPECT_EQ(says("progress_way"), "My list: few: 1 of 4.");
  learn_one(U'二', std::chrono::seconds(20));
  EXPECT_EQ(says("progress_way"), "My list: few: 2 of 4, at this pace done in about 2 days.");
}

TEST_F(WayOfProgress, WithoutKanjiIsThatOfTheListThatIsLearned) {
  learn_from({U'あ', U'い', U'う', U'え', U'お'});
  EXPECT_EQ(says("progress_title"), "My list: few: 0 of 5");
  EXPECT_EQ(says("progress_way"), "(hidden)") << "there is no pace yet";
  view_.clear();
  EXPECT_FALSE(view_.findChild<QLabel*>(QStringLiteral("progress_way"))->isHidden())
      << "who has studied nothing is told how to begin";
  learn_one(U'あ', std::chrono::seconds(20));
  EXPECT_EQ(says("progress_title"), "My list: few: 1 of 5");
  EXPECT_EQ(says("progress_way"), "At this pace, all of them in about 4 days.");
  auto settings = learner_->store().settings();
  settings.new_lists.clear();
  ASSERT_TRUE(learner_->store().change_settings(settings));
  EXPECT_EQ(says("progress_title"), "Progress");
  EXPECT_EQ(says("progress_way"), "(hidden)") << "there is no list";
}

TEST_F(MadePages, TheCalendarGoesThroughTheYearsOfStudy) {
  CalendarCard card(nullptr);
  expect_laid_out(card, {{"calendar_chart",
                          "column 0 0 0 0 gap 8: (row: calendar_earlier, calendar_year, calendar_later, "
                          "stretch*1), calendar_days, calendar_here, stretch*1"}});
  expect_made(card,
              {{"calendar_earlier", "accessibleName Earlier year; text ◀; toolTip Earlier year (Page Up)"},
               {"calendar_later", "accessibleName Later year; text ▶; toolTip Later year (Page Down)"},
               {"calendar_year", "textFormat PlainText"},
               {"calendar_here", "role muted; textFormat PlainText; wordWrap"},
               {"calendar_chart", "keyboard to calendar_days"}});
  const auto day = [](const char* text) { return *study::parse_day(text); };
  study::Statistics statistics;
  statistics.today = day("2026-03-02");
  statistics.days = {{day("2024-12-31"), 3, 1, 2, std::chrono::minutes(5)},
                     {day("2026-02-01"), 4, 0, 1, std::chrono::minutes(6)}};
  card.show_calendar(statistics);
  auto* earlier = card.findChild<QToolButton*>(QStringLiteral("calendar_earlier"));
  auto* later = card.findChild<QToolButton*>(QStringLiteral("calendar_later"));
  const auto state = [&] {
    return card.findChild<QLabel*>(QStringLiteral("calendar_year"))->text().toStdString() +
           (earlier->isHidden() ? " h" : " ") + (earlier->isEnabled() ? "<" : "") +
           (later->isHidden() ? "h" : "") + (later->isEnabled() ? ">" : "");
  };
  EXPECT_EQ(state(), "2026 <");
  earlier->click();
  EXPECT_EQ(state(), "2025 <>");
  EXPECT_EQ(card.shown().numbers.rows.size(), 1);
  EXPECT_EQ(card.shown().numbers.rows[0].mid(0, 4), (QStringList{QStringLiteral("2025"), QStringLiteral("0"),
                                                                 QStringLiteral("0"), QStringLiteral("0")}));
  emit card.findChild<YearView*>()->year_wanted(-1);
  EXPECT_EQ(state(), "2024 >");
  EXPECT_EQ(card.shown().numbers.rows,
            (QList<QStringList>{{QStringLiteral("31 Dec 2024"), QStringLiteral("3"), QStringLiteral("1"),
                                 QStringLiteral("2"), QStringLiteral("5 min")}}));
  EXPECT_EQ(card.shown().summary,
            QStringLiteral("Study days in 2024: 1. Darker squares: written or practised more often."));
  EXPECT_EQ(card.shown().numbers.head,
            (QStringList{QStringLiteral("Day"), QStringLiteral("From memory"), QStringLiteral("Practised"),
                         QStringLiteral("New"), QStringLiteral("Time")}));
  emit card.findChild<YearView*>()->year_wanted(-1);
  EXPECT_EQ(state(), "2024 >") << "nothing was studied before";
  later->click();
  later->click();
  EXPECT_EQ(state(), "2026 <");
  emit card.findChild<YearView*>()->year_wanted(+1);
  EXPECT_EQ(state(), "2026 <") << "the next year is to come";
  EXPECT_EQ(card.shown().numbers.rows.size(), 2) << "the day of study, and today";
  EXPECT_EQ(
      card.findChild<YearView*>()->accessibleName(),
      QStringLiteral("Calendar of 2026. Arrow keys: day by day and week by week. Levels: none, 1 to 9, 10 "
                     "to 29, 30 to 59, 60 or more."));
  statistics.days.erase(statistics.days.begin());
  card.show_calendar(statistics);
  EXPECT_EQ(state(), "2026 hh") << "there is one year only";
}

TEST_F(MadePages, TheDaysOfAYearAreSaidWithWhatWasDone) {
  YearView year(nullptr);
  EXPECT_EQ(made_words(year).toStdString(),
            "focusPolicy StrongFocus; mouseTracking; sizePolicy Expanding Preferred with height");
  practice::CalendarDay day;
  day.activity = {*study::parse_day("2026-03-02"), 3, 1, 2, std::chrono::minutes(5)};
  day.level = practice::DayLevel::none;
  EXPECT_EQ(YearView::words(day).toStdString(), "2 Mar 2026: no study");
  day.is_today = true;
  EXPECT_EQ(YearView::words(day).toStdString(), "2 Mar 2026, today: no study yet");
  day.level = practice::DayLevel::some;
  EXPECT_EQ(YearView::words(day).toStdString(),
            "2 Mar 2026, today: from memory 3, practised 1, new 2, 5 min");
  day.is_today = false;
  day.activity.reviews = day.activity.introduced = 0;
  EXPECT_EQ(YearView::words(day).toStdString(), "2 Mar 2026: practised 1, 5 min");
}

TEST_F(MadePages, TheKeysOfTheCalendarGoFromDayToDayWithinItsYear) {
  YearView year(nullptr);
  study::Statistics statistics;
  statistics.today = *study::parse_day("2026-03-02");
  year.show_year(practice::year_calendar(statistics, 2026));
  EXPECT_EQ(year.day(), 60) << "today";
  EXPECT_EQ(year.toolTip(), QStringLiteral("2 Mar 2026, today: no study yet"));
  EXPECT_EQ(year.accessibleDescription(), year.toolTip());
  QSignalSpy wanted(&year, &YearView::year_wanted), walked(&year, &YearView::walked);
  QTest::keyClick(&year, Qt::Key_PageUp);
  QTest::keyClick(&year, Qt::Key_PageDown);
  ASSERT_EQ(wanted.count(), 2);
  EXPECT_EQ(wanted.at(0).at(0).toInt(), -1);
  EXPECT_EQ(wanted.at(1).at(0).toInt(), 1);
  year.set_day(-5);
  EXPECT_EQ(year.day(), 0);
  year.set_day(999);
  EXPECT_EQ(year.day(), 364);
  EXPECT_EQ(walked.count(), 2);
  year.set_day(364);
  EXPECT_EQ(walked.count(), 2) << "it was there";
  year.show_year(practice::year_calendar(statistics, 2026));
  EXPECT_EQ(year.day(), 364) << "the same year: the place is kept";
  year.show_year(practice::year_calendar(statistics, 2025));
  EXPECT_EQ(year.day(), 364) << "another: today is not in it";
}

TEST_F(MadePages, TheGridAndTheListOfProgressScrollUpAndDownOnly) {
  const CharactersCard characters;
  expect_laid_out(characters,
                  {{"characters_chart",
                    "column 0 0 0 0 gap 8: characters_list left, strength_grid*1, strength_reading"}});
  expect_made(characters, {{"characters_chart", "keyboard to strength_grid"},
                           {"strength_grid",
                            "acceptDrops; dragDropMode DropOnly; flow LeftToRight; horizontalScrollBarPolicy "
                            "ScrollBarAlwaysOff; isWrapping; mouseTracking; "
                            "resizeMode Adjust; selectionRectVisible; uniformItemSizes; verticalScrollMode "
                            "ScrollPerPixel; viewMode IconMode"}});
  EXPECT_EQ(characters.findChild<QWidget*>(QStringLiteral("characters_list"))->accessibleName(),
            QStringLiteral("Characters to show"));
  const HardStrokesCard strokes;
  expect_made(strokes,
              {{"hard_strokes_chart",
                "horizontalScrollBarPolicy ScrollBarAlwaysOff; resizeMode Adjust; verticalScrollMode "
                "ScrollPerPixel"}});
}

TEST_F(MadePages, ADeckForAnkiIsChosenInThreeFields) {
  AnkiDialog dialog(learner_->store(), nullptr);
  expect_laid_out(dialog,
                  {{"anki_dialog",
                    "form 20 20 20 16 gap 12 12 wraps: “&Characters” | anki_list, “&Deck” | anki_deck, "
                    "“&Words per character” | anki_words, QDialogButtonBox"}});
  const practice::AnkiChoice usual;
  expect_made(dialog, {{"anki_dialog", "windowTitle Export for Anki"},
                       {"anki_deck", ("maxLength 40; text " + usual.deck).c_str()},
                       {"anki_words", ("maximum 20; value " + std::to_string(usual.words)).c_str()}});
  EXPECT_EQ(dialog.choice().list, "grade-1") << "nothing is studied yet";
  QSignalSpy accepted(&dialog, &QDialog::accepted);
  for (auto* button : dialog.findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Choose file…")) {
      EXPECT_TRUE(button->isDefault());
      button->click();
    }
  EXPECT_EQ(accepted.count(), 1);
  know(U'一');
  EXPECT_EQ(AnkiDialog(learner_->store(), nullptr).choice().list, "");
  dialog.findChild<QLineEdit*>(QStringLiteral("anki_deck"))->setText(QStringLiteral(" mine "));
  dialog.findChild<QSpinBox*>()->setValue(7);
  EXPECT_EQ(dialog.choice().deck, "mine");
  EXPECT_EQ(dialog.choice().words, 7);
}

TEST_F(MadePages, LearnersAndBackupsStandAboveWhatCanBeDoneWithThem) {
  const LearnersDialog learners(*learner_, nullptr);
  expect_laid_out(
      learners,
      {{"learners_dialog",
        "column 20 20 20 16 gap 10: “&Learners”, learners_list*1, learner_choose, "
        "“&Name (to add or rename)”, learner_name, (row: learner_add, learner_rename, learner_remove, "
        "stretch*1), learners_words, QDialogButtonBox"}});
  const int line = QFontMetrics(learners.font()).height();
  EXPECT_EQ(learners.size(), QSize(20 * line, 22 * line));
  const std::string words = "Each learner has their own study history, settings and backups.";
  expect_made(
      learners,
      {{"learners_dialog", "windowTitle Learners"},
       {"learners_list", "accessibleName Learners"},
       {"learner_name", "accessibleName Name (to add or rename)"},
       {"learner_choose", "default; text &Study as this learner"},
       {"learner_add", "text &Add"},
       {"learner_rename", "text &Rename"},
       {"learner_remove", "text Re&move…"},
       {"learners_words",
        ("accessibleName " + words + "; text " + words + "; textFormat PlainText; wordWrap").c_str()}});
  for (const auto* label : learners.findChildren<QLabel*>())
    if (label->objectName().isEmpty()) {
      EXPECT_EQ(label->buddy()->objectName(), label->text() == QStringLiteral("&Learners")
                                                  ? QStringLiteral("learners_list")
                                                  : QStringLiteral("learner_name"));
    }
  QWidget window;
  practice::LearnerExchange exchange(inbox_.inbox(), *learner_);
  const ExchangeProgress progress(exchange, &window);
  const BackupsDialog backups(inbox_.inbox(), *learner_, exchange, progress, nullptr);
  expect_laid_out(backups, {{"backups_dialog",
                             "column 20 20 20 16 gap 10: backups_table*1, (row: backup_restore, backup_now, "
                             "stretch*1), backups_words, QDialogButtonBox"}});
  EXPECT_EQ(backups.size(), QSize(38 * line, 20 * line));
  expect_made(backups,
              {{"backup_now", "text &Back up now"}, {"backup_restore", "no enabled; text &Restore…"}});
  const auto* table = backups.findChild<QTableWidget*>();
  QStringList heads;
  for (int column = 0; column < table->columnCount(); ++column)
    heads.append(table->horizontalHeaderItem(column)->text());
  EXPECT_EQ(heads.join(QLatin1Char('|')), QStringLiteral("Type|Last study day|Times written|Characters"));
}

}  // namespace
}  // namespace nazori::ui
