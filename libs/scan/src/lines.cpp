// SPDX-License-Identifier: Apache-2.0
#include "lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "connected.h"
#include "nazori/geometry/polyline.h"

namespace nazori::scan {
namespace {

constexpr int kSide = kCellSide;
using Line = std::vector<writing::WritingPoint>;

/// The eight neighbours clockwise from the upper one.
constexpr std::array<Pixel, 8> kAround{
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

std::uint8_t value(const std::vector<std::uint8_t>& cell, int x, int y) {
  if (x < 0 || y < 0 || x >= kSide || y >= kSide) return 0;
  return cell[static_cast<std::size_t>(y * kSide + x)];
}

void thin(InkCell& ink) {
  std::vector<std::size_t> gone;
  bool changed = true;
  while (changed) {
    changed = false;
    for (const bool second : {false, true}) {
      gone.clear();
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
          if (value(ink, x, y) == 0) continue;
          std::array<int, 8> p{};
          for (std::size_t k = 0; k < 8; ++k) p[k] = value(ink, x + kAround[k].x, y + kAround[k].y);
          int count = 0;
          int turns = 0;
          for (std::size_t k = 0; k < 8; ++k) {
            count += p[k];
            turns += p[k] == 0 && p[(k + 1) % 8] == 1 ? 1 : 0;
          }
          if (count < 2 || count > 6 || turns != 1) continue;
          const bool keeps = second ? p[0] * p[2] * p[6] != 0 || p[0] * p[4] * p[6] != 0
                                    : p[0] * p[2] * p[4] != 0 || p[2] * p[4] * p[6] != 0;
          if (!keeps) gone.push_back(static_cast<std::size_t>(y * kSide + x));
        }
      for (const std::size_t at : gone) ink[at] = 0;
      changed = changed || !gone.empty();
    }
  }
}

/// Pieces of line between ends and crossings.
class Pieces {
 public:
  explicit Pieces(const InkCell& thin) : thin_(thin), node_(thin.size(), -1), done_(thin.size()) {
    find_nodes();
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        if (node_at(x, y) >= 0) follow_from(x, y);
    // What is left has neither ends nor crossings: rings.
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        if (value(thin_, x, y) != 0 && node_at(x, y) < 0 && value(done_, x, y) == 0) follow_ring(x, y);
  }

  struct Piece {
    Line line;
    int from = -1;  ///< node, -1 for a ring
    int to = -1;
  };
  std::vector<Piece> pieces;
  std::vector<int> arms;                      ///< pieces that end at each node
  std::vector<writing::WritingPoint> places;  ///< of the nodes

 private:
  [[nodiscard]] int node_at(int x, int y) const {
    if (x < 0 || y < 0 || x >= kSide || y >= kSide) return -1;
    return node_[static_cast<std::size_t>(y * kSide + x)];
  }

  /// Connected pixels with three or more arms are one crossing.
  void find_nodes() {
    std::vector<std::uint8_t> is_node(thin_.size());
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        if (value(thin_, x, y) == 0) continue;
        int count = 0;
        int turns = 0;
        for (std::size_t k = 0; k < 8; ++k) {
          const int here = value(thin_, x + kAround[k].x, y + kAround[k].y);
          const int next = value(thin_, x + kAround[(k + 1) % 8].x, y + kAround[(k + 1) % 8].y);
          count += here;
          turns += here == 0 && next == 1 ? 1 : 0;
        }
        if (count <= 1 || turns >= 3 || turns == 1) is_node[static_cast<std::size_t>(y * kSide + x)] = 1;
      }
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        if (value(is_node, x, y) == 0 || node_at(x, y) >= 0) continue;
        std::vector<Pixel> cluster{{x, y}};
        const int number = static_cast<int>(places.size());
        node_[static_cast<std::size_t>(y * kSide + x)] = number;
        double sum_x = 0;
        double sum_y = 0;
        for (std::size_t i = 0; i < cluster.size(); ++i) {
          const Pixel p = cluster[i];
          sum_x += p.x;
          sum_y += p.y;
          for (const Pixel d : kAround)
            if (value(is_node, p.x + d.x, p.y + d.y) != 0 && node_at(p.x + d.x, p.y + d.y) < 0) {
              node_[static_cast<std::size_t>((p.y + d.y) * kSide + p.x + d.x)] = number;
              cluster.push_back({p.x + d.x, p.y + d.y});
            }
        }
        const auto n = static_cast<double>(cluster.size());
        places.push_back({sum_x / n, sum_y / n});
        arms.push_back(0);
      }
  }

