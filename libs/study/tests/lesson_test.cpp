// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/lesson.h"

#include <gtest/gtest.h>

namespace nazori::study {
namespace {

using std::chrono::seconds;

WritingResult good(int score = 85) {
  WritingResult result;
  result.score = score;
  result.duration = seconds(10);
  return result;
}
const UsualWriting kTenSeconds{seconds(10), 5};

TEST(ProposedRating, GoodWritingIsGood) {
  EXPECT_EQ(proposed_rating(good(), kTenSeconds), Rating::good);
  EXPECT_EQ(proposed_rating(good(70), {}), Rating::good);
}

TEST(ProposedRating, FlawlessAndNotSlowIsEasyOnceThePaceIsKnown) {
  EXPECT_EQ(proposed_rating(good(95), kTenSeconds), Rating::easy);
  EXPECT_EQ(proposed_rating(good(95), {}), Rating::good);
  EXPECT_EQ(proposed_rating(good(95), {seconds(10), 2}), Rating::good);
  EXPECT_EQ(proposed_rating(good(95), {seconds(9), 5}), Rating::good);
}

TEST(ProposedRating, EndingsAreAdviceOnly) {
  WritingResult result = good(95);
  result.faults = {{FaultKind::ending, 1}};
  EXPECT_EQ(proposed_rating(result, kTenSeconds), Rating::good);
}

TEST(ProposedRating, EachThingThatWentWrongMakesItHard) {
  const auto with = [](auto change) {
    WritingResult result = good(95);
    change(result);
    return proposed_rating(result, kTenSeconds);
  };
  EXPECT_EQ(with([](auto& r) { r.hints = 1; }), Rating::hard);
  EXPECT_EQ(with([](auto& r) { r.misses = 1; }), Rating::hard);
  EXPECT_EQ(with([](auto& r) { r.help = 0.2; }), Rating::hard);
  EXPECT_EQ(with([](auto& r) { r.score = 69; }), Rating::hard);
  EXPECT_EQ(with([](auto& r) { r.duration = seconds(21); }), Rating::hard);
  for (const FaultKind kind : {FaultKind::order, FaultKind::reversed, FaultKind::joined, FaultKind::split}) {
    EXPECT_EQ(with([kind](auto& r) { r.faults = {{kind, 0}}; }), Rating::hard) << name_of(kind);
  }
}

TEST(ProposedRating, WhatWasNotKnownIsAgain) {
  const auto with = [](auto change) {
    WritingResult result = good(95);
    change(result);
    return proposed_rating(result, kTenSeconds);
  };
  EXPECT_EQ(with([](auto& r) { r.accepted = false; }), Rating::again);
  EXPECT_EQ(with([](auto& r) { r.shown_strokes = 1; }), Rating::again);
  EXPECT_EQ(with([](auto& r) { r.hints = 2; }), Rating::again);
  EXPECT_EQ(with([](auto& r) { r.help = 0.6; }), Rating::again);
}

TEST(ProposedRating, LittleHelpCostsNothing) {
  WritingResult result = good();
  result.help = 0.1;
  EXPECT_EQ(proposed_rating(result, kTenSeconds), Rating::good);
}

TEST(Lesson, LeadsFromWatchingToMemory) {
  Lesson lesson;
  EXPECT_EQ(lesson.next_stage(), Stage::watch);
  lesson.finish(Stage::watch, good(), 6);
  EXPECT_EQ(lesson.next_stage(), Stage::trace);
  lesson.finish(Stage::trace, good(), 6);
  EXPECT_EQ(lesson.next_stage(), Stage::guided);
  lesson.finish(Stage::guided, good(), 6);
  EXPECT_EQ(lesson.next_stage(), Stage::memory);
  EXPECT_FALSE(lesson.done());
  lesson.finish(Stage::memory, good(), 6);
  EXPECT_TRUE(lesson.done());
}

TEST(Lesson, GuidedGoesOnUntilTheHelpHasFaded) {
  Lesson lesson(Stage::guided, 1);
  WritingResult shaky = good();
  shaky.misses = 1;  // error 1/6, so the help settles at 0.6 / 6 / 0.3 = 1/3
  int tries = 0;
  for (; tries < 20 && lesson.next_stage() == Stage::guided; ++tries) lesson.finish(Stage::guided, shaky, 6);
  EXPECT_EQ(tries, 20);
  EXPECT_NEAR(lesson.help(), 1.0 / 3, 0.01);
  lesson.finish(Stage::guided, good(), 6);
  EXPECT_EQ(lesson.next_stage(), Stage::memory);
}

TEST(Lesson, TwoFailuresInARowLeadAStageBack) {
  WritingResult failed = good();
  failed.accepted = false;
  Lesson lesson(Stage::guided, 0.5);
  lesson.finish(Stage::guided, failed, 6);
  EXPECT_EQ(lesson.next_stage(), Stage::guided);
  lesson.finish(Stage::guided, failed, 6);
  EXPECT_EQ(lesson.next_stage(), Stage::trace);
  lesson.finish(Stage::trace, failed, 6);
  lesson.finish(Stage::trace, failed, 6);
  EXPECT_EQ(lesson.next_stage(), Stage::watch);
}

TEST(Lesson, ForgettingBringsTheHelpBack) {
  Lesson lesson(Stage::memory, 0);
  WritingResult failed = good();
  failed.accepted = false;
  lesson.finish(Stage::memory, failed, 6);
  EXPECT_EQ(lesson.next_stage(), Stage::guided);
  EXPECT_DOUBLE_EQ(lesson.help(), 0.6);
}

TEST(Lesson, AStageOfTheLearnersOwnChoiceCounts) {
  Lesson lesson;
  lesson.finish(Stage::memory, good(), 6);
  EXPECT_TRUE(lesson.done());
}

TEST(Lesson, HelpFadesByTheLawOfAssistanceAsNeeded) {
  EXPECT_DOUBLE_EQ(faded_help(1, 0), 0.7);
  EXPECT_DOUBLE_EQ(faded_help(0.5, 0.5), 0.65);
  EXPECT_DOUBLE_EQ(faded_help(1, 1), 1);
}

TEST(Lesson, AfterMissesComesAHintThenTheStroke) {
  EXPECT_EQ(reply_to_miss(1), MissReply::try_again);
  EXPECT_EQ(reply_to_miss(2), MissReply::hint);
  EXPECT_EQ(reply_to_miss(3), MissReply::show);
  EXPECT_EQ(reply_to_miss(9), MissReply::show);
}

TEST(Lesson, ErrorsAreSharesOfTheCharacter) {
  EXPECT_EQ(error_of(good(), 6), 0);
  WritingResult half = good();
  half.shown_strokes = 3;
  EXPECT_EQ(error_of(half, 6), 1);
  half.shown_strokes = 0;
  half.faults = {{FaultKind::wrong, 0}, {FaultKind::order, 1}};
  EXPECT_NEAR(error_of(half, 4), 0.25, 1e-12);
}

}  // namespace
}  // namespace nazori::study
