// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include "language.h"

namespace {

QString translations(const char* name) {
  return QStringLiteral(NAZORI_TRANSLATIONS "/") + QLatin1String(name);
}

/// Every place holder of the source must be in the translation, and no other.
QStringList place_holders(const QString& text) {
  // As QString::arg() reads them: "%1100" is number 11.
  static const QRegularExpression holder(QStringLiteral("%(\\d{1,2}|L?n)"));
  QStringList found;
  for (auto match = holder.globalMatch(text); match.hasNext();) found.append(match.next().captured());
  found.removeDuplicates();
  found.sort();
  return found;
}

TEST(JapaneseTranslation, EveryTextIsTranslatedAndKeepsItsPlaceHolders) {
  QFile file(translations("nazori_ja.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  int texts = 0;
  QString source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("source")) {
      source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      ++texts;
      EXPECT_FALSE(xml.attributes().hasAttribute(QStringLiteral("type")))
          << source.toStdString() << " is unfinished";
      const QString translation = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
      EXPECT_FALSE(translation.isEmpty()) << source.toStdString();
      EXPECT_EQ(place_holders(translation), place_holders(source)) << source.toStdString();
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  EXPECT_GT(texts, 200);
}

TEST(JapaneseTranslation, IsLoadedFromTheProgramItself) {
  EXPECT_EQ(nazori::ui::install_language(QStringLiteral("ja")), QStringLiteral("ja"));
  EXPECT_EQ(QCoreApplication::translate("nazori::ui::InformationPanel", "Radical"), QStringLiteral("部首"));
  EXPECT_EQ(QCoreApplication::translate("nazori::ui::InformationPanel", "%n strokes", nullptr, 6),
            QStringLiteral("6 画"));
  EXPECT_EQ(QLocale().language(), QLocale::Japanese);
  nazori::ui::install_language(QStringLiteral("en"));
}

TEST(EnglishTexts, KnowOneFromMany) {
  nazori::ui::install_language(QStringLiteral("en"));
  const auto strokes = [](int n) {
    return QCoreApplication::translate("nazori::ui::InformationPanel", "%n strokes", nullptr, n);
  };
  EXPECT_EQ(strokes(1), QStringLiteral("1 stroke"));
  EXPECT_EQ(strokes(6), QStringLiteral("6 strokes"));
  const auto streak = [](int n) {
    return QCoreApplication::translate("nazori::ui::HomePage", "days in a row", nullptr, n);
  };
  EXPECT_EQ(streak(0), QStringLiteral("days in a row"));
  EXPECT_EQ(streak(1), QStringLiteral("day in a row"));
  EXPECT_EQ(streak(7), QStringLiteral("days in a row"));
}

TEST(EnglishTexts, HaveBothFormsOfEveryCountedOne) {
  QFile file(translations("nazori_en.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  int forms = 0;
  QString source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("source")) {
      source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      EXPECT_FALSE(xml.attributes().hasAttribute(QStringLiteral("type")))
          << source.toStdString() << " is unfinished";
    } else if (xml.name() == QLatin1String("numerusform")) {
      ++forms;
      EXPECT_FALSE(xml.readElementText().trimmed().isEmpty()) << source.toStdString();
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  EXPECT_GT(forms, 60);
}

}  // namespace
