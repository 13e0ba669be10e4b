// SPDX-License-Identifier: Apache-2.0
#include "nazori/geometry/svg_path.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <system_error>

#include "nazori/geometry/polyline.h"

namespace nazori::geometry {
namespace {

constexpr double kLargestNumber = 1e6;
constexpr std::size_t kMostPieces = 10'000;
/// 2^16 segments for one piece: far finer than any tolerance in use, and a limit for absurd input.
constexpr int kDeepestSubdivision = 16;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_relative(char command) { return command >= 'a'; }
char absolute(char command) {
  return is_relative(command) ? static_cast<char>(command - 'a' + 'A') : command;
}

/// Reads one path from left to right; the first error ends the reading.
class PathReader {
 public:
  explicit PathReader(std::string_view data) : data_(data) {}

  base::Result<BezierPath> read() {
    skip_spaces();
    if (at_end()) return refuse("path data are empty");
    if (absolute(data_[at_]) != 'M') return refuse("path data must begin with M");
    while (!at_end()) {
      if (!read_command()) return refuse(fault_);
    }
    return path_;
  }

 private:
  [[nodiscard]] tl::unexpected<base::Error> refuse(std::string what) const {
    return base::fail(base::Errc::parse, std::move(what), "column " + std::to_string(at_ + 1));
  }
  bool stop(std::string what) {
    fault_ = std::move(what);
    return false;
  }
  [[nodiscard]] bool at_end() const { return at_ == data_.size(); }
  void skip_spaces() {
    while (!at_end() && is_space(data_[at_])) ++at_;
  }
  void skip_comma() {
    skip_spaces();
    if (!at_end() && data_[at_] == ',') {
      ++at_;
      skip_spaces();
    }
  }
  [[nodiscard]] bool number_follows() const {
    if (at_end()) return false;
    const char c = data_[at_];
    return is_digit(c) || c == '.' || c == '-' || c == '+';
  }

  /// A number as SVG writes it: sign, digits, point, exponent; it ends at the first character that does not
  /// belong to it.
  std::optional<double> number() {
    std::size_t end = at_;
    const auto digits = [&] {
      const std::size_t first = end;
      while (end < data_.size() && is_digit(data_[end])) ++end;
      return end - first;
    };
    const bool plus = end < data_.size() && data_[end] == '+';
    if (end < data_.size() && (plus || data_[end] == '-')) ++end;
    std::size_t figures = digits();
    if (end < data_.size() && data_[end] == '.') {
      ++end;
      figures += digits();
    }
    if (figures == 0) return stop("a number is missing"), std::nullopt;
    if (end < data_.size() && (data_[end] == 'e' || data_[end] == 'E')) {
      const std::size_t before = end++;
      if (end < data_.size() && (data_[end] == '+' || data_[end] == '-')) ++end;
      if (digits() == 0) end = before;
    }
    double value = 0;
    const char* const first = data_.data() + at_ + (plus ? 1 : 0);
    const auto read = std::from_chars(first, data_.data() + end, value);
    if (read.ec != std::errc{} || std::abs(value) > kLargestNumber) {
      return stop("a number is over 1e6 or finer than a double holds"), std::nullopt;
    }
    at_ = end;
    return value;
  }

  std::optional<double> coordinate(double origin) {
    const auto value = number();
    if (!value) return std::nullopt;
    const double sum = *value + origin;
    if (std::abs(sum) > kLargestNumber) return stop("a point lies beyond 1e6"), std::nullopt;
    return sum;
  }
  std::optional<GlyphPoint> point(GlyphPoint origin) {
    const auto x = coordinate(origin.x);
    if (!x) return std::nullopt;
    skip_comma();
    const auto y = coordinate(origin.y);
    if (!y) return std::nullopt;
    return GlyphPoint{*x, *y};
  }

  bool read_command() {
    const char command = data_[at_];
    if (!is_letter(command)) return stop("a command is missing");
    const char kind = absolute(command);
    if (kind == 'M' && started_) return stop("a stroke is one line: a second M");
    if (kind == 'Z') return stop("a stroke is one line: Z closes it");
    if (kind == 'A') return stop("arcs (A) do not occur in strokes");
    if (std::string_view("MLHVCSQT").find(kind) == std::string_view::npos) {
      return stop("unknown command");
    }
    ++at_;
    skip_spaces();
    char repeated = command;
    do {
      if (!read_operands(repeated)) return false;
      // Pairs after the first of M are lines.
      if (kind == 'M') repeated = is_relative(command) ? 'l' : 'L';
      const std::size_t before = at_;
      skip_comma();
      if (!number_follows() && data_.substr(before, at_ - before).find(',') != std::string_view::npos) {
        return stop("a number is missing after the comma");
      }
    } while (number_follows());
    return true;
  }

