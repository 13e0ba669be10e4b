// SPDX-License-Identifier: Apache-2.0
#include "stroke_outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "nazori/geometry/needed_points.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;

constexpr double kQuarter = std::numbers::pi / 2;

/// What two neighbouring discs sweep, without the discs: the two lines that touch both.
struct SweptPart {
  GlyphPoint left;       // from a centre to where the line touches, of length 1; to the left of the direction
  GlyphPoint right;      // the same on the right
  double direction = 0;  // [rad], clockwise on the screen
  double half_front = 0;  // half the angle between left and right, over the front [rad], 0..pi
  double length = 0;      // of the lines
};

/// Whether one of the discs contains the other: there is no line that touches both.
bool is_within(const Disc& a, const Disc& b) {
  return distance(a.at, b.at) <= std::abs(a.radius - b.radius) + 1e-9;
}

SweptPart swept_part(const Disc& a, const Disc& b) {
  const GlyphPoint way = b.at - a.at;
  const double far = length(way);
  const GlyphPoint forward = way * (1 / far);
  const double lean = (a.radius - b.radius) / far;
  const double across = std::sqrt(1 - lean * lean);
  const GlyphPoint to_left{forward.y, -forward.x};
  return {forward * lean + to_left * across, forward * lean - to_left * across,
          std::atan2(forward.y, forward.x), std::acos(lean), far * across};
}

/// One contour around discs, of which none contains its neighbour.
///
/// It is the sum of the outlines of parts that all go clockwise: the four-sided part between two discs, which
/// has both centres on its border, and the sectors at joins and ends. What two of them share cancels out.
/// So the winding number is over 0 in all parts, however they overlap, and 0 elsewhere.
class ContourBuilder {
 public:
  ContourBuilder(std::span<const Disc> discs, double tolerance) : discs_(discs), tolerance_(tolerance) {}

  OutlineContour build() {
    if (discs_.size() == 1) {
      arc(discs_[0], {0, -1}, {0, -1}, 4 * kQuarter);
      nodes_.pop_back();
      return contour();
    }
    std::vector<SweptPart> parts;
    parts.reserve(discs_.size() - 1);
    for (std::size_t i = 0; i + 1 < discs_.size(); ++i) parts.push_back(swept_part(discs_[i], discs_[i + 1]));
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const Turn turn = turn_between(parts[i - 1], parts[i]);
      join(discs_[i], parts[i - 1].left, parts[i].left, turn.left, parts[i - 1].length, parts[i].length);
    }
    const SweptPart& last = parts.back();
    arc(discs_.back(), last.left, last.right, 2 * last.half_front);
    for (std::size_t i = parts.size() - 1; i >= 1; --i) {
      const Turn turn = turn_between(parts[i - 1], parts[i]);
      join(discs_[i], parts[i].right, parts[i - 1].right, turn.right, parts[i].length, parts[i - 1].length);
    }
    const SweptPart& first = parts.front();
    arc(discs_.front(), first.right, first.left, 4 * kQuarter - 2 * first.half_front);
    return contour();
  }

 private:
  enum class NodeKind : std::uint8_t { corner, control, bend };
  struct ContourNode {
    GlyphPoint at;
    NodeKind kind = NodeKind::corner;
    double sharpness = 0;  // of a bend: the sine of its turn
    double cut = 0;        // how far the curve that rounds it may be from its sides
  };
  /// Angles from the touching point before a join to the one after it, in the contour's direction.
  struct Turn {
    double left = 0;
    double right = 0;
  };

  /// Both angles come from one turn: so where the line turns back, one side gets the half disc, and never
  /// both sides or none.
  static Turn turn_between(const SweptPart& before, const SweptPart& after) {
    const double turn = std::remainder(after.direction - before.direction, 4 * kQuarter);
    const double opening = before.half_front - after.half_front;
    return {opening + turn, opening - turn};
  }

  void corner(GlyphPoint at) { nodes_.push_back({at}); }

  void arc(const Disc& disc, GlyphPoint from, GlyphPoint to, double sweep) {
    // The middle of a quadratic curve over the angle 2h is too far out by this share of the radius.
    const auto excess = [](double h) { return (std::cos(h) + 1 / std::cos(h)) / 2 - 1; };
    int pieces = static_cast<int>(std::ceil(sweep / kQuarter));
    pieces = std::max(pieces, 1);
    while (disc.radius * excess(sweep / (2 * pieces)) > tolerance_) ++pieces;
    const double half = sweep / (2 * pieces);
    const double start = std::atan2(from.y, from.x);
    const double far = disc.radius / std::cos(half);
    corner(disc.at + from * disc.radius);
    for (int i = 0; i < pieces; ++i) {
      const double angle = start + half * (2 * i + 1);
      nodes_.push_back({disc.at + GlyphPoint{std::cos(angle), std::sin(angle)} * far, NodeKind::control});
    }
    corner(disc.at + to * disc.radius);
  }

  void join(const Disc& disc, GlyphPoint from, GlyphPoint to, double turn, double before, double after) {
    constexpr double kGentle = kQuarter;
    const double half = std::abs(turn) / 2;
    if (2 * half <= kGentle) {
      // The lines of both sides meet here. Outside that is beyond the disc; inside it must be on both lines.
      const double beyond = disc.radius * (1 / std::cos(half) - 1);
      const bool meets =
          turn > 0 ? beyond <= tolerance_ : disc.radius * std::tan(half) <= 0.45 * std::min(before, after);
      if (meets) {
        const GlyphPoint middle = from + to;
        const GlyphPoint at = disc.at + middle * ((disc.radius + beyond) / length(middle));
        nodes_.push_back({at, half > 1e-6 ? NodeKind::bend : NodeKind::corner, std::sin(2 * half),
                          std::min(tolerance_, disc.radius / 2)});
        return;
      }
    }
    if (turn > 0) {
      arc(disc, from, to, turn);
    } else {
      corner(disc.at + from * disc.radius);
      corner(disc.at);
      corner(disc.at + to * disc.radius);
    }
  }

  /// The nodes with bends rounded.
  [[nodiscard]] OutlineContour contour() const {
    OutlineContour out;
    const auto put_on = [&out](GlyphPoint at) {
      constexpr double kSame = 1e-6;
      if (out.empty() || !out.back().on_curve || distance(out.back().at, at) > kSame) out.push_back({at});
    };
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const ContourNode& node = nodes_[i];
      if (node.kind == NodeKind::corner) {
        put_on(node.at);
      } else if (node.kind == NodeKind::control) {
        out.push_back({node.at, false});
      } else {
        const ContourNode& before = nodes_[(i + nodes_.size() - 1) % nodes_.size()];
        const ContourNode& after = nodes_[(i + 1) % nodes_.size()];
        // Two bends share the line between them.
        const auto part = [&node](const ContourNode& other) {
          return distance(node.at, other.at) * (other.kind == NodeKind::bend ? 0.5 : 1.0);
        };
        double back = part(before);
        double ahead = part(after);
        const double roots = std::sqrt(back) + std::sqrt(ahead);
        const double depth = roots > 0 ? node.sharpness * back * ahead / (roots * roots) : 0;
        if (depth > node.cut) {
          back *= node.cut / depth;
          ahead *= node.cut / depth;
        }
        const auto towards = [&node](const ContourNode& other, double reach) {
          const double far = distance(node.at, other.at);
          return far > 0 ? node.at + (other.at - node.at) * (reach / far) : node.at;
        };
        put_on(towards(before, back));
        out.push_back({node.at, false});
        put_on(towards(after, ahead));
      }
    }
    return out;
  }

  std::span<const Disc> discs_;
  double tolerance_;
  std::vector<ContourNode> nodes_;
};

}  // namespace

