// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/ink_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "model_inside.h"
#include "nazori/geometry/point.h"
#include "nazori/writing/grade.h"
#include "shape.h"

namespace nazori::writing {
namespace {

constexpr double kStep = 2;         // glyph units between marks
constexpr double kReach = 9;        // glyph units, for a character as large as its box
constexpr double kSlantWeight = 7;  // glyph units that slants at right angles are worth

/// A bit of line: where it lies and how it slants.
struct Mark {
  double x = 0, y = 0;
  double cosine = 1, sine = 0;  // of twice its angle
  std::size_t stroke = 0;
};

template <class X, class Y>
void add_marks(std::vector<Mark>& marks, std::size_t count, X x, Y y, std::size_t stroke) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double dx = x(i + 1) - x(i);
    const double dy = y(i + 1) - y(i);
    const double length2 = dx * dx + dy * dy;
    if (length2 < 1e-12) continue;
    const int steps = std::max(1, static_cast<int>(std::sqrt(length2) / kStep + 0.5));
    for (int k = 0; k < steps; ++k) {
      const double t = (k + 0.5) / steps;
      marks.push_back(
          {x(i) + dx * t, y(i) + dy * t, (dx * dx - dy * dy) / length2, 2 * dx * dy / length2, stroke});
    }
  }
}

std::vector<Mark> marks_of(const Form& form) {
  std::vector<Mark> marks;
  for (std::size_t s = 0; s < form.shapes.size(); ++s) {
    const Samples& line = form.shapes[s].whole;
    add_marks(
        marks, kSamples, [&](std::size_t i) { return static_cast<double>(line.x[i]); },
        [&](std::size_t i) { return static_cast<double>(line.y[i]); }, s);
  }
  return marks;
}

/// The ink in glyph units of its box.
std::vector<Mark> marks_of(const WrittenCharacter& ink) {
  std::vector<Mark> marks;
  const double scale = geometry::kGlyphSide / ink.box->side;
  for (const WrittenStroke& stroke : ink.strokes)
    add_marks(
        marks, stroke.size(), [&](std::size_t i) { return (stroke[i].at.x - ink.box->corner.x) * scale; },
        [&](std::size_t i) { return (stroke[i].at.y - ink.box->corner.y) * scale; }, 0);
  return marks;
}

struct Extent {
  double left = std::numeric_limits<double>::max();
  double right = std::numeric_limits<double>::lowest();
  double top = left;
  double bottom = right;

  explicit Extent(const std::vector<Mark>& marks) {
    for (const Mark& m : marks) {
      left = std::min(left, m.x);
      right = std::max(right, m.x);
      top = std::min(top, m.y);
      bottom = std::max(bottom, m.y);
    }
  }
  [[nodiscard]] double larger() const { return std::max({right - left, bottom - top, 1.0}); }
};

double turned(const Mark& a, const Mark& b) { return 0.5 * (1 - a.cosine * b.cosine - a.sine * b.sine); }

std::size_t nearest(const Mark& from, const std::vector<Mark>& all) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double dx = from.x - all[i].x;
    const double dy = from.y - all[i].y;
    const double square = dx * dx + dy * dy + kSlantWeight * kSlantWeight * turned(from, all[i]);
    if (square < least) {
      least = square;
      best = i;
    }
  }
  return best;
}

/// The least squares of where marks lie and where they belong: x' = a x + b y + c for one coordinate.
std::array<double, 3> fitted(const std::vector<Mark>& from, const std::vector<double>& to) {
  const auto n = static_cast<double>(from.size());
  double x = 0, y = 0, u = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    x += from[i].x / n;
    y += from[i].y / n;
    u += to[i] / n;
  }
  // So much as if the map were the identity: flat characters (一) leave a direction open.
  double xx = 0.02 * n * 109, xy = 0, yy = 0.02 * n * 109, ux = 0, uy = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double dx = from[i].x - x;
    const double dy = from[i].y - y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    ux += (to[i] - u) * dx;
    uy += (to[i] - u) * dy;
  }
  const double determinant = std::max(xx * yy - xy * xy, 1e-9);
  const double a = (ux * yy - uy * xy) / determinant;
  const double b = (uy * xx - ux * xy) / determinant;
  return {a, b, u - a * x - b * y};
}

