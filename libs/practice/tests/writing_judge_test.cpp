// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "database_under_test.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::practice {
namespace {

using test::database;

JudgeRequest request(char32_t asked, char32_t written) {
  JudgeRequest made;
  made.character = asked;
  for (const auto& line : kanji::KanjiDatabase::open(database())->find(written)->lines()) {
    auto& stroke = made.ink.strokes.emplace_back();
    for (const auto& p : line.points) stroke.push_back({{p.x, p.y}});
  }
  return made;
}

/// A judge, and all its answers.
struct Court {
  explicit Court(const std::filesystem::path& path = database()) : judge(inbox, path) {
    judge.judged.connect([this](std::uint64_t number, const writing::Grade& grade) {
      order.push_back("judged " + std::to_string(number));
      judged.emplace_back(number, grade);
    });
    judge.pen_reported.connect([this](std::uint64_t number, const PenReport& pen) {
      order.push_back("pen " + std::to_string(number) + " " + std::to_string(pen.motions.size()));
    });
    judge.recognised.connect([this](std::uint64_t number, const std::vector<FoundCharacter>& found) {
      recognised.emplace_back(number, found);
    });
    judge.judging_failed.connect(
        [this](std::uint64_t number, const base::Error&) { not_judged.push_back(number); });
    judge.recognising_failed.connect(
        [this](std::uint64_t number, const base::Error&) { not_recognised.push_back(number); });
  }
  template <class List>
  void wait_for(const List& list, std::size_t count) {
    inbox.run_until([&] { return list.size() >= count; });
  }

  std::vector<std::string> order;
  std::vector<std::pair<std::uint64_t, writing::Grade>> judged;
  std::vector<std::pair<std::uint64_t, std::vector<FoundCharacter>>> recognised;
  std::vector<std::uint64_t> not_judged, not_recognised;
  base::Inbox inbox;
  WritingJudge judge;
};

TEST(WritingJudge, AcceptsTheModelAndRefusesItsLookalike) {
  Court court;
  court.judge.judge(request(U'土', U'土'));
  court.wait_for(court.judged, 1);
  EXPECT_TRUE(court.judged[0].second.accepted);
  court.judge.judge(request(U'土', U'士'));
  court.wait_for(court.judged, 2);
  EXPECT_FALSE(court.judged[1].second.accepted);
}

TEST(WritingJudge, OfSeveralRequestsOnlyTheNewestIsAnswered) {
  Court court;
  std::uint64_t last = 0;
  for (int i = 0; i < 20; ++i) last = court.judge.judge(request(U'木', U'木'));
  court.wait_for(court.judged, 1);
  EXPECT_EQ(court.judged[0].first, last);
  // An answer to an earlier request would come before that to a later one.
  const std::uint64_t next = court.judge.judge(request(U'木', U'木'));
  court.wait_for(court.judged, 2);
  EXPECT_EQ(court.judged[1].first, next);
}

TEST(WritingJudge, ACharacterThatIsNotThereFailsAndAnswersNothing) {
  Court court;
  court.judge.judge(request(U'☃', U'木'));
  court.wait_for(court.not_judged, 1);
  EXPECT_TRUE(court.judged.empty());
}

TEST(WritingJudge, HowThePenMovedIsReportedBeforeTheVerdictOfFinishedWritingOnly) {
  Court court;
  auto asked = request(U'十', U'十');
  for (auto& stroke : asked.ink.strokes)
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      stroke[i].time_s = 0.05 * static_cast<double>(i) + (&stroke == &asked.ink.strokes[0] ? 0 : 10);
      stroke[i].pressure = 0.5;
    }
  court.judge.judge(asked);
  court.wait_for(court.judged, 1);
  asked.finished = false;
  court.judge.judge(asked);
  court.wait_for(court.judged, 2);
  EXPECT_EQ(court.order, (std::vector<std::string>{"pen 1 2", "judged 1", "judged 2"}));
}

TEST(WritingJudge, UnfinishedWritingIsNotBlamedForWhatIsMissing) {
  Court court;
  auto asked = request(U'十', U'十');
  asked.ink.strokes.pop_back();
  court.judge.judge(asked);
  court.wait_for(court.judged, 1);
  EXPECT_EQ(court.judged[0].second.mistakes.size(), 1U);
  asked.finished = false;
  court.judge.judge(asked);
  court.wait_for(court.judged, 2);
  EXPECT_TRUE(court.judged[1].second.mistakes.empty());
}

