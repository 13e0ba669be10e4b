// SPDX-License-Identifier: Apache-2.0
#include "window/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

// The macro does not work inside a namespace.
static void init_nazori_translations() { Q_INIT_RESOURCE(nazori_ui); }

namespace nazori::ui {

QString install_language(const QString& language) {
  init_nazori_translations();
  static QTranslator own;
  static QTranslator qt;
  QCoreApplication::removeTranslator(&own);
  QCoreApplication::removeTranslator(&qt);
  const QString desktop = QLocale::system().uiLanguages().value(0).section(QLatin1Char('-'), 0, 0);
  QString wanted = !language.isEmpty()              ? language
                   : desktop == QLatin1String("ja") ? desktop
                                                    : QStringLiteral("en");
  const QLocale locale(wanted);
  QLocale::setDefault(language.isEmpty() && wanted == desktop ? QLocale::system() : locale);
  if (own.load(QStringLiteral(":/nazori/nazori_%1.qm").arg(wanted)))
    QCoreApplication::installTranslator(&own);
  // Present where the distribution's package of Qt translations is; else Qt's dialogs stay English.
  if (qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
              QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&qt);
  return wanted;
}

}  // namespace nazori::ui
