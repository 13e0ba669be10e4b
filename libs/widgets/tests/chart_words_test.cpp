// SPDX-License-Identifier: Apache-2.0
// The words of the learner's charts: each chart made from a few days of study whose numbers differ.
#include <gtest/gtest.h>

#include <QLocale>

#include "nazori/practice/study_charts.h"
#include "nazori/widgets/charts/role_colours.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/look/palette.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using practice::ChartId;
using std::chrono::days;
using std::chrono::minutes;

QString said(const char* text) { return QString::fromUtf8(text); }

study::Day on(const char* text) { return *study::parse_day(text); }

class WordsOfCharts : public testing::Test {
 protected:
  WordsOfCharts() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
  ~WordsOfCharts() override { QLocale::setDefault(before_); }
  WordsOfCharts(const WordsOfCharts&) = delete;
  WordsOfCharts& operator=(const WordsOfCharts&) = delete;

  static study::Statistics three_days() {
    study::Statistics s;
    s.today = on("2026-03-03");
    s.days = {{on("2026-03-01"), 6, 3, 2, minutes(9)},
              {on("2026-03-02"), 20, 1, 0, minutes(30)},
              {on("2026-03-03"), 10, 0, 4, minutes(21)}};
    s.retention_days = {{on("2026-03-02"), {10, 9, 0.91}}, {on("2026-03-03"), {30, 21, 0.83}}};
    s.forecast = {{on("2026-03-03"), 5}, {on("2026-03-04"), 12}, {on("2026-03-05"), 7}};
    s.motion = {{on("2026-03-01"), 7, 109, -2.5}, {on("2026-03-03"), 8, 218, -1.75}};
    return s;
  }
  static ChartText text(ChartId id, const study::Statistics& statistics) {
    return StudyCharts::text(practice::build_chart(id, statistics));
  }

 private:
  QLocale before_;
};

TEST_F(WordsOfCharts, TheForecastTellsTheSumTheDayAndTheFullestDay) {
  const auto chart = text(ChartId::forecast, three_days());
  EXPECT_EQ(chart.id, said("forecast"));
  EXPECT_EQ(chart.title, said("Upcoming reviews"));
  EXPECT_EQ(chart.empty, said("Write a character from memory once, and its next review will appear here."));
  EXPECT_EQ(chart.summary, said("Next 30 days: 24. Today: 5. Busiest day: 4 Mar 2026 (12)."));
  EXPECT_EQ(chart.numbers.head, (QStringList{said("Day"), said("Reviews")}));
  EXPECT_EQ(chart.series_names, QStringList{said("Reviews")});
  EXPECT_EQ(chart.row_names, (QStringList{said("3 Mar"), said("4 Mar"), said("5 Mar")}));
  ASSERT_EQ(chart.numbers.rows.size(), 3);
  EXPECT_EQ(chart.numbers.rows[0], (QStringList{said("3 Mar 2026"), said("5")}));
  EXPECT_EQ(chart.numbers.rows[2], (QStringList{said("5 Mar 2026"), said("7")}));
}

TEST_F(WordsOfCharts, WhatWasDoneIsTheSumOfTheDaysAndTheirMeanOfReviewsAndMinutes) {
  const auto chart = text(ChartId::activity, three_days());
  EXPECT_EQ(chart.id, said("activity"));
  EXPECT_EQ(chart.title, said("Reviews and minutes"));
  EXPECT_EQ(chart.empty, said("Nothing written in this period. What you write appears here, day by day."));
  EXPECT_EQ(chart.summary,
            said("Reviews: 36 in 1 h 0 min. Study days: 3, with about 12 reviews in 20 min each."));
  EXPECT_EQ(chart.numbers.head,
            (QStringList{said("Day"), said("Reviews"), said("Practice"), said("New"), said("Minutes")}));
  EXPECT_EQ(chart.series_names, (QStringList{said("Reviews"), said("Minutes")}));
  ASSERT_EQ(chart.numbers.rows.size(), 3);
  EXPECT_EQ(chart.numbers.rows[1],
            (QStringList{said("2 Mar 2026"), said("20"), said("1"), said("0"), said("30.0")}));
}

TEST_F(WordsOfCharts, WhatWasRecalledStandsBesideWhatWasPredicted) {
  const auto chart = text(ChartId::retention, three_days());
  EXPECT_EQ(chart.id, said("retention"));
  EXPECT_EQ(chart.title, said("Recall: actual and predicted"));
  EXPECT_EQ(chart.empty, said("Starts when a character comes back after a day or more. Come back tomorrow."));
  // 30 of 40, and (10 x 0.91 + 30 x 0.83) / 40.
  EXPECT_EQ(chart.summary, said("Reviews after a day or more: 40. Recalled 75%, predicted 85%."));
  EXPECT_EQ(chart.numbers.head,
            (QStringList{said("Day"), said("Reviews"), said("Recalled"), said("Predicted")}));
  EXPECT_EQ(chart.series_names, (QStringList{said("Recalled"), said("Predicted")}));
  ASSERT_EQ(chart.numbers.rows.size(), 2);
  EXPECT_EQ(chart.numbers.rows[0], (QStringList{said("2 Mar 2026"), said("10"), said("90%"), said("91%")}));
}

