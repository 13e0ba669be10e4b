// SPDX-License-Identifier: Apache-2.0
#include "relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace nazori::carving {
namespace {

constexpr int kBandRows = 64;
constexpr int kTile = 32;  ///< samples on each side; bands are whole tiles high
static_assert(kBandRows % kTile == 0);
/// Square of a depth from which on further strokes change it by less than a float can represent.
constexpr float kFull = 1.0F - 1e-7F;
/// After this many changed rows, check whether the whole tile is full.
constexpr int kChangesBetweenLooks = 128;
constexpr double kLevel = 1e-9;  ///< a segment that rises less than this is level

// Cross sections: depth in [0, 1] at x in [0, 1], the distance from the centre line in half widths. All of
// them are level at the rim and at the centre, so that no groove has an edge.

struct Rounded {
  float operator()(float x) const {
    const float u = 1.0F - x * x;
    return u * u;
  }
};

struct VShaped {
  static constexpr float kEase = 0.15F;
  float operator()(float x) const {
    const float inner = std::min(x, kEase);
    const float outer = std::max(x - (1.0F - kEase), 0.0F);
    const float fallen = inner * inner * (0.5F / kEase) + (x - inner) - outer * outer * (0.5F / kEase);
    return std::max(1.0F - fallen * (1.0F / (1.0F - kEase)), 0.0F);
  }
};

struct FlatBottom {
  float operator()(float x) const {
    const float t = std::min(2.0F - 2.0F * x, 1.0F);
    return t * t * (3.0F - 2.0F * t);
  }
};

/// Columns [begin, end) that a row may use.
struct Span {
  int begin;
  int end;
};

int clamp_to_int(double v, int low, int high) {
  return v <= low ? low : v >= high ? high : static_cast<int>(v);
}

/// First whole column at or after x.
int column_from(double x, int size) { return clamp_to_int(std::ceil(x), 0, size); }

/// Keeps the columns of a row beyond a joint's cross line (`ahead`) or before it. Both sides compute the
/// border in the same way, so that each sample belongs to exactly one of them.
void clip(Span& span, const Joint& joint, double dy, bool ahead, int size) {
  constexpr double kParallel = 1e-12;
  if (std::abs(joint.forward_x) < kParallel) {
    const bool beyond = joint.forward_y * dy >= 0;
    if (beyond != ahead) span.end = span.begin;
    return;
  }
  const double border = joint.x - joint.forward_y * dy / joint.forward_x;
  const bool to_right = joint.forward_x > 0;
  if (to_right) {
    const int c = column_from(border, size);
    ahead ? span.begin = std::max(span.begin, c) : span.end = std::min(span.end, c);
  } else {
    const int c = clamp_to_int(std::floor(border) + 1, 0, size);
    ahead ? span.end = std::min(span.end, c) : span.begin = std::max(span.begin, c);
  }
}

// Rows are filled from sample `first`, and what is computed there does not depend on it.

template <class Profile>
void fill_even(float* row, int first, int count, float q, float dq, float depth, Profile profile) {
  for (int i = first; i < count; ++i) {
    const float x = std::min(std::abs(q + dq * static_cast<float>(i)), 1.0F);
    row[i] = std::max(row[i], depth * profile(x));
  }
}

/// Values that change linearly along a row.
struct Ramp {
  float start;
  float step;
};

template <class Profile>
void fill_changing(float* row, int first, int count, Ramp across, Ramp from, Ramp to, Ramp width, Ramp depth,
                   Profile profile) {
  for (int i = first; i < count; ++i) {
    const auto k = static_cast<float>(i);
    const float after = std::max(from.start + from.step * k, 0.0F);
    const float before = std::max(to.start + to.step * k, 0.0F);
    const float t = after / (after + before + 1e-12F);
    const float q = std::abs(across.start + across.step * k);
    const float x = std::min(q / (width.start + width.step * t), 1.0F);
    row[i] = std::max(row[i], (depth.start + depth.step * t) * profile(x));
  }
}

}  // namespace

Relief::Relief(std::span<float> samples, int size, CrossSection cross_section)
    : samples_(samples),
      size_(size),
      cross_section_(cross_section),
      box_(whole_map(size)),
      used_(kBandRows, Columns{0, 0}),
      tiles_in_row_((size + kTile - 1) / kTile),
      tiles_(static_cast<std::size_t>(tiles_in_row_) * static_cast<std::size_t>(tiles_in_row_)) {}

Relief::Relief(std::span<float> samples, int size, const GridBox& box)
    : Relief(samples, size, CrossSection::rounded) {
  box_ = box;
  skips_full_ = false;
}

