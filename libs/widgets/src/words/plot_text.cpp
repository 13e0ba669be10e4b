// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/plot_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

// Before PlotText: lupdate would lose the context of the strings that follow.
functions::SpeechStyle chosen_speech = functions::SpeechStyle::verbose;

struct PlotText {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::PlotText)
};

}  // namespace

functions::Language plot_language() {
  return QLocale().language() == QLocale::Japanese ? functions::Language::japanese
                                                   : functions::Language::english;
}

functions::SpeechStyle plot_speech() { return chosen_speech; }

void set_plot_speech(functions::SpeechStyle style) { chosen_speech = style; }

bool uses_decimal_comma() { return QLocale::system().decimalPoint() == QLatin1String(","); }

QString localised(const std::string& words) {
  QString text = to_text(words);
  if (uses_decimal_comma()) {
    static const QRegularExpression point(QStringLiteral("(\\d)\\.(\\d)"));
    text.replace(point, QStringLiteral("\\1,\\2"));
  }
  return text;
}

QString number_text(double value, int digits) {
  return localised(QString::number(value, 'g', digits).toStdString());
}

QString syntax_error_words(const functions::SyntaxError& error) {
  const auto words = functions::in_words(error, plot_language());
  return PlotText::tr("Column %1: %2; %3.")
      .arg(error.column)
      .arg(localised(words.message), localised(words.expected));
}

}  // namespace nazori::ui
