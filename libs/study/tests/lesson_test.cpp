// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/lesson.h"

#include <gtest/gtest.h>

namespace nazori::study {
namespace {

using std::chrono::milliseconds;
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

TEST(SuggestedRating, NamesTheFirstReasonThatHolds) {
  using Reason = RatingReason;
  const auto reason = [](WritingResult result, const UsualWriting& usual = {seconds(10), 3}) {
    const auto suggested = suggested_rating(result, usual);
    EXPECT_EQ(suggested.rating, proposed_rating(result, usual));
    return suggested.reason;
  };
  WritingResult result = good(95);
  EXPECT_EQ(reason(result), Reason::quick);
  EXPECT_EQ(reason(result, {}), Reason::usual);
  result.duration = seconds(21);
  EXPECT_EQ(reason(result), Reason::slow);
  result.score = 69;
  EXPECT_EQ(reason(result), Reason::form);
  result.mistakes = {{kanji::MistakeKind::ending, 0}};
  EXPECT_EQ(reason(result), Reason::form);
  result.mistakes = {{kanji::MistakeKind::order, 0}};
  EXPECT_EQ(reason(result), Reason::mistake);
  result.help = 0.2;
  EXPECT_EQ(reason(result), Reason::some_help);
  result.misses = 1;
  EXPECT_EQ(reason(result), Reason::missed_strokes);
  result.hints = 1;
  EXPECT_EQ(reason(result), Reason::hint);
  result.help = 0.6;
  EXPECT_EQ(reason(result), Reason::much_help);
  result.hints = 2;
  EXPECT_EQ(reason(result), Reason::many_hints);
  result.accepted = false;
  EXPECT_EQ(reason(result), Reason::not_accepted);
  result.shown_strokes = 1;
  EXPECT_EQ(reason(result), Reason::strokes_shown);
  EXPECT_EQ(name_of(Reason::not_accepted), "not-accepted");
  EXPECT_EQ(name_of(Reason::usual), "usual");
  EXPECT_EQ(name_of(static_cast<Reason>(12)), "");
}

TEST(ProposedRating, EndingsAreAdviceOnly) {
  WritingResult result = good(95);
  result.mistakes = {{kanji::MistakeKind::ending, 1}};
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
  for (const kanji::MistakeKind kind : {kanji::MistakeKind::order, kanji::MistakeKind::reversed,
                                        kanji::MistakeKind::joined, kanji::MistakeKind::split}) {
    EXPECT_EQ(with([kind](auto& r) { r.mistakes = {{kind, 0}}; }), Rating::hard) << name_of(kind);
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
  half.mistakes = {{kanji::MistakeKind::wrong, 0}, {kanji::MistakeKind::order, 1}};
  EXPECT_NEAR(error_of(half, 4), 0.25, 1e-12);
}

TEST(ProposedRating, EachBoundIsWhereTheManualSays) {
  const auto with = [](auto change, UsualWriting usual = kTenSeconds) {
    WritingResult result = good(90);
    change(result);
    return proposed_rating(result, usual);
  };
  EXPECT_EQ(with([](auto&) {}), Rating::easy);
  EXPECT_EQ(with([](auto& r) { r.score = 89; }), Rating::good);
  EXPECT_EQ(with([](auto& r) { r.score = 70; }), Rating::good);
  EXPECT_EQ(with([](auto& r) { r.score = 69; }), Rating::hard);
  EXPECT_EQ(with([](auto& r) { r.help = 0.1; }), Rating::easy);
  EXPECT_EQ(with([](auto& r) { r.help = 0.101; }), Rating::hard);
  EXPECT_EQ(with([](auto& r) { r.help = 0.5; }), Rating::hard);
  EXPECT_EQ(with([](auto& r) { r.help = 0.501; }), Rating::again);
  EXPECT_EQ(with([](auto& r) { r.duration = seconds(10) + milliseconds(1); }), Rating::good);
  EXPECT_EQ(with([](auto& r) { r.duration = seconds(20); }), Rating::good);
  EXPECT_EQ(with([](auto& r) { r.duration = seconds(20) + milliseconds(1); }), Rating::hard);
  const auto quick = [](auto& r) { r.duration = seconds(1); };
  EXPECT_EQ(with(quick, {seconds(10), 3}), Rating::easy);
  EXPECT_EQ(with(quick, {seconds(10), 2}), Rating::good) << "too few to know the pace";
  EXPECT_EQ(with(quick, {seconds(0), 5}), Rating::good) << "no time was measured";
  EXPECT_EQ(with(quick, {milliseconds(1'000), 5}), Rating::easy);
  EXPECT_EQ(with([](auto& r) { r.duration = seconds(99); }, {seconds(10), 2}), Rating::good);
}

TEST(ProposedRating, OneMistakeOfAnotherKindAmongEndingsIsEnough) {
  WritingResult result = good(95);
  result.mistakes = {{kanji::MistakeKind::ending, 0}, {kanji::MistakeKind::wrong, 1}};
  EXPECT_EQ(proposed_rating(result, kTenSeconds), Rating::hard);
  for (const kanji::MistakeKind kind : {kanji::MistakeKind::missing, kanji::MistakeKind::extra,
                                        kanji::MistakeKind::other, kanji::MistakeKind::wrong}) {
    result.mistakes = {{kind, 0}};
    EXPECT_EQ(proposed_rating(result, kTenSeconds), Rating::hard) << name_of(kind);
  }
}

TEST(ProposedRating, AWritingBeginsWithoutAnyMistake) {
  EXPECT_EQ(WritingResult(), (WritingResult{true, 100, {}, 0, 0, 0, 0, milliseconds(0)}));
  EXPECT_EQ(StrokeMistake(), (StrokeMistake{kanji::MistakeKind::wrong, 0}));
  EXPECT_EQ(UsualWriting().count, 0);
  EXPECT_EQ(UsualWriting().duration, milliseconds(0));
}

TEST(Lesson, NamesAreReadBack) {
  for (const Stage stage : kStages) EXPECT_EQ(stage_named(name_of(stage)), stage);
  EXPECT_FALSE(stage_named("sleep"));
  for (const kanji::MistakeKind kind :
       {kanji::MistakeKind::order, kanji::MistakeKind::reversed, kanji::MistakeKind::missing,
        kanji::MistakeKind::extra, kanji::MistakeKind::joined, kanji::MistakeKind::split,
        kanji::MistakeKind::wrong, kanji::MistakeKind::other, kanji::MistakeKind::ending})
    EXPECT_EQ(kanji::mistake_named(name_of(kind)), kind);
  EXPECT_FALSE(kanji::mistake_named(""));
}

TEST(Lesson, BeginsWithAllTheHelpAndNoFailure) {
  const Lesson lesson;
  EXPECT_EQ(lesson.help(), 1);
  EXPECT_EQ(lesson.failures(), 0);
  EXPECT_FALSE(lesson.done());
  EXPECT_EQ(Lesson(Stage::guided, 1.5).help(), 1);
  EXPECT_EQ(Lesson(Stage::guided, -0.5).help(), 0);
}

WritingResult not_accepted() {
  WritingResult result = good();
  result.accepted = false;
  return result;
}

TEST(Lesson, ASuccessEndsARowOfFailures) {
  // Help that does not fade and one miss each: the learner stays in the stage.
  LessonRules rules;
  rules.help_retained = 1;
  WritingResult shaky = good();
  shaky.misses = 1;
  Lesson lesson(Stage::guided, 1, rules);
  for (int i = 0; i < 3; ++i) {
    lesson.finish(Stage::guided, not_accepted(), 6);
    EXPECT_EQ(lesson.failures(), 1);
    lesson.finish(Stage::guided, shaky, 6);
    EXPECT_EQ(lesson.failures(), 0);
    EXPECT_EQ(lesson.next_stage(), Stage::guided);
  }
  // Failures in another stage are counted separately.
  lesson.finish(Stage::trace, not_accepted(), 6);
  EXPECT_EQ(lesson.failures(), 1);
  lesson.finish(Stage::guided, not_accepted(), 6);
  EXPECT_EQ(lesson.failures(), 1);
  EXPECT_EQ(lesson.next_stage(), Stage::guided);
  lesson.finish(Stage::guided, not_accepted(), 6);
  EXPECT_EQ(lesson.next_stage(), Stage::trace);
  EXPECT_EQ(lesson.failures(), 0);
}

TEST(Lesson, AShownStrokeIsNoSuccess) {
  WritingResult shown = good();
  shown.shown_strokes = 1;
  Lesson memory(Stage::memory, 0.5);
  memory.finish(Stage::memory, shown, 6);
  EXPECT_FALSE(memory.done());
  EXPECT_EQ(memory.next_stage(), Stage::guided);
  // 0.7 of 0.5, and 0.6 times an error of a third.
  EXPECT_NEAR(memory.help(), 0.55, 1e-12);
  Lesson trace(Stage::trace);
  trace.finish(Stage::trace, shown, 6);
  EXPECT_EQ(trace.next_stage(), Stage::trace);
  Lesson guided(Stage::guided, 0);
  guided.finish(Stage::guided, shown, 1'000);
  EXPECT_EQ(guided.next_stage(), Stage::guided) << "though hardly any help is left";
}

TEST(Lesson, GuidedIsOverOnceTheHelpHasFadedToItsBound) {
  LessonRules rules;
  rules.help_retained = 0.5;
  rules.help_per_error = 0;
  rules.help_is_over = 0.125;
  WritingResult shaky = good();
  shaky.misses = 1;
  Lesson lesson(Stage::guided, 0.5, rules);
  lesson.finish(Stage::guided, shaky, 6);
  EXPECT_EQ(lesson.next_stage(), Stage::guided);
  EXPECT_EQ(lesson.help(), 0.25);
  lesson.finish(Stage::guided, shaky, 6);
  EXPECT_EQ(lesson.help(), 0.125);
  EXPECT_EQ(lesson.next_stage(), Stage::memory);
}

TEST(Lesson, WhatIsDoneAgainIsNoLongerOver) {
  Lesson lesson;
  lesson.finish(Stage::memory, good(), 6);
  EXPECT_TRUE(lesson.done());
  EXPECT_EQ(lesson.next_stage(), Stage::memory);
  lesson.finish(Stage::watch, good(), 6);
  EXPECT_FALSE(lesson.done());
  EXPECT_EQ(lesson.next_stage(), Stage::trace);
}

TEST(Lesson, HelpAndErrorStayBetweenNoneAndAll) {
  LessonRules much;
  much.help_retained = much.help_per_error = 1;
  EXPECT_EQ(faded_help(0.8, 0.8, much), 1);
  EXPECT_EQ(faded_help(0, 5), 0.6);
  EXPECT_EQ(faded_help(1, -5), 0.7);
  EXPECT_EQ(faded_help(0, 0), 0);
}

TEST(Lesson, AMissOrHintIsHalfAShownStrokeAndAMistakeAQuarter) {
  const auto error = [](auto change) {
    WritingResult result = good();
    change(result);
    return error_of(result, 8);
  };
  EXPECT_EQ(error([](auto& r) { r.shown_strokes = 1; }), 0.25);
  EXPECT_EQ(error([](auto& r) { r.misses = 1; }), 0.125);
  EXPECT_EQ(error([](auto& r) { r.hints = 1; }), 0.125);
  EXPECT_EQ(error([](auto& r) { r.mistakes = {{kanji::MistakeKind::wrong, 0}}; }), 0.0625);
  EXPECT_EQ(error([](auto& r) {
              r.shown_strokes = r.misses = r.hints = 1;
              r.mistakes = {{kanji::MistakeKind::wrong, 0}};
            }),
            0.5625);
  EXPECT_EQ(error([](auto& r) { r.shown_strokes = 8; }), 1);
  EXPECT_EQ(error([](auto& r) { r.accepted = false; }), 1);
  EXPECT_EQ(error_of(good(), 1), 0);
}

}  // namespace
}  // namespace nazori::study
