// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/study_words.h"

#include <gtest/gtest.h>

#include <array>

#include "window/language.h"

namespace nazori::ui {
namespace {

using std::chrono::days;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

const study::Time kNow = *study::parse_time("2026-11-22T09:00:00Z");
const study::Day kToday = *study::parse_day("2026-11-22");

study::Card due_in(int day_count) {
  study::Card card;
  card.memory.phase = study::Phase::review;
  card.due_day = kToday + days(day_count);
  return card;
}
study::Card step_in(seconds time) {
  study::Card card;
  card.memory.phase = study::Phase::learning;
  card.memory.due = kNow + time;
  return card;
}

std::array<std::string, 2> words(const study::Card& card) {
  return {StudyWords::comes_again(card, kNow, kToday).toStdString(),
          StudyWords::comes_again_short(card, kNow, kToday).toStdString()};
}
using Words = std::array<std::string, 2>;

TEST(StudyWords, SayWhenACardComesAgain) {
  install_language(QStringLiteral("en"));
  EXPECT_EQ(words(step_in(seconds(-5))), (Words{"in 1 minute", "1 min"}));
  EXPECT_EQ(words(step_in(seconds(89))), (Words{"in 1 minute", "1 min"}));
  EXPECT_EQ(words(step_in(seconds(90))), (Words{"in 2 minutes", "2 min"}));
  EXPECT_EQ(words(step_in(minutes(10))), (Words{"in 10 minutes", "10 min"}));
  EXPECT_EQ(words(due_in(0)), (Words{"tomorrow", "1 d"}));
  EXPECT_EQ(words(due_in(1)), (Words{"tomorrow", "1 d"}));
  EXPECT_EQ(words(due_in(2)), (Words{"in 2 days", "2 d"}));
  EXPECT_EQ(words(due_in(59)), (Words{"in 59 days", "59 d"}));
  EXPECT_EQ(words(due_in(60)), (Words{"in 2 months", "2 mo"}));
  EXPECT_EQ(words(due_in(76)), (Words{"in 2 months", "2 mo"}));
  EXPECT_EQ(words(due_in(77)), (Words{"in 3 months", "3 mo"}));
  EXPECT_EQ(words(due_in(365)), (Words{"in 12 months", "12 mo"}));
  EXPECT_EQ(words(due_in(366)), (Words{"in 1.0 years", "1.0 y"}));
  EXPECT_EQ(words(due_in(548)), (Words{"in 1.5 years", "1.5 y"}));
}

TEST(StudyWords, SayHowLongSomethingTakes) {
  install_language(QStringLiteral("en"));
  EXPECT_EQ(StudyWords::about(milliseconds(29'999)), QStringLiteral("less than a minute"));
  EXPECT_EQ(StudyWords::about(milliseconds(30'001)), QStringLiteral("about 1 minute"));
  EXPECT_EQ(StudyWords::about(minutes(4)), QStringLiteral("about 4 minutes"));
}

TEST(StudyWords, NameDaysAsTheLanguageDoes) {
  install_language(QStringLiteral("en"));
  EXPECT_EQ(StudyWords::day(kToday), QStringLiteral("Sunday 22 November"));
  EXPECT_EQ(StudyWords::short_day(kToday), QStringLiteral("22 Nov 2026"));
  install_language(QStringLiteral("ja"));
  EXPECT_EQ(StudyWords::day(kToday), QStringLiteral("11月22日（日）"));
  EXPECT_EQ(StudyWords::short_day(kToday), QStringLiteral("2026/11/22"));
  install_language(QStringLiteral("en"));
}

}  // namespace
}  // namespace nazori::ui
