// SPDX-License-Identifier: Apache-2.0
// The words of the charts one by one, and how days, weeks and months are named.
#include <gtest/gtest.h>

#include <map>

#include "nazori/practice/study_charts.h"
#include "nazori/widgets/charts/study_charts.h"
#include "print_qt.h"
#include "progress/strength_grid.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

using practice::ChartId;
using std::chrono::days;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using study::Day;

const Day kToday = *study::parse_day("2026-03-20");

class StudyChartsBounds : public testing::Test {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }
};

ChartText chart_text(ChartId id, const study::Statistics& statistics, Day first = {}) {
  return StudyCharts::text(practice::build_chart(id, statistics, first));
}

std::string text(const QString& words) { return words.toStdString(); }

TEST_F(StudyChartsBounds, EveryStrengthAndEveryMistakeHasItsWords) {
  using study::Strength;
  const std::map<Strength, std::string> strengths{
      {Strength::unseen, "not studied"},     {Strength::learning, "learning"},
      {Strength::young, "recently learned"}, {Strength::mature, "well known"},
      {Strength::leech, "difficult"},        {Strength::paused, "suspended"}};
  for (const auto& [strength, words] : strengths) EXPECT_EQ(text(StudyCharts::strength(strength)), words);
  using kanji::MistakeKind;
  const std::map<MistakeKind, std::string> mistakes{{MistakeKind::order, "wrong order"},
                                                    {MistakeKind::reversed, "drawn backwards"},
                                                    {MistakeKind::missing, "missing"},
                                                    {MistakeKind::extra, "extra stroke"},
                                                    {MistakeKind::joined, "joined to another stroke"},
                                                    {MistakeKind::split, "split into pieces"},
                                                    {MistakeKind::wrong, "wrong shape or position"},
                                                    {MistakeKind::other, "stroke of another character"},
                                                    {MistakeKind::ending, "wrong ending"}};
  for (const auto& [mistake, words] : mistakes) EXPECT_EQ(text(StudyCharts::mistake(mistake)), words);
}

TEST_F(StudyChartsBounds, MistakesThatAreAsFrequentStandInTheirOwnOrder) {
  using kanji::MistakeKind;
  const study::HardStroke stroke{
      U'休', 0, 3, 3, {{MistakeKind::reversed, 1}, {MistakeKind::order, 1}, {MistakeKind::wrong, 2}}};
  EXPECT_EQ(text(StudyCharts::mistakes(stroke)),
            "wrong shape or position (2), wrong order (1), drawn backwards (1)");
}

TEST_F(StudyChartsBounds, TimesAreMinutesThenHours) {
  EXPECT_EQ(text(StudyCharts::duration(seconds(29))), "0 min");
  EXPECT_EQ(text(StudyCharts::duration(seconds(31))), "1 min");
  EXPECT_EQ(text(StudyCharts::duration(minutes(59))), "59 min");
  EXPECT_EQ(text(StudyCharts::duration(minutes(60))), "1 h 0 min");
  EXPECT_EQ(text(StudyCharts::duration(minutes(500))), "8 h 20 min");
}

TEST_F(StudyChartsBounds, SharesAreWholePercents) {
  EXPECT_EQ(text(StudyCharts::percent(0)), "0%");
  EXPECT_EQ(text(StudyCharts::percent(0.914)), "91%");
  EXPECT_EQ(text(StudyCharts::percent(0.916)), "92%");
  EXPECT_EQ(text(StudyCharts::percent(1)), "100%");
}

TEST_F(StudyChartsBounds, DatesAreThoseOfTheLanguage) {
  EXPECT_EQ(text(StudyCharts::date(kToday)), "20 Mar 2026");
  install_language(QStringLiteral("ja"));
  EXPECT_EQ(StudyCharts::date(kToday), QStringLiteral("2026年3月20日"));
  study::Statistics s;
  s.today = kToday;
  s.days = {{kToday, 1, 0, 0, minutes(1)}};
  EXPECT_EQ(chart_text(ChartId::activity, s, Day()).row_names, QStringList{QStringLiteral("3/20")});
  s.days.insert(s.days.begin(), {kToday - days(900), 1, 0, 0, minutes(1)});
  EXPECT_EQ(chart_text(ChartId::activity, s, Day()).row_names.back(), QStringLiteral("2026/3"));
  install_language(QStringLiteral("en"));
  EXPECT_EQ(text(chart_text(ChartId::activity, s, Day()).row_names.back()), "Mar 26");
  s.days.erase(s.days.begin());
  EXPECT_EQ(text(chart_text(ChartId::activity, s, Day()).row_names.back()), "20 Mar");
}

