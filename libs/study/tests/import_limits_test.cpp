// SPDX-License-Identifier: Apache-2.0
// Which numbers and texts an import takes: on both sides of each bound.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../src/base64.h"
#include "learner_fixture.h"
#include "nazori/study/exchange.h"

namespace nazori::study {
namespace {

using nlohmann::json;
using test::MovedClock;
using test::must;
using test::review;
using test::some_ink;
using testing::AllOf;
using testing::HasSubstr;

/// A learner with a writing, a postponement, an undo and settings, as an export.
json small_export() {
  LearnerStore store = must(LearnerStore::in_memory(MovedClock("2026-01-01T09:00:00Z").clock()));
  Settings settings;
  settings.fuzz = true;
  EXPECT_TRUE(store.change_settings(settings));
  Writing writing = review(Rating::good);
  writing.result.mistakes = {{kanji::MistakeKind::wrong, 2}};
  (void)must(store.add_writing(U'休', 6, writing, some_ink()));
  EXPECT_TRUE(store.postpone(std::array{U'休'}, *parse_day("2026-01-05")));
  EXPECT_TRUE(must(store.undo()));
  EXPECT_TRUE(store.save_list({"trees", {U'木'}}));
  const std::vector<std::string> tags{"exam"};
  EXPECT_TRUE(store.set_tags(U'木', tags));
  return json::parse(must(export_json(store)));
}
constexpr std::size_t kSettings = 0;
constexpr std::size_t kWriting = 1;
constexpr std::size_t kPostponement = 2;
constexpr std::size_t kUndo = 3;

std::string refusal(const json& text) {
  const auto checked = check_json(text_source(text.dump()));
  return checked ? std::string() : base::to_line(checked.error());
}

/// The error for an export in which one member of an entry is changed.
std::string with(std::size_t entry, const char* member, const json& value) {
  json all = small_export();
  all["entries"][entry][member] = value;
  return refusal(all);
}

TEST(ImportLimits, NumbersOfAWritingHaveTheirRanges) {
  struct Bounds {
    const char* member;
    std::int64_t lowest, highest;
  };
  for (const auto& [member, lowest, highest] :
       {Bounds{"score", 0, 100}, Bounds{"hints", 0, 1'000'000}, Bounds{"misses", 0, 1'000'000},
        Bounds{"shown_strokes", 0, 1'000'000}, Bounds{"duration_ms", 0, 86'400'000},
        Bounds{"strokes", 1, 1'000}, Bounds{"interval_days", 1, 36'600}, Bounds{"help", 0, 1}}) {
    EXPECT_EQ(with(kWriting, member, lowest), "") << member;
    EXPECT_EQ(with(kWriting, member, highest), "") << member;
    for (const std::int64_t outside : {lowest - 1, highest + 1}) {
      const std::string remedy = "give " + std::to_string(lowest) + " to " + std::to_string(highest);
      EXPECT_THAT(with(kWriting, member, outside), AllOf(HasSubstr(member), HasSubstr(remedy)));
    }
    EXPECT_THAT(with(kWriting, member, "many"), HasSubstr(member));
  }
  EXPECT_EQ(with(kWriting, "help", 0.5), "");
  EXPECT_EQ(with(kWriting, "interval_days", nullptr), "") << "as if it were not there";
  EXPECT_THAT(with(kWriting, "score", nullptr), HasSubstr("score"));
  EXPECT_THAT(with(kWriting, "score", 85.5), HasSubstr("score"));
  EXPECT_THAT(with(kWriting, "accepted", 1), HasSubstr("accepted"));
}

TEST(ImportLimits, AMistakeNamesAStrokeUpToTheThousandth) {
  const auto with_stroke = [](const json& stroke) {
    json all = small_export();
    all["entries"][kWriting]["faults"][0]["stroke"] = stroke;
    return refusal(all);
  };
  EXPECT_EQ(with_stroke(0), "");
  EXPECT_EQ(with_stroke(1'000), "");
  EXPECT_THAT(with_stroke(1'001), HasSubstr("faults/0/stroke"));
  EXPECT_THAT(with_stroke(-1), HasSubstr("give 0 to 1000"));
}

TEST(ImportLimits, EntriesAndActionsAreNumberedFromOne) {
  for (const char* member : {"id", "action"}) {
    for (const std::int64_t outside : {std::int64_t{0}, std::int64_t{1'000'000'001}})
      EXPECT_THAT(with(kWriting, member, outside),
                  AllOf(HasSubstr(member), HasSubstr("give 1 to 1000000000")));
    EXPECT_THAT(with(kWriting, member, 1'000'000'000),
                testing::AnyOf(HasSubstr("order"), HasSubstr("no action")));
  }
  for (const std::int64_t outside : {std::int64_t{0}, std::int64_t{1'000'000'001}})
    EXPECT_THAT(with(kUndo, "undoes", outside),
                AllOf(HasSubstr("undoes"), HasSubstr("give 1 to 1000000000")));
  EXPECT_THAT(with(kUndo, "undoes", 1'000'000'000), HasSubstr("undoes no action"));
  EXPECT_THAT(with(kUndo, "undoes", 1), HasSubstr("undoes no action")) << "settings stay";
  EXPECT_EQ(with(kUndo, "undoes", 2), "");
}

TEST(ImportLimits, NamesAreFortyBytesAtMost) {
  const std::string longest(40, 'x');
  for (const char* member : {"stage", "rating", "proposed", "kind", "at", "day"}) {
    EXPECT_THAT(with(kWriting, member, longest), HasSubstr("'" + longest + "'")) << member;
    EXPECT_THAT(with(kWriting, member, longest + "x"), HasSubstr("longer than 40 bytes")) << member;
  }
  EXPECT_THAT(with(kPostponement, "until", longest), HasSubstr("'" + longest + "'"));
  EXPECT_THAT(with(kPostponement, "until", longest + "x"), HasSubstr("longer than 40 bytes"));
  EXPECT_THAT(with(kWriting, "character", std::string(10, 'x')), HasSubstr("must be one character"));
  EXPECT_THAT(with(kWriting, "character", std::string(11, 'x')), HasSubstr("longer than 10 bytes"));
  EXPECT_THAT(with(kWriting, "character", ""), HasSubstr("must be one character"));
  EXPECT_THAT(with(kWriting, "character", std::string(1, '\0')), HasSubstr("must be one character"));
  json all = small_export();
  all["format"] = std::string(101, 'x');
  EXPECT_THAT(refusal(all), HasSubstr("longer than 100 bytes"));
  all["format"] = std::string(100, 'x');
  EXPECT_THAT(refusal(all), HasSubstr("is not an export of study data"));
}

TEST(ImportLimits, NamesOfListsAndTagsAreAHundredBytesAtMost) {
  for (const char* part : {"lists", "tags"}) {
    json all = small_export();
    all[part][0]["name"] = std::string(100, 'x');
    EXPECT_EQ(refusal(all), "") << part;
    all[part][0]["name"] = std::string(101, 'x');
    EXPECT_THAT(refusal(all), HasSubstr("longer than 100 bytes")) << part;
    all[part][0]["name"] = " x";
    EXPECT_THAT(refusal(all), HasSubstr("is not ")) << part;
    all = small_export();
    all[part][0]["characters"] = std::string(std::size_t{1} << 20, 'x');
    EXPECT_EQ(refusal(all), "") << part;
    all[part][0]["characters"] = std::string((std::size_t{1} << 20) + 1, 'x');
    EXPECT_THAT(refusal(all), HasSubstr("longer than 1048576 bytes")) << part;
    all[part][0].erase("characters");
    EXPECT_THAT(refusal(all), HasSubstr("missing")) << part;
  }
}

TEST(ImportLimits, AVersionIsAWholeNumberFromOne) {
  json all = small_export();
  all["version"] = 0;
  EXPECT_THAT(refusal(all), HasSubstr("give 1 to 1000000"));
  all["version"] = 1'000'000;
  EXPECT_THAT(refusal(all), HasSubstr("version 1000000, written by a newer"));
  all["version"] = 1'000'001;
  EXPECT_THAT(refusal(all), HasSubstr("give 1 to 1000000"));
}

TEST(ImportLimits, WhatIsPassedOverMayBeNestedSixtyFourDeep) {
  const auto nested = [](std::size_t lists) {
    json all = small_export();
    std::string text = all.dump();
    text.insert(1, "\"other\":" + std::string(lists, '[') + std::string(lists, ']') + ",");
    const auto checked = check_json(text_source(text));
    return checked ? std::string() : checked.error().what;
  };
  EXPECT_EQ(nested(63), "") << "within the object of the whole";
  EXPECT_EQ(nested(64), "is nested too deeply");
}

TEST(ImportLimits, InkIsOfAWritingAndCanBeRead) {
  const json whole = small_export();
  ASSERT_TRUE(whole["entries"][kWriting].contains("ink"));
  const std::string ink = whole["entries"][kWriting]["ink"];
  EXPECT_THAT(with(kWriting, "ink", ink.substr(0, ink.size() - 4)), HasSubstr("ink that cannot be read"));
  EXPECT_THAT(with(kWriting, "ink", ink + "="), HasSubstr("is not readable handwriting data"));
  EXPECT_THAT(with(kWriting, "ink", std::string((4U << 20) + 4, 'A')),
              HasSubstr("longer than 4194304 bytes"));
  EXPECT_THAT(with(kWriting, "ink", std::string(4U << 20, 'A')), HasSubstr("ink that cannot be read"));
  EXPECT_EQ(with(kPostponement, "ink", ink), "") << "not looked at where none belongs";
  json without = whole;
  without["entries"][kWriting].erase("ink");
  EXPECT_EQ(refusal(without), "");
}

TEST(ImportLimits, EachKindNeedsWhatBelongsToIt) {
  const auto without = [](std::size_t entry, const char* member) {
    json all = small_export();
    all["entries"][entry].erase(member);
    return refusal(all);
  };
  for (const char* member :
       {"id", "action", "at", "day", "kind", "character", "stage", "rating", "proposed", "accepted", "score",
        "faults", "hints", "misses", "shown_strokes", "help", "duration_ms", "strokes"})
    EXPECT_THAT(without(kWriting, member), AllOf(HasSubstr(member), HasSubstr("is missing")));
  EXPECT_THAT(without(kPostponement, "until"), HasSubstr("until: is missing"));
  EXPECT_THAT(without(kPostponement, "character"), HasSubstr("character: is missing"));
  EXPECT_THAT(without(kUndo, "undoes"), HasSubstr("undoes: is missing"));
  EXPECT_THAT(without(kSettings, "settings"), HasSubstr("settings"));
  EXPECT_THAT(with(kSettings, "settings", json{{"new_per_day", 1'001}}), HasSubstr("settings: 1001"));
  EXPECT_THAT(with(kWriting, "day", "2026-02-30"), AllOf(HasSubstr("day"), HasSubstr("2026-02-30")));
  EXPECT_THAT(with(kWriting, "at", "noon"), AllOf(HasSubstr("at"), HasSubstr("noon")));
}

TEST(Base64, IsThatOfTheStandard) {
  // RFC 4648, section 10.
  const std::array<std::pair<std::string, std::string>, 7> kExamples{{{"", ""},
                                                                      {"f", "Zg=="},
                                                                      {"fo", "Zm8="},
                                                                      {"foo", "Zm9v"},
                                                                      {"foob", "Zm9vYg=="},
                                                                      {"fooba", "Zm9vYmE="},
                                                                      {"foobar", "Zm9vYmFy"}}};
  for (const auto& [plain, text] : kExamples) {
    const std::vector<std::uint8_t> bytes(plain.begin(), plain.end());
    EXPECT_EQ(to_base64(bytes), text);
    EXPECT_EQ(from_base64(text), bytes);
  }
  for (const char* wrong : {"Z", "Zg", "Zg=", "Zg===", "Zh==", "Zm9=", "Z===", "====", "Zm9vYg", "Zm 9v",
                            "Zg==Zg==", "Zm9v\n", " Zm9v"})
    EXPECT_FALSE(from_base64(wrong)) << wrong;
}

}  // namespace
}  // namespace nazori::study
