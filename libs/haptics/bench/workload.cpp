// SPDX-License-Identifier: Apache-2.0
#include "workload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nazori::haptics::workload {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLevel = 0.05 * (2.0 / 124.0);
constexpr double kTick_s = 0.001;
constexpr double kBorder = 0.90;
constexpr double kReach = 8.0 * 2.0 / 127.0;  // centre line to lip
constexpr double kMetresPerUnit = 0.05;

double rounded(double v) { return std::floor(v * 16777216.0 + 0.5) / 16777216.0; }
Point3 rounded(const Point3& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

/// Knuth's MMIX generator, of which the upper 32 bits are used.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2862933555777941757ULL + 3037000493ULL) {
    (void)next();
    (void)next();
  }
  double uniform(double low, double high) { return low + (high - low) * (next() * (1.0 / 4294967296.0)); }

 private:
  std::uint32_t next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::uint32_t>(state_ >> 32);
  }
  std::uint64_t state_;
};

struct Point {
  double x, y;
};
using Line = std::vector<Point>;

/// Six strokes, each a quadratic curve in 24 straight pieces.
std::vector<Line> strokes() {
  struct Curve {
    Point start, control, end;
  };
  static constexpr std::array<Curve, 6> kCurves{{{{-0.70, 0.45}, {0.00, 0.45}, {0.70, 0.45}},
                                                 {{0.00, 0.85}, {0.00, 0.02}, {0.00, -0.80}},
                                                 {{-0.02, 0.40}, {-0.25, -0.15}, {-0.75, -0.55}},
                                                 {{0.02, 0.40}, {0.25, -0.15}, {0.75, -0.55}},
                                                 {{-0.45, -0.70}, {0.00, -0.70}, {0.45, -0.70}},
                                                 {{0.35, 0.80}, {0.50, 0.75}, {0.60, 0.66}}}};
  constexpr int kPieces = 24;
  std::vector<Line> lines;
  for (const Curve& c : kCurves) {
    Line line;
    for (int i = 0; i <= kPieces; ++i) {
      const double t = double(i) / kPieces, u = 1.0 - t;
      line.push_back({u * u * c.start.x + 2 * u * t * c.control.x + t * t * c.end.x,
                      u * u * c.start.y + 2 * u * t * c.control.y + t * t * c.end.y});
    }
    lines.push_back(line);
  }
  return lines;
}

double height(const Kanji& k, double x, double y) {
  const double column = (x + 1) * 0.5 * (k.size - 1), row = (y + 1) * 0.5 * (k.size - 1);
  const int i = std::min(std::max(static_cast<int>(std::floor(column)), 0), k.size - 2);
  const int j = std::min(std::max(static_cast<int>(std::floor(row)), 0), k.size - 2);
  const double u = column - i, v = row - j;
  const auto z = [&](int a, int b) {
    return k.levels[static_cast<std::size_t>(b) * static_cast<std::size_t>(k.size) +
                    static_cast<std::size_t>(a)] *
           kLevel;
  };
  return (1 - v) * ((1 - u) * z(i, j) + u * z(i + 1, j)) + v * ((1 - u) * z(i, j + 1) + u * z(i + 1, j + 1));
}

void mix(std::uint64_t& hash, std::uint64_t byte) {
  hash ^= byte;
  hash *= 1099511628211ULL;
}
constexpr std::uint64_t kStart = 1469598103934665603ULL;

}  // namespace