void Relief::mark(int row, int begin, int end) {
  const int top = row / kTile * kTile;
  Tile* const tiles =
      tiles_.data() + static_cast<std::size_t>(row / kTile) * static_cast<std::size_t>(tiles_in_row_);
  for (int column = begin / kTile; column * kTile < end; ++column) {
    Tile& tile = tiles[column];
    if (tile.is_full || ++tile.changes < kChangesBetweenLooks) continue;
    tile.changes = 0;
    const std::ptrdiff_t left = static_cast<std::ptrdiff_t>(column) * kTile;
    const std::ptrdiff_t right = std::min<std::ptrdiff_t>(left + kTile, size_);
    tile.is_full = true;
    for (int y = top; y < std::min(top + kTile, size_) && tile.is_full; ++y) {
      const float* const line =
          samples_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_);
      tile.is_full = std::all_of(line + left, line + right, [](float s) { return s >= kFull; });
    }
    any_full_ = any_full_ || tile.is_full;
  }
}

bool Relief::is_full(int tile_row, double left, double right) const {
  if (!any_full_) return false;
  const int begin = clamp_to_int(std::floor(left / kTile), 0, tiles_in_row_);
  const int end = clamp_to_int(std::floor(right / kTile) + 1, 0, tiles_in_row_);
  const Tile* const tiles =
      tiles_.data() + static_cast<std::size_t>(tile_row) * static_cast<std::size_t>(tiles_in_row_);
  return std::all_of(tiles + begin, tiles + std::max(begin, end),
                     [](const Tile& tile) { return tile.is_full; });
}

float* Relief::row_of(int row, int begin, int end) {
  Columns& used = used_[static_cast<std::size_t>(row - first_row_)];
  cut_begin_ = std::min(cut_begin_, row);
  cut_end_ = std::max(cut_end_, row + 1);
  float* const line =
      depths_.data() + static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(size_);
  if (used.begin >= used.end) {
    std::fill(line + begin, line + end, 0.0F);
    used = {begin, end};
  } else {
    if (begin < used.begin) {
      std::fill(line + begin, line + used.begin, 0.0F);
      used.begin = begin;
    }
    if (end > used.end) {
      std::fill(line + used.end, line + end, 0.0F);
      used.end = end;
    }
  }
  return line;
}

template <class Profile>
void Relief::sweep(const Joint& from, const Joint& to, Profile profile) {
  const double reach = std::max(from.half_width, to.half_width);
  if (reach <= 0) return;
  // Cross lines may be oblique to the segment; this is how far their ends reach.
  const double lean = reach * 1.5;
  const int row_begin =
      std::max(first_row_, clamp_to_int(std::ceil(std::min(from.y, to.y) - lean), 0, size_));
  const int row_end =
      std::min(last_row_, clamp_to_int(std::floor(std::max(from.y, to.y) + lean) + 1, 0, size_));
  if (row_begin >= row_end) return;
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length <= 0) return;
  const double ux = dx / length;
  const double uy = dy / length;
  for (int row = row_begin; row < row_end;) {
    const int rows_end = std::min(row_end, (row / kTile + 1) * kTile);
    double left = std::min(from.x, to.x) - lean;
    double right = std::max(from.x, to.x) + lean;
    if (std::abs(uy) > kLevel) {
      const double first = from.x + (row - from.y) * ux / uy;
      const double last = from.x + (rows_end - 1 - from.y) * ux / uy;
      left = std::max(left, std::min(first, last) - reach / std::abs(uy));
      right = std::min(right, std::max(first, last) + reach / std::abs(uy));
    }
    if (!is_full(row / kTile, left, right)) sweep_rows(from, to, ux, uy, row, rows_end, profile);
    row = rows_end;
  }
}

template <class Profile>
void Relief::sweep_rows(const Joint& from, const Joint& to, double ux, double uy, int row_begin, int row_end,
                        Profile profile) {
  const double reach = std::max(from.half_width, to.half_width);
  const bool even = from.half_width == to.half_width && from.depth == to.depth;
  for (int row = row_begin; row < row_end; ++row) {
    const double from_dy = row - from.y;
    const double to_dy = row - to.y;
    Span span{0, size_};
    // Distance from the line: (x - from.x) * -uy + from_dy * ux, within the groove.
    if (std::abs(uy) > kLevel) {
      const double a = from.x + (from_dy * ux - reach) / uy;
      const double b = from.x + (from_dy * ux + reach) / uy;
      span.begin = column_from(std::min(a, b), size_);
      span.end = clamp_to_int(std::floor(std::max(a, b)) + 1, 0, size_);
    } else if (std::abs(from_dy) > reach) {
      continue;
    }
    clip(span, from, from_dy, true, size_);
    clip(span, to, to_dy, false, size_);
    if (span.begin >= span.end) continue;
    const double x0 = span.begin;
    const int first = std::max(box_.left - span.begin, 0);
    const int count = std::min(span.end, box_.right) - span.begin;
    if (first >= count) continue;
    float* const line = row_of(row, span.begin + first, span.begin + count) + span.begin;
    const double across = (x0 - from.x) * -uy + from_dy * ux;
    if (even) {
      fill_even(line, first, count, static_cast<float>(across / reach), static_cast<float>(-uy / reach),
                static_cast<float>(from.depth), profile);
    } else {
      fill_changing(line, first, count, {static_cast<float>(across), static_cast<float>(-uy)},
                    {static_cast<float>((x0 - from.x) * from.forward_x + from_dy * from.forward_y),
                     static_cast<float>(from.forward_x)},
                    {static_cast<float>(-(x0 - to.x) * to.forward_x - to_dy * to.forward_y),
                     static_cast<float>(-to.forward_x)},
                    {static_cast<float>(std::max(from.half_width, 1e-4)),
                     static_cast<float>(std::max(to.half_width, 1e-4) - std::max(from.half_width, 1e-4))},
                    {static_cast<float>(from.depth), static_cast<float>(to.depth - from.depth)}, profile);
    }
  }
}