  void mark(int x, int y) { done_[static_cast<std::size_t>(y * kSide + x)] = 1; }

  /// Follows every line that begins beside a pixel of a node.
  void follow_from(int x0, int y0) {
    const int from = node_at(x0, y0);
    for (const Pixel d : kAround) {
      int x = x0 + d.x;
      int y = y0 + d.y;
      if (value(thin_, x, y) == 0 || node_at(x, y) >= 0 || value(done_, x, y) != 0) continue;
      Piece piece{{places_at(from)}, from, -1};
      int last_x = x0;
      int last_y = y0;
      while (true) {
        mark(x, y);
        piece.line.push_back({static_cast<double>(x), static_cast<double>(y)});
        std::optional<Pixel> next;
        int to = -1;
        // Straight neighbours before slanted ones; the node that it came from only after a few pixels.
        for (const bool slanted : {false, true})
          for (const Pixel e : kAround) {
            if ((e.x != 0 && e.y != 0) != slanted) continue;
            const int u = x + e.x;
            const int v = y + e.y;
            if (u == last_x && v == last_y) continue;
            const int node = node_at(u, v);
            if (node >= 0 && (node != from || piece.line.size() > 4)) to = node;
            if (node < 0 && value(thin_, u, v) != 0 && value(done_, u, v) == 0 && !next) next = {u, v};
          }
        if (to >= 0) {
          piece.to = to;
          piece.line.push_back(places_at(to));
          break;
        }
        if (!next) break;
        last_x = x;
        last_y = y;
        x = next->x;
        y = next->y;
      }
      add(std::move(piece));
    }
  }

  void follow_ring(int x, int y) {
    Piece piece;
    const writing::WritingPoint start{static_cast<double>(x), static_cast<double>(y)};
    std::optional<Pixel> next{{x, y}};
    while (next) {
      const Pixel p = *next;
      mark(p.x, p.y);
      piece.line.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
      next.reset();
      for (const bool slanted : {false, true})
        for (const Pixel e : kAround)
          if ((e.x != 0 && e.y != 0) == slanted && !next && value(thin_, p.x + e.x, p.y + e.y) != 0 &&
              value(done_, p.x + e.x, p.y + e.y) == 0)
            next = {p.x + e.x, p.y + e.y};
    }
    piece.line.push_back(start);
    pieces.push_back(std::move(piece));
  }

  [[nodiscard]] writing::WritingPoint places_at(int node) const {
    return places[static_cast<std::size_t>(node)];
  }

  void add(Piece piece) {
    for (const int end : {piece.from, piece.to})
      if (end >= 0) ++arms[static_cast<std::size_t>(end)];
    pieces.push_back(std::move(piece));
  }

  const InkCell& thin_;
  std::vector<int> node_;  // of each pixel, -1: none
  std::vector<std::uint8_t> done_;
};

/// The direction in which a line leaves one of its ends.
writing::WritingPoint leaving(const Line& line, bool at_start) {
  constexpr std::size_t kLook = 7;
  const std::size_t far = std::min(kLook, line.size() - 1);
  const std::size_t near = std::min<std::size_t>(2, far / 2);
  const auto at = [&](std::size_t i) { return at_start ? line[i] : line[line.size() - 1 - i]; };
  const writing::WritingPoint d = at(far) - at(near);
  const double length = std::max(geometry::length(d), 1e-9);
  return d * (1 / length);
}

/// Short pieces that end nowhere are whiskers of thick ink, not strokes.
void cut_whiskers(Pieces& all, double width) {
  std::erase_if(all.pieces, [&](const Pieces::Piece& piece) {
    if (piece.from < 0 || piece.to < 0 || piece.from == piece.to) return false;
    const int start = all.arms[static_cast<std::size_t>(piece.from)];
    const int end = all.arms[static_cast<std::size_t>(piece.to)];
    return std::min(start, end) == 1 && std::max(start, end) >= 3 &&
           geometry::arc_length<writing::WritingFrame>(piece.line) < width * 0.9 + 1;
  });
}

