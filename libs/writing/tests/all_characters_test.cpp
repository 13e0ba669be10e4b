// SPDX-License-Identifier: Apache-2.0
// Every stroke of every character of the database, as drawn and with each kind of mistake.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "drawing.h"
#include "indistinguishable.h"
#include "lookalike_contrast.h"
#include "nazori/base/utf8.h"
#include "nazori/geometry/polyline.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/lookalikes.h"
#include "nazori/writing/model_library.h"
#include "nazori/writing/recogniser.h"
#include "quick_strokes.h"

namespace nazori::writing::test {
namespace {

const kanji::KanjiDatabase& database() {
  static const auto kOpened = [] {
    const char* folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe): one thread
    auto opened =
        kanji::KanjiDatabase::open(std::filesystem::path(folder == nullptr ? "." : folder) / "kanji.db");
    if (!opened) {
      ADD_FAILURE() << base::to_line(opened.error());
      std::abort();
    }
    return std::move(*opened);
  }();
  return kOpened;
}

// All characters in optimised code; every eighth where the code is slow.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define NAZORI_SLOW_CODE
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__) || \
    defined(NAZORI_SLOW_CODE)
constexpr std::size_t kEvery = 8;
#else
constexpr std::size_t kEvery = 1;
#endif

std::vector<kanji::Summary> sampled() {
  const auto all = database().list(kanji::List::all);
  std::vector<kanji::Summary> some;
  for (std::size_t i = 0; i < all.size(); i += kEvery) some.push_back(all[i]);
  return some;
}

/// Cached, like the models of the library, because several tests need each of them.
const kanji::Character& known(char32_t character) {
  static std::map<char32_t, kanji::Character> read;
  const auto found = read.find(character);
  if (found != read.end()) return found->second;
  return read.emplace(character, *database().find(character)).first->second;
}

ModelLibrary& library() {
  static ModelLibrary made(database());
  return made;
}

/// The stroke of a character to be spoilt: a different one for each character and mistake, but the same in
/// every run.
std::size_t chosen(char32_t character, std::size_t salt, std::size_t count) {
  return (static_cast<std::size_t>(character) * 2654435761U + salt * 40503U) % 104729U % count;
}

class AllCharacters : public testing::Test {
 protected:
  /// Calls `judge` for each tested main form.
  template <class Judge>
  static void each(Judge judge) {
    for (const auto& summary : sampled()) {
      const auto entry = library().find(summary.code_point);
      ASSERT_TRUE(entry);
      const auto accepted = [&entry](const WrittenCharacter& ink) {
        const auto g = grade(ink, (*entry)->model, {}, (*entry)->lookalikes);
        EXPECT_TRUE(g);
        return g && g->accepted;
      };
      const auto& c = known(summary.code_point);
      judge(c, trace(c), accepted);
    }
  }
};

TEST_F(AllCharacters, AreThoseOfTheDatabase) { EXPECT_EQ(database().list(kanji::List::all).size(), 6702U); }

TEST_F(AllCharacters, AreAcceptedAsDrawn) {
  each([&](const kanji::Character& c, const WrittenCharacter& ink, const auto& accepted) {
    EXPECT_TRUE(accepted(ink)) << base::encode_utf8(c.code_point);
  });
}

TEST_F(AllCharacters, AreNotAcceptedWithAStrokeReversed) {
  each([&](const kanji::Character& c, WrittenCharacter ink, const auto& accepted) {
    const auto k = chosen(c.code_point, 1, ink.strokes.size());
    if (indistinguishable_reversed(c, k)) return;
    ink.strokes[k] = reversed(ink.strokes[k]);
    EXPECT_FALSE(accepted(ink)) << base::encode_utf8(c.code_point) << " stroke " << k + 1;
  });
}

