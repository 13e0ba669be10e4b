// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "nazori/author/stroke_edits.h"
#include "nazori/carving/groove.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using carving::SmoothPoint;
using geometry::GlyphPoint;
using geometry::kGlyphSide;

/// Of the rounded cross section: half of the depth at this many half widths from the centre line.
constexpr double kHalfDeep = 0.5412;
constexpr double kPi = 3.14159265358979323846;

/// A stroke with its line as it is carved.
struct Line {
  std::vector<SmoothPoint> points;
  [[nodiscard]] double length() const { return points.back().arc_length; }
  /// The half width that half of the points exceed.
  [[nodiscard]] double usual_half_width() const {
    std::vector<double> widths;
    for (const SmoothPoint& p : points) widths.push_back(p.half_width);
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    return *middle;
  }
  [[nodiscard]] double half_width_at(double s) const {
    const auto after = std::ranges::lower_bound(points, s, {}, &SmoothPoint::arc_length);
    return after == points.end() ? points.back().half_width : after->half_width;
  }
};

class Checks {
 public:
  Checks(const OwnCharacter& character, const CheckSettings& settings)
      : character_(character), settings_(settings), strokes_(character.strokes) {
    for (const OwnStroke& stroke : strokes_) lines_.push_back({carving::smooth_line(stroke.points)});
  }

  std::vector<Finding> run() {
    check_facts();
    if (!strokes_.empty()) {
      check_numbers();
      for (std::size_t k = 0; k < strokes_.size(); ++k) check_stroke(k);
      check_depths();
      check_pairs();
    }
    std::ranges::stable_sort(findings_, {},
                             [](const Finding& f) { return std::pair(f.kind, f.stroke.value_or(0)); });
    return std::move(findings_);
  }

 private:
  void add(Finding finding) { findings_.push_back(std::move(finding)); }

  void check_facts() {
    const Facts& facts = character_.facts;
    if (strokes_.empty()) {
      add({.kind = FindingKind::no_strokes,
           .severity = character_.hand.is_untouched() ? Severity::error : Severity::note});
    }
    if (facts.name.empty()) add({.kind = FindingKind::no_name});
    std::vector<bool> in_part(strokes_.size(), facts.parts.empty());
    for (const OwnPart& part : facts.parts) {
      if (part.strokes.empty()) add({.kind = FindingKind::part_empty, .text = part.name});
      for (const int stroke : part.strokes) in_part.at(static_cast<std::size_t>(stroke)) = true;
    }
    for (std::size_t k = 0; k < in_part.size(); ++k)
      if (!in_part[k]) add({.kind = FindingKind::stroke_in_no_part, .severity = Severity::note, .stroke = k});
    if (settings_.dictionary != nullptr) {
      const std::vector<int>& counts = settings_.dictionary->stroke_counts;
      const bool fits = std::ranges::find(counts, static_cast<int>(strokes_.size())) != counts.end();
      if (!counts.empty() && !fits && !strokes_.empty())
        add({.kind = FindingKind::count_differs,
             .severity = Severity::note,
             .amount = static_cast<double>(counts[0])});
    }
    const Rights& rights = facts.rights;
    if (rights.source == kKanjiVgSource) {
      // The licence allows later versions of itself.
      const bool is_kept = rights.licence == kKanjiVgLicence || rights.licence == "CC-BY-SA-4.0";
      if (!is_kept || rights.author.empty())
        add({.kind = FindingKind::licence_lost, .severity = Severity::error, .text = rights.licence});
    } else if (rights.licence.empty()) {
      add({.kind = FindingKind::no_licence, .severity = Severity::note});
    }
  }