/// Joins pieces that go straight on through a crossing, the straightest first.
std::vector<Line> joined(Pieces& all) {
  constexpr double kStraight = 0.72;  // cosine of the greatest bend
  struct End {
    std::size_t piece;
    bool at_start;
  };
  struct Pair {
    double straight;
    End a, b;
  };
  std::vector<std::vector<End>> at_node(all.places.size());
  for (std::size_t i = 0; i < all.pieces.size(); ++i) {
    if (all.pieces[i].from >= 0) at_node[static_cast<std::size_t>(all.pieces[i].from)].push_back({i, true});
    if (all.pieces[i].to >= 0) at_node[static_cast<std::size_t>(all.pieces[i].to)].push_back({i, false});
  }
  std::vector<Pair> pairs;
  for (const auto& ends : at_node)
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t k = i + 1; k < ends.size(); ++k) {
        if (ends[i].piece == ends[k].piece) continue;
        const double straight = -geometry::dot(leaving(all.pieces[ends[i].piece].line, ends[i].at_start),
                                               leaving(all.pieces[ends[k].piece].line, ends[k].at_start));
        // Where only two are left after whiskers were cut, they are one line.
        if (straight > kStraight || ends.size() == 2) pairs.push_back({straight, ends[i], ends[k]});
      }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.straight > q.straight; });
  // For each end of a piece the end that follows it.
  std::vector<std::array<std::optional<End>, 2>> next(all.pieces.size());
  for (const Pair& pair : pairs) {
    auto& a = next[pair.a.piece][pair.a.at_start ? 0 : 1];
    auto& b = next[pair.b.piece][pair.b.at_start ? 0 : 1];
    if (a || b) continue;
    a = pair.b;
    b = pair.a;
  }
  std::vector<Line> lines;
  std::vector<bool> used(all.pieces.size());
  const auto walk = [&](End end) {
    Line line;
    while (!used[end.piece]) {
      used[end.piece] = true;
      const Line& part = all.pieces[end.piece].line;
      if (end.at_start) {
        line.insert(line.end(), part.begin(), part.end());
      } else {
        line.insert(line.end(), part.rbegin(), part.rend());
      }
      const auto& follow = next[end.piece][end.at_start ? 1 : 0];
      if (!follow) break;
      end = *follow;
    }
    lines.push_back(std::move(line));
  };
  for (std::size_t i = 0; i < all.pieces.size(); ++i)
    for (const bool at_start : {true, false})
      if (!used[i] && !next[i][at_start ? 0 : 1]) walk({i, at_start});
  for (std::size_t i = 0; i < all.pieces.size(); ++i)
    if (!used[i]) walk({i, true});
  for (std::size_t node = 0; node < all.places.size(); ++node)
    if (all.arms[node] == 0) lines.push_back({all.places[node]});
  return lines;
}

/// Without the stairs of the pixels: points at equal steps of a line of which each moved to the mean of its
/// neighbours.
Line smooth(const Line& line) {
  constexpr int kPasses = 3;
  constexpr std::size_t kStep = 3;
  Line now = line;
  for (int pass = 0; pass < kPasses; ++pass) {
    Line next = now;
    for (std::size_t i = 1; i + 1 < now.size(); ++i) next[i] = (now[i - 1] + now[i] + now[i + 1]) * (1.0 / 3);
    now = std::move(next);
  }
  Line fewer;
  for (std::size_t i = 0; i + 1 < now.size(); i += kStep) fewer.push_back(now[i]);
  fewer.push_back(now.back());
  return fewer;
}

}  // namespace

writing::WrittenCharacter lines_of(InkCell ink) {
  const auto count = [&ink] { return static_cast<double>(std::count(ink.begin(), ink.end(), 1)); };
  const double area = count();
  writing::WrittenCharacter written;
  written.box = writing::WritingBox{{0, 0}, static_cast<double>(kSide)};
  if (area == 0) return written;
  thin(ink);
  const double width = area / std::max(count(), 1.0);
  Pieces pieces(ink);
  cut_whiskers(pieces, width);
  for (Line line : joined(pieces)) {
    if (line.size() < 2 || geometry::arc_length<writing::WritingFrame>(line) < 1) {
      // A dot has no length of its own.
      const writing::WritingPoint at = line.front();
      line = {{at.x - width / 2, at.y - width / 2}, {at.x + width / 2, at.y + width / 2}};
    }
    written.strokes.push_back(geometry::written_along(smooth(line)));
  }
  return written;
}

}  // namespace nazori::scan