std::vector<Disc> discs_of(const carving::Groove& groove, const RadiusFloor& floor, double tolerance) {
  const std::vector<carving::SmoothPoint> line = carving::smooth_line(groove);
  const double all = line.back().arc_length;
  const double run = std::min(floor.run, all / 4);
  std::vector<Disc> discs;
  discs.reserve(line.size());
  for (const carving::SmoothPoint& point : line) {
    const double from_end = std::min(point.arc_length, all - point.arc_length);
    const double share = from_end < run ? from_end / run : 1.0;
    discs.push_back({point.at, std::max(point.half_width, floor.tip + (floor.body - floor.tip) * share)});
  }
  return thinned_discs(discs, tolerance);
}

double distance_to_segment(const Disc& disc, const Disc& a, const Disc& b) {
  const double share = geometry::nearest_share(disc.at, a.at, b.at);
  return distance(disc.at, a.at + (b.at - a.at) * share) +
         std::abs(disc.radius - (a.radius + (b.radius - a.radius) * share));
}

std::vector<Disc> thinned_discs(std::span<const Disc> discs, double tolerance, std::size_t block) {
  assert(!discs.empty());
  std::vector<Disc> thinned{discs.front()};
  for (std::size_t start = 0; start + 1 < discs.size(); start += block) {
    const std::size_t end = std::min(start + block, discs.size() - 1);
    const auto needed = geometry::needed_points(discs.subspan(start, end - start + 1), tolerance);
    // The first of a block is the last of the one before it.
    for (const std::size_t i : std::span(needed).subspan(1)) thinned.push_back(discs[start + i]);
  }
  return thinned;
}

void append_outline(std::span<const Disc> discs, double tolerance, std::vector<OutlineContour>& contours) {
  assert(!discs.empty());
  std::size_t start = 0;
  for (std::size_t end = 1; end <= discs.size(); ++end) {
    if (end < discs.size() && !is_within(discs[end - 1], discs[end])) continue;
    // Between a disc and one within it nothing is swept: the contour ends, and another one begins. A disc
    // that would be alone and is within a neighbour needs none; of two equal ones the first has it.
    const double radius = discs[start].radius;
    const bool hidden = end == start + 1 && ((start > 0 && discs[start - 1].radius >= radius) ||
                                             (end < discs.size() && discs[end].radius > radius));
    if (!hidden) contours.push_back(ContourBuilder(discs.subspan(start, end - start), tolerance).build());
    start = end;
  }
}

}  // namespace nazori::author
