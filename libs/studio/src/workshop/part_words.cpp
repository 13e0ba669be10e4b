// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/part_words.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "nazori/author/stroke_numbers.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

struct PartWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::PartWords)
};

constexpr int kLastRadical = 214;
constexpr char16_t kFirstForm = 0x2F00;  ///< KANGXI RADICAL ONE

}  // namespace

QString part_words(const author::OwnPart& part) {
  const QString name = part.name.empty() ? PartWords::tr("No name yet") : to_text(part.name);
  if (part.strokes.empty()) return PartWords::tr("%1: no strokes").arg(name);
  return PartWords::tr("%1: strokes %2", nullptr, static_cast<int>(part.strokes.size()))
      .arg(name, to_text(author::stroke_numbers_text(part.strokes)));
}

base::Result<std::vector<int>> read_strokes(const QString& typed, std::size_t count) {
  // Full-width digits, commas and hyphens become those of ASCII.
  QString text = typed.normalized(QString::NormalizationForm_KC);
  text.replace(QChar(0x3001), QLatin1Char(','));
  for (const char16_t dash : {u'\u2013', u'\u301C', u'~'}) text.replace(QChar(dash), QLatin1Char('-'));
  return author::parse_stroke_numbers(text.simplified().toStdString(), count);
}

QString radical_form(int radical) {
  return QString(QChar(static_cast<char16_t>(kFirstForm + radical - 1)))
      .normalized(QString::NormalizationForm_KC);
}

QString radical_words(std::optional<int> radical) {
  return radical ? QStringLiteral("%1 %2").arg(*radical).arg(radical_form(*radical)) : QString();
}

namespace {

/// The radical of a form, 0 where there is none.
int radical_of(const QString& form, const RadicalOfForm& of_form) {
  for (int number = 1; number <= kLastRadical; ++number)
    if (radical_form(number) == form) return number;
  return of_form ? of_form(form).value_or(0) : 0;
}

}  // namespace

bool read_radical(const QString& typed, std::optional<int>& radical, const RadicalOfForm& of_form) {
  const QString text = typed.normalized(QString::NormalizationForm_KC).simplified();
  if (text.isEmpty()) {
    radical.reset();
    return true;
  }
  static const QRegularExpression shape(QStringLiteral("^([0-9]{0,3}) ?(\\D*)$"));
  const auto match = shape.match(text);
  const QString form = match.captured(2);
  int number = match.captured(1).toInt();
  const int named = form.isEmpty() ? number : radical_of(form, of_form);
  if (match.captured(1).isEmpty()) number = named;
  if (number < 1 || number > kLastRadical || named != number) return false;
  radical = number;
  return true;
}

}  // namespace nazori::ui
