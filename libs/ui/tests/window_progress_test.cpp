// SPDX-License-Identifier: Apache-2.0
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTableWidget>
#include <QToolButton>

#include "characters/characters.h"
#include "nazori/widgets/charts/day_chart.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/page/window_parts.h"
#include "progress/characters_card.h"
#include "progress/progress.h"
#include "progress/progress_view.h"
#include "progress/strength_grid.h"
#include "progress/year_view.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using std::chrono::days;
using std::chrono::minutes;
using study::Rating;

WindowParts* the_parts = nullptr;
Progress* the_progress = nullptr;

std::unique_ptr<Page> make_characters(WindowParts& parts) { return std::make_unique<Characters>(parts); }
std::unique_ptr<Page> make_progress(WindowParts& parts) {
  the_parts = &parts;
  auto made = std::make_unique<Progress>(parts);
  the_progress = made.get();
  return made;
}

study::Handwriting straight_ink() {
  study::HandwritingStroke stroke;
  for (int i = 0; i < 40; ++i) stroke.push_back({{20.0 + i, 50}, i * 0.01, 0.5});
  return {stroke};
}

class ProgressTest : public WindowTest {
 protected:
  ProgressTest() {
    pages_ = {make_characters, make_progress};
    clock_ = [this] { return now_; };
  }

  void SetUp() override { install_language(QStringLiteral("en")); }

  [[nodiscard]] std::filesystem::path learner_file() const {
    return std::filesystem::path(folder_.filePath(QStringLiteral("learners/learner")).toStdString()) /
           "learner.db";
  }

  /// Three characters, written from memory again and again for three weeks; the second stroke of 二 is hard.
  void study_for_weeks() {
    auto store = study::LearnerStore::open(learner_file(), study::Access::write, clock_);
    ASSERT_TRUE(store);
    study::Settings settings;
    settings.time_zone = "UTC";
    ASSERT_TRUE(store->change_settings(settings));
    for (int turn = 0; turn < 6; ++turn) {
      for (const auto& [character, strokes] :
           {std::pair(U'一', 1), std::pair(U'二', 2), std::pair(U'三', 3)}) {
        study::Writing writing;
        writing.rating = character == U'三' && turn == 3 ? Rating::again : Rating::good;
        writing.proposed = writing.rating;
        writing.result.accepted = writing.rating != Rating::again;
        writing.result.duration = std::chrono::seconds(12);
        if (character == U'二') writing.result.mistakes = {{kanji::MistakeKind::wrong, 1}};
        ASSERT_TRUE(store->add_writing(character, strokes, writing, straight_ink()));
        now_ += minutes(1);
      }
      now_ += turn == 0 ? study::Time::duration(minutes(11)) : study::Time::duration(days(3 + turn));
    }
  }