TEST_F(AllCharacters, AreNotAcceptedWithAStrokeMissing) {
  each([&](const kanji::Character& c, WrittenCharacter ink, const auto& accepted) {
    const auto k = chosen(c.code_point, 2, ink.strokes.size());
    if (ink.strokes.size() < 2 || indistinguishable_without(c, k)) return;
    ink.strokes.erase(ink.strokes.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(accepted(ink)) << base::encode_utf8(c.code_point) << " stroke " << k + 1;
  });
}

TEST_F(AllCharacters, AreNotAcceptedWithTwoStrokesExchanged) {
  each([&](const kanji::Character& c, WrittenCharacter ink, const auto& accepted) {
    if (ink.strokes.size() < 2) return;
    const auto k = chosen(c.code_point, 3, ink.strokes.size() - 1);
    if (indistinguishable_exchanged(c, k)) return;
    std::swap(ink.strokes[k], ink.strokes[k + 1]);
    EXPECT_FALSE(accepted(ink)) << base::encode_utf8(c.code_point) << " strokes " << k + 1 << " and "
                                << k + 2;
  });
}

TEST_F(AllCharacters, AreNotAcceptedWithAStrokeShortenedToAThird) {
  each([&](const kanji::Character& c, WrittenCharacter ink, const auto& accepted) {
    const auto k = chosen(c.code_point, 4, ink.strokes.size());
    if (indistinguishable_shortened(database(), c, k)) return;
    ink.strokes[k] = shortened(ink.strokes[k], 1.0 / 3);
    EXPECT_FALSE(accepted(ink)) << base::encode_utf8(c.code_point) << " stroke " << k + 1;
  });
}

/// Strokes of all characters of which one long stroke was spoiled.
struct Spoiled {
  int tried = 0;
  int accepted = 0;
  int passed_over = 0;  ///< accepted, and the stroke not named in the advice either
};

/// Spoils every stroke of more than 25 of the 109 units of every `step`th character in turn.
template <class Spoil>
Spoiled spoil_long_strokes(std::size_t step, Spoil spoil) {
  Spoiled result;
  const auto all = sampled();
  for (std::size_t i = 0; i < all.size(); i += step) {
    const auto entry = library().find(all[i].code_point);
    if (!entry) continue;
    const auto& c = known(all[i].code_point);
    // A single stroke has no other to be measured by.
    if (c.strokes.size() < 2) continue;
    const auto ink = trace(c);
    for (std::size_t k = 0; k < ink.strokes.size(); ++k) {
      if (geometry::arc_length<geometry::GlyphFrame>(c.strokes[k].line.points) <= 25) continue;
      auto changed = ink;
      changed.strokes[k] = spoil(ink.strokes[k]);
      const auto g = grade(changed, (*entry)->model, {}, (*entry)->lookalikes);
      if (!g) continue;
      ++result.tried;
      if (!g->accepted) continue;
      ++result.accepted;
      if (std::none_of(g->advice.begin(), g->advice.end(),
                       [k](const Mistake& m) { return m.stroke == static_cast<int>(k); }))
        ++result.passed_over;
    }
  }
  return result;
}

/// About the centre of its points: as many times as large, and turned.
WrittenStroke about_its_centre(WrittenStroke stroke, double size, double turn_rad) {
  double x = 0;
  double y = 0;
  for (const auto& p : stroke) {
    x += p.at.x / static_cast<double>(stroke.size());
    y += p.at.y / static_cast<double>(stroke.size());
  }
  for (auto& p : stroke) {
    const double dx = size * (p.at.x - x);
    const double dy = size * (p.at.y - y);
    p.at.x = x + dx * std::cos(turn_rad) - dy * std::sin(turn_rad);
    p.at.y = y + dx * std::sin(turn_rad) + dy * std::cos(turn_rad);
  }
  return stroke;
}

TEST_F(AllCharacters, AreRefusedWithAnyLongStrokeCutToAThird) {
  const auto found = spoil_long_strokes(2, [](const WrittenStroke& s) { return shortened(s, 1.0 / 3); });
  EXPECT_GT(found.tried, 20'000 / static_cast<int>(kEvery));
  EXPECT_LE(200 * found.accepted, found.tried) << found.accepted << " of " << found.tried;
}

TEST_F(AllCharacters, AnyLongStrokeTwiceAsLongIsTold) {
  const auto found = spoil_long_strokes(4, [](const WrittenStroke& s) { return about_its_centre(s, 2, 0); });
  EXPECT_LE(33 * found.passed_over, found.tried) << found.passed_over << " of " << found.tried;
}

TEST_F(AllCharacters, AnyLongStrokeTurnedBy40DegreesIsTold) {
  const auto found =
      spoil_long_strokes(4, [](const WrittenStroke& s) { return about_its_centre(s, 1, 0.698); });
  EXPECT_LE(50 * found.passed_over, found.tried) << found.passed_over << " of " << found.tried;
}

TEST_F(AllCharacters, AnyLongStrokeMovedByAFifthOfTheBoxIsTold) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> direction(0, 6.283);
  const auto found = spoil_long_strokes(4, [&](WrittenStroke s) {
    const double way = direction(random);
    for (auto& p : s) {
      p.at.x += 0.2 * geometry::kGlyphSide * std::cos(way);
      p.at.y += 0.2 * geometry::kGlyphSide * std::sin(way);
    }
    return s;
  });
  EXPECT_LE(100 * found.passed_over, found.tried) << found.passed_over << " of " << found.tried;
}

TEST_F(AllCharacters, NoneIsListedAsIndistinguishableThatIsTold) {
  for (const auto& [character, stroke] : listed_as_shortened()) {
    const auto entry = library().find(character);
    ASSERT_TRUE(entry);
    auto ink = trace(known(character));
    ink.strokes[stroke - 1] = shortened(ink.strokes[stroke - 1], 1.0 / 3);
    const auto g = grade(ink, (*entry)->model, {}, (*entry)->lookalikes);
    ASSERT_TRUE(g);
    EXPECT_TRUE(g->accepted) << base::encode_utf8(character) << " stroke " << stroke;
  }
}

TEST_F(AllCharacters, AreAcceptedElsewhereLargerSlantedAndShaken) {
  // Stated limits: any place and size, 8 degrees of turning, a slant of 0.15, an aspect of 1.2, and 1 % of
  // the box of jitter on 16 points a stroke.
  std::uint32_t seed = 1;
  int refused = 0;
  int count = 0;
  each([&](const kanji::Character&, WrittenCharacter ink, const auto& accepted) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (auto& s : ink.strokes) s = resampled(s, 16);
    ink = shaken(std::move(ink), 0.01 * geometry::kGlyphSide, ++seed);
    const double size = std::exp(3 * unit(random));
    const double turn = 0.14 * unit(random);
    const double slant = 0.15 * unit(random);
    const double aspect = std::exp(0.18 * unit(random));
    ink =
        mapped(std::move(ink), size * aspect * std::cos(turn), size * (slant - std::sin(turn)),
               size * aspect * std::sin(turn), size * std::cos(turn), 500 * unit(random), 500 * unit(random));
    ++count;
    if (!accepted(ink)) ++refused;
  });
  EXPECT_LE(refused, count / 100);
}

