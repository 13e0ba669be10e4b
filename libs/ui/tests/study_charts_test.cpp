// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/charts/study_charts.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <cmath>
#include <set>

#include "nazori/practice/study_charts.h"
#include "nazori/widgets/look/palette.h"
#include "print_qt.h"
#include "progress/strength_grid.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

using practice::ChartId;
using std::chrono::days;
using std::chrono::minutes;
using study::Day;

Day day(const char* text) { return *study::parse_day(text); }

/// Four days of study in three weeks, the last of them today.
study::Statistics some_statistics() {
  study::Statistics s;
  s.today = day("2026-03-20");
  s.days = {{day("2026-03-01"), 0, 6, 2, minutes(9)},
            {day("2026-03-02"), 2, 0, 0, minutes(1)},
            {day("2026-03-10"), 10, 1, 0, minutes(4)},
            {day("2026-03-20"), 7, 0, 1, minutes(3)}};
  s.retention_days = {{day("2026-03-10"), {10, 9, 0.91}}, {day("2026-03-20"), {5, 4, 0.89}}};
  for (int i = 0; i < study::kForecastDays; ++i)
    s.forecast.push_back({s.today + days(i), i % 7 == 2 ? 4 : 1});
  s.motion = {{day("2026-03-10"), 10, 109, -2.5}, {day("2026-03-20"), 7, 218, -1.75}};
  s.hard_strokes = {{U'休', 2, 4, 9, {{kanji::MistakeKind::wrong, 1}, {kanji::MistakeKind::order, 3}}}};
  return s;
}

ChartText chart_text(ChartId id, const study::Statistics& statistics, Day first = {}) {
  return StudyCharts::text(practice::build_chart(id, statistics, first));
}

class StudyChartsTest : public testing::Test {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }
};

TEST_F(StudyChartsTest, ForecastHasARowForEachOfThirtyDays) {
  const auto s = some_statistics();
  const ChartText chart = chart_text(ChartId::forecast, s);
  ASSERT_EQ(chart.row_names.size(), 30);
  ASSERT_EQ(chart.numbers.rows.size(), 30);
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(chart.numbers.rows[i][1].toInt(), s.forecast[static_cast<std::size_t>(i)].reviews);
  }
  EXPECT_EQ(chart.summary, QStringLiteral("Next 30 days: 42. Today: 1. Busiest day: 22 Mar 2026 (4)."));
  EXPECT_EQ(chart.numbers.row_text(2), QStringLiteral("22 Mar 2026: Reviews 4"));
}

TEST_F(StudyChartsTest, ActivityCountsDaysWithoutStudyToo) {
  const ChartText chart = chart_text(ChartId::activity, some_statistics(), Day());
  ASSERT_EQ(chart.row_names.size(), 20);
  EXPECT_EQ(chart.numbers.rows[9],
            (QStringList{QStringLiteral("10 Mar 2026"), QStringLiteral("10"), QStringLiteral("1"),
                         QStringLiteral("0"), QStringLiteral("4.0")}));
  EXPECT_EQ(chart.summary,
            QStringLiteral("Reviews: 19 in 17 min. Study days: 4, with about 5 reviews in 4 min each."));
  EXPECT_EQ(chart_text(ChartId::activity, some_statistics(), day("2026-03-05")).row_names.size(), 11);
}

TEST_F(StudyChartsTest, ALongTimeIsTakenTogetherByWeekAndByMonth) {
  auto s = some_statistics();
  s.days.insert(s.days.begin(), {day("2025-11-03"), 3, 0, 0, minutes(1)});
  const ChartText weeks = chart_text(ChartId::activity, s, Day());
  EXPECT_EQ(weeks.numbers.head[0], QStringLiteral("Week starting"));
  EXPECT_EQ(weeks.row_names.size(), 20);  // Mondays from 3 November to 16 March
  s.days.front().day = day("2023-06-15");
  const ChartText months = chart_text(ChartId::activity, s, Day());
  EXPECT_EQ(months.numbers.head[0], QStringLiteral("Month starting"));
  EXPECT_EQ(months.row_names.size(), 34);
}

TEST_F(StudyChartsTest, RetentionShowsTrueBesidePredicted) {
  const ChartText chart = chart_text(ChartId::retention, some_statistics(), Day());
  EXPECT_EQ(chart.numbers.row_text(1), QStringLiteral("20 Mar 2026: Reviews 5, Recalled 80%, Predicted 89%"));
  EXPECT_EQ(chart.summary, QStringLiteral("Reviews after a day or more: 15. Recalled 87%, predicted 90%."));
}

