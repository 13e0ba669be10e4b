// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/recogniser.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "alignment.h"
#include "nazori/writing/grade.h"
#include "shortlist.h"

namespace nazori::writing {
namespace {

struct Scored {
  std::size_t index = 0;
  double cost = 0;
};

/// What speaks for a character, in one unit; lower is likelier. The weights are those under which the right
/// characters of drawings by people who know the strokes and by people who do not are likeliest
/// (docs/writing.md).
struct Weights {
  double rare = 0.275;   // for each e-fold in rank
  double kana = -0.285;  // kanji: 0
  double letter = -0.119;
  double mark = 1.0;
  double size = 1.95;  // for each e-fold that it is larger or smaller in the box than the model
  // Of a writer who just copies the looks:
  double stranger = -0.62;
  double looks = 6.07;   // for the net's likeness 0
  double drawn = 1.67;   // of drawn ink that the model lacks
  double model = 2.36;   // of the model's ink that was not drawn
  double count = 0.197;  // for each stroke more or less
  // Of a writer who knows the strokes, beside the strokes:
  double looks_known = 26;
  double drawn_known = 3.39;
  double model_known = 1.48;
  // Of a writer who knows the strokes, but wrote one that spoils the looks:
  double spoiled = 5.6;
  // Within this all three are possible.
  double spread = 3.735;
};
constexpr Weights kWeights;

double cost_of_kind(char32_t c) {
  const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  if (within(0x3041, 0x3096) || within(0x30A1, 0x30FA) || c == U'ー') return kWeights.kana;
  if (is_among(c, Among::letters)) return kWeights.letter;
  const bool kanji =
      within(0x3400, 0x9FFF) || within(0xF900, 0xFAFF) || c >= 0x20000 || c == U'々' || c == U'〇';
  return kanji ? 0 : kWeights.mark;
}

/// Cost of laying the strokes over the model's, for each drawn stroke; only roughly known where it is above
/// `limit`.
double cost_of_strokes(const KnownCharacters& all, const Known& known, const Drawn& drawn, bool beginning,
                       double limit) {
  const auto form = all.form(known);
  std::vector<Shape> pairs;
  if (const auto n = drawn.shapes.size(); n < known.strokes) {
    // Strokes after the last drawn one are ignored.
    const auto last = beginning ? std::min(known.strokes, n + 2) : known.strokes;
    pairs.reserve(last);
    for (std::size_t k = 0; k + 1 < last; ++k)
      pairs.push_back(joined(form.shapes[k].whole, form.shapes[k + 1].whole));
  }
  const auto count = static_cast<double>(drawn.shapes.size());
  const auto a =
      align_roughly({drawn.shapes, form.shapes, pairs, {}, beginning ? Extent::beginning : Extent::whole},
                    static_cast<float>(std::max(limit, 0.0) * count));
  return static_cast<double>(a.cost) / count;
}

/// Of a drawing that may go on: strokes in order, and the picture where the model has no more of them.
double cost_of_beginning(const KnownCharacters& all, const Drawn& drawn, std::size_t character,
                         double limit) {
  constexpr double kRare = 0.12;
  constexpr double kKana = 0.8;
  constexpr double kOther = 1.6;
  constexpr double kGoesOn = 0.5;
  constexpr double kPicture = 12.0;  // for likeness 0
  const auto& known = all.characters()[character];
  const bool beginning = known.strokes > drawn.shapes.size();
  double cost = kRare * std::log(20.0 + known.place);
  if (!is_among(known.code_point, Among::kanji))
    cost += is_among(known.code_point, Among::kana) ? kKana : kOther;
  cost += beginning ? kGoesOn
                    : kPicture * (1 - static_cast<double>(likeness(drawn.picture, all.picture(character))));
  return cost + cost_of_strokes(all, known, drawn, beginning, limit - cost);
}

/// A writer either knows the strokes, or just copies the looks: what is likelier counts most.
double cost_of(const KnownCharacters& all, const Drawn& drawn, const Listed& listed, double limit) {
  constexpr int kMostStrokes = 4;
  constexpr double kMostSize = 1.5;
  const auto& w = kWeights;
  const auto& known = all.characters()[listed.character];
  double cost = w.rare * std::log(20.0 + known.place) + cost_of_kind(known.code_point);
  if (drawn.extent > 0 && known.extent > 0)
    cost +=
        w.size * std::min(std::abs(std::log(drawn.extent / static_cast<double>(known.extent))), kMostSize);
  const double unlike = 1 - static_cast<double>(listed.likeness);
  const auto apart = all.ink_distance(drawn.ink, listed.character);
  const auto ink_drawn = static_cast<double>(apart.drawn);
  const auto ink_model = static_cast<double>(apart.model);
  const int strokes = static_cast<int>(known.strokes) - static_cast<int>(drawn.shapes.size());
  const double by_looks = cost + w.stranger + w.looks * unlike + w.drawn * ink_drawn + w.model * ink_model +
                          w.count * std::min(std::abs(strokes), kMostStrokes);
  const double looks_known = w.looks_known * unlike + w.drawn_known * ink_drawn + w.model_known * ink_model;
  const double others = cost + std::min(looks_known, w.spoiled);
  const double laid_over = cost_of_strokes(all, known, drawn, false, limit + 2 * w.spread - others);
  const double by_strokes = cost + looks_known + laid_over;
  const double spoiled = cost + w.spoiled + laid_over;
  const double least = std::min({by_looks, by_strokes, spoiled});
  double sum = 0;
  for (const double c : {by_looks, by_strokes, spoiled}) sum += std::exp((least - c) / w.spread);
  return least - w.spread * std::log(sum);
}

/// Of two that look the same the kanji comes before the kana (ニ and 二), but a part that hardly anybody
/// looks for does not come before a kana that many look for (イ and 亻).
void put_kanji_first(const KnownCharacters& all, std::vector<Scored>& scored) {
  constexpr float kTwin = 0.87F;
  constexpr int kUsual = 3285;  // places of kana, Jōyō and Jinmeiyō kanji lie below
  const auto is_usual = [&](const Scored& s) { return all.characters()[s.index].place < kUsual; };
  for (auto& kanji : scored) {
    if (!is_among(all.characters()[kanji.index].code_point, Among::kanji)) continue;
    for (const auto& kana : scored)
      if (is_among(all.characters()[kana.index].code_point, Among::kana) && kana.cost < kanji.cost &&
          (is_usual(kanji) || !is_usual(kana)) &&
          likeness(all.forms()[kanji.index].embedding, all.forms()[kana.index].embedding) > kTwin)
        kanji.cost = kana.cost;
  }
  std::stable_sort(scored.begin(), scored.end(), [&](const Scored& a, const Scored& b) {
    if (a.cost != b.cost) return a.cost < b.cost;
    return is_among(all.characters()[a.index].code_point, Among::kanji) &&
           !is_among(all.characters()[b.index].code_point, Among::kanji);
  });
}

double likeness_of(double cost, bool unfinished) {
  constexpr double kOfTheModel = -1.8;  // the cost of a common kanji's own strokes
  return unfinished ? 1 / (1 + std::max(0.0, cost) / 8) : 1 / (1 + std::max(0.0, cost - kOfTheModel) / 4);
}

}  // namespace

Recogniser::Recogniser(std::unique_ptr<const KnownCharacters> known) : known_(std::move(known)) {}
Recogniser::Recogniser(Recogniser&&) noexcept = default;
Recogniser& Recogniser::operator=(Recogniser&&) noexcept = default;
Recogniser::~Recogniser() = default;

base::Result<Recogniser> Recogniser::make(const kanji::KanjiDatabase& database) {
  auto known = KnownCharacters::load(database);
  if (!known) return tl::unexpected(known.error());
  return Recogniser(std::make_unique<const KnownCharacters>(std::move(*known)));
}

base::Result<Recogniser> Recogniser::make(const std::vector<kanji::Character>& characters) {
  auto known = KnownCharacters::load(characters);
  if (!known) return tl::unexpected(known.error());
  return Recogniser(std::make_unique<const KnownCharacters>(std::move(*known)));
}

int Recogniser::size() const { return static_cast<int>(known_->characters().size()); }

base::Result<std::vector<Candidate>> Recogniser::recognise(const WrittenCharacter& ink,
                                                           const RecogniseOptions& options) const {
  if (auto good = check(ink); !good) return tl::unexpected(good.error());
  if (options.limit < 1) return base::fail(base::Errc::bad_argument, "must be at least 1", "limit");
  const auto drawn = look_at(ink);
  constexpr double kUnlikely = 1e6;
  constexpr std::size_t kFewest = 12;  // so that those that look the same meet
  const auto limit = static_cast<std::size_t>(options.limit);
  const auto kept = std::max(limit, kFewest);
  std::vector<Scored> scored;  // ascending
  for (const auto& listed : shortlist(*known_, drawn, options)) {
    const bool full = scored.size() == kept;
    const double worst = full ? scored.back().cost : kUnlikely;
    const double cost = options.unfinished ? cost_of_beginning(*known_, drawn, listed.character, worst)
                                           : cost_of(*known_, drawn, listed, worst);
    if (cost >= worst) continue;
    if (full) scored.pop_back();
    const auto place = std::upper_bound(scored.begin(), scored.end(), cost,
                                        [](double c, const Scored& s) { return c < s.cost; });
    scored.insert(place, {listed.character, cost});
  }
  if (!options.unfinished) put_kanji_first(*known_, scored);
  if (scored.size() > limit) scored.resize(limit);
  std::vector<Candidate> result;
  for (const auto& s : scored)
    result.push_back({known_->characters()[s.index].code_point, likeness_of(s.cost, options.unfinished)});
  return result;
}

}  // namespace nazori::writing
