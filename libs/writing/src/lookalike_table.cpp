// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string_view>

#include "nazori/writing/lookalikes.h"

namespace nazori::writing {
namespace {

struct Row {
  char32_t character;
  std::u32string_view lookalikes;  // those with greater code points
};

// Computed from the strokes of KanjiVG (CC BY-SA 3.0) with distance_of_forms(); a test computes them again.
constexpr Row kRows[] = {
    // clang-format off
    {U'う', U"らラ"},
    {U'え', U"こ"},
    {U'く', U"しそるろゑノ"},
    {U'ぐ', U"じ"},
    {U'こ', U"ニ"},
    {U'し', U"るゐゑんレ"},
    {U'す', U"ナ"},
    {U'そ', U"てへるろゐゑ"},
    {U'ぞ', U"で"},
    {U'つ', U"フ"},
    {U'づ', U"ブ"},
    {U'て', U"へヘ"},
    {U'ね', U"れわ"},
    {U'の', U"る"},
    {U'ひ', U"ゐレ"},
    {U'ま', U"モ"},
    {U'よ', U"ヒ"},
    {U'り', U"リ"},
    {U'る', U"ろゐ"},
    {U'ろ', U"ゐフ"},
    {U'ゐ', U"ゑ"},
    {U'ん', U"レ"},
    {U'エ', U"ヱ"},
    {U'ク', U"ワ"},
    {U'グ', U"ヷ"},
    {U'コ', U"ユ"},
    {U'ス', U"ヌ"},
    {U'セ', U"ヒヤ"},
    {U'ソ', U"リ"},
    {U'ト', U"メ"},
    {U'丁', U"厂"},
    {U'丈', U"大尢"},
    {U'且', U"旦目"},
    {U'丨', U"丶丿亅"},
    {U'丶', U"乙亅"},
    {U'丸', U"凡"},
    {U'丿', U"亅"},
    {U'乃', U"冂"},
    {U'久', U"夂"},
    {U'九', U"人"},
    {U'于', U"干"},
    {U'人', U"几𠆢"},
    {U'今', U"兮"},
    {U'俎', U"爼"},
    {U'俱', U"倶"},
    {U'儿', U"几𠆢"},
    {U'兀', U"尢"},
    {U'元', U"无"},
    {U'兄', U"只"},
    {U'入', U"八𠆢"},
    {U'八', U"几𠆢"},
    {U'冑', U"胃胄"},
    {U'冗', U"欠"},
    {U'几', U"𠆢"},
    {U'刀', U"力卩"},
    {U'刧', U"劫却"},
    {U'劫', U"却"},
    {U'勹', U"𠂊"},
    {U'午', U"牛"},
    {U'友', U"反"},
    {U'口', U"囗"},
    {U'叨', U"叩"},
    {U'叭', U"叺"},
    {U'史', U"央"},
    {U'呷', U"呻"},
    {U'土', U"士工"},
    {U'坏', U"抔"},
    {U'坑', U"抗"},
    {U'坡', U"披"},
    {U'坤', U"抻"},
    {U'坦', U"担"},
    {U'坩', U"拑"},
    {U'坿', U"拊"},
    {U'埃', U"挨"},
    {U'埔', U"捕"},
    {U'埵', U"捶"},
    {U'埼', U"掎"},
    {U'堀', U"掘"},
    {U'堆', U"推"},
    {U'堤', U"提"},
    {U'場', U"揚"},
    {U'塔', U"搭"},
    {U'壇', U"擅"},
    {U'壙', U"擴"},
    {U'壤', U"攘"},
    {U'夂', U"夊"},
    {U'大', U"尢"},
    {U'天', U"夫无旡"},
    {U'夫', U"夬无"},
    {U'失', U"矢"},
    {U'妲', U"姐"},
    {U'子', U"孑"},
    {U'尤', U"犬"},
    {U'巛', U"川"},
    {U'己', U"已巳"},
    {U'已', U"巳"},
    {U'帳', U"悵"},
    {U'忤', U"忰"},
    {U'戌', U"戍"},
    {U'戍', U"成"},
    {U'扶', U"抉"},
    {U'抉', U"択"},
    {U'抻', U"押"},
    {U'斂', U"歛"},
    {U'无', U"旡"},
    {U'未', U"末"},
    {U'朷', U"朸"},
    {U'机', U"杁"},
    {U'杲', U"果"},
    {U'杵', U"枠"},
    {U'柤', U"相"},
    {U'汗', U"汚"},
    {U'江', U"汢"},
    {U'沒', U"没"},
    {U'沮', U"泪"},
    {U'油', U"沺"},
    {U'泅', U"泗"},
    {U'漠', U"漢"},
    {U'田', U"由"},
    {U'甲', U"申"},
    {U'疸', U"疽"},
    {U'癸', U"発"},
    {U'皿', U"罒"},
    {U'紬', U"細"},
    {U'肚', U"肛"},
    {U'胃', U"胄"},
    {U'苜', U"苴"},
    {U'見', U"貝"},
    {U'訣', U"訳"},
    {U'釖', U"釛"},
    {U'釜', U"釡"},
    {U'陜', U"陝"},
    {U'靭', U"靱"},
    // clang-format on
};

}  // namespace

std::vector<char32_t> lookalikes_of(char32_t character) {
  std::vector<char32_t> result;
  for (const auto& row : kRows) {
    if (row.character == character)
      result.insert(result.end(), row.lookalikes.begin(), row.lookalikes.end());
    else if (row.lookalikes.find(character) != std::u32string_view::npos)
      result.push_back(row.character);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace nazori::writing