Kanji make_kanji(int size) {
  const auto n = static_cast<std::size_t>(size);
  const double step = 2.0 / (size - 1);
  std::vector<float> nearest(n * n, 1e9F);  // squared distance to a centre line
  for (const Line& line : strokes())
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const Point a = line[k], b = line[k + 1];
      const double ex = b.x - a.x, ey = b.y - a.y, ee = ex * ex + ey * ey;
      const auto first = [&](double p, double q) {
        return std::max(0, static_cast<int>(std::floor((std::min(p, q) - kReach + 1) / step)));
      };
      const auto last = [&](double p, double q) {
        return std::min(size - 1, static_cast<int>(std::ceil((std::max(p, q) + kReach + 1) / step)));
      };
      for (int y = first(a.y, b.y); y <= last(a.y, b.y); ++y)
        for (int x = first(a.x, b.x); x <= last(a.x, b.x); ++x) {
          const double px = -1.0 + 2.0 * x / (size - 1) - a.x, py = -1.0 + 2.0 * y / (size - 1) - a.y;
          const double t = std::clamp(ee > 0 ? (px * ex + py * ey) / ee : 0.0, 0.0, 1.0);
          const double dx = px - t * ex, dy = py - t * ey;
          float& best = nearest[static_cast<std::size_t>(y) * n + static_cast<std::size_t>(x)];
          best = std::min(best, static_cast<float>(dx * dx + dy * dy));
        }
    }
  Kanji kanji{size, std::vector<std::uint8_t>(n * n, 255)};
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const double d = std::sqrt(static_cast<double>(nearest[i])) / kReach;
    if (d < 1.0)
      kanji.levels[i] = static_cast<std::uint8_t>(std::floor(255.0 * 0.5 * (1.0 - std::cos(kPi * d)) + 0.5));
  }
  return kanji;
}

std::vector<Point3> trace(const Kanji& kanji, std::size_t ticks) {
  const double speed = 0.2 * kTick_s, fly = 1.0 * kTick_s, depth = 0.01, top = 255 * kLevel + 0.05;
  const std::vector<Line> lines = strokes();
  std::vector<Point3> out;
  for (std::size_t s = 0; out.size() < ticks; ++s) {
    const Line& line = lines[s % lines.size()];
    const double down_to = height(kanji, line[0].x, line[0].y) - depth;
    double z = top;
    while (z > down_to) {
      out.push_back({line[0].x, line[0].y, z});
      z -= speed;
    }
    const Point chord{line.back().x - line[0].x, line.back().y - line[0].y};
    const double chord_length = std::sqrt(chord.x * chord.x + chord.y * chord.y);
    const std::size_t start = out.size();
    for (const bool back : {false, true})
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Point a = back ? line[line.size() - 1 - k] : line[k];
        const Point b = back ? line[line.size() - 2 - k] : line[k + 1];
        const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
        const int steps = std::max(1, static_cast<int>(std::floor(length / speed + 0.5)));
        for (int i = 0; i < steps; ++i) {
          const double t = double(i) / steps;
          const double wander =
              0.02 * std::sin(2 * kPi * 1.0 * kTick_s * static_cast<double>(out.size() - start));
          const double x = a.x + t * (b.x - a.x) - wander * chord.y / chord_length;
          const double y = a.y + t * (b.y - a.y) + wander * chord.x / chord_length;
          out.push_back({x, y, height(kanji, x, y) - depth});
        }
      }
    const Point3 last = out.back();
    z = last.z;
    while (z < top) {
      out.push_back({last.x, last.y, z});
      z += fly;
    }
    const Point to = lines[(s + 1) % lines.size()][0];
    const double length = std::sqrt((to.x - last.x) * (to.x - last.x) + (to.y - last.y) * (to.y - last.y));
    const int steps = std::max(1, static_cast<int>(std::floor(length / fly + 0.5)));
    for (int i = 0; i < steps; ++i) {
      const double t = double(i) / steps;
      out.push_back({last.x + t * (to.x - last.x), last.y + t * (to.y - last.y), top});
    }
  }
  out.resize(ticks);
  for (Point3& p : out) p = rounded(p);
  return out;
}

