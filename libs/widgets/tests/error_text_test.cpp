// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/error_text.h"

#include <gtest/gtest.h>

#include <QLocale>

#include "nazori/widgets/words/device_text.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

/// A window of another language, as long as it lives.
class Abroad {
 public:
  Abroad() { QLocale::setDefault(QLocale(QLocale::Japanese)); }
  Abroad(const Abroad&) = delete;
  Abroad& operator=(const Abroad&) = delete;
  ~Abroad() { QLocale::setDefault(before_); }

 private:
  QLocale before_;
};

const base::Error kBadLine{base::Errc::parse, "no such rating: 7.", "/home/aiko/words.csv:3:14",
                           "use 1 to 4"};

TEST(ErrorText, InEnglishTheMessageAndItsRemedyStandBehindTheKindOfFailure) {
  EXPECT_TRUE(is_english());
  EXPECT_EQ(reason(kBadLine), QStringLiteral("the file format is not valid (no such rating: 7; use 1 to 4)"));
  EXPECT_EQ(reason({base::Errc::not_found, {}, "a.csv", {}}), QStringLiteral("it does not exist"));
}

TEST(ErrorText, InAnotherLanguageOnlyTheLineOfTheFileStandsBehindIt) {
  const Abroad abroad;
  EXPECT_FALSE(is_english());
  EXPECT_EQ(reason(kBadLine), QStringLiteral("the file format is not valid (words.csv:3:14)"));
  EXPECT_EQ(reason({base::Errc::parse, "no such rating", "words.csv:3", {}}),
            QStringLiteral("the file format is not valid (words.csv:3)"));
  EXPECT_EQ(reason({base::Errc::io, "No space left on device", "/home/aiko/words.csv", {}}),
            QStringLiteral("it could not be read or written"));
}

TEST(ErrorText, WhatADriverSaysIsLeftOutInAnotherLanguage) {
  const Abroad abroad;
  EXPECT_EQ(trouble_text(haptics::DeviceTrouble::in_use, QStringLiteral("Arm"), QStringLiteral("by cat")),
            QStringLiteral("Arm is in use. Close the program that uses it."));
}

}  // namespace
}  // namespace nazori::ui