  void check_numbers() {
    // KanjiVG's numbers begin at most so far from the start of their strokes, but for a few.
    constexpr double kFar = 12;
    const std::vector<GlyphPoint> places = number_places(strokes_);
    std::vector<NumberBox> boxes;
    for (std::size_t k = 0; k < places.size(); ++k) boxes.push_back(number_box(k + 1, places[k]));
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const GlyphPoint start = strokes_[k].points.front().at;
      const double dx = std::max({boxes[k].left - start.x, start.x - boxes[k].right, 0.0});
      const double dy = std::max({boxes[k].top - start.y, start.y - boxes[k].bottom, 0.0});
      const double away = std::hypot(dx, dy);
      if (away > kFar) add({.kind = FindingKind::number_far, .stroke = k, .at = places[k], .amount = away});
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const GlyphPoint other = strokes_[i].points.front().at;
        if (other.x > boxes[k].left && other.x < boxes[k].right && other.y > boxes[k].top &&
            other.y < boxes[k].bottom)
          add({.kind = FindingKind::number_hides_start, .stroke = k, .second = i, .at = other});
        const bool overlap = i > k && boxes[k].left < boxes[i].right && boxes[i].left < boxes[k].right &&
                             boxes[k].top < boxes[i].bottom && boxes[i].top < boxes[k].bottom;
        if (overlap) add({.kind = FindingKind::numbers_overlap, .stroke = k, .second = i, .at = places[k]});
      }
    }
  }

  void check_stroke(std::size_t k) {
    const OwnStroke& stroke = strokes_[k];
    const Line& line = lines_[k];
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
      const GlyphPoint p = stroke.points[i].at;
      if (p.x >= 0 && p.x <= kGlyphSide && p.y >= 0 && p.y <= kGlyphSide) continue;
      add({.kind = FindingKind::outside, .stroke = k, .point = i, .at = p});
      break;
    }
    constexpr double kShortest = 1;
    if (line.length() < kShortest) {
      add({.kind = FindingKind::no_length,
           .severity = Severity::error,
           .stroke = k,
           .at = stroke.points.front().at,
           .amount = line.length()});
      return;
    }
    constexpr double kLastPart = 0.15;
    constexpr double kNarrow = 0.6;
    const bool narrows =
        line.points.back().half_width < kNarrow * line.half_width_at(line.length() * (1 - kLastPart));
    const bool is_stop = stroke.ending == kanji::StrokeEnding::stop;
    if (stroke.ending != kanji::StrokeEnding::either && is_stop == narrows)
      add({.kind = FindingKind::ending_differs, .stroke = k, .at = stroke.points.back().at});
    constexpr double kSpike = 160;
    for (std::size_t i = 1; i + 1 < stroke.points.size(); ++i) {
      const GlyphPoint before = stroke.points[i].at - stroke.points[i - 1].at;
      const GlyphPoint after = stroke.points[i + 1].at - stroke.points[i].at;
      const double turn = geometry::angle_between(before, after) * 180 / kPi;
      if (turn > kSpike)
        add({.kind = FindingKind::point_off_line,
             .stroke = k,
             .point = i,
             .at = stroke.points[i].at,
             .amount = turn});
    }
    const double width = 2 * line.usual_half_width();
    if (width < settings_.tip)
      add({.kind = FindingKind::too_narrow, .stroke = k, .at = stroke.points.front().at, .amount = width});
  }

  /// The depth of each body in the relief, with what the hand changed. A body is what is neither the start
  /// nor the ending.
  void check_depths() {
    constexpr int kSize = 512;
    constexpr double kBodyBegin = 0.1;
    constexpr double kBodyEnd = 0.75;
    const auto map = carve(character_, kSize);
    if (!map) return;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      double least = std::numeric_limits<double>::infinity();
      GlyphPoint where;
      for (const SmoothPoint& p : lines_[k].points) {
        const double share = p.arc_length / std::max(lines_[k].length(), 1e-9);
        if (share < kBodyBegin || share > kBodyEnd) continue;
        const geometry::GridPoint g = geometry::glyph_to_grid(p.at, kSize);
        const long column = std::lround(g.x);
        const long row = std::lround(g.y);
        if (column < 0 || row < 0 || column >= kSize || row >= kSize) continue;
        const double depth =
            1 - static_cast<double>(map->at(static_cast<int>(column), static_cast<int>(row)));
        if (depth >= least) continue;
        least = depth;
        where = p.at;
      }
      if (least < kReadableDepth)
        add({.kind = FindingKind::too_shallow, .stroke = k, .at = where, .amount = least});
    }
  }

  void check_pairs() {
    for (std::size_t a = 0; a < lines_.size(); ++a) {
      for (std::size_t b = a + 1; b < lines_.size(); ++b) {
        if (lies_on(lines_[a], lines_[b]) && lies_on(lines_[b], lines_[a])) {
          add({.kind = FindingKind::doubled,
               .severity = Severity::error,
               .stroke = a,
               .second = b,
               .at = strokes_[b].points.front().at});
        } else {
          check_wall(a, b);
        }
      }
    }
  }

  static bool lies_on(const Line& a, const Line& b) {
    constexpr double kNear = 1;
    return std::ranges::all_of(a.points, [&b](const SmoothPoint& p) {
      for (std::size_t i = 0; i < b.points.size(); ++i) {
        const std::size_t next = std::min(i + 1, b.points.size() - 1);
        if (geometry::distance_to_segment(p.at, b.points[i].at, b.points[next].at) <= kNear) return true;
      }
      return false;
    });
  }

  /// The thinnest place of the wall between strokes that run side by side, measured at half of the depth.
  void check_wall(std::size_t a, std::size_t b) {
    constexpr double kParallel = 0.94;
    constexpr double kBeside = 0.3;    // of the distance, along the line
    constexpr double kSameLine = 2.0;  // nearer lines are one groove, such as where a stroke goes on
    double thinnest = settings_.tip;
    std::optional<GlyphPoint> where;
    const std::vector<SmoothPoint>& first = lines_[a].points;
    const std::vector<SmoothPoint>& second = lines_[b].points;
    for (std::size_t i = 0; i + 1 < first.size(); ++i) {
      const GlyphPoint along = first[i + 1].at - first[i].at;
      for (std::size_t k = 0; k + 1 < second.size(); ++k) {
        const GlyphPoint d = second[k].at - first[i].at;
        const double away = geometry::length(d);
        const double wall = away - kHalfDeep * (first[i].half_width + second[k].half_width);
        if (wall >= thinnest || away < kSameLine) continue;
        const GlyphPoint other = second[k + 1].at - second[k].at;
        const double lengths = geometry::length(along) * geometry::length(other);
        if (std::abs(geometry::dot(along, other)) < kParallel * lengths) continue;
        if (std::abs(geometry::dot(along, d)) > kBeside * geometry::length(along) * away) continue;
        thinnest = wall;
        where = (first[i].at + second[k].at) * 0.5;
      }
    }
    if (where)
      add({.kind = FindingKind::thin_wall,
           .stroke = a,
           .second = b,
           .at = where,
           .amount = std::max(thinnest, 0.0)});
  }

  const OwnCharacter& character_;
  const CheckSettings& settings_;
  const std::vector<OwnStroke>& strokes_;
  std::vector<Line> lines_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> check(const OwnCharacter& character, const CheckSettings& settings) {
  return Checks(character, settings).run();
}

std::string_view name_of(FindingKind kind) {
  static constexpr std::array<std::string_view, 26> kNames{
      "no_strokes",      "no_name",           "number_far",   "numbers_overlap", "number_hides_start",
      "part_empty",      "stroke_in_no_part", "outside",      "no_length",       "doubled",
      "ending_differs",  "point_off_line",    "too_shallow",  "too_narrow",      "thin_wall",
      "count_differs",   "licence_lost",      "no_licence",   "svg_view_box",    "svg_size",
      "svg_root_id",     "svg_style",         "svg_group_id", "svg_stroke_id",   "svg_number_count",
      "svg_number_order"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

}  // namespace nazori::author
