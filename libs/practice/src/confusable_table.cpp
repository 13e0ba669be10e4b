// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string_view>
#include <vector>

#include "nazori/practice/confusables.h"

namespace nazori::practice {
namespace {

// Groups that learners confuse, by look: most of them are what schoolbooks practise as 似ている漢字. Written
// for Nazori, from no published list.
constexpr std::u32string_view kGroups[] = {
    // clang-format off
    U"土士", U"未末", U"待持", U"人入八", U"大犬太", U"木本", U"日目", U"白百", U"千干", U"牛午", U"石右", U"左右",
    U"王玉主", U"字学", U"名各", U"貝見", U"力刀", U"九丸", U"天夫", U"水氷永", U"小少", U"手毛", U"川州", U"己已巳",
    U"田由甲申", U"鳥島烏", U"馬鳥", U"間問聞", U"開閉閥", U"体休", U"何可", U"地池他", U"侍待持", U"時持", U"寺等", U"特持",
    U"料科", U"使便", U"輪輸論", U"陽場湯", U"復複腹", U"清晴精", U"清情", U"議義儀", U"検険験", U"講構購", U"際祭察", U"深探",
    U"鏡境", U"遣遺", U"績積", U"側測則", U"径経軽", U"粉紛", U"若苦", U"失矢", U"末来未", U"米来", U"氏民", U"低底",
    U"代伐", U"付村", U"住往", U"住注柱", U"作昨", U"札礼", U"折析", U"技枝", U"拾捨", U"投役", U"設説", U"読続", U"緑縁",
    U"線綿", U"績責", U"組祖粗", U"終給", U"結細", U"紙細", U"級吸", U"券巻", U"勝騰", U"努怒", U"勤勧", U"動働", U"童量",
    U"早草", U"旱早", U"春奏", U"書昼", U"夏真", U"具貝", U"真具", U"買貿", U"賞貧", U"貨貸", U"貸賃", U"員買", U"費質",
    U"負員", U"順須", U"預領", U"令今", U"古右", U"占古", U"告吉", U"吉古", U"喜善", U"因困囚", U"国固", U"回面",
    U"西酉四", U"酒洒", U"海毎", U"母毎", U"侮悔", U"薄簿", U"第弟", U"笛箱", U"筆律", U"健建", U"津律", U"曜躍濯",
    U"観歓権", U"職識織", U"幕墓募暮", U"慕墓", U"性姓", U"妹姉", U"始治", U"好妙", U"奴好", U"官宮", U"空究", U"密蜜",
    U"容客", U"家豚", U"宿縮", U"寒塞", U"病疲", U"度席", U"席座", U"庭廷", U"康庸", U"厚原", U"厘里", U"局居", U"尺尽",
    U"展屋", U"戸尸", U"所折", U"旅族", U"旋施", U"勿物", U"牧物", U"狭挟", U"独触", U"犯狂", U"率卒", U"着看", U"差着",
    U"義養", U"食良", U"飲飯", U"館飯", U"根眼", U"限根", U"即既", U"郎朗", U"都郡", U"部陪", U"防妨坊", U"除徐", U"院完",
    U"陸隆", U"隊墜", U"階皆", U"雪雲", U"電雷", U"青責", U"非悲", U"駅訳", U"験駅", U"点黒", U"然燃", U"無舞", U"熱勢",
    U"烈列", U"化北", U"乳孔", U"子了", U"予矛", U"才オ", U"才木", U"禾木", U"秒砂", U"程税", U"租祖", U"積責", U"穏隠",
    U"微徴", U"徳得", U"術述", U"街衛", U"後従", U"復後", U"彼波", U"破波", U"皮反", U"友反", U"及乃", U"又文", U"史吏",
    U"兄元", U"児見", U"免兎", U"賞常", U"営宮", U"戒成", U"城成", U"武式", U"試式", U"代式", U"弐武", U"弓引", U"弱強",
    U"張帳", U"幣弊", U"敵適", U"滴摘", U"敗販", U"枚牧", U"致到", U"倒到", U"制製", U"刑形", U"判刊", U"前煎", U"勇男",
    U"共供", U"港巷", U"浜兵", U"血皿", U"監覧", U"臣巨", U"酸酷", U"衣依", U"哀衰衷", U"遅避", U"壁璧", U"商適", U"滴敵",
    U"栽裁載", U"載戴", U"撤徹", U"微徹", U"旬句", U"勺句", U"約的", U"均旬", U"拘句", U"抱拘", U"抱泡", U"泡砲", U"肥肌",
    U"服報", U"朝潮", U"明朋", U"布希", U"存在", U"猫描", U"苗描", U"登発", U"祭登", U"票要", U"栗票", U"粟栗", U"末抹",
    U"妹味", U"珠株", U"仕仁", U"仁任", U"伸仲", U"沖仲", U"神伸", U"紳伸", U"シツ", U"ソン", U"ノメ", U"クワ", U"ウワ",
    U"コユ", U"ヌメ", U"スヌ", U"チテ", U"ルレ", U"ラヲ", U"ナメ", U"マム", U"アマ", U"いり", U"うら", U"きさ", U"さち",
    U"ちら", U"けは", U"こに", U"ねれわ", U"ぬめ", U"るろ", U"はほ", U"まも", U"おあ", U"しも", U"つう", U"くへ",
    // clang-format on
};

}  // namespace

std::vector<char32_t> confusables_in_table(char32_t character) {
  std::vector<char32_t> found;
  for (const auto group : kGroups) {
    if (group.find(character) == group.npos) continue;
    for (const char32_t one : group)
      if (one != character && std::find(found.begin(), found.end(), one) == found.end()) found.push_back(one);
  }
  return found;
}

}  // namespace nazori::practice
