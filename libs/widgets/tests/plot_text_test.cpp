// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/plot_text.h"

#include <gtest/gtest.h>

#include <QLocale>

#include "print_qt.h"

namespace nazori::ui {
namespace {

/// A window of this language, as long as it lives.
class InLanguage {
 public:
  explicit InLanguage(QLocale::Language language) { QLocale::setDefault(QLocale(language)); }
  ~InLanguage() { QLocale::setDefault(before_); }
  InLanguage(const InLanguage&) = delete;
  InLanguage& operator=(const InLanguage&) = delete;

 private:
  QLocale before_;
};

TEST(PlotText, IsInJapaneseOrElseInEnglish) {
  for (const auto& [language, spoken] : {std::pair(QLocale::Japanese, functions::Language::japanese),
                                         {QLocale::English, functions::Language::english},
                                         {QLocale::German, functions::Language::english}}) {
    const InLanguage window(language);
    EXPECT_EQ(plot_language(), spoken);
  }
}

TEST(PlotText, ExpressionsAreSpokenInFullUntilTheLearnerWantsLess) {
  EXPECT_EQ(plot_speech(), functions::SpeechStyle::verbose);
  set_plot_speech(functions::SpeechStyle::superbrief);
  EXPECT_EQ(plot_speech(), functions::SpeechStyle::superbrief);
  set_plot_speech(functions::SpeechStyle::verbose);
}

TEST(PlotText, AnErrorIsItsColumnWhatIsWrongAndWhatWouldBeRight) {
  const InLanguage english(QLocale::English);
  const functions::SyntaxError error{7, functions::SyntaxFault::operand_missing, "+"};
  const auto words = functions::in_words(error, functions::Language::english);
  EXPECT_EQ(syntax_error_words(error),
            QStringLiteral("Column 7: %1; %2.")
                .arg(QString::fromStdString(words.message), QString::fromStdString(words.expected)));
  EXPECT_NE(words.message, words.expected);
}

TEST(PlotText, NumbersHaveTheDigitsThatAreAskedForAndThePointOfTheDesktop) {
  const QString point = uses_decimal_comma() ? QStringLiteral(",") : QStringLiteral(".");
  EXPECT_EQ(uses_decimal_comma(), QLocale::system().decimalPoint() == QLatin1String(","));
  EXPECT_EQ(number_text(1.23456789), QStringLiteral("1") + point + QStringLiteral("23457"));
  EXPECT_EQ(number_text(1.23456789, 3), QStringLiteral("1") + point + QStringLiteral("23"));
  EXPECT_EQ(number_text(-2), QStringLiteral("-2"));
  EXPECT_EQ(localised("from 0.5 to 1.25. Then"),
            QStringLiteral("from 0") + point + QStringLiteral("5 to 1") + point + QStringLiteral("25. Then"));
}

}  // namespace
}  // namespace nazori::ui
