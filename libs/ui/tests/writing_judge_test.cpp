// SPDX-License-Identifier: Apache-2.0
#include "writing_judge.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "nazori/kanji/kanji_database.h"

namespace {

using nazori::ui::JudgeRequest;
using nazori::ui::WritingJudge;
namespace writing = nazori::writing;

std::filesystem::path database() {
  return std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db";
}

JudgeRequest request(char32_t asked, char32_t written) {
  JudgeRequest made;
  made.character = asked;
  for (const auto& line : nazori::kanji::KanjiDatabase::open(database())->find(written)->lines()) {
    auto& stroke = made.ink.strokes.emplace_back();
    for (const auto& p : line.points) stroke.push_back({{p.x, p.y}});
  }
  return made;
}

TEST(WritingJudge, AcceptsTheModelAndRefusesItsLookalike) {
  WritingJudge judge(database());
  QSignalSpy judged(&judge, &WritingJudge::judged);
  judge.judge(request(U'土', U'土'));
  ASSERT_TRUE(judged.wait(20000));
  EXPECT_TRUE(judged.at(0).at(1).value<writing::Grade>().accepted);
  judge.judge(request(U'土', U'士'));
  ASSERT_TRUE(judged.wait(20000));
  EXPECT_FALSE(judged.at(1).at(1).value<writing::Grade>().accepted);
}

TEST(WritingJudge, OfSeveralRequestsOnlyTheNewestIsAnswered) {
  WritingJudge judge(database());
  QSignalSpy judged(&judge, &WritingJudge::judged);
  std::uint64_t last = 0;
  for (int i = 0; i < 20; ++i) last = judge.judge(request(U'木', U'木'));
  ASSERT_TRUE(QTest::qWaitFor([&] { return judged.count() > 0; }, 20000));
  EXPECT_EQ(judged.at(0).at(0).toULongLong(), last);
  // An answer to an earlier request would come before that to a later one.
  const std::uint64_t next = judge.judge(request(U'木', U'木'));
  ASSERT_TRUE(QTest::qWaitFor([&] { return judged.count() > 1; }, 20000));
  EXPECT_EQ(judged.at(1).at(0).toULongLong(), next);
}

TEST(WritingJudge, ACharacterThatIsNotThereFailsAndAnswersNothing) {
  WritingJudge judge(database());
  QSignalSpy failed(&judge, &WritingJudge::failed);
  judge.judge(request(U'☃', U'木'));
  EXPECT_TRUE(failed.wait(20000));
}

TEST(WritingJudge, HowThePenMovedIsToldBeforeTheVerdictOfFinishedWritingOnly) {
  WritingJudge judge(database());
  QStringList order;
  QObject::connect(&judge, &WritingJudge::pen_told,
                   [&](std::uint64_t ticket, const nazori::ui::PenReport& pen) {
                     order.append(QStringLiteral("pen %1 %2").arg(ticket).arg(pen.motions.size()));
                   });
  QSignalSpy judged(&judge, &WritingJudge::judged);
  QObject::connect(&judge, &WritingJudge::judged,
                   [&](std::uint64_t ticket) { order.append(QStringLiteral("judged %1").arg(ticket)); });
  auto asked = request(U'十', U'十');
  for (auto& stroke : asked.ink.strokes)
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      stroke[i].time_s = 0.05 * static_cast<double>(i) + (&stroke == &asked.ink.strokes[0] ? 0 : 10);
      stroke[i].pressure = 0.5;
    }
  const auto first = judge.judge(asked);
  ASSERT_TRUE(judged.wait(20000));
  asked.finished = false;
  const auto second = judge.judge(asked);
  ASSERT_TRUE(judged.wait(20000));
  EXPECT_EQ(order, (QStringList{QStringLiteral("pen %1 2").arg(first), QStringLiteral("judged %1").arg(first),
                                QStringLiteral("judged %1").arg(second)}));
}

TEST(WritingJudge, WhatIsStillBeingWrittenLacksNothing) {
  WritingJudge judge(database());
  QSignalSpy judged(&judge, &WritingJudge::judged);
  auto asked = request(U'十', U'十');
  asked.ink.strokes.pop_back();
  judge.judge(asked);
  ASSERT_TRUE(judged.wait(20000));
  EXPECT_EQ(judged.at(0).at(1).value<writing::Grade>().mistakes.size(), 1U);
  asked.finished = false;
  judge.judge(asked);
  ASSERT_TRUE(judged.wait(20000));
  EXPECT_TRUE(judged.at(1).at(1).value<writing::Grade>().mistakes.empty());
}

TEST(WritingJudge, TheFailureHasTheNumberOfItsQuestion) {
  WritingJudge judge(database());
  QSignalSpy failed(&judge, &WritingJudge::failed);
  const auto ticket = judge.judge(request(U'☃', U'木'));
  ASSERT_TRUE(failed.wait(20000));
  EXPECT_EQ(failed.at(0).at(0).toULongLong(), ticket);
  const auto empty = judge.recognise({}, 5);
  ASSERT_TRUE(failed.wait(60000));
  EXPECT_EQ(failed.at(1).at(0).toULongLong(), empty);
  WritingJudge nowhere(std::filesystem::path("/no/such/kanji.db"));
  QSignalSpy lost(&nowhere, &WritingJudge::failed);
  nowhere.prepare_recogniser();
  (void)nowhere.judge(request(U'木', U'木'));
  ASSERT_TRUE(lost.wait(20000));
  (void)nowhere.recognise(request(U'木', U'木').ink, 5);
  EXPECT_TRUE(lost.wait(20000));
}

TEST(WritingJudge, WhatEndsHereAndWhatGoesOnAreOfferedByTurnsEachOnce) {
  const auto kanji = nazori::kanji::KanjiDatabase::open(database());
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
  WritingJudge judge(database());
  QSignalSpy recognised(&judge, &WritingJudge::recognised);
  (void)judge.recognise(ink, 2);
  const auto ticket = judge.recognise(ink, kLimit);
  ASSERT_TRUE(recognised.wait(60000));
  EXPECT_EQ(recognised.count(), 1) << "only the newest is answered";
  EXPECT_EQ(recognised.at(0).at(0).toULongLong(), ticket);
  std::u32string found;
  for (const auto& one : recognised.at(0).at(1).value<std::vector<writing::Candidate>>())
    found.push_back(one.character);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), static_cast<std::size_t>(kLimit));
  EXPECT_EQ(found.front(), U'休');
}

}  // namespace
