// SPDX-License-Identifier: Apache-2.0
#include "characters/word_label.h"

#include <QFontInfo>
#include <QRegularExpression>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

/// Words that are wider than the panel may be broken anywhere but near their ends.
QString breakable(const QString& text) {
  static const QRegularExpression kInside(QStringLiteral(R"((?<=\w{4})(?=\w{4}))"));
  return QString(text).replace(kInside, QString(QChar(0x200B)));
}

/// The word with a link for each kanji.
QString linked(const std::string& word, const QColor& colour) {
  QString rich;
  for (const char32_t c : base::decode_utf8(word).value_or(std::u32string())) {
    const QString text = to_text(c).toHtmlEscaped();
    rich += kanji::script_of(c) == kanji::Script::other
                ? QStringLiteral("<a href=\"%1\" style=\"color:%2; text-decoration:none\">%1</a>")
                      .arg(text, colour.name())
                : text;
  }
  return rich;
}

}  // namespace

WordLabel::WordLabel(const practice::HelpfulWord& word, bool is_narrow, QWidget* parent) : QLabel(parent) {
  setObjectName(QStringLiteral("word"));
  setWordWrap(true);
  setTextFormat(Qt::RichText);
  const double size_pt = QFontInfo(font()).pointSizeF();
  const Colours& c = current_colours();
  QStringList meanings;
  for (const auto& meaning : word.meanings) meanings.append(to_text(meaning));
  const QString meaning = meanings.join(QStringLiteral("; "));
  const QString text = to_text(word.word.text);
  const QString reading = word.word.reading == word.word.text ? QString() : to_text(word.word.reading);
  setText(QStringLiteral("<span style=\"font-family:'Klee One'; font-size:%1pt\">%2</span>"
                         "&nbsp; <span style=\"font-family:'Klee One'; font-size:%3pt; color:%4\">%5</span>"
                         "<br>%6")
              .arg(size_pt * 1.25)
              .arg(linked(word.word.text, c.ink))
              .arg(size_pt)
              .arg(c.muted.name(), reading.toHtmlEscaped(),
                   (is_narrow ? breakable(meaning) : meaning).toHtmlEscaped()));
  setAccessibleName(QStringList{text, reading, meaning}.join(QStringLiteral(", ")));
  setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse |
                          Qt::LinksAccessibleByKeyboard);
  connect(this, &QLabel::linkActivated, this, [this](const QString& link) {
    if (const auto points = base::decode_utf8(link.toStdString()); points && points->size() == 1)
      emit character_chosen(points->front());
  });
}

bool WordLabel::focusNextPrevChild(bool next) {
  // QLabel never leaves its links backwards (seen with Qt 6.4): Shift+Tab would be caught in the word.
  return next ? QLabel::focusNextPrevChild(true) : QFrame::focusNextPrevChild(false);
}

}  // namespace nazori::ui
