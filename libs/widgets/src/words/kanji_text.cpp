// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/kanji_text.h"

#include <QFontDatabase>
#include <QRawFont>
#include <QStringList>
#include <algorithm>
#include <set>
#include <string>

namespace nazori::ui {
namespace {

constexpr auto kFamily = "Klee One";

struct OwnForms {
  QString family;
  std::set<char32_t> characters;
};

OwnForms& own_forms() {
  static OwnForms forms;
  return forms;
}

}  // namespace

QString to_text(char32_t code_point) { return QString::fromUcs4(&code_point, 1); }

QString to_text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

QString joined(const std::vector<std::string>& texts, const QString& between, std::size_t most) {
  QStringList all;
  for (std::size_t i = 0; i < texts.size() && i < most; ++i) all.append(to_text(texts[i]));
  return all.join(between);
}

QString kun_plain(const kanji::KunReading& r) { return to_text(kanji::kun_text(r)); }

QString kun_rich(const kanji::KunReading& r, const QColor& muted) {
  const auto faint = [&muted](const QString& text) {
    return text.isEmpty()
               ? QString()
               : QStringLiteral("<span style=\"color:%1\">%2</span>").arg(muted.name(), text.toHtmlEscaped());
  };
  return faint(r.as_suffix ? QStringLiteral("～") : QString()) + to_text(r.stem).toHtmlEscaped() +
         faint(r.okurigana.empty() ? QString() : QStringLiteral("・") + to_text(r.okurigana)) +
         faint(r.as_prefix ? QStringLiteral("～") : QString());
}

QFont textbook_font(double point_size, int weight) {
  QFont font(QString::fromLatin1(kFamily));
  font.setPointSizeF(std::max(point_size, 1.0));
  font.setWeight(static_cast<QFont::Weight>(weight));
  return font;
}

void set_own_forms(const QString& family, const std::set<char32_t>& characters) {
  own_forms() = {family, characters};
}

QFont character_font(const QString& text, double point_size, int weight) {
  QFont font = textbook_font(point_size, weight);
  const std::u32string letters = text.toStdU32String();
  if (letters.size() == 1 && own_forms().characters.contains(letters.front()))
    font.setFamily(own_forms().family);
  return font;
}

bool textbook_font_has(char32_t code_point) {
  static const QRawFont klee = QFontDatabase::hasFamily(QString::fromLatin1(kFamily))
                                   ? QRawFont::fromFont(textbook_font(16))
                                   : QRawFont();
  return klee.isValid() && klee.supportsCharacter(static_cast<uint>(code_point));
}

}  // namespace nazori::ui
