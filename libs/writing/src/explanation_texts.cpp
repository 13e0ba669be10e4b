// SPDX-License-Identifier: Apache-2.0
#include "explanation_texts.h"

namespace nazori::writing {
namespace {

struct Sentence {
  std::string_view english;
  std::string_view japanese;
};

Sentence sentence(Text which) {
  switch (which) {
    case Text::right:
      return {"Right.", "正しく書けました。"};
    case Text::right_other_order:
      return {"Right; this stroke order is also used.", "正しく書けました。この書き順も使われます。"};
    case Text::right_other_form:
      return {"Right; this is another accepted form.", "正しく書けました。この字形も認められています。"};
    case Text::order:
      return {"Stroke {0} was drawn before stroke {1}.", "{1}画目より先に{0}画目を書きました。"};
    case Text::starts_top:
      return {"Stroke {0} starts at the top.", "{0}画目は上から書き始めます。"};
    case Text::starts_bottom:
      return {"Stroke {0} starts at the bottom.", "{0}画目は下から書き始めます。"};
    case Text::starts_left:
      return {"Stroke {0} starts at the left.", "{0}画目は左から書き始めます。"};
    case Text::starts_right:
      return {"Stroke {0} starts at the right.", "{0}画目は右から書き始めます。"};
    case Text::missing:
      return {"Stroke {0} is missing.", "{0}画目が足りません。"};
    case Text::extra:
      return {"The stroke you wrote as number {0} does not belong here.", "{0}番目に書いた線は余分です。"};
    case Text::joined:
      return {"Strokes {0} and {1} are two strokes: lift the pen between them.",
              "{0}画目と{1}画目は別の画です。間でペンを離してください。"};
    case Text::split:
      return {"Stroke {0} is one stroke: do not lift the pen in it.",
              "{0}画目は一画です。途中でペンを離さずに書いてください。"};
    case Text::wrong_shape:
      return {"Stroke {0} has another shape.", "{0}画目の形が違います。"};
    case Text::wrong_direction:
      return {"Stroke {0} goes in another direction.", "{0}画目の向きが違います。"};
    case Text::too_long:
      return {"Stroke {0} is too long.", "{0}画目が長すぎます。"};
    case Text::too_short:
      return {"Stroke {0} is too short.", "{0}画目が短すぎます。"};
    case Text::too_far_left:
      return {"Stroke {0} is too far to the left.", "{0}画目が左に寄りすぎています。"};
    case Text::too_far_right:
      return {"Stroke {0} is too far to the right.", "{0}画目が右に寄りすぎています。"};
    case Text::too_high:
      return {"Stroke {0} is too high.", "{0}画目が上に寄りすぎています。"};
    case Text::too_low:
      return {"Stroke {0} is too low.", "{0}画目が下に寄りすぎています。"};
    case Text::other_character:
      return {"This looks like {0}: mind stroke {1}.",
              "これでは「{0}」に見えます。{1}画目に気をつけてください。"};
    case Text::kick_missing:
      return {"Stroke {0} ends with a small kick.", "{0}画目の最後は、はねます。"};
    case Text::kick_needless:
      return {"Stroke {0} stops without a kick.", "{0}画目の最後は、はねずにとめます。"};
  }
  return {};
}

}  // namespace

std::string_view text(Text which, Language language) {
  const auto s = sentence(which);
  return language == Language::japanese ? s.japanese : s.english;
}

}  // namespace nazori::writing
