// SPDX-License-Identifier: Apache-2.0
#include "functions/plot_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <cmath>

#include "kanji_text.h"

namespace nazori::ui {
namespace {

QString say(const char* text) { return QCoreApplication::translate("nazori::ui::plot_words", text); }

/// Four significant digits; "minus", because screen readers pass over a hyphen.
QString spoken(double value) {
  if (std::isinf(value))
    return value > 0 ? say(QT_TRANSLATE_NOOP("nazori::ui::plot_words", "infinity"))
                     : say(QT_TRANSLATE_NOOP("nazori::ui::plot_words", "minus infinity"));
  const double shown = std::abs(value) < 1e-12 ? 0 : value;
  const QString digits = number_text(std::abs(shown), 4);
  return shown < 0 ? say(QT_TRANSLATE_NOOP("nazori::ui::plot_words", "minus %1")).arg(digits) : digits;
}

}  // namespace

functions::Language plot_language() {
  return QLocale().language() == QLocale::Japanese ? functions::Language::japanese
                                                   : functions::Language::english;
}

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

QString no_coordinate() { return QStringLiteral("–"); }

QString coordinate_text(double value, const std::string& exact_name) {
  if (std::isnan(value)) return no_coordinate();
  const QString number = number_text(std::abs(value) < 1e-12 ? 0 : value, 4);
  static const QRegularExpression whole(QStringLiteral("^-?\\d+$"));
  QString name = to_text(exact_name);
  if (name.isEmpty() || whole.match(name).hasMatch())
    return name.isEmpty() ? QStringLiteral("≈ ") + number : name;
  name.replace(QLatin1String("pi"), QStringLiteral("π"));
  name.replace(QLatin1String("sqrt"), QStringLiteral("√"));
  name.replace(QLatin1Char('*'), QStringLiteral("·"));
  return QStringLiteral("%1 ≈ %2").arg(name, number);
}

QString place_words(const TracePlace& place) {
  return localised(functions::place_in_words(place.x, place.y, plot_language()));
}

QString point_words(const functions::PointOfInterest& point) {
  return localised(functions::in_words(point, plot_language()));
}

QString kind_words(functions::PointKind kind) { return to_text(functions::in_words(kind, plot_language())); }

QString slope_words(double slope) {
  if (std::isinf(slope))
    return say(QT_TRANSLATE_NOOP("nazori::ui::plot_words", "The curve is upright here."));
  return say(QT_TRANSLATE_NOOP("nazori::ui::plot_words", "slope %1")).arg(spoken(slope));
}

QString window_words(const functions::Window& window) {
  return say(QT_TRANSLATE_NOOP("nazori::ui::plot_words",
                               "x from %1 to %2, one tick is %3; y from %4 to %5, one tick is %6"))
      .arg(spoken(window.x0), spoken(window.x1), spoken(functions::tick_step(window.x0, window.x1)),
           spoken(window.y0), spoken(window.y1), spoken(functions::tick_step(window.y0, window.y1)));
}

}  // namespace nazori::ui