/// The first heading of a chart whose first row is this many days ago, including today.
std::string head(ChartId chart, int day_count, Day first = {}) {
  const Day begin = kToday - days(day_count - 1);
  study::Statistics s;
  s.today = kToday;
  s.days = {{begin, 1, 0, 0, minutes(1)}, {kToday, 1, 0, 0, minutes(1)}};
  s.retention_days = {{begin, {1, 1, 0.9}}, {kToday, {1, 1, 0.9}}};
  s.motion = {{begin, 1, 109, -2}, {kToday, 1, 109, -2}};
  return text(chart_text(chart, s, first).numbers.head[0]);
}

TEST_F(StudyChartsBounds, ASeasonIsShownByDaysAndTwoYearsByWeeks) {
  for (const auto chart : {ChartId::activity, ChartId::motion}) {
    EXPECT_EQ(head(chart, 92), "Day");
    EXPECT_EQ(head(chart, 93), "Week starting");
    EXPECT_EQ(head(chart, 800), "Week starting");
    EXPECT_EQ(head(chart, 801), "Month starting");
    EXPECT_EQ(head(chart, 801, kToday - days(91)), "Day") << "less is shown";
  }
  EXPECT_EQ(head(ChartId::retention, 31), "Day");
  EXPECT_EQ(head(ChartId::retention, 32), "Week starting");
  EXPECT_EQ(head(ChartId::retention, 801), "Month starting");
  EXPECT_EQ(head(ChartId::retention, 801, kToday - days(30)), "Day");
}

TEST_F(StudyChartsBounds, OfReviewsToComeTheFirstOfTheFullestDaysIsNamed) {
  study::Statistics s;
  s.today = kToday;
  for (const int reviews : {2, 5, 1, 5}) s.forecast.push_back({kToday + days(s.forecast.size()), reviews});
  const ChartText chart = chart_text(ChartId::forecast, s);
  EXPECT_EQ(text(chart.summary), "Next 30 days: 13. Today: 2. Busiest day: 21 Mar 2026 (5).");
  EXPECT_EQ(text(chart.row_names[1]), "21 Mar");
  s.forecast.front().reviews = 5;
  EXPECT_TRUE(chart_text(ChartId::forecast, s).summary.contains(QStringLiteral("Busiest day: 20 Mar 2026")));
}