std::vector<Point3> sweep(const Kanji& kanji, std::size_t ticks) {
  const double speed = 1.0 * kTick_s, depth = 0.01, pitch = 0.031;
  std::vector<Point3> out;
  double along = -kBorder, across = -kBorder, way = 1, next = 1, left = 0;
  bool turned = false;
  while (out.size() < ticks) {
    const double x = turned ? across : along, y = turned ? along : across;
    out.push_back(rounded({x, y, height(kanji, x, y) - depth}));
    if (left > 0) {
      const double s = std::min(speed, left);
      across += next * s;
      left -= s;
      continue;
    }
    along += way * speed;
    if (std::fabs(along) < kBorder) continue;
    along = along > 0 ? kBorder : -kBorder;
    way = -way;
    if (std::fabs(across + next * pitch) <= kBorder) {
      left = pitch;
    } else {
      std::swap(along, across);
      turned = !turned;
      way = along > 0 ? -1 : 1;
      next = across > 0 ? -1 : 1;
    }
  }
  return out;
}

std::vector<Point3> scribble(const Kanji& kanji, std::size_t ticks) {
  const double speed = 3.0 * kTick_s;
  Random random(7);
  std::vector<Point3> out;
  double x = 0.3, y = 0.1, heading = 0.7, turn = 0, turn_to = 0, depth = 0.02, depth_to = 0.02;
  const auto inside = [](double v) { return std::min(kBorder, std::max(-kBorder, v)); };
  while (out.size() < ticks) {
    if (out.size() % 50 == 0) {
      turn_to = random.uniform(-0.06, 0.06);
      depth_to = random.uniform(0.005, 0.045);
    }
    turn += 0.05 * (turn_to - turn);
    depth += 0.05 * (depth_to - depth);
    heading += turn;
    const double ahead_x = x + speed * std::cos(heading), ahead_y = y + speed * std::sin(heading);
    if (std::fabs(ahead_x) > kBorder) heading = kPi - heading;
    if (std::fabs(ahead_y) > kBorder) heading = -heading;
    x = rounded(inside(x + speed * std::cos(heading)));
    y = rounded(inside(y + speed * std::sin(heading)));
    heading = rounded(heading);
    out.push_back(rounded({x, y, height(kanji, x, y) - depth}));
  }
  return out;
}

std::vector<std::vector<Point3>> centre_lines() {
  std::vector<std::vector<Point3>> made;
  for (const Line& line : strokes()) {
    std::vector<Point3>& points = made.emplace_back();
    for (const Point& p : line) points.push_back({p.x, p.y, 0});
  }
  return made;
}

std::uint64_t checksum(const Kanji& kanji) {
  std::uint64_t hash = kStart;
  for (const std::uint8_t level : kanji.levels) mix(hash, level);
  return hash;
}

std::uint64_t checksum(std::span<const Point3> path) {
  std::uint64_t hash = kStart;
  for (const Point3& p : path)
    for (const double c : {p.x, p.y, p.z}) {
      const auto steps =
          static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(c * 1048576.0 + 0.5)));
      for (int byte = 0; byte < 8; ++byte) mix(hash, (steps >> (8 * byte)) & 255U);
    }
  return hash;
}

geometry::TabletShape shape() { return {2 * kMetresPerUnit, 255 * kLevel * kMetresPerUnit}; }

surface::HeightMap height_map(const Kanji& kanji) {
  surface::HeightMap map = *surface::HeightMap::create(kanji.size);
  for (int y = 0; y < kanji.size; ++y)
    for (int x = 0; x < kanji.size; ++x) {
      const std::size_t from = static_cast<std::size_t>(y) * static_cast<std::size_t>(kanji.size);
      map.set(x, kanji.size - 1 - y,
              static_cast<float>(kanji.levels[from + static_cast<std::size_t>(x)]) / 255.0F);
    }
  return map;
}

std::vector<Vec3> to_metres(std::span<const Point3> path) {
  std::vector<Vec3> out;
  out.reserve(path.size());
  for (const Point3& p : path)
    out.emplace_back(p.x * kMetresPerUnit, p.y * kMetresPerUnit, (p.z - 255 * kLevel) * kMetresPerUnit);
  return out;
}

}  // namespace nazori::haptics::workload
