// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/recogniser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "alignment.h"
#include "lookalike_contrast.h"
#include "nazori/base/utf8.h"
#include "nazori/geometry/svg_path.h"
#include "nazori/writing/grade.h"
#include "quick_strokes.h"
#include "stroke_picture.h"

namespace nazori::writing {
namespace {

/// A known character: the position of its strokes in the common arrays.
struct Known {
  char32_t code_point = 0;
  int place = 0;  // 0: the commonest
  std::size_t first_stroke = 0;
  std::size_t strokes = 0;
};

}  // namespace

struct RecogniserInside {
  std::vector<Known> characters;
  std::vector<Picture> pictures;    // of each character
  std::vector<ThreePoints> points;  // of each stroke
  std::vector<std::size_t> starts;  // of each stroke in `lines`, and one more
  std::vector<float> lines;         // x and y alternating

  [[nodiscard]] FlatLine line(std::size_t stroke) const {
    return FlatLine(lines).subspan(starts[stroke], starts[stroke + 1] - starts[stroke]);
  }
  [[nodiscard]] std::vector<FlatLine> lines_of(const Known& known) const {
    std::vector<FlatLine> result;
    for (std::size_t k = 0; k < known.strokes; ++k) result.push_back(line(known.first_stroke + k));
    return result;
  }

