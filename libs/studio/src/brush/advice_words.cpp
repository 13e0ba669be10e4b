// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/advice_words.h"

#include <QCoreApplication>
#include <cmath>
#include <numbers>
#include <vector>

#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/writing_language.h"
#include "nazori/writing/explanation.h"

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::AdviceWords)
};

using calligraphy::Advice;
using calligraphy::AdviceKind;
using calligraphy::StrokePart;

/// "Stroke 2", "Strokes 1, 3 and 5"; numbers from 1.
QString strokes_of(const std::vector<int>& strokes) {
  if (strokes.size() == 1) return Words::tr("Stroke %1").arg(strokes.front() + 1);
  QStringList first;
  for (std::size_t i = 0; i + 1 < strokes.size(); ++i) first.append(QString::number(strokes[i] + 1));
  return Words::tr("Strokes %1 and %2").arg(first.join(Words::tr(", "))).arg(strokes.back() + 1);
}

int percent(double share) { return static_cast<int>(std::lround(share * 100)); }

/// About strokes. @param advice  of one kind, and one part.
QString stroke_words(const Advice& advice, const std::vector<int>& strokes, double amount) {
  const QString who = strokes_of(strokes);
  switch (advice.kind) {
    case AdviceKind::start_turned:
      return Words::tr("%1: the start is turned by %2°. Begin in the direction of the arrow.")
          .arg(who)
          .arg(std::lround(std::abs(amount) * 180 / std::numbers::pi));
    case AdviceKind::hidden_tip:
      return Words::tr("%1: the start moves back first (hidden tip). Here the tip may stay visible.")
          .arg(who);
    case AdviceKind::no_stop:
      return Words::tr("%1: there is no stop. Stop and press at the end, then lift.").arg(who);
    case AdviceKind::no_hook:
      return Words::tr("%1: the hook is missing or blunt. Stop, then flick the brush off.").arg(who);
    case AdviceKind::no_sweep:
      return Words::tr("%1: the end stays broad. Lift the brush slowly while it is still moving.").arg(who);
    case AdviceKind::thin:
      return Words::tr("%1: too thin. Press more, or take a thicker brush.").arg(who);
    case AdviceKind::thick:
      return Words::tr("%1: too thick. Press less, or take a thinner brush.").arg(who);
    case AdviceKind::hasty:
      switch (advice.part) {
        case StrokePart::beginning:
          return Words::tr("%1: hurried at the beginning. Keep an even speed.").arg(who);
        case StrokePart::middle:
          return Words::tr("%1: hurried in the middle. Keep an even speed.").arg(who);
        case StrokePart::end:
          return Words::tr("%1: hurried towards the end. Keep an even speed.").arg(who);
      }
      return {};
    case AdviceKind::halting:
      switch (advice.part) {
        case StrokePart::beginning:
          return Words::tr("%1: hesitant at the beginning. Keep an even speed.").arg(who);
        case StrokePart::middle:
          return Words::tr("%1: hesitant in the middle. Keep an even speed.").arg(who);
        case StrokePart::end:
          return Words::tr("%1: hesitant towards the end. Keep an even speed.").arg(who);
      }
      return {};
    default:
      return {};
  }
}

QString whole_words(const Advice& advice) {
  switch (advice.kind) {
    case AdviceKind::flat_width:
      return Words::tr(
          "All strokes are equally thick. Press at starts and stops, and lift in hooks and sweeps.");
    case AdviceKind::uncovered:
      return Words::tr("The ink covers only %1% of the model.").arg(percent(advice.amount));
    case AdviceKind::outside:
      return Words::tr("%1% of the ink is outside the model.").arg(percent(advice.amount));
    case AdviceKind::too_far_left:
      return Words::tr("The character is too far to the left.");
    case AdviceKind::too_far_right:
      return Words::tr("The character is too far to the right.");
    case AdviceKind::too_high:
      return Words::tr("The character is too high.");
    case AdviceKind::too_low:
      return Words::tr("The character is too low.");
    case AdviceKind::too_large:
      return Words::tr("The character is larger than the model.");
    case AdviceKind::too_small:
      return Words::tr("The character is smaller than the model.");
    case AdviceKind::wide_gap:
      return Words::tr("The gap between strokes %1 and %2 is too wide.")
          .arg(advice.stroke + 1)
          .arg(advice.second + 1);
    case AdviceKind::narrow_gap:
      return Words::tr("The gap between strokes %1 and %2 is too narrow.")
          .arg(advice.stroke + 1)
          .arg(advice.second + 1);
    default:
      return {};
  }
}

bool is_about_stroke(const Advice& advice) { return advice.stroke >= 0 && advice.second < 0; }

}  // namespace

QStringList advice_words(const calligraphy::CharacterAdvice& advice) {
  if (advice.written == 0) return {};
  if (!advice.is_comparable || !advice.grade)
    return {Words::tr("Too few strokes match the model, so they cannot be compared.")};
  QStringList sentences;
  for (const auto& mistake : advice.grade->mistakes)
    sentences.append(to_text(writing::explain(mistake, *advice.grade, writing_language())));
  // The same advice on several strokes is one sentence, where it comes first.
  std::vector<bool> is_said(advice.advice.size());
  for (std::size_t i = 0; i < advice.advice.size(); ++i) {
    const Advice& one = advice.advice[i];
    if (is_said[i]) continue;
    if (!is_about_stroke(one)) {
      sentences.append(whole_words(one));
      continue;
    }
    std::vector<int> strokes;
    double most = 0;
    for (std::size_t k = i; k < advice.advice.size(); ++k) {
      const Advice& other = advice.advice[k];
      if (!is_about_stroke(other) || other.kind != one.kind || other.part != one.part) continue;
      strokes.push_back(other.stroke);
      most = std::max(most, std::abs(other.amount));
      is_said[k] = true;
    }
    sentences.append(stroke_words(one, strokes, most));
  }
  if (advice.is_good)
    sentences.append(Words::tr("Well written: there is nothing to correct."));
  else if (!advice.good.empty())
    sentences.append(Words::tr("%1: very good.").arg(strokes_of(advice.good)));
  return sentences;
}

QStringList advice_words(std::span<const calligraphy::CharacterAdvice> sheet) {
  QStringList all;
  int written = 0;
  for (const auto& one : sheet) written += one.written > 0 ? 1 : 0;
  for (const auto& one : sheet) {
    if (one.written == 0) continue;
    if (written > 1) all.append(Words::tr("%1:").arg(to_text(one.character)));
    all.append(advice_words(one));
  }
  return all;
}

}  // namespace nazori::ui
