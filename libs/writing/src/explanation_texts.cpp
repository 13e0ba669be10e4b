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
      return {"Correct.", "正解です。"};
    case Text::right_other_order:
      return {"Correct. This stroke order is also accepted: {0}.", "正解です。この書き順も使われます：{0}。"};
    case Text::right_other_form:
      return {"Correct. This form is also accepted.", "正解です。この字形も認められています。"};
    case Text::order:
      return {"Stroke {1} comes before stroke {0}.", "{1}画目は{0}画目より先に書きます。"};
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
      return {"Stroke {0} is missing.", "{0}画目が抜けています。"};
    case Text::one_missing:
      return {"Stroke {0} or {1} is missing.", "{0}画目か{1}画目が抜けています。"};
    case Text::extra:
      return {"Your stroke {0} isn't part of this character.", "{0}番目に書いた画は、この字にはありません。"};
    case Text::joined:
      return {"Write strokes {0} and {1} separately: lift the pen between them.",
              "{0}画目と{1}画目は別の画です。間でペンを離してください。"};
    case Text::split:
      return {"Write stroke {0} in one go: do not lift the pen.",
              "{0}画目は一画です。途中でペンを離さずに書いてください。"};
    case Text::wrong_shape:
      return {"Stroke {0} has the wrong shape.", "{0}画目の形が違います。"};
    case Text::wrong_direction:
      return {"Stroke {0} slants the wrong way.", "{0}画目の傾きが違います。"};
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
      return {"This looks like {0}. Check stroke {1}.", "「{0}」に見えます。{1}画目を見直しましょう。"};
    case Text::kick_missing:
      return {"Stroke {0} ends with a hook.", "{0}画目の最後は、はねます。"};
    case Text::kick_needless:
      return {"Stroke {0} ends with a stop, not a hook.", "{0}画目の最後は、はねずにとめます。"};
    case Text::paused:
      return {"You paused in {0} (up to {1} seconds). Try to write without stopping.",
              "{0}の途中で止まりました（最長{1}秒）。一気に書いてみましょう。"};
    case Text::hesitant:
      return {"You wrote {0} in many short movements. Try one smooth movement.",
              "{0}は細かく区切れていました。流れるように書いてみましょう。"};
    case Text::not_stopped:
      return {"End {0} with a stop: hold the pen still before you lift it.",
              "{0}は、とめます。ペンを止めてから離しましょう。"};
    case Text::not_swept:
      return {"Let {0} trail off: lift the pen while it is still moving.",
              "{0}は、はらいます。動かしながらペンを離しましょう。"};
    case Text::kick_held:
      return {"Flick the hook of {0}: lift the pen while it is still moving.",
              "{0}のはねは、動かしながらペンを離しましょう。"};
    case Text::heavy_end:
      return {"Let {0} get thinner: press less and less towards the end.",
              "{0}は、終わりに向かって力を抜きましょう。"};
    case Text::light_end:
      return {"Keep pressing until the end of {0}.", "{0}は、最後まで力を入れてとめましょう。"};
    case Text::pace:
      return {"Written in {0} seconds. {1} of {2} strokes were smooth.",
              "{0}秒で書きました。{2}画のうち{1}画がなめらかでした。"};
    case Text::points_for_strokes:
      return {"Strokes: {0}/{1}", "画数：{1}点中{0}点"};
    case Text::points_for_order:
      return {"Order: {0}/{1}", "書き順：{1}点中{0}点"};
    case Text::points_for_direction:
      return {"Direction: {0}/{1}", "向き：{1}点中{0}点"};
    case Text::points_for_shape:
      return {"Shape and size: {0}/{1}", "形と大きさ：{1}点中{0}点"};
    case Text::points_for_place:
      return {"Balance: {0}/{1}", "バランス：{1}点中{0}点"};
  }
  return {};
}

}  // namespace

std::string_view text(Text which, Language language) {
  const auto s = sentence(which);
  return language == Language::japanese ? s.japanese : s.english;
}

}  // namespace nazori::writing