TEST_F(StudyChartsBounds, MinutesHaveAnAxisOfTheirOwn) {
  study::Statistics s;
  s.today = kToday;
  s.days = {{kToday - days(1), 3, 2, 1, milliseconds(90'000)}, {kToday, 6, 0, 0, seconds(15)}};
  const ChartText chart = chart_text(ChartId::activity, s, Day());
  EXPECT_EQ(chart.series_names, (QStringList{QStringLiteral("Reviews"), QStringLiteral("Minutes")}));
  EXPECT_EQ(chart.numbers.row_text(0).toStdString(),
            "19 Mar 2026: Reviews 3, Practice 2, New 1, Minutes 1.5");
  EXPECT_TRUE(chart.summary.startsWith(QStringLiteral("Reviews: 9 in 2 min. Study days: 2, with about")));
  const ChartText last = chart_text(ChartId::activity, s, kToday);
  EXPECT_TRUE(last.summary.startsWith(QStringLiteral("Reviews: 6 in 0 min. Study days: 1, with about 6 ")));
}

TEST_F(StudyChartsBounds, RecalledAndPredictedAreMeansOverTheReviews) {
  study::Statistics s;
  s.today = kToday;
  s.retention_days = {{kToday - days(1), {4, 3, 0.62}}, {kToday, {2, 2, 0.92}}};
  const ChartText chart = chart_text(ChartId::retention, s, Day());
  EXPECT_EQ(chart.series_names, (QStringList{QStringLiteral("Recalled"), QStringLiteral("Predicted")}));
  // (4 * 0.62 + 2 * 0.92) / 6 = 0.72
  EXPECT_EQ(text(chart.summary), "Reviews after a day or more: 6. Recalled 83%, predicted 72%.");
}

TEST_F(StudyChartsBounds, OfThePenTheFirstAndTheLastAreSaid) {
  study::Statistics s;
  s.today = kToday;
  s.motion = {{kToday - days(2), 1, 109, -2.5}, {kToday - days(1), 1, 545, -9}, {kToday, 1, 218, -1.75}};
  const ChartText chart = chart_text(ChartId::motion, s, Day());
  EXPECT_EQ(text(chart.summary),
            "Speed in character widths per second: 1.00 at first, 2.00 now. Smoothness: -2.50 at first, "
            "-1.75 now (closer to 0 is smoother).");
}

TEST_F(StudyChartsBounds, ARowOutsideTheTableHasNoWords) {
  Numbers numbers{{QStringLiteral("Day"), QStringLiteral("A"), QStringLiteral("B")},
                  {{QStringLiteral("x"), QStringLiteral("1"), QStringLiteral("2")},
                   {},
                   {QStringLiteral("y"), QStringLiteral("3"), QStringLiteral("4"), QStringLiteral("5")},
                   {QStringLiteral("z"), QStringLiteral("6")}}};
  EXPECT_EQ(text(numbers.row_text(0)), "x: A 1, B 2");
  EXPECT_TRUE(numbers.row_text(-1).isEmpty());
  EXPECT_TRUE(numbers.row_text(1).isEmpty());
  EXPECT_EQ(text(numbers.row_text(2)), "y: A 3, B 4");
  EXPECT_EQ(text(numbers.row_text(3)), "z: A 6");
  EXPECT_TRUE(numbers.row_text(4).isEmpty());
}

TEST_F(StudyChartsBounds, TheGridTellsStrengthAndChanceOfWhatIsKnown) {
  StrengthModel model;
  model.set_states({{U'休', study::Strength::young, 0.93},
                    {U'木', study::Strength::unseen, 0.5},
                    {U'人', study::Strength::paused, 0}});
  EXPECT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.rowCount(model.index(0)), 0);
  EXPECT_EQ(model.at(0), U'休');
  EXPECT_EQ(model.at(2), U'人');
  EXPECT_EQ(model.at(-1), 0U);
  EXPECT_EQ(model.at(3), 0U);
  const auto data = [&](int row, int role) { return model.data(model.index(row), role); };
  EXPECT_EQ(data(0, Qt::DisplayRole).toString(), QStringLiteral("休"));
  EXPECT_EQ(data(0, Qt::ToolTipRole).toString(),
            QStringLiteral("休, recently learned, 93% likely to be remembered"));
  EXPECT_EQ(data(0, Qt::AccessibleTextRole), data(0, Qt::ToolTipRole));
  EXPECT_EQ(data(1, Qt::ToolTipRole).toString(), QStringLiteral("木, not studied"));
  EXPECT_EQ(data(2, Qt::ToolTipRole).toString(), QStringLiteral("人, suspended"));
  EXPECT_EQ(data(2, StrengthModel::kStrengthRole).toInt(), static_cast<int>(study::Strength::paused));
  EXPECT_FALSE(data(0, Qt::DecorationRole).isValid());
  EXPECT_FALSE(model.data({}, Qt::DisplayRole).isValid());
}

TEST_F(StudyChartsBounds, SignsOfStrengthAreThoseOfTheManual) {
  const auto sign = [](study::Strength strength) { return look_of(strength, light_colours()).sign; };
  EXPECT_EQ(sign(study::Strength::learning), QStringLiteral("◔"));
  EXPECT_EQ(sign(study::Strength::young), QStringLiteral("◑"));
  EXPECT_EQ(sign(study::Strength::mature), QStringLiteral("●"));
  EXPECT_EQ(sign(study::Strength::leech), QStringLiteral("!"));
  EXPECT_EQ(sign(study::Strength::paused), QStringLiteral("‖"));
  EXPECT_EQ(sign(study::Strength::unseen), QString());
}

}  // namespace
}  // namespace nazori::ui
