// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/kana_sound.h"

#include <algorithm>
#include <array>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"

namespace nazori::kanji {
namespace {

struct Row {
  char32_t kana;  ///< hiragana
  std::string_view romaji;
  std::string_view typed = {};
};

/// Every hiragana with its sound, in teaching order.
constexpr auto kRows = std::to_array<Row>({
    {U'あ', "a"},       {U'い', "i"},   {U'う', "u"},        {U'え', "e"},        {U'お', "o"},
    {U'か', "ka"},      {U'き', "ki"},  {U'く', "ku"},       {U'け', "ke"},       {U'こ', "ko"},
    {U'さ', "sa"},      {U'し', "shi"}, {U'す', "su"},       {U'せ', "se"},       {U'そ', "so"},
    {U'た', "ta"},      {U'ち', "chi"}, {U'つ', "tsu"},      {U'て', "te"},       {U'と', "to"},
    {U'な', "na"},      {U'に', "ni"},  {U'ぬ', "nu"},       {U'ね', "ne"},       {U'の', "no"},
    {U'は', "ha"},      {U'ひ', "hi"},  {U'ふ', "fu"},       {U'へ', "he"},       {U'ほ', "ho"},
    {U'ま', "ma"},      {U'み', "mi"},  {U'む', "mu"},       {U'め', "me"},       {U'も', "mo"},
    {U'や', "ya"},      {U'ゆ', "yu"},  {U'よ', "yo"},       {U'ら', "ra"},       {U'り', "ri"},
    {U'る', "ru"},      {U'れ', "re"},  {U'ろ', "ro"},       {U'わ', "wa"},       {U'を', "o", "wo"},
    {U'ん', "n"},       {U'ー', "-"},   {U'っ', "tsu"},      {U'ゃ', "ya"},       {U'ゅ', "yu"},
    {U'ょ', "yo"},      {U'が', "ga"},  {U'ぎ', "gi"},       {U'ぐ', "gu"},       {U'げ', "ge"},
    {U'ご', "go"},      {U'ざ', "za"},  {U'じ', "ji"},       {U'ず', "zu"},       {U'ぜ', "ze"},
    {U'ぞ', "zo"},      {U'だ', "da"},  {U'ぢ', "ji", "di"}, {U'づ', "zu", "du"}, {U'で', "de"},
    {U'ど', "do"},      {U'ば', "ba"},  {U'び', "bi"},       {U'ぶ', "bu"},       {U'べ', "be"},
    {U'ぼ', "bo"},      {U'ぱ', "pa"},  {U'ぴ', "pi"},       {U'ぷ', "pu"},       {U'ぺ', "pe"},
    {U'ぽ', "po"},      {U'ぁ', "a"},   {U'ぃ', "i"},        {U'ぅ', "u"},        {U'ぇ', "e"},
    {U'ぉ', "o"},       {U'ゎ', "wa"},  {U'ゕ', "ka"},       {U'ゖ', "ke"},       {U'ゐ', "i", "wi"},
    {U'ゑ', "e", "we"}, {U'ゔ', "vu"},
});
constexpr std::u32string_view kSmall = U"っゃゅょぁぃぅぇぉゎゕゖ";

/// Kana that are mistaken for each other, in groups; the neighbours in a group are the nearest.
constexpr auto kSimilar = std::to_array<std::u32string_view>(
    {U"あお", U"いりこ", U"うら", U"えん",   U"かや", U"きさち", U"くへ",   U"けはほ", U"しも",
     U"すむ", U"たに",   U"ちら", U"つてし", U"なた", U"ぬめ",   U"ねれわ", U"のめ",   U"まもほ",
     U"るろ", U"ゆめ",   U"アマ", U"ウワフ", U"オホ", U"カヤ",   U"クケタ", U"クワ",   U"コユヨ",
     U"サセ", U"シツ",   U"ソン", U"シン",   U"ツソ", U"スヌ",   U"セヒ",   U"チテ",   U"ナメ",
     U"ノソ", U"ヌメ",   U"フラ", U"マム",   U"ルレ", U"ラヲ",   U"コロ",   U"ニハ",   U"イト"});

/// The consonant of きゃ: the first kana, and the letters before a, u and o.
struct Combination {
  char32_t first;
  std::string_view letters;
};
constexpr auto kCombinations = std::to_array<Combination>({{U'き', "ky"},
                                                           {U'し', "sh"},
                                                           {U'ち', "ch"},
                                                           {U'に', "ny"},
                                                           {U'ひ', "hy"},
                                                           {U'み', "my"},
                                                           {U'り', "ry"},
                                                           {U'ぎ', "gy"},
                                                           {U'じ', "j"},
                                                           {U'び', "by"},
                                                           {U'ぴ', "py"}});
constexpr auto kGlides = std::to_array<std::pair<char32_t, char>>({{U'ゃ', 'a'}, {U'ゅ', 'u'}, {U'ょ', 'o'}});

bool is_katakana(char32_t kana) { return kana != U'ー' && script_of(kana) == Script::katakana; }

char32_t in_hiragana(char32_t kana) { return is_katakana(kana) ? in_other_syllabary(kana) : kana; }

const Row* row_of(char32_t kana) {
  const char32_t hiragana = in_hiragana(kana);
  const auto found =
      std::find_if(kRows.begin(), kRows.end(), [&](const Row& row) { return row.kana == hiragana; });
  return found == kRows.end() ? nullptr : &*found;
}

std::string in_syllabary_of(char32_t model, std::initializer_list<char32_t> hiragana) {
  std::string text;
  for (const char32_t one : hiragana)
    text += base::encode_utf8(is_katakana(model) ? in_other_syllabary(one) : one);
  return text;
}

/// "kya" for き and ゃ, "fa" for ふ and ぁ; empty where the two are no syllable.
std::string glide(char32_t first, char32_t small) {
  for (const auto& one : kCombinations)
    for (const auto& [kana, vowel] : kGlides)
      if (one.first == first && kana == small) return std::string(one.letters) + vowel;
  constexpr std::u32string_view kVowels = U"ぁぃぅぇぉ";
  const auto vowel = kVowels.find(small);
  const Row* const row = row_of(first);
  if (vowel == std::u32string_view::npos || row == nullptr) return {};
  // ファ, ティ, ウィ, シェ: the consonant of the first with the vowel of the second.
  const std::string_view consonant =
      first == U'う' ? std::string_view("w") : row->romaji.substr(0, row->romaji.size() - 1);
  return consonant.empty() ? std::string() : std::string(consonant) + "aiueo"[vowel];
}

/// The letter with a macron.
std::string lengthened(char vowel) {
  constexpr std::string_view kPlain = "aiueo";
  constexpr std::array<const char*, 5> kLong{"ā", "ī", "ū", "ē", "ō"};
  const auto at = kPlain.find(vowel);
  return at == std::string_view::npos ? std::string(1, vowel) + "-" : kLong[at];
}

}  // namespace

std::optional<KanaSound> kana_sound(char32_t kana) {
  // ヷ to ヺ have no hiragana.
  if (kana >= U'ヷ' && kana <= U'ヺ') return KanaSound{std::string("v") + "aieo"[kana - U'ヷ'], "", false};
  const Row* const row = row_of(kana);
  if (row == nullptr) return std::nullopt;
  return KanaSound{std::string(row->romaji), std::string(row->typed),
                   kSmall.find(row->kana) != std::u32string_view::npos};
}

std::string romaji_of(std::string_view kana) {
  const auto decoded = base::decode_utf8(kana);
  if (!decoded) return std::string(kana);
  std::string out;
  bool doubles = false;  ///< っ before this
  bool after_n = false;  ///< ん before this
  for (std::size_t i = 0; i < decoded->size(); ++i) {
    const char32_t c = in_hiragana((*decoded)[i]);
    const Row* const row = row_of(c);
    if (row == nullptr) {
      out += base::encode_utf8((*decoded)[i]);
      doubles = after_n = false;
      continue;
    }
    if (c == U'っ') {
      // At the end it cuts the vowel off: あっ.
      doubles = i + 1 < decoded->size();
      if (!doubles) out += '\'';
      continue;
    }
    if (c == U'ー') {
      if (!out.empty()) {
        const char vowel = out.back();
        out.pop_back();
        out += lengthened(vowel);
      }
      continue;
    }
    std::string syllable(row->romaji);
    if (i + 1 < decoded->size())
      if (std::string two = glide(c, in_hiragana((*decoded)[i + 1])); !two.empty()) {
        syllable = std::move(two);
        ++i;
      }
    // っち is "tch" in Hepburn.
    if (std::exchange(doubles, false)) out += syllable.starts_with("ch") ? 't' : syllable.front();
    constexpr std::string_view kAmbiguous = "aiueoy";
    if (after_n && kAmbiguous.find(syllable.front()) != std::string_view::npos) out += '\'';
    after_n = c == U'ん';
    out += syllable;
  }
  return out;
}

std::optional<int> teaching_rank(char32_t kana) {
  // ヷ to ヺ have no hiragana.
  if (kana >= U'ヷ' && kana <= U'ヺ') return static_cast<int>(kRows.size() + (kana - U'ヷ'));
  const Row* const row = row_of(kana);
  return row == nullptr ? std::nullopt : std::optional(static_cast<int>(row - kRows.data()));
}

std::vector<char32_t> similar_kana(char32_t kana) {
  std::vector<std::pair<std::size_t, char32_t>> found;
  for (const auto group : kSimilar) {
    const auto own = group.find(kana);
    if (own == std::u32string_view::npos) continue;
    for (std::size_t i = 0; i < group.size(); ++i)
      if (i != own) found.emplace_back(i > own ? i - own : own - i, group[i]);
  }
  // は, ば and ぱ differ only in their marks.
  constexpr char32_t kDakuten = 0x3099;
  constexpr char32_t kHandakuten = 0x309A;
  for (char32_t plain = kana >= 2 ? kana - 2 : kana; plain <= kana; ++plain)
    for (const char32_t other :
         {plain, with_sound_mark(plain, kDakuten), with_sound_mark(plain, kHandakuten)})
      if ((with_sound_mark(plain, kDakuten) == kana || with_sound_mark(plain, kHandakuten) == kana) &&
          other != 0 && other != kana)
        found.emplace_back(0, other);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<char32_t> similar;
  for (const auto& [distance, one] : found)
    if (std::find(similar.begin(), similar.end(), one) == similar.end()) similar.push_back(one);
  return similar;
}

std::vector<std::string> combinations_with(char32_t kana) {
  const char32_t hiragana = in_hiragana(kana);
  std::vector<std::string> found;
  for (const auto& one : kCombinations)
    for (const auto& [small, vowel] : kGlides)
      if (one.first == hiragana || small == hiragana)
        found.push_back(in_syllabary_of(kana, {one.first, small}));
  return found;
}

}  // namespace nazori::kanji