  void begin_character(char32_t code_point, int place) {
    characters.push_back({code_point, place, points.size(), 0});
  }
  void add_point(geometry::GlyphPoint p) {
    lines.push_back(static_cast<float>(p.x));
    lines.push_back(static_cast<float>(p.y));
  }
  void end_stroke() {
    const std::size_t start = starts.empty() ? 0 : starts.back();
    if (starts.empty()) starts.push_back(0);
    starts.push_back(lines.size());
    points.push_back(three_points(FlatLine(lines).subspan(start)));
    ++characters.back().strokes;
  }
  void finish() {
    std::erase_if(characters, [](const Known& k) { return k.strokes == 0; });
    std::stable_sort(characters.begin(), characters.end(),
                     [](const Known& a, const Known& b) { return a.place < b.place; });
    pictures.reserve(characters.size());
    for (const auto& k : characters) pictures.push_back(make_picture(lines_of(k)));
  }
};

namespace {

/// A few points of each curve are enough, because they are resampled for comparison.
void add_path(RecogniserInside& inside, const geometry::BezierPath& path) {
  auto from = path.start;
  inside.add_point(from);
  for (const auto& piece : path.pieces) {
    for (const double t : {0.25, 0.5, 0.75}) {
      const double s = 1 - t;
      inside.add_point(from * (s * s * s) + piece[0] * (3 * s * s * t) + piece[1] * (3 * s * t * t) +
                       piece[2] * (t * t * t));
    }
    inside.add_point(piece[2]);
    from = piece[2];
  }
  inside.end_stroke();
}

/// The drawn strokes in all forms needed for comparison.
struct Drawn {
  std::vector<Shape> shapes;
  QuickDrawing points;
  Picture picture{};
};

Drawn look_at(const WrittenCharacter& ink) {
  Drawn d;
  std::vector<std::vector<float>> flat;
  std::vector<ThreePoints> points;
  for (const auto& s : ink.strokes) {
    d.shapes.push_back(make_shape<WritingFrame>(geometry::line_of(s)));
    const auto& whole = d.shapes.back().whole;
    auto& line = flat.emplace_back();
    for (std::size_t k = 0; k < kSamples; ++k) {
      line.push_back(whole.x[k]);
      line.push_back(whole.y[k]);
    }
    points.push_back(three_points(line));
  }
  d.points = quick_drawing(points);
  const std::vector<FlatLine> lines(flat.begin(), flat.end());
  d.picture = make_picture(lines);
  return d;
}

/// The `count` smallest of `scores`, by index.
std::vector<std::size_t> smallest(const std::vector<float>& scores, std::size_t count) {
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (scores[i] < std::numeric_limits<float>::max()) index.push_back(i);
  count = std::min(count, index.size());
  std::nth_element(index.begin(), index.begin() + static_cast<std::ptrdiff_t>(count), index.end(),
                   [&scores](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
  index.resize(count);
  return index;
}

/// Characters worth a closer comparison: selected by their picture, and by three points of each stroke in
/// order, also with one stroke missing or extra; the most similar first.
std::vector<std::size_t> shortlist(const RecogniserInside& inside, const Drawn& drawn, bool unfinished) {
  // The picture of a beginning differs from that of the whole.
  const std::size_t most_by_picture = unfinished ? 18 : 26;
  const std::size_t most_by_order = unfinished ? 28 : 14;
  constexpr float kNever = std::numeric_limits<float>::max();
  constexpr float kPerStroke = 0.01F;
  constexpr std::size_t kWithAGap = 8;
  constexpr std::size_t kOneTooMany = 4;
  const auto n = drawn.shapes.size();
  std::vector<float> by_picture(inside.characters.size(), kNever);
  std::vector<float> by_order(inside.characters.size(), kNever);
  std::vector<float> with_a_gap(inside.characters.size(), kNever);
  std::vector<float> one_too_many(inside.characters.size(), kNever);
  for (std::size_t i = 0; i < inside.characters.size(); ++i) {
    const auto& known = inside.characters[i];
    const auto m = known.strokes;
    // In quick writing strokes are joined: more often too few are drawn than too many.
    if (m + 2 + m / 8 >= n && m <= 2 * n + 2) {
      const float apart = static_cast<float>(m > n ? m - n : n - m);
      by_picture[i] = kPerStroke * apart - likeness(drawn.picture, inside.pictures[i]);
    }
    const auto points = std::span(inside.points).subspan(known.first_stroke, m);
    if (!unfinished && m == n + 1) with_a_gap[i] = distance_with_a_gap(drawn.points, points);
    if (!unfinished && m + 1 == n) one_too_many[i] = distance_with_one_too_many(drawn.points, points);
    if (m == n || (unfinished && m > n))
      by_order[i] = distance_in_order(drawn.points, points) + (m == n ? 0.0F : 0.01F);
  }
  auto result = smallest(by_picture, most_by_picture);
  for (const auto i : smallest(by_order, most_by_order)) result.push_back(i);
  for (const auto i : smallest(with_a_gap, kWithAGap)) result.push_back(i);
  for (const auto i : smallest(one_too_many, kOneTooMany)) result.push_back(i);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  std::stable_sort(result.begin(), result.end(),
                   [&by_picture](std::size_t a, std::size_t b) { return by_picture[a] < by_picture[b]; });
  return result;
}

struct Scored {
  std::size_t index = 0;
  double cost = 0;
};

Form form_of(const RecogniserInside& inside, const Known& known) {
  Form form;
  form.shapes.reserve(known.strokes);
  std::vector<double> xs;
  std::vector<double> ys;
  for (std::size_t k = 0; k < known.strokes; ++k) {
    const auto line = inside.line(known.first_stroke + k);
    xs.clear();
    ys.clear();
    for (std::size_t i = 0; i + 1 < line.size(); i += 2) {
      xs.push_back(static_cast<double>(line[i]));
      ys.push_back(static_cast<double>(line[i + 1]));
    }
    form.shapes.push_back(make_shape(xs, ys));
  }
  return form;
}

/// A drawing is likelier to be a kanji than a kana with the same strokes (二, ニ), and rarely a letter or a
/// mark.
double cost_of_kind(char32_t c) {
  constexpr double kKana = 0.8;
  constexpr double kOther = 1.6;
  const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  if (within(0x3041, 0x3096) || within(0x30A1, 0x30FA)) return kKana;
  return within(0x3400, 0x9FFF) || within(0xF900, 0xFAFF) || c >= 0x20000 ? 0 : kOther;
}

/// Cost for each stroke, common characters a little cheaper. Nullopt where it is not below `limit`.
std::optional<double> cost_of(const RecogniserInside& inside, const Drawn& drawn, std::size_t index,
                              bool unfinished, double limit) {
  constexpr double kRare = 0.12;     // for each e-fold in rank
  constexpr double kPicture = 12.0;  // for likeness 0
  const auto& known = inside.characters[index];
  const bool beginning = unfinished && known.strokes > drawn.shapes.size();
  double cost = kRare * std::log(20.0 + known.place) + cost_of_kind(known.code_point);
  if (beginning)
    cost += 0.5;
  else
    cost += kPicture * (1 - static_cast<double>(likeness(drawn.picture, inside.pictures[index])));
  if (cost >= limit) return std::nullopt;
  const auto form = form_of(inside, known);
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
                    static_cast<float>((limit - cost) * count));
  cost += static_cast<double>(a.cost) / count;
  return cost < limit ? std::optional(cost) : std::nullopt;
}

}  // namespace

Recogniser::Recogniser(std::unique_ptr<const RecogniserInside> inside) : inside_(std::move(inside)) {}
Recogniser::Recogniser(Recogniser&&) noexcept = default;
Recogniser& Recogniser::operator=(Recogniser&&) noexcept = default;
Recogniser::~Recogniser() = default;

base::Result<Recogniser> Recogniser::make(const kanji::KanjiDatabase& database) {
  auto inside = std::make_unique<RecogniserInside>();
  char32_t current = 0;
  char32_t damaged = 0;
  database.for_each_stroke([&](const kanji::StrokePath& stroke) {
    const auto path = geometry::parse_svg_path(stroke.path);
    if (!path) damaged = stroke.code_point;
    if (!path) return;
    if (inside->characters.empty() || stroke.code_point != current)
      inside->begin_character(stroke.code_point, stroke.place);
    current = stroke.code_point;
    add_path(*inside, *path);
  });
  inside->finish();
  if (database.trouble()) return tl::unexpected(*database.trouble());
  if (damaged != 0)
    return base::fail(base::Errc::schema, "A stroke of this character is no path.",
                      base::encode_utf8(damaged), "build it again: nazori-cli database build");
  if (inside->characters.empty())
    return base::fail(base::Errc::not_found, "the database has no characters with strokes", {},
                      "build it again: nazori-cli database build");
  return Recogniser(std::move(inside));
}

base::Result<Recogniser> Recogniser::make(const std::vector<kanji::Character>& characters) {
  auto inside = std::make_unique<RecogniserInside>();
  int place = 0;
  for (const auto& c : characters) {
    inside->begin_character(c.code_point, place++);
    for (const auto& s : c.strokes) {
      if (s.line.points.empty()) continue;
      for (const auto& p : s.line.points) inside->add_point(p);
      inside->end_stroke();
    }
  }
  inside->finish();
  if (inside->characters.empty())
    return base::fail(base::Errc::not_found, "none of the characters has strokes");
  return Recogniser(std::move(inside));
}

int Recogniser::size() const { return static_cast<int>(inside_->characters.size()); }

base::Result<std::vector<Candidate>> Recogniser::recognise(const WrittenCharacter& ink,
                                                           const RecogniseOptions& options) const {
  if (auto good = check(ink); !good) return tl::unexpected(good.error());
  if (options.limit < 1) return base::fail(base::Errc::bad_argument, "must be at least 1", "limit");
  const auto drawn = look_at(ink);
  constexpr double kUnlikely = 1e6;
  std::vector<Scored> scored;  // ascending
  for (const auto index : shortlist(*inside_, drawn, options.unfinished)) {
    const bool full = scored.size() == static_cast<std::size_t>(options.limit);
    const auto cost =
        cost_of(*inside_, drawn, index, options.unfinished, full ? scored.back().cost : kUnlikely);
    if (!cost) continue;
    if (full) scored.pop_back();
    const auto place = std::upper_bound(scored.begin(), scored.end(), *cost,
                                        [](double c, const Scored& s) { return c < s.cost; });
    scored.insert(place, {index, *cost});
  }
  std::vector<Candidate> result;
  for (const auto& s : scored)
    result.push_back({inside_->characters[s.index].code_point, 1 / (1 + std::max(0.0, s.cost) / 8)});
  return result;
}

}  // namespace nazori::writing