TEST(Lookalikes, TheTableNamesAllPairsOfTheDatabase) {
  const std::u32string small = U"ぁぃぅぇぉっゃゅょゎゕゖァィゥェォッャュョヮヵヶ";
  const auto kind = [&small](char32_t c) {
    if (small.find(c) != std::u32string::npos) return 0;
    if ((c >= 0x3041 && c <= 0x3096) || (c >= 0x30A1 && c <= 0x30FA)) return 1;
    return (c >= 0x3400 && c <= 0x9FFF) || (c >= 0xF900 && c <= 0xFAFF) || c >= 0x20000 ? 2 : 0;
  };
  struct Member {
    Model model;
    std::vector<ThreePoints> points;
    QuickDrawing drawing;
  };
  std::map<std::pair<int, std::size_t>, std::vector<Member>> by_count;
  for (const auto& summary : sampled())
    if (const int k = kind(summary.code_point); k > 0) {
      const auto& c = known(summary.code_point);
      std::vector<ThreePoints> points;
      for (const auto& s : c.strokes) {
        std::vector<float> line;
        for (const auto& p : s.line.points) {
          line.push_back(static_cast<float>(p.x));
          line.push_back(static_cast<float>(p.y));
        }
        points.push_back(three_points(line));
      }
      by_count[{k, c.strokes.size()}].push_back({model_of(c), points, quick_drawing(points)});
    }
  // Strokes this far apart are never confused, whatever the fit does.
  const auto alike = [](const Member& a, const Member& b) {
    constexpr float kApart = 0.4F;
    return a.points.size() < 6 || distance_in_order(a.drawing, b.points) < kApart;
  };
  std::set<std::pair<char32_t, char32_t>> expected;
  std::set<char32_t> looked_at;
  for (const auto& [key, members] : by_count)
    for (const auto& a : members) {
      looked_at.insert(a.model.code_point());
      for (const auto& b : members) {
        if (a.model.code_point() >= b.model.code_point() || !alike(a, b)) continue;
        const auto& form = a.model.inside().main;
        const auto& other = b.model.inside().main;
        const double there = distance_of_forms(form, other);
        if (there >= kEasilyMistaken) continue;
        const double back = distance_of_forms(other, form);
        if (back < kEasilyMistaken && std::min(there, back) >= kSameToTheEye)
          expected.insert({a.model.code_point(), b.model.code_point()});
      }
    }
  std::set<std::pair<char32_t, char32_t>> listed;
  for (const char32_t a : looked_at)
    for (const char32_t b : lookalikes_of(a))
      if (looked_at.contains(b)) listed.insert({std::min(a, b), std::max(a, b)});
  const auto only_in = [](const auto& some, const auto& others) {
    std::string names;
    for (const auto& [a, b] : some)
      if (!others.contains({a, b})) names += base::encode_utf8(a) + base::encode_utf8(b) + " ";
    return names;
  };
  EXPECT_EQ(only_in(expected, listed), "") << "easily mistaken, not in the table";
  EXPECT_EQ(only_in(listed, expected), "") << "in the table, not easily mistaken";
}

