// SPDX-License-Identifier: Apache-2.0
#include "shortlist.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "ink_moments.h"
#include "steady_line.h"

namespace nazori::writing {
namespace {

constexpr float kNever = std::numeric_limits<float>::max();

/// The `count` smallest of `scores`, by index.
std::vector<std::size_t> smallest(const std::vector<float>& scores, std::size_t count) {
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (scores[i] < kNever) index.push_back(i);
  count = std::min(count, index.size());
  std::nth_element(index.begin(), index.begin() + static_cast<std::ptrdiff_t>(count), index.end(),
                   [&scores](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
  index.resize(count);
  return index;
}

struct Bounds {
  double left = 0, top = 0, side = 0;
};

Bounds bounds_of(const WrittenCharacter& ink) {
  const auto first = ink.strokes.front().front().at;
  double left = first.x, right = first.x, top = first.y, bottom = first.y;
  for (const auto& s : ink.strokes)
    for (const auto& p : s) {
      left = std::min(left, p.at.x);
      right = std::max(right, p.at.x);
      top = std::min(top, p.at.y);
      bottom = std::max(bottom, p.at.y);
    }
  return {left, top, std::max({right - left, bottom - top, std::numeric_limits<double>::min()})};
}

/// The strokes, steadied, in a box of side 100: sums of large coordinates would lose their small differences.
std::vector<std::vector<float>> in_box(const WrittenCharacter& ink, const Bounds& bounds) {
  constexpr double kSide = 100;
  std::vector<std::vector<float>> lines;
  std::vector<float> line;
  for (const auto& s : ink.strokes) {
    line.clear();
    for (const auto& p : s) {
      line.push_back(static_cast<float>((p.at.x - bounds.left) / bounds.side * kSide));
      line.push_back(static_cast<float>((p.at.y - bounds.top) / bounds.side * kSide));
    }
    lines.push_back(steady_line(line, static_cast<float>(kSide)));
  }
  return lines;
}

}  // namespace

Drawn look_at(const WrittenCharacter& ink) {
  constexpr double kGlyphBox = 109;
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
  d.picture = make_picture(std::vector<FlatLine>(flat.begin(), flat.end()));
  const auto bounds = bounds_of(ink);
  const auto lines = in_box(ink, bounds);
  const std::vector<FlatLine> all(lines.begin(), lines.end());
  d.embedding = embed(trained_weights(), make_field(all));
  d.ink = ink_points(all);
  if (ink.box) d.extent = bounds.side / ink.box->side * kGlyphBox;
  return d;
}

std::vector<Listed> shortlist(const KnownCharacters& known, const Drawn& drawn,
                              const RecogniseOptions& options) {
  constexpr std::size_t kByNet = 32;
  const std::size_t most_by_picture = options.unfinished ? 18 : 10;
  constexpr float kPerStroke = 0.01F;
  constexpr std::size_t kWithAGap = 8;
  constexpr std::size_t kOneTooMany = 4;
  const bool unfinished = options.unfinished;
  const std::size_t most_by_order = unfinished ? 28 : 14;
  const auto n = drawn.shapes.size();
  const auto characters = known.characters();
  std::vector<float> by_net(characters.size(), kNever);
  std::vector<float> by_picture(characters.size(), kNever);
  std::vector<float> by_order(characters.size(), kNever);
  std::vector<float> with_a_gap(characters.size(), kNever);
  std::vector<float> one_too_many(characters.size(), kNever);
  for (const auto& form : known.forms())
    by_net[form.character] = std::min(by_net[form.character], -likeness(drawn.embedding, form.embedding));
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const auto m = characters[i].strokes;
    if (!is_among(characters[i].code_point, options.among)) {
      by_net[i] = kNever;
      continue;
    }
    // The picture of a beginning differs from that of the whole.
    const float apart = unfinished ? static_cast<float>(m > n ? m - n : n - m) : 0;
    if (!unfinished || (m + 2 + m / 8 >= n && m <= 2 * n + 2))
      by_picture[i] = kPerStroke * apart - likeness(drawn.picture, known.picture(i));
    const auto points = known.points(characters[i]);
    if (!unfinished && m == n + 1) with_a_gap[i] = distance_with_a_gap(drawn.points, points);
    if (!unfinished && m + 1 == n) one_too_many[i] = distance_with_one_too_many(drawn.points, points);
    if (m == n || (unfinished && m > n))
      by_order[i] = distance_in_order(drawn.points, points) + (m == n ? 0.0F : 0.01F);
  }
  auto chosen = smallest(by_order, most_by_order);
  const auto add = [&chosen](const std::vector<float>& scores, std::size_t count) {
    const auto more = smallest(scores, count);
    chosen.insert(chosen.end(), more.begin(), more.end());
  };
  add(by_picture, most_by_picture);
  if (!unfinished) {
    add(by_net, kByNet);
    add(with_a_gap, kWithAGap);
    add(one_too_many, kOneTooMany);
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::stable_sort(chosen.begin(), chosen.end(), [&](std::size_t a, std::size_t b) {
    return unfinished ? by_picture[a] < by_picture[b] : by_net[a] < by_net[b];
  });
  std::vector<Listed> result;
  for (const auto i : chosen) result.push_back({i, -by_net[i]});
  return result;
}

}  // namespace nazori::writing