template <class Profile>
void Relief::press(const Joint& at, Profile profile) {
  const double radius = at.half_width;
  if (radius <= 0 || at.depth <= 0) return;
  const int row_begin = std::max(first_row_, clamp_to_int(std::ceil(at.y - radius), 0, size_));
  const int row_end = std::min(last_row_, clamp_to_int(std::floor(at.y + radius) + 1, 0, size_));
  for (int row = row_begin; row < row_end; ++row) {
    if (is_full(row / kTile, at.x - radius, at.x + radius)) {
      row = (row / kTile + 1) * kTile - 1;
      continue;
    }
    const double dy = row - at.y;
    const double half = std::sqrt(std::max(radius * radius - dy * dy, 0.0));
    const int begin = column_from(at.x - half, size_);
    const int end = clamp_to_int(std::floor(at.x + half) + 1, 0, size_);
    const int first = std::max(box_.left - begin, 0);
    const int count = std::min(end, box_.right) - begin;
    if (first >= count) continue;
    float* const line = row_of(row, begin + first, begin + count) + begin;
    const auto x0 = static_cast<float>((begin - at.x) / radius);
    const auto step = static_cast<float>(1 / radius);
    const auto y2 = static_cast<float>(dy * dy / (radius * radius));
    const auto depth = static_cast<float>(at.depth);
    for (int i = first; i < count; ++i) {
      const float x = x0 + step * static_cast<float>(i);
      line[i] = std::max(line[i], depth * profile(std::min(std::sqrt(x * x + y2), 1.0F)));
    }
  }
}

void Relief::join() {
  for (int row = cut_begin_; row < cut_end_; ++row) {
    const Columns used = std::exchange(used_[static_cast<std::size_t>(row - first_row_)], Columns{0, 0});
    const float* depths =
        depths_.data() + static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(size_);
    float* out = samples_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(size_);
    for (int x = used.begin; x < used.end; ++x) {
      const float square = depths[x] * depths[x];
      out[x] += square - out[x] * square;
    }
    if (skips_full_) mark(row, used.begin, used.end);
  }
}

template <class Profile>
void Relief::cut_with(const Piece& piece, Profile profile) {
  double top = std::numeric_limits<double>::infinity();
  double bottom = -top;
  for (const Joint& joint : piece.joints) {
    top = std::min(top, joint.y - joint.half_width);
    bottom = std::max(bottom, joint.y + joint.half_width);
  }
  const int begin = std::max(box_.top, clamp_to_int(std::floor(top), 0, size_)) / kTile * kTile;
  const int end = std::min(box_.bottom, clamp_to_int(std::ceil(bottom) + 1, 0, size_));
  depths_.resize(static_cast<std::size_t>(kBandRows) * static_cast<std::size_t>(size_));
  for (int band = begin; band < end; band += kBandRows) {
    first_row_ = std::max(band, box_.top);
    last_row_ = std::min(end, band + kBandRows);
    if (first_row_ >= last_row_) continue;
    cut_begin_ = last_row_;
    cut_end_ = first_row_;
    for (std::size_t i = 0; i + 1 < piece.joints.size(); ++i)
      sweep(piece.joints[i], piece.joints[i + 1], profile);
    for (const Joint& joint : piece.joints)
      if (joint.needs_disc) press(joint, profile);
    if (piece.round_start) press(piece.joints.front(), profile);
    if (piece.round_end) press(piece.joints.back(), profile);
    join();
  }
}

void Relief::cut(const Piece& piece) {
  switch (cross_section_) {
    case CrossSection::rounded:
      return cut_with(piece, Rounded{});
    case CrossSection::v_shaped:
      return cut_with(piece, VShaped{});
    case CrossSection::flat_bottom:
      return cut_with(piece, FlatBottom{});
  }
}

}  // namespace nazori::carving
