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
      return {"Right; this stroke order is also used: {0}.",
              "正しく書けました。この書き順も使われます：{0}。"};
    case Text::right_other_form:
      return {"Right; this is another accepted form.", "正しく書けました。この字形も認められています。"};
    case Text::order:
      return {"Stroke {0} was drawn before stroke {1}.", "{1}画目より先に{0}画目を書きました。"};
    case Text::comes_first:
      return {"Stroke {0} comes first.", "先に{0}画目を書きます。"};
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
    case Text::paused:
      return {"You paused within {0}, for up to {1} seconds: try to write on without stopping.",
              "{0}の途中で止まりました（最長{1}秒）。一気に書いてみましょう。"};
    case Text::hesitant:
      return {"You wrote {0} in many short moves: try to let the pen flow.",
              "{0}は細かく区切れていました。流れるように書いてみましょう。"};
    case Text::not_stopped:
      return {"Stop at the end of {0}: hold the pen still before you lift it.",
              "{0}は、とめます。ペンを止めてから離しましょう。"};
    case Text::not_swept:
      return {"Sweep out {0}: lift the pen while it still moves.",
              "{0}は、はらいます。動かしながらペンを離しましょう。"};
    case Text::kick_held:
      return {"Flick out of the kick of {0}: lift the pen while it still moves.",
              "{0}のはねは、動かしながらペンを離しましょう。"};
    case Text::heavy_end:
      return {"Let {0} thin out: press less and less towards the end.",
              "{0}は、終わりに向かって力を抜きましょう。"};
    case Text::light_end:
      return {"Keep the pressure to the very end of {0}.", "{0}は、最後まで力を入れてとめましょう。"};
    case Text::pace:
      return {"Written in {0} seconds; {1} of {2} strokes flowed.",
              "{0}秒で書きました。{2}画のうち{1}画が滑らかでした。"};
    case Text::points_for_strokes:
      return {"Strokes: {0} of {1} points, for each being there, once.",
              "画：{1}点中{0}点（過不足なく書けたか）。"};
    case Text::points_for_order:
      return {"Order: {0} of {1} points, for each at its turn.", "書き順：{1}点中{0}点（順番どおりか）。"};
    case Text::points_for_direction:
      return {"Direction: {0} of {1} points, for each from its beginning.",
              "方向：{1}点中{0}点（書き始めは正しいか）。"};
    case Text::points_for_shape:
      return {"Shape and size: {0} of {1} points, for being like the model.",
              "形と大きさ：{1}点中{0}点（手本に近いか）。"};
    case Text::points_for_place:
      return {"Place: {0} of {1} points, for lying well among the others.",
              "位置：{1}点中{0}点（釣り合いはよいか）。"};
  }
  return {};
}

}  // namespace

std::string_view text(Text which, Language language) {
  const auto s = sentence(which);
  return language == Language::japanese ? s.japanese : s.english;
}

}  // namespace nazori::writing
