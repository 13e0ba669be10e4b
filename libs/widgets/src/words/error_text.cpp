// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/error_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::reason)
};

QString kind(base::Errc code) {
  switch (code) {
    case base::Errc::bad_argument:
      return Words::tr("a value is out of range");
    case base::Errc::io:
      return Words::tr("it could not be read or written");
    case base::Errc::parse:
      return Words::tr("the file format is not valid");
    case base::Errc::schema:
      return Words::tr("it is a different kind of file than expected");
    case base::Errc::not_found:
      return Words::tr("it does not exist");
    case base::Errc::device:
      return Words::tr("the graphics driver or the device reported an error");
    case base::Errc::cancelled:
      return Words::tr("it was stopped");
    case base::Errc::in_use:
      return Words::tr("another program is using it");
  }
  return {};
}

/// The end of "words.csv:3" or "words.csv:3:14", which is understood in each language.
QString line_of(const base::Error& error) {
  static const QRegularExpression line(QStringLiteral("[^/]+(:[0-9]+){1,2}$"));
  return line.match(to_text(error.where)).captured();
}

}  // namespace

bool is_english() {
  const auto language = QLocale().language();
  return language == QLocale::English || language == QLocale::C;
}

QString reason(const base::Error& error) {
  if (!is_english()) {
    const QString line = line_of(error);
    return line.isEmpty() ? kind(error.code) : Words::tr("%1 (%2)").arg(kind(error.code), line);
  }
  QString detail = to_text(error.what);
  while (detail.endsWith(QLatin1Char('.'))) detail.chop(1);
  if (!error.remedy.empty()) detail += QStringLiteral("; ") + to_text(error.remedy);
  return detail.isEmpty() ? kind(error.code) : QStringLiteral("%1 (%2)").arg(kind(error.code), detail);
}

QString no_sound(const base::Error& error) {
  if (!is_english())
    return Words::tr(
        "No sound: no working sound card was found. Connect or switch on speakers or headphones. "
        "Everything else works.");
  return Words::tr(
             "No sound: no working sound card was found (%1). Connect or switch on "
             "speakers or headphones. Everything else works.")
      .arg(to_text(error.what));
}

}  // namespace nazori::ui