TEST(WritingJudge, AFailureHasTheNumberOfItsRequest) {
  Court court;
  const auto number = court.judge.judge(request(U'☃', U'木'));
  court.wait_for(court.not_judged, 1);
  EXPECT_EQ(court.not_judged[0], number);
  const auto empty = court.judge.recognise({}, 5);
  court.wait_for(court.not_recognised, 1);
  EXPECT_EQ(court.not_recognised[0], empty);
}

TEST(WritingJudge, WithoutADatabaseEveryRequestFails) {
  Court nowhere("/no/such/kanji.db");
  nowhere.judge.prepare_recogniser();
  (void)nowhere.judge.judge(request(U'木', U'木'));
  nowhere.wait_for(nowhere.not_judged, 1);
  (void)nowhere.judge.recognise(request(U'木', U'木').ink, 5);
  nowhere.wait_for(nowhere.not_recognised, 1);
}

TEST(WritingJudge, WhatEndsHereAndWhatGoesOnAreOfferedByTurnsEachOnce) {
  const auto kanji = kanji::KanjiDatabase::open(database());
  const auto recogniser = writing::Recogniser::make(*kanji);
  const auto ink = request(U'休', U'休').ink;
  constexpr int kLimit = 7;
  const auto whole = recogniser->recognise(ink, {.limit = kLimit, .unfinished = false});
  const auto begun = recogniser->recognise(ink, {.limit = kLimit, .unfinished = true});
  std::u32string expected;
  for (std::size_t i = 0; i < kLimit; ++i)
    for (const auto* from : {&*whole, &*begun})
      if (i < from->size() && expected.size() < kLimit &&
          expected.find((*from)[i].character) == std::u32string::npos)
        expected.push_back((*from)[i].character);
  Court court;
  (void)court.judge.recognise(ink, 2);
  const auto number = court.judge.recognise(ink, kLimit);
  court.wait_for(court.recognised, 1);
  EXPECT_EQ(court.recognised.size(), 1U) << "only the newest is answered";
  EXPECT_EQ(court.recognised[0].first, number);
  std::u32string found;
  for (const auto& one : court.recognised[0].second) found.push_back(one.character);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), static_cast<std::size_t>(kLimit));
  EXPECT_EQ(found.front(), U'休');
}

TEST(WritingJudge, NamesTheOtherCharacterThatWasWritten) {
  const auto named = [](char32_t asked, char32_t written, bool backwards = false) {
    Court court;
    std::vector<std::pair<std::uint64_t, char32_t>> names;
    court.judge.named.connect([&](std::uint64_t number, char32_t name) { names.emplace_back(number, name); });
    auto ink = request(asked, written).ink;
    if (backwards) std::reverse(ink.strokes.begin(), ink.strokes.end());
    const auto number = court.judge.name_other(ink, asked);
    court.wait_for(names, 1);
    EXPECT_EQ(names[0].first, number);
    return names[0].second;
  };
  EXPECT_EQ(named(U'日', U'大'), U'大');
  EXPECT_EQ(named(U'日', U'大', true), U'大') << "whatever the order of its strokes";
  EXPECT_EQ(named(U'め', U'ぬ'), U'ぬ');
  EXPECT_EQ(named(U'日', U'日'), 0U) << "it is the one that was asked for";
  EXPECT_EQ(named(U'へ', U'ヘ'), 0U) << "they look the same";
  EXPECT_EQ(named(U'水', U'口'), U'口') << "a kanji where a kanji was asked for";
  EXPECT_EQ(named(U'ホ', U'ロ'), U'ロ');
}

TEST(WritingJudge, NamesNothingInAScrawlOrWithoutADatabase) {
  for (const auto& path : {database(), std::filesystem::path("/nowhere/kanji.db")}) {
    Court court(path);
    std::vector<char32_t> names;
    court.judge.named.connect([&](std::uint64_t, char32_t name) { names.push_back(name); });
    writing::WrittenCharacter ink;
    for (int i = 0; i < 5; ++i) {
      auto& stroke = ink.strokes.emplace_back();
      for (int j = 0; j < 12; ++j)
        stroke.push_back(
            {{10.0 + 70 * ((j * 7 + i * 3) % 5) / 4.0, 10.0 + 70 * ((j * 5 + i * 11) % 7) / 6.0}});
    }
    (void)court.judge.name_other(ink, U'日');
    (void)court.judge.name_other({}, U'日');
    court.wait_for(names, 1);
    EXPECT_EQ(names[0], 0U);
  }
}

}  // namespace
}  // namespace nazori::practice
