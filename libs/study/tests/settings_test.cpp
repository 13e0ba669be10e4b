// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "nazori/study/pace.h"
#include "nazori/study/statistics.h"

namespace nazori::study {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::minutes;
using testing::AllOf;
using testing::HasSubstr;

TEST(Settings, BeginAsTheManualSays) {
  const Settings settings;
  EXPECT_FALSE(settings.fuzz);
  EXPECT_FALSE(settings.load_balance);
  EXPECT_EQ(settings.new_per_day, 5);
  EXPECT_EQ(settings.reviews_per_day, 100);
  EXPECT_EQ(settings.day_starts_at, 4);
  EXPECT_EQ(settings.time_zone, "");
  EXPECT_EQ(settings.new_order, NewOrder::grade);
  EXPECT_EQ(settings.leech_lapses, 8);
  EXPECT_EQ(settings.lesson.hint_after_misses, 2);
  EXPECT_EQ(settings.lesson.show_after_misses, 3);
  EXPECT_EQ(settings.lesson.help_retained, 0.7);
  EXPECT_EQ(settings.lesson.help_per_error, 0.6);
  EXPECT_EQ(settings.lesson.help_is_over, 0.15);
  const Pace pace;
  EXPECT_EQ(pace.recalled, milliseconds(20'000));
  EXPECT_EQ(pace.failed, milliseconds(60'000));
  EXPECT_EQ(pace.introduced, milliseconds(180'000));
  EXPECT_EQ(pace.recalled_days + pace.failed_days + pace.introduced_days, 0);
}

/// Every setting different from its default.
Settings other_settings() {
  Settings settings;
  settings.fsrs.desired_retention = 0.85;
  settings.fsrs.weights[0] = 0.25;
  settings.fsrs.weights[20] = 0.5;
  settings.fsrs.short_term_steps = false;
  settings.fsrs.learning_steps = {minutes(2), minutes(20), minutes(200)};
  settings.fsrs.relearning_steps = {};
  settings.fsrs.maximum_interval_days = 365;
  settings.fuzz = true;
  settings.load_balance = true;
  settings.new_per_day = 11;
  settings.reviews_per_day = 222;
  settings.day_starts_at = 6;
  settings.time_zone = "Asia/Tokyo";
  settings.new_order = NewOrder::components;
  settings.new_lists = {"hiragana", "list:mine"};
  settings.leech_lapses = 5;
  settings.lesson = {4, 6, 0.5, 0.25, 0.125};
  return settings;
}

TEST(Settings, ComeBackFromTheirText) {
  for (const Settings& settings : {Settings(), other_settings()}) {
    const std::string text = to_json(settings);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const auto read = parse_settings(text);
    ASSERT_TRUE(read) << base::to_line(read.error());
    EXPECT_EQ(*read, settings);
  }
}

TEST(Settings, ThatAreMissingKeepTheirDefaults) {
  EXPECT_EQ(*parse_settings("{}"), Settings());
  // Each setting alone: all others are unchanged.
  const json all = json::parse(to_json(other_settings()));
  const json before = json::parse(to_json(Settings()));
  for (const auto& [name, value] : all.items()) {
    if (name == "hint_after_misses") continue;  // it must not exceed show_after_misses
    json expected = before;
    expected[name] = value;
    const auto read = parse_settings(json{{name, value}}.dump());
    ASSERT_TRUE(read) << name;
    EXPECT_EQ(json::parse(to_json(*read)), expected) << name;
    EXPECT_EQ(*parse_settings(json{{name, nullptr}}.dump()), Settings()) << name;
  }
}

TEST(Settings, HaveTheirRangesInTheTextAndInTheProgram) {
  struct Range {
    const char* member;
    const char* name;
    std::function<void(Settings&, int)> set;
    int lowest, highest;
  };
  const std::vector<Range> ranges{
      {"new_per_day", "new characters a day", [](Settings& s, int value) { s.new_per_day = value; }, 0,
       1'000},
      {"reviews_per_day", "reviews a day", [](Settings& s, int value) { s.reviews_per_day = value; }, 1,
       10'000},
      {"day_starts_at", "start of the day", [](Settings& s, int value) { s.day_starts_at = value; }, 0, 12},
      {"leech_lapses", "lapses of a leech", [](Settings& s, int value) { s.leech_lapses = value; }, 2, 100},
      {"maximum_interval_days", "longest interval",
       [](Settings& s, int value) { s.fsrs.maximum_interval_days = value; }, 1, 36'500},
      {"show_after_misses", "misses before the stroke is shown",
       [](Settings& s, int value) { s.lesson.show_after_misses = value; }, 2, 20},
      {"hint_after_misses", "misses before a hint",
       [](Settings& s, int value) {
         s.lesson.hint_after_misses = value;
         s.lesson.show_after_misses = 20;
       },
       1, 20}};
  for (const auto& [member, name, set, lowest, highest] : ranges) {
    for (const int value : {lowest - 1, lowest, highest, highest + 1}) {
      const bool fits = value >= lowest && value <= highest;
      Settings settings;
      set(settings, value);
      const auto checked = check(settings);
      EXPECT_EQ(checked.has_value(), fits) << member << " " << value;
      if (!checked) {
        EXPECT_EQ(checked.error().where, name);
      }
      json text{{"show_after_misses", 20}};
      text[member] = value;
      const auto read = parse_settings(text.dump());
      EXPECT_EQ(read.has_value(), fits) << member << " " << value;
      // The text is refused where it is read, with its line; what no member alone breaks is refused
      // afterwards.
      if (!read && value != lowest - 1) {
        EXPECT_EQ(read.error().where, std::string("line 1, ") + member) << value;
      }
      if (fits && read) {
        Settings expected;
        expected.lesson.show_after_misses = 20;
        set(expected, value);
        EXPECT_EQ(*read, expected) << member;
      }
    }
  }
  EXPECT_THAT(base::to_line(parse_settings(R"({"show_after_misses": 0})").error()),
              HasSubstr("give 1 to 20"));
  EXPECT_THAT(base::to_line(parse_settings(R"({"show_after_misses": 1})").error()),
              AllOf(HasSubstr("misses before the stroke is shown"), HasSubstr("give 2 to 20")))
      << "no hint would come before";
}

TEST(Settings, SharesOfHelpAreNoneToAll) {
  for (double LessonRules::*const member :
       {&LessonRules::help_retained, &LessonRules::help_per_error, &LessonRules::help_is_over}) {
    for (const double value : {-0.01, 0.0, 1.0, 1.01, static_cast<double>(NAN)}) {
      Settings settings;
      settings.lesson.*member = value;
      EXPECT_EQ(check(settings).has_value(), value >= 0 && value <= 1) << value;
    }
  }
  for (const char* member : {"help_retained", "help_per_error", "help_is_over"}) {
    for (const double value : {-0.01, 0.0, 1.0, 1.01}) {
      EXPECT_EQ(parse_settings(json{{member, value}}.dump()).has_value(), value >= 0 && value <= 1) << member;
    }
  }
  for (const double value : {0.79, 0.80, 0.97, 0.98})
    EXPECT_EQ(parse_settings(json{{"desired_retention", value}}.dump()).has_value(),
              value > 0.795 && value < 0.975)
        << value;
}

TEST(Settings, AHundredListsMayBeChosen) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{100}, std::size_t{101}}) {
    Settings settings;
    settings.new_lists.assign(count, "grade-1");
    EXPECT_EQ(check(settings).has_value(), count <= 100);
    const auto read = parse_settings(json{{"new_lists", settings.new_lists}}.dump());
    EXPECT_EQ(read.has_value(), count <= 100);
    if (read) {
      EXPECT_EQ(read->new_lists.size(), count);
    }
  }
  EXPECT_THAT(base::to_line(parse_settings(R"({"new_lists": ["grade-1", 2]})").error()),
              HasSubstr("an invalid list name"));
}

TEST(Settings, ThatCannotBeReadAreNamed) {
  const auto refusal = [](const char* text) {
    const auto read = parse_settings(text);
    return read ? std::string() : base::to_line(read.error());
  };
  EXPECT_THAT(refusal(R"({"new_order": "by chance"})"),
              AllOf(HasSubstr("by chance"), HasSubstr("give grade")));
  EXPECT_THAT(refusal(R"({"new_order": "12345678901234567890123456789012345678901"})"),
              HasSubstr("longer than 40"));
  EXPECT_THAT(refusal(R"({"new_order": "1234567890123456789012345678901234567890"})"),
              HasSubstr("is not an order"));
  EXPECT_THAT(refusal(("{\"time_zone\": \"" + std::string(101, 'x') + "\"}").c_str()),
              HasSubstr("longer than 100"));
  EXPECT_EQ(refusal(("{\"time_zone\": \"" + std::string(100, 'x') + "\"}").c_str()), "")
      << "another computer may know it";
  EXPECT_THAT(refusal(R"({"weights": [1, 2]})"), HasSubstr("2 numbers"));
  EXPECT_THAT(refusal(R"({"weights": 1})"), HasSubstr("is not a list"));
  EXPECT_THAT(refusal(R"({"weights": ["x"]})"), HasSubstr("not finite"));
  EXPECT_THAT(refusal(R"({"learning_steps_min": [1, 2.5]})"), HasSubstr("whole number of minutes"));
  EXPECT_THAT(refusal(R"({"learning_steps_min": [0]})"), HasSubstr("learning steps"));
  EXPECT_THAT(refusal(R"({"relearning_steps_min": 10})"), HasSubstr("is not a list"));
  EXPECT_THAT(refusal(R"({"fuzz": 1})"), HasSubstr("true nor false"));
  EXPECT_THAT(refusal("[]"), HasSubstr("is not an object"));
  EXPECT_THAT(refusal("{"), HasSubstr("not JSON"));
  std::string many = "1";
  for (int i = 0; i < 100; ++i) many += ",1";
  EXPECT_THAT(refusal(("{\"learning_steps_min\": [" + many + "]}").c_str()), HasSubstr("at most 20 steps"));
  EXPECT_THAT(refusal(("{\"learning_steps_min\": [" + many + ",1]}").c_str()),
              HasSubstr("whole number of minutes"));
}

TEST(Settings, ATimeZoneIsCheckedOnThisComputerOnly) {
  Settings settings;
  settings.time_zone = "Mars/Olympus";
  EXPECT_EQ(check(settings).error().where, "time zone");
  EXPECT_TRUE(parse_settings(to_json(settings)));
}

TEST(Settings, OrdersAreNamed) {
  for (const NewOrder order :
       {NewOrder::grade, NewOrder::frequency, NewOrder::strokes, NewOrder::components, NewOrder::own})
    EXPECT_EQ(new_order_named(name_of(order)), order);
  EXPECT_EQ(new_order_named("own"), NewOrder::own);
  EXPECT_FALSE(new_order_named("chance"));
}

}  // namespace
}  // namespace nazori::study