void move(std::vector<Mark>& marks, const std::array<double, 3>& to_x, const std::array<double, 3>& to_y) {
  for (Mark& m : marks) {
    const double angle = 0.5 * std::atan2(m.sine, m.cosine);
    const double dx = std::cos(angle);
    const double dy = std::sin(angle);
    const double u = to_x[0] * dx + to_x[1] * dy;
    const double v = to_y[0] * dx + to_y[1] * dy;
    const double length2 = std::max(u * u + v * v, 1e-12);
    m.cosine = (u * u - v * v) / length2;
    m.sine = 2 * u * v / length2;
    const double x = to_x[0] * m.x + to_x[1] * m.y + to_x[2];
    m.y = to_y[0] * m.x + to_y[1] * m.y + to_y[2];
    m.x = x;
  }
}

/// Lays the ink over the model: first box over box, then by the nearest bits of line.
double lay_over(std::vector<Mark>& ink, const std::vector<Mark>& model) {
  constexpr int kPasses = 5;
  const Extent a(ink);
  const Extent b(model);
  const double scale = b.larger() / a.larger();
  const double middle_x = (b.left + b.right - scale * (a.left + a.right)) / 2;
  const double middle_y = (b.top + b.bottom - scale * (a.top + a.bottom)) / 2;
  move(ink, {scale, 0, middle_x}, {0, scale, middle_y});
  double lean = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    std::vector<double> x;
    std::vector<double> y;
    // Both ways: else much ink would shrink onto a little of the model.
    std::vector<Mark> from = ink;
    for (const Mark& m : ink) {
      const Mark& to = model[nearest(m, model)];
      x.push_back(to.x);
      y.push_back(to.y);
    }
    for (const Mark& m : model) {
      from.push_back(ink[nearest(m, ink)]);
      x.push_back(m.x);
      y.push_back(m.y);
    }
    const auto to_x = fitted(from, x);
    const auto to_y = fitted(from, y);
    // What takes the ink to the model turns it back.
    lean -= std::atan2(to_y[0] - to_x[1], to_x[0] + to_y[1]);
    move(ink, to_x, to_y);
  }
  return lean;
}

InkShape compare(const std::vector<Mark>& drawn, const Form& form) {
  const std::vector<Mark> model = marks_of(form);
  InkShape shape;
  shape.covered.assign(form.shapes.size(), 0);
  const Extent a(drawn);
  const Extent b(model);
  shape.size = a.larger() / b.larger();
  shape.offset_x = (a.left + a.right - b.left - b.right) / 2 / geometry::kGlyphSide;
  shape.offset_y = (a.top + a.bottom - b.top - b.bottom) / 2 / geometry::kGlyphSide;
  std::vector<Mark> ink = drawn;
  shape.lean_rad = lay_over(ink, model);
  const double reach = kReach * std::clamp(b.larger() / 90, 0.3, 1.0);
  const auto is_near = [reach](const Mark& p, const Mark& q) {
    return std::hypot(p.x - q.x, p.y - q.y) < reach && turned(p, q) < 0.5;
  };
  std::vector<double> length(form.shapes.size());
  double missing = 0;
  for (const Mark& m : model) {
    const bool near = is_near(m, ink[nearest(m, ink)]);
    length[m.stroke] += 1;
    shape.covered[m.stroke] += near ? 1 : 0;
    missing += near ? 0 : 1;
  }
  for (std::size_t s = 0; s < length.size(); ++s)
    shape.covered[s] = length[s] > 0 ? shape.covered[s] / length[s] : 1;
  shape.missing = missing / static_cast<double>(model.size());
  double extra = 0;
  for (const Mark& m : ink) extra += is_near(m, model[nearest(m, model)]) ? 0 : 1;
  shape.extra = extra / static_cast<double>(ink.size());
  return shape;
}

}  // namespace

base::Result<InkShape> compare_ink(const WrittenCharacter& ink, const Model& model) {
  if (auto good = check(ink); !good) return tl::unexpected(good.error());
  if (!ink.box || !(ink.box->side > 0))
    return base::fail(base::Errc::bad_argument, "the box of the ink is unknown", "box");
  const std::vector<Mark> drawn = marks_of(ink);
  InkShape best = compare(drawn, model.inside().main);
  for (const Form& form : model.inside().variants) {
    InkShape other = compare(drawn, form);
    if (other.missing + other.extra < best.missing + best.extra) best = std::move(other);
  }
  return best;
}

}  // namespace nazori::writing
