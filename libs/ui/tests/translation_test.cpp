// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <functional>

#include "test_paths.h"
#include "window/language.h"

namespace {

QString translations(const char* name) {
  return QLatin1String(nazori::test_paths::kTranslations) + QLatin1Char('/') + QLatin1String(name);
}

/// The placeholders of a text. The translation must have the same as the source.
QStringList place_holders(const QString& text) {
  // As QString::arg() reads them: "%1100" is number 11.
  static const QRegularExpression holder(QStringLiteral("%(\\d{1,2}|L?n)"));
  QStringList found;
  for (auto match = holder.globalMatch(text); match.hasNext();) found.append(match.next().captured());
  found.removeDuplicates();
  found.sort();
  return found;
}

/// Each finished translation of a file: its source and its forms, one where nothing is counted.
void for_each_translation(const char* name,
                          const std::function<void(const QString& source, const QStringList& forms)>& see) {
  QFile file(translations(name));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  QString source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() != QLatin1String("translation")) continue;
    EXPECT_FALSE(xml.attributes().hasAttribute(QStringLiteral("type")))
        << source.toStdString() << " is unfinished";
    QStringList forms(QString{});
    while (xml.readNext() != QXmlStreamReader::EndElement) {
      if (xml.isCharacters()) forms.front() += xml.text();
      if (xml.isStartElement()) forms.append(xml.readElementText());
    }
    if (forms.size() > 1) forms.removeFirst();
    see(source, forms);
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
}

TEST(JapaneseTranslation, EveryTextIsTranslatedAndKeepsItsPlaceHolders) {
  int texts = 0;
  for_each_translation("nazori_ja.ts", [&](const QString& source, const QStringList& forms) {
    ++texts;
    for (const QString& form : forms) {
      EXPECT_FALSE(form.trimmed().isEmpty()) << source.toStdString();
      EXPECT_EQ(place_holders(form), place_holders(source)) << source.toStdString();
    }
  });
  EXPECT_GT(texts, 200);
}

TEST(JapaneseTranslation, IsLoadedFromTheProgramItself) {
  EXPECT_EQ(nazori::ui::install_language(QStringLiteral("ja")), QStringLiteral("ja"));
  EXPECT_EQ(QCoreApplication::translate("nazori::ui::InformationPanel", "Radical"), QStringLiteral("部首"));
  EXPECT_EQ(QCoreApplication::translate("nazori::ui::InformationPanel", "%n strokes", nullptr, 6),
            QStringLiteral("6画"));
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
    return QCoreApplication::translate("nazori::ui::HomeWords", "%n days in a row", nullptr, n);
  };
  EXPECT_EQ(streak(0), QStringLiteral("0 days in a row"));
  EXPECT_EQ(streak(1), QStringLiteral("1 day in a row"));
  EXPECT_EQ(streak(7), QStringLiteral("7 days in a row"));
}

TEST(EnglishTexts, HaveBothFormsOfEveryCountedOne) {
  int texts = 0;
  for_each_translation("nazori_en.ts", [&](const QString& source, const QStringList& forms) {
    ++texts;
    EXPECT_EQ(forms.size(), 2) << source.toStdString();
    for (const QString& form : forms) EXPECT_FALSE(form.trimmed().isEmpty()) << source.toStdString();
  });
  EXPECT_GT(texts, 30);
}

}  // namespace