TEST_F(WordsOfCharts, ThePenIsToldAtFirstAndNow) {
  const auto chart = text(ChartId::motion, three_days());
  EXPECT_EQ(chart.id, said("motion"));
  EXPECT_EQ(chart.title, said("Speed and smoothness of the pen"));
  EXPECT_EQ(chart.empty, said("Shown once you have written on the tablet with a mouse, pen or stylus."));
  EXPECT_EQ(chart.summary,
            said("Speed in character widths per second: 1.00 at first, 2.00 now. Smoothness: -2.50 at "
                 "first, -1.75 now (closer to 0 is smoother)."));
  EXPECT_EQ(chart.numbers.head,
            (QStringList{said("Day"), said("Times written"), said("Speed"), said("Smoothness")}));
  EXPECT_EQ(chart.series_names, (QStringList{said("Speed"), said("Smoothness")}));
  ASSERT_EQ(chart.numbers.rows.size(), 2);
  EXPECT_EQ(chart.numbers.rows[1], (QStringList{said("3 Mar 2026"), said("8"), said("2.00"), said("-1.75")}));
}

TEST_F(WordsOfCharts, AChartWithoutRowsHasHeadsAndNoSummary) {
  const auto chart = text(ChartId::activity, {});
  EXPECT_EQ(chart.summary, QString());
  EXPECT_TRUE(chart.row_names.isEmpty());
  EXPECT_TRUE(chart.numbers.rows.isEmpty());
  EXPECT_TRUE(chart.series_names.isEmpty());
  EXPECT_EQ(chart.numbers.head.size(), 5);
}

TEST_F(WordsOfCharts, WeeksAndMonthsAreSaidAtTheHeadAndOnTheAxis) {
  practice::Chart chart;
  chart.id = ChartId::forecast;
  chart.days = {on("2026-03-02")};
  chart.positions = {0};
  chart.columns = {{practice::Quantity::reviews, {4}}};
  chart.period = study::Period::week;
  EXPECT_EQ(StudyCharts::text(chart).numbers.head[0], said("Week starting"));
  EXPECT_EQ(StudyCharts::text(chart).row_names, QStringList{said("2 Mar")});
  chart.period = study::Period::month;
  EXPECT_EQ(StudyCharts::text(chart).numbers.head[0], said("Month starting"));
  EXPECT_EQ(StudyCharts::text(chart).row_names, QStringList{said("Mar 26")});
  QLocale::setDefault(QLocale(QLocale::Japanese));
  EXPECT_EQ(StudyCharts::text(chart).row_names, QStringList{said("2026/3")});
  chart.period = study::Period::day;
  EXPECT_EQ(StudyCharts::text(chart).row_names, QStringList{said("3/2")});
  EXPECT_EQ(StudyCharts::text(chart).numbers.rows[0][0], said("2026年3月2日"));
}

TEST_F(WordsOfCharts, TheMenuNamesEachChartAndWhereItLeads) {
  const std::tuple<ChartId, const char*, const char*> all[] = {
      {ChartId::forecast, "Up&coming reviews", "Go to the upcoming reviews"},
      {ChartId::retention, "&Recall: actual and predicted", "Go to actual and predicted recall"},
      {ChartId::activity, "Reviews and &minutes", "Go to reviews and minutes"},
      {ChartId::motion, "&Speed and smoothness", "Go to speed and smoothness of the pen"}};
  for (const auto& [id, name, tip] : all) {
    EXPECT_EQ(StudyCharts::menu_text(id), said(name));
    EXPECT_EQ(StudyCharts::menu_tip(id), said(tip));
  }
}

TEST_F(WordsOfCharts, ANumberHasItsDecimalsAndItsPercentSign) {
  EXPECT_EQ(StudyCharts::number(12.346, {2, false}), said("12.35"));
  EXPECT_EQ(StudyCharts::number(12.346, {0, true}), said("12%"));
  EXPECT_EQ(StudyCharts::number(0.5, {1, false}), said("0.5"));
}

TEST(ColoursOfRoles, AreThoseOfTheWindowMixedAsFarAsTheySay) {
  using practice::ColourRole;
  for (const Colours* c : {&light_colours(), &dark_colours()}) {
    const std::pair<ColourRole, QColor> all[] = {
        {ColourRole::paper, c->paper},      {ColourRole::surface, c->surface},
        {ColourRole::line, c->line},        {ColourRole::text, c->ink},
        {ColourRole::muted, c->muted},      {ColourRole::accent, c->indigo},
        {ColourRole::warning, c->vermilion}};
    for (const auto& [role, colour] : all) EXPECT_EQ(colour_of({role}, *c).name(), colour.name());
    // Half way from the surface to the text, each channel is the mean of both.
    const QColor half = colour_of({ColourRole::surface, ColourRole::text, 0.5}, *c);
    EXPECT_NEAR(half.redF(), (c->surface.redF() + c->ink.redF()) / 2, 1e-3);
    EXPECT_NEAR(half.blueF(), (c->surface.blueF() + c->ink.blueF()) / 2, 1e-3);
    const QColor little = colour_of({ColourRole::surface, ColourRole::text, 0.25}, *c);
    EXPECT_NEAR(little.greenF(), 0.75 * c->surface.greenF() + 0.25 * c->ink.greenF(), 1e-3);
  }
}

}  // namespace
}  // namespace nazori::ui