TEST_F(StudyChartsTest, ThePenIsMeasuredInCharacterWidths) {
  const ChartText chart = chart_text(ChartId::motion, some_statistics(), Day());
  EXPECT_EQ(chart.numbers.row_text(0),
            QStringLiteral("10 Mar 2026: Times written 10, Speed 1.00, Smoothness -2.50"));
}

TEST_F(StudyChartsTest, AHardStrokeSaysWhatGoesWrongMostFirst) {
  const auto s = some_statistics();
  EXPECT_EQ(StudyCharts::mistakes(s.hard_strokes[0]),
            QStringLiteral("wrong order (3), wrong shape or position (1)"));
  const Numbers numbers = StudyCharts::hard_strokes(s);
  ASSERT_EQ(numbers.rows.size(), 1);
  EXPECT_EQ(numbers.rows[0].mid(0, 4), (QStringList{QStringLiteral("休"), QStringLiteral("3"),
                                                    QStringLiteral("4"), QStringLiteral("9")}));
}

TEST_F(StudyChartsTest, WithoutStudyEveryChartSaysWhatToDo) {
  study::Statistics none;
  none.today = day("2026-03-20");
  for (const ChartText& chart :
       {chart_text(ChartId::forecast, none), chart_text(ChartId::activity, none, Day()),
        chart_text(ChartId::retention, none, Day()), chart_text(ChartId::motion, none, Day())}) {
    EXPECT_TRUE(chart.row_names.isEmpty()) << chart.id.toStdString();
    EXPECT_TRUE(chart.numbers.rows.isEmpty());
    EXPECT_GT(chart.empty.size(), 20);
    EXPECT_FALSE(chart.title.isEmpty());
  }
}

TEST_F(StudyChartsTest, EveryChartHasWordsOfItsOwn) {
  QSet<QString> ids, titles, menu;
  for (const auto& kind : practice::chart_kinds()) {
    const ChartText text = chart_text(kind.id, some_statistics());
    ids.insert(text.id);
    titles.insert(text.title);
    menu.insert(StudyCharts::menu_text(kind.id));
    EXPECT_EQ(text.id.toStdString(), kind.name);
    EXPECT_FALSE(text.summary.isEmpty()) << kind.name;
    EXPECT_FALSE(text.series_names.isEmpty()) << kind.name;
    EXPECT_FALSE(StudyCharts::menu_tip(kind.id).isEmpty()) << kind.name;
    for (const QString& name : text.numbers.head + text.series_names)
      EXPECT_FALSE(name.isEmpty()) << kind.name;
  }
  const auto count = static_cast<qsizetype>(practice::chart_kinds().size());
  EXPECT_EQ(ids.size(), count);
  EXPECT_EQ(titles.size(), count);
  EXPECT_EQ(menu.size(), count);
}

TEST_F(StudyChartsTest, NumbersAreCopiedAsASpreadsheetTakesThem) {
  const QString text = chart_text(ChartId::retention, some_statistics(), Day()).numbers.as_text();
  EXPECT_EQ(text, QStringLiteral("Day\tReviews\tRecalled\tPredicted\n10 Mar 2026\t10\t90%\t91%\n"
                                 "20 Mar 2026\t5\t80%\t89%\n"));
}

TEST(StrengthLook, TextStandsOutAndEverySignIsAnother) {
  constexpr std::array kAll{study::Strength::unseen, study::Strength::learning, study::Strength::young,
                            study::Strength::mature, study::Strength::leech,    study::Strength::paused};
  for (const Colours* colours : {&light_colours(), &dark_colours()}) {
    std::set<QString> signs;
    for (const auto strength : kAll) {
      const StrengthLook look = look_of(strength, *colours);
      EXPECT_GE(contrast_ratio(look.fill, look.text), 4.5) << static_cast<int>(strength);
      EXPECT_TRUE(signs.insert(look.sign).second) << static_cast<int>(strength);
    }
    // A higher strength has more contrast, so that it can be seen without colour vision.
    const auto against_paper = [&](study::Strength strength) {
      return contrast_ratio(look_of(strength, *colours).fill, colours->surface);
    };
    EXPECT_LT(against_paper(study::Strength::unseen), against_paper(study::Strength::learning));
    EXPECT_LT(against_paper(study::Strength::learning), against_paper(study::Strength::young));
    EXPECT_LT(1.5 * against_paper(study::Strength::young), against_paper(study::Strength::mature));
  }
}

}  // namespace
}  // namespace nazori::ui