  bool read_operands(char command) {
    const GlyphPoint origin = is_relative(command) ? here_ : GlyphPoint{};
    switch (absolute(command)) {
      case 'M': {
        const auto to = point(origin);
        if (!to) return false;
        path_.start = here_ = *to;
        started_ = true;
        return true;
      }
      case 'L': {
        const auto to = point(origin);
        return to && line(*to);
      }
      case 'H': {
        const auto x = coordinate(origin.x);
        return x && line({*x, here_.y});
      }
      case 'V': {
        const auto y = coordinate(origin.y);
        return y && line({here_.x, *y});
      }
      case 'C': {
        const auto first = point(origin);
        if (!first) return false;
        skip_comma();
        return smooth(*first, origin);
      }
      case 'S':
        return smooth(cubic_control_ ? here_ + (here_ - *cubic_control_) : here_, origin);
      case 'Q': {
        const auto control = point(origin);
        if (!control) return false;
        skip_comma();
        return quadratic(*control, origin);
      }
      default:  // T
        return quadratic(quadratic_control_ ? here_ + (here_ - *quadratic_control_) : here_, origin);
    }
  }

  /// The rest of a cubic curve whose first control point is known.
  bool smooth(GlyphPoint first, GlyphPoint origin) {
    const auto second = point(origin);
    if (!second) return false;
    skip_comma();
    const auto to = point(origin);
    if (!to || !piece(first, *second, *to)) return false;
    forget_controls();
    cubic_control_ = *second;
    return true;
  }
  /// A quadratic curve, raised to a cubic one of the same shape.
  bool quadratic(GlyphPoint control, GlyphPoint origin) {
    const auto to = point(origin);
    if (!to) return false;
    if (!piece(here_ + (control - here_) * (2.0 / 3), *to + (control - *to) * (2.0 / 3), *to)) return false;
    forget_controls();
    quadratic_control_ = control;
    return true;
  }
  bool line(GlyphPoint to) {
    if (!piece(here_ + (to - here_) * (1.0 / 3), here_ + (to - here_) * (2.0 / 3), to)) return false;
    forget_controls();
    return true;
  }
  bool piece(GlyphPoint first, GlyphPoint second, GlyphPoint to) {
    if (path_.pieces.size() == kMostPieces) return stop("more than 10,000 pieces");
    for (const double v : {first.x, first.y, second.x, second.y}) {
      if (std::abs(v) > 2 * kLargestNumber) return stop("a control point lies beyond 2e6");
    }
    path_.pieces.push_back({first, second, to});
    here_ = to;
    return true;
  }
  void forget_controls() {
    cubic_control_.reset();
    quadratic_control_.reset();
  }

  std::string_view data_;
  std::size_t at_ = 0;
  std::string fault_;
  BezierPath path_;
  GlyphPoint here_;
  std::optional<GlyphPoint> cubic_control_;      ///< second control point of a C or S just before
  std::optional<GlyphPoint> quadratic_control_;  ///< control point of a Q or T just before
  bool started_ = false;
};

void append(Polyline<GlyphFrame>& line, GlyphPoint p) {
  if (line.back() != p) line.push_back(p);
}

/// The distance to the chord is a convex function, 0 at both ends, so on the curve it is at most the control
/// points' times their largest share in the curve, B1 + B2 <= 3/4.
void subdivide(GlyphPoint a, GlyphPoint b, GlyphPoint c, GlyphPoint d, double tolerance, int depth,
               Polyline<GlyphFrame>& line) {
  const double reach = 0.75 * std::max(distance_to_segment(b, a, d), distance_to_segment(c, a, d));
  if (reach <= tolerance || depth == 0) {
    append(line, d);
    return;
  }
  const GlyphPoint ab = (a + b) * 0.5;
  const GlyphPoint bc = (b + c) * 0.5;
  const GlyphPoint cd = (c + d) * 0.5;
  const GlyphPoint abc = (ab + bc) * 0.5;
  const GlyphPoint bcd = (bc + cd) * 0.5;
  const GlyphPoint middle = (abc + bcd) * 0.5;
  subdivide(a, ab, abc, middle, tolerance, depth - 1, line);
  subdivide(middle, bcd, cd, d, tolerance, depth - 1, line);
}

}  // namespace

base::Result<BezierPath> parse_svg_path(std::string_view data) { return PathReader(data).read(); }

Polyline<GlyphFrame> flatten(const BezierPath& path, double tolerance) {
  assert(tolerance > 0);
  Polyline<GlyphFrame> line{path.start};
  GlyphPoint from = path.start;
  for (const auto& [first, second, to] : path.pieces) {
    subdivide(from, first, second, to, tolerance, kDeepestSubdivision, line);
    from = to;
  }
  return line;
}

}  // namespace nazori::geometry
