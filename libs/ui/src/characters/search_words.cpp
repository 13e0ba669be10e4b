// SPDX-License-Identifier: Apache-2.0
#include "characters/search_words.h"

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

QString SearchWords::head(const practice::SearchRow& row) {
  return row.word ? to_text(row.word->text) : to_text(row.character.code_point);
}

QString SearchWords::why(const practice::SearchRow& row) {
  const QString between = QStringLiteral(" · ");
  if (row.word) {
    QStringList meanings;
    for (const auto& meaning : row.word->meanings) meanings.append(to_text(meaning));
    QStringList all;
    if (row.word->reading != row.word->text) all.append(to_text(row.word->reading));
    if (!meanings.isEmpty()) all.append(meanings.join(QStringLiteral("; ")));
    return all.join(between);
  }
  const QString meaning = to_text(row.character.meaning);
  const auto as_text = [](const std::string& reading) { return kun_plain(kanji::split_kun(reading)); };
  QStringList all;
  switch (row.reason) {
    case kanji::Reason::reading:
      all.append(as_text(row.text));
      all.append(meaning);
      break;
    case kanji::Reason::name:
      all.append(tr("in names: %1").arg(as_text(row.text)));
      all.append(meaning);
      break;
    case kanji::Reason::meaning:
      all.append(to_text(row.text));
      if (!row.character.reading.empty()) all.append(as_text(row.character.reading));
      break;
    case kanji::Reason::condition:
    case kanji::Reason::itself:
      if (!row.character.reading.empty()) all.append(as_text(row.character.reading));
      all.append(meaning);
      all.append(tr("%n strokes", nullptr, row.character.strokes));
      break;
  }
  all.removeAll(QString());
  return all.join(between);
}

}  // namespace nazori::ui