  void go_to_progress() {
    open_window();
    action("go_progress")->trigger();
    wait_for_statistics();
  }
  void wait_for_statistics() {
    ASSERT_TRUE(QTest::qWaitFor([] { return !the_progress->is_reading(); }, 20'000));
    QCoreApplication::processEvents();
  }
  [[nodiscard]] study::Statistics truth() {
    const auto store = study::LearnerStore::open(learner_file(), study::Access::read, clock_);
    const auto found = study::statistics_of(*store);
    EXPECT_TRUE(found);
    return *found;
  }
  QTableWidget* table(const char* id) { return find<QTableWidget>((std::string(id) + "_table").c_str()); }

  study::Time now_ = *study::parse_time("2026-03-01T09:00:00Z");
};

TEST_F(ProgressTest, TheTablesHoldTheNumbersOfTheStatistics) {
  study_for_weeks();
  go_to_progress();
  const study::Statistics s = truth();
  ASSERT_EQ(table("forecast")->rowCount(), study::kForecastDays);
  for (int row = 0; row < study::kForecastDays; ++row)
    EXPECT_EQ(table("forecast")->item(row, 1)->text().toInt(),
              s.forecast[static_cast<std::size_t>(row)].reviews);
  int reviews = 0;
  for (int row = 0; row < table("activity")->rowCount(); ++row)
    reviews += table("activity")->item(row, 1)->text().toInt();
  EXPECT_EQ(reviews, s.reviews);
  EXPECT_EQ(s.reviews, 18);
  int counted = 0;
  for (int row = 0; row < table("retention")->rowCount(); ++row)
    counted += table("retention")->item(row, 1)->text().toInt();
  EXPECT_EQ(counted, s.retention.reviews);
  ASSERT_EQ(table("hard_strokes")->rowCount(), 1);
  EXPECT_EQ(table("hard_strokes")->item(0, 0)->text(), QStringLiteral("二"));
  EXPECT_EQ(table("hard_strokes")->item(0, 1)->text(), QStringLiteral("2"));
  EXPECT_EQ(table("hard_strokes")->item(0, 2)->text(), QStringLiteral("6"));
  ASSERT_EQ(table("characters")->rowCount(), 3);
  for (int row = 0; row < 3; ++row)
    EXPECT_EQ(table("characters")->item(row, 1)->text(),
              StudyCharts::strength(s.characters[static_cast<std::size_t>(row)].strength));
  EXPECT_EQ(table("motion")->rowCount(), static_cast<int>(s.motion.size()));
  EXPECT_TRUE(text("progress_figures").contains(QStringLiteral("Reviews: 18 in 4 min")))
      << text("progress_figures").toStdString();
}

TEST_F(ProgressTest, WithNothingStudiedThePageSaysHowToBegin) {
  go_to_progress();
  EXPECT_TRUE(text("progress_way").startsWith(QStringLiteral("Nothing studied yet.")));
  EXPECT_TRUE(find("calendar_days")->isVisible()) << "empty, as it will be filled";
  press(Qt::Key_M);
  for (const char* id : {"forecast_empty", "retention_empty", "activity_empty", "motion_empty",
                         "characters_empty", "hard_strokes_empty"}) {
    EXPECT_TRUE(find<QLabel>(id)->isVisible()) << id;
    EXPECT_FALSE(text(id).isEmpty()) << id;
  }
  press(Qt::Key_2);
  action("progress_copy")->trigger();
  EXPECT_TRUE(feedback().contains(QStringLiteral("no data yet"))) << feedback().toStdString();
}

TEST_F(ProgressTest, DigitsGoToChartsAndNShowsTheirNumbers) {
  study_for_weeks();
  go_to_progress();
  EXPECT_FALSE(find("retention_card")->isVisible());
  press(Qt::Key_5);
  EXPECT_TRUE(action("progress_more")->isChecked());
  auto* chart = find<DayChart>("retention_chart");
  EXPECT_EQ(window_->focusWidget(), chart);
  press(Qt::Key_N);
  EXPECT_EQ(window_->focusWidget(), table("retention"));
  EXPECT_TRUE(table("retention")->isVisible());
  press(Qt::Key_N);
  EXPECT_EQ(window_->focusWidget(), chart);
}

TEST_F(ProgressTest, ArrowsReadAChartRowByRow) {
  study_for_weeks();
  go_to_progress();
  press(Qt::Key_4);
  press(Qt::Key_Right);
  press(Qt::Key_Right);
  const QString words = text("forecast_reading");
  EXPECT_EQ(words, find<ChartCard>("forecast_card")->shown().numbers.row_text(1));
  EXPECT_EQ(find<DayChart>("forecast_chart")->accessibleDescription(), words);
  press(Qt::Key_End);
  EXPECT_EQ(find<DayChart>("forecast_chart")->row(), 29);
}

TEST_F(ProgressTest, TheNumbersOfTheChartAtHandAreCopiedByKey) {
  study_for_weeks();
  go_to_progress();
  press(Qt::Key_3);
  QGuiApplication::clipboard()->clear();
  press(Qt::Key_C, Qt::ControlModifier);
  const QString copied = QGuiApplication::clipboard()->text();
  EXPECT_EQ(copied, find<ChartCard>("hard_strokes_card")->shown().numbers.as_text());
  EXPECT_TRUE(copied.contains(QStringLiteral("二\t2\t6\t6")));
  EXPECT_TRUE(feedback().contains(QStringLiteral("Hardest strokes"))) << feedback().toStdString();
}

TEST_F(ProgressTest, TheGridIsWalkedByKeysAndEnterOpensACharacter) {
  study_for_weeks();
  go_to_progress();
  press(Qt::Key_2);
  auto* grid = find<StrengthGrid>("strength_grid");
  ASSERT_EQ(window_->focusWidget(), grid);
  press(Qt::Key_Right);
  EXPECT_TRUE(text("strength_reading").startsWith(QStringLiteral("三")))
      << text("strength_reading").toStdString();
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  press(Qt::Key_Return);
  ASSERT_TRUE(shown.wait(20'000));
  EXPECT_EQ(shown.at(0).at(0).value<char32_t>(), U'三');
}

TEST_F(ProgressTest, AListShowsWhatIsNotMetYetToo) {
  study_for_weeks();
  go_to_progress();
  auto* lists = find<QComboBox>("characters_list");
  lists->setCurrentIndex(lists->findData(QStringLiteral("grade-1")));
  EXPECT_EQ(find<StrengthGrid>("strength_grid")->states().rowCount(), 80);
  EXPECT_TRUE(text("characters_summary").contains(QStringLiteral("not studied 77")))
      << text("characters_summary").toStdString();
}

TEST_F(ProgressTest, WhatIsUndoneMeanwhileIsGoneFromTheCharts) {
  study_for_weeks();
  go_to_progress();
  auto& learner = the_parts->learner();
  ASSERT_TRUE(learner.report(learner.store().undo()));
  wait_for_statistics();
  EXPECT_EQ(truth().reviews, 17);
  int reviews = 0;
  for (int row = 0; row < table("activity")->rowCount(); ++row)
    reviews += table("activity")->item(row, 1)->text().toInt();
  EXPECT_EQ(reviews, 17);
}

TEST_F(ProgressTest, LongerAndShorterTimesAreChosenByKeyAndRemembered) {
  study_for_weeks();
  go_to_progress();
  auto* time = find<QComboBox>("progress_time");
  EXPECT_EQ(time->currentIndex(), 1);
  press(Qt::Key_L);
  EXPECT_EQ(time->currentIndex(), 2);
  press(Qt::Key_L);
  press(Qt::Key_L);
  EXPECT_EQ(feedback(), QStringLiteral("All data is shown."));
  window_->close();
  QSettings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat)
      .setValue(QStringLiteral("window/workplace"), QStringLiteral("characters"));
  go_to_progress();
  EXPECT_EQ(find<QComboBox>("progress_time")->currentIndex(), 3);
}

TEST_F(ProgressTest, TheChartsAreFoldedAwayAndThatIsRemembered) {
  study_for_weeks();
  go_to_progress();
  EXPECT_FALSE(find("progress_more_box")->isVisible());
  press(Qt::Key_M);
  EXPECT_TRUE(find("progress_more_box")->isVisible());
  EXPECT_EQ(find<QPushButton>("progress_more_button")->accessibleName(),
            QStringLiteral("Less: hide the charts"));
  window_->close();
  QSettings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat)
      .setValue(QStringLiteral("window/workplace"), QStringLiteral("characters"));
  go_to_progress();
  EXPECT_TRUE(find("progress_more_box")->isVisible());
  EXPECT_TRUE(action("progress_more")->isChecked());
  find<QPushButton>("progress_more_button")->click();
  EXPECT_FALSE(find("progress_more_box")->isVisible());
  EXPECT_FALSE(action("progress_more")->isChecked());
}

TEST_F(ProgressTest, TheCalendarIsWalkedByKeysAndSpoken) {
  study_for_weeks();
  go_to_progress();
  press(Qt::Key_1);
  auto* year = find<YearView>("calendar_days");
  ASSERT_EQ(window_->focusWidget(), year);
  const int today = year->day();
  EXPECT_TRUE(year->calendar().days[static_cast<std::size_t>(today)].is_today);
  press(Qt::Key_Up);
  EXPECT_EQ(year->day(), today - 1);
  press(Qt::Key_Left);
  EXPECT_EQ(year->day(), today - 8);
  press(Qt::Key_Home);
  EXPECT_EQ(year->accessibleDescription(), QStringLiteral("1 Jan 2026: no study"));
  year->set_day(59);
  EXPECT_EQ(year->accessibleDescription(), QStringLiteral("1 Mar 2026: from memory 6, new 3, 1 min"));
  EXPECT_EQ(text("calendar_here"), year->accessibleDescription());
  EXPECT_EQ(year->toolTip(), year->accessibleDescription());
  press(Qt::Key_PageUp);
  EXPECT_EQ(year->calendar().year, 2026) << "nothing was studied before";
}

TEST_F(ProgressTest, TheHardestStrokesArePractisedByOneKey) {
  study_for_weeks();
  go_to_progress();
  EXPECT_EQ(find<QPushButton>("progress_practise_button")->text(), QStringLiteral("Practise these, 1 min"));
  press(Qt::Key_P);
  EXPECT_TRUE(the_parts->session().is_running());
  EXPECT_EQ(the_parts->session().character(), U'二');
}

TEST_F(ProgressTest, AnotherLearnerNeverSeesWhatWasWorkedOutForTheLast) {
  study_for_weeks();
  open_window();
  auto& learner = the_parts->learner();
  action("go_progress")->trigger();
  ASSERT_TRUE(the_progress->is_reading());
  action("go_characters")->trigger();
  // The page is left, and the learner changes, while the statistics are still being worked out.
  ASSERT_TRUE(learner.switch_profile("aiko"));
  EXPECT_FALSE(the_progress->is_reading());
  const auto is_empty = [&] {
    return text("progress_way").startsWith(QStringLiteral("Nothing studied yet.")) &&
           table("hard_strokes")->rowCount() == 0 && table("characters")->rowCount() == 0 &&
           find<YearView>("calendar_days")->calendar().study_days == 0;
  };
  EXPECT_TRUE(is_empty());
  // Even an answer that was already on its way does not arrive.
  for (int pass = 0; pass < 20; ++pass) QCoreApplication::processEvents();
  EXPECT_TRUE(is_empty());
  action("go_progress")->trigger();
  wait_for_statistics();
  EXPECT_TRUE(is_empty());
  ASSERT_TRUE(learner.switch_profile("learner"));
  EXPECT_TRUE(is_empty()) << "until they are read again";
  wait_for_statistics();
  EXPECT_EQ(table("characters")->rowCount(), 3);
}

TEST_F(ProgressTest, EverythingFitsAtTheLargestText) {
  study_for_weeks();
  go_to_progress();
  press(Qt::Key_M);
  set_text_size(Preferences::kMaxText_pt);
  const auto* scroll = find<QScrollArea>("progress_scroll");
  EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width());
  for (const auto* label : window_->findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty() || !scroll->isAncestorOf(label)) continue;
    EXPECT_GE(label->width(), label->wordWrap() ? 40 : label->sizeHint().width())
        << label->objectName().toStdString();
    EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->objectName().toStdString();
  }
  for (const auto* button : scroll->findChildren<QToolButton*>()) {
    if (!button->isVisible()) continue;
    EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->objectName().toStdString();
  }
}

TEST_F(ProgressTest, EveryChartHasWordsForAScreenReader) {
  study_for_weeks();
  go_to_progress();
  for (const char* id :
       {"forecast", "retention", "activity", "motion", "characters", "hard_strokes", "calendar"}) {
    const auto* drawing = find((std::string(id) + "_chart").c_str());
    EXPECT_FALSE(drawing->accessibleName().isEmpty()) << id;
    EXPECT_TRUE(drawing->accessibleDescription().contains(QStringLiteral("N: show all numbers"))) << id;
    EXPECT_FALSE(table(id)->item(0, 0)->data(Qt::AccessibleTextRole).toString().isEmpty()) << id;
  }
}

}  // namespace
}  // namespace nazori::ui
