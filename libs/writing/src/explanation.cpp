// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/explanation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "explanation_texts.h"
#include "nazori/base/utf8.h"

namespace nazori::writing {
namespace {

std::string fill(Text which, Language language, const std::string& first, const std::string& second = {}) {
  return fmt::format(fmt::runtime(text(which, language)), first, second);
}

std::string number(int index) { return std::to_string(index + 1); }

Text text_of_start(Side side) {
  switch (side) {
    case Side::top:
      return Text::starts_top;
    case Side::bottom:
      return Text::starts_bottom;
    case Side::left:
      return Text::starts_left;
    case Side::right:
      return Text::starts_right;
  }
  return Text::starts_top;
}

Text text_of_wrong(const Mistake& mistake, const StrokeVerdict& verdict) {
  switch (mistake.deviation) {
    case Deviation::place:
      if (std::abs(verdict.offset_x) > std::abs(verdict.offset_y))
        return verdict.offset_x > 0 ? Text::too_far_right : Text::too_far_left;
      return verdict.offset_y > 0 ? Text::too_low : Text::too_high;
    case Deviation::length:
      return verdict.size > 1 ? Text::too_long : Text::too_short;
    case Deviation::direction:
      return Text::wrong_direction;
    case Deviation::none:
    case Deviation::shape:
      break;
  }
  return Text::wrong_shape;
}

/// "2 1 3 (Tebiki 1958 list)": the strokes by their usual numbers, and the source of the order.
std::string order_words(const kanji::AlternativeOrder& order) {
  const auto remark = order.source.find(';');
  return fmt::format("{} ({})", fmt::join(order.order, " "), order.source.substr(0, remark));
}

}  // namespace

std::string explain(const Mistake& mistake, const Grade& grade, Language language) {
  const auto stroke = number(mistake.model.empty() ? mistake.stroke : mistake.model.front());
  switch (mistake.kind) {
    case kanji::MistakeKind::order:
      if (mistake.model.size() == 2 && !mistake.second)
        return fill(Text::comes_first, language, number(mistake.model[1]));
      if (mistake.model.size() == 2)
        return fill(Text::order, language, number(mistake.model[0]), number(mistake.model[1]));
      break;
    case kanji::MistakeKind::reversed:
      return fill(text_of_start(mistake.start), language, stroke);
    case kanji::MistakeKind::missing:
      if (mistake.model.size() == 2)
        return fill(Text::one_missing, language, number(mistake.model[0]), number(mistake.model[1]));
      return fill(Text::missing, language, stroke);
    case kanji::MistakeKind::extra:
      return fill(Text::extra, language, number(mistake.stroke));
    case kanji::MistakeKind::joined:
      if (mistake.model.size() == 2)
        return fill(Text::joined, language, number(mistake.model[0]), number(mistake.model[1]));
      break;
    case kanji::MistakeKind::split:
      return fill(Text::split, language, stroke);
    case kanji::MistakeKind::other:
      return fill(Text::other_character, language, base::encode_utf8(mistake.character), stroke);
    case kanji::MistakeKind::ending:
      return fill(mistake.expected == kanji::StrokeEnding::hook ? Text::kick_missing : Text::kick_needless,
                  language, stroke);
    case kanji::MistakeKind::wrong:
      if (static_cast<std::size_t>(mistake.stroke) < grade.strokes.size())
        return fill(text_of_wrong(mistake, grade.strokes[static_cast<std::size_t>(mistake.stroke)]), language,
                    stroke);
      break;
  }
  return fill(Text::wrong_shape, language, stroke);
}

std::vector<std::string> explain(const Grade& grade, Language language) {
  std::vector<std::string> sentences;
  if (grade.accepted) {
    const auto which = grade.alternative        ? Text::right_other_order
                       : !grade.variant.empty() ? Text::right_other_form
                                                : Text::right;
    sentences.push_back(fill(which, language, grade.alternative ? order_words(*grade.alternative) : ""));
  }
  for (const auto& mistake : grade.mistakes) sentences.push_back(explain(mistake, grade, language));
  for (const auto& advice : grade.advice) sentences.push_back(explain(advice, grade, language));
  return sentences;
}

std::vector<std::string> explain_score(const Grade& grade, Language language) {
  struct Part {
    Text text;
    double share;
    int most;
    int points = 0;
  };
  const auto& p = grade.parts;
  std::array<Part, 5> parts{{{Text::points_for_strokes, p.strokes, kPointsForStrokes},
                             {Text::points_for_order, p.order, kPointsForOrder},
                             {Text::points_for_direction, p.direction, kPointsForDirection},
                             {Text::points_for_shape, p.shape, kPointsForShape},
                             {Text::points_for_place, p.place, kPointsForPlace}}};
  // Whole points that add up to the score: the parts with the largest remainders get the remaining points.
  int left = grade.score;
  for (auto& part : parts) {
    part.points = static_cast<int>(part.share * part.most);
    left -= part.points;
  }
  const auto cut = [](const Part& part) { return part.share * part.most - part.points; };
  for (; left > 0; --left)
    ++std::max_element(parts.begin(), parts.end(), [&cut](const Part& a, const Part& b) {
        return cut(a) < cut(b);
      })->points;
  std::vector<std::string> sentences;
  sentences.reserve(parts.size());
  for (const auto& part : parts)
    sentences.push_back(fmt::format(fmt::runtime(text(part.text, language)), part.points, part.most));
  return sentences;
}

}  // namespace nazori::writing
