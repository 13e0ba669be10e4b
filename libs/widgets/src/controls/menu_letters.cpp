// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/menu_letters.h"

#include <QRegularExpression>
#include <QSet>

namespace nazori::ui {
namespace {

bool is_letter(QChar c) { return (c >= u'a' && c <= u'z') || (c >= u'A' && c <= u'Z'); }

/// The place of the `&` before a letter; -1 without one. `&&` is an ampersand that is shown.
qsizetype mark_of(const QString& text) {
  for (qsizetype i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != u'&') continue;
    if (text[i + 1] != u'&') return i;
    ++i;
  }
  return -1;
}

QString without_letter(QString text) {
  static const QRegularExpression kInBrackets(QStringLiteral(" ?\\(&[A-Za-z]\\)"));
  text.remove(kInBrackets);
  const qsizetype mark = mark_of(text);
  return mark < 0 ? text : text.remove(mark, 1);
}

QString with_free_letter(const QString& plain, const QSet<QChar>& taken) {
  const auto is_free = [&](qsizetype i) {
    return is_letter(plain[i]) && !taken.contains(plain[i].toLower());
  };
  for (const bool begins_word : {true, false})
    for (qsizetype i = 0; i < plain.size(); ++i)
      if (is_free(i) && (!begins_word || i == 0 || !plain[i - 1].isLetter()))
        return QString(plain).insert(i, u'&');
  // An ellipsis stays at the end.
  const qsizetype end = plain.endsWith(u'…') ? plain.size() - 1 : plain.size();
  for (char16_t letter = u'A'; letter <= u'Z'; ++letter)
    if (!taken.contains(QChar(letter).toLower()))
      return QString(plain).insert(
          end, QStringLiteral("%1(&%2)")
                   .arg(end > 0 && is_letter(plain[end - 1]) ? QStringLiteral(" ") : QString())
                   .arg(QChar(letter)));
  return plain;
}

}  // namespace

void give_own_letters(const QList<QAction*>& entries) {
  QSet<QChar> taken;
  QList<QAction*> without;
  for (auto* entry : entries) {
    if (entry->isSeparator() || entry->text().isEmpty()) continue;
    const qsizetype mark = mark_of(entry->text());
    const QChar letter = mark < 0 ? QChar() : entry->text()[mark + 1].toLower();
    if (letter.isNull() || taken.contains(letter))
      without.append(entry);
    else
      taken.insert(letter);
  }
  for (auto* entry : without) {
    const QString text = with_free_letter(without_letter(entry->text()), taken);
    if (const qsizetype mark = mark_of(text); mark >= 0) taken.insert(text[mark + 1].toLower());
    entry->setText(text);
  }
}

}  // namespace nazori::ui