TEST(Lookalikes, WritingOneIsNotAcceptedForTheOther) {
  const std::vector<std::u32string> groups{U"土士", U"未末", U"己已巳", U"刀力", U"干于", U"人入八",
                                           U"りリ", U"田由", U"由甲",   U"甲申", U"大丈", U"矢失",
                                           U"午牛", U"千干", U"天夭",   U"目且", U"王壬"};
  for (const auto& group : groups)
    for (const char32_t asked : group)
      for (const char32_t written : group) {
        const auto entry = library().find(asked);
        ASSERT_TRUE(entry);
        const auto g = grade(trace(known(written)), (*entry)->model, {}, (*entry)->lookalikes);
        ASSERT_TRUE(g);
        EXPECT_EQ(g->accepted, asked == written)
            << base::encode_utf8(written) << " for " << base::encode_utf8(asked);
        const bool named = std::any_of(g->mistakes.begin(), g->mistakes.end(),
                                       [](const Mistake& f) { return f.kind == kanji::MistakeKind::other; });
        if (named) {
          EXPECT_LE(g->score, 70) << "the strokes of another character earn nothing";
        }
      }
}

/// Whether the character is among the ten likeliest.
bool is_found(const Recogniser& recogniser, const WrittenCharacter& ink, char32_t character) {
  const auto found = recogniser.recognise(ink);
  return found && std::any_of(found->begin(), found->end(),
                              [&](const Candidate& c) { return c.character == character; });
}

TEST(RecogniserOfAll, FindsEveryKanjiThatIsNotDrawnLikeAnother) {
  const auto recogniser = Recogniser::make(database());
  ASSERT_TRUE(recogniser);
  EXPECT_EQ(recogniser->size(), 6702);
  int missed = 0;
  const auto all = database().list(kanji::List::all);
  for (std::size_t i = 0; i < all.size(); i += 13 * kEvery)
    if (!is_found(*recogniser, trace(known(all[i].code_point)), all[i].code_point)) ++missed;
  EXPECT_LE(missed, 3);
}

// Few strokes in a slanted, shaky hand, where one that is not theirs changes the picture most.
TEST(RecogniserOfAll, FindsTheFirstGradeWithAStrokeOfAnotherCharacterAnywhereAmongTheirs) {
  const auto recogniser = Recogniser::make(database());
  ASSERT_TRUE(recogniser);
  std::mt19937 random(5);
  const auto below = [&random](std::size_t n) { return random() % n; };
  const auto all = database().list(kanji::List::grade_1);
  int tried = 0, missed = 0;
  for (std::size_t i = 0; i < 4 * all.size(); i += kEvery) {
    const char32_t asked = all[i % all.size()].code_point;
    auto ink =
        mapped(shaken(trace(known(asked)), 2.5, static_cast<std::uint32_t>(i)), 1, 0.15, 0.1, 0.9, 4, 6);
    const auto other = trace(known(all[below(all.size())].code_point));
    const auto turn = static_cast<std::ptrdiff_t>(below(ink.strokes.size() + 1));
    ink.strokes.insert(ink.strokes.begin() + turn, other.strokes[below(other.strokes.size())]);
    ++tried;
    if (!is_found(*recogniser, ink, asked)) ++missed;
  }
  EXPECT_LE(20 * missed, tried) << missed << " of " << tried;
}

}  // namespace
}  // namespace nazori::writing::test
