// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/spoken_line.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QSignalSpy>
#include <QTest>

#include "nazori/widgets/controls/feedback_line.h"

namespace nazori::ui {
namespace {

/// What a screen reader is told.
class Spoken : public ::testing::Test {
 protected:
  void listen(const SpokenLine& line) {
    QObject::connect(&line, &SpokenLine::spoken, [this](const QString& text) { spoken.append(text); });
  }

  QStringList spoken;
};

TEST_F(Spoken, ANotificationIsShownThatHasTheSentenceAsItsName) {
  SpokenLine line(nullptr, 0);
  auto* part = QAccessible::queryAccessibleInterface(&line);
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->role(), QAccessible::Notification);
  line.speak(Urgency::at_once, QStringLiteral("Correct."));
  EXPECT_EQ(part->text(QAccessible::Name), QStringLiteral("Correct."));
  EXPECT_FALSE(part->state().focusable);
}

TEST_F(Spoken, ErrorsAndVerdictsAreSpokenAtOnceInPlaceOfWhatWaits) {
  SpokenLine line(nullptr, 0);
  listen(line);
  line.speak(Urgency::queued, QStringLiteral("Watch."));
  line.speak(Urgency::at_once, QStringLiteral("Correct."));
  EXPECT_EQ(spoken, QStringList{QStringLiteral("Correct.")});
  QTest::qWait(1);
  EXPECT_EQ(spoken, QStringList{QStringLiteral("Correct.")}) << "what waited is out of date";
}

TEST_F(Spoken, WhatComesTogetherIsSpokenTogetherInItsOrderAndOnce) {
  SpokenLine line(nullptr, 0);
  listen(line);
  for (const char* sentence : {"One.", "Two.", "One.", ""})
    line.speak(Urgency::queued, QString::fromLatin1(sentence));
  EXPECT_TRUE(spoken.isEmpty());
  ASSERT_TRUE(QTest::qWaitFor([this] { return !spoken.isEmpty(); }));
  EXPECT_EQ(spoken, QStringList{QStringLiteral("One. Two.")});
  line.speak(Urgency::queued, QStringLiteral("One."));
  ASSERT_TRUE(QTest::qWaitFor([this] { return spoken.size() == 2; }));
  EXPECT_EQ(spoken.last(), QStringLiteral("One.")) << "later it is news again";
}

TEST_F(Spoken, AnEmptySentenceIsSilent) {
  SpokenLine line(nullptr, 0);
  listen(line);
  line.speak(Urgency::at_once, {});
  EXPECT_TRUE(spoken.isEmpty());
}

TEST_F(Spoken, TheFeedbackLineSpeaksEachNewSentenceAndEachAnswer) {
  FeedbackLine line;
  listen(*line.findChild<SpokenLine*>());
  line.announce(Feedback::wrong, QStringLiteral("Stroke 2 is missing."));
  line.announce(Feedback::wrong, QStringLiteral("Stroke 2 is missing."));
  EXPECT_EQ(spoken.size(), 1) << "it is still on the screen";
  line.respond(Feedback::advice, QStringLiteral("Stroke 2 is missing."));
  EXPECT_EQ(spoken.size(), 2) << "the learner asked";
  line.announce(Feedback::good, QStringLiteral("Correct."));
  EXPECT_EQ(spoken.last(), QStringLiteral("Correct."));
  line.announce(Feedback::hint, QStringLiteral("Enter: next."));
  EXPECT_EQ(spoken.size(), 3) << "a hint waits for what else is said";
  ASSERT_TRUE(QTest::qWaitFor([this] { return spoken.size() == 4; }));
  EXPECT_EQ(spoken.last(), QStringLiteral("Enter: next."));
}

}  // namespace
}  // namespace nazori::ui
