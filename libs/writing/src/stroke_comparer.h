// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit.h"
#include "shape.h"
#include "stroke_difference.h"
#include "stroke_summary.h"

namespace nazori::writing {

/// Compares the strokes of a drawing with those of a model under one map after the other. A map is linear:
/// what two strokes have in common is summed up once, and then holds under every map.
class StrokeComparer {
 public:
  /// @param pairs  of the model: strokes k and k + 1 joined, at k; empty: not compared
  StrokeComparer(std::span<const Shape> drawn, std::span<const Shape> model, std::span<const Shape> pairs);

  [[nodiscard]] std::span<const Shape> drawn() const { return drawn_; }
  [[nodiscard]] std::span<const Shape> model() const { return model_; }
  [[nodiscard]] std::span<const Shape> pairs() const { return pairs_; }

  /// Lays the drawing over the model; what follows is about this map.
  void lay(const Affine& map);

  /// As compare() of shapes. @param drawn, model  strokes
  [[nodiscard]] StrokeDifference compare(std::size_t drawn, std::size_t model, float far);
  /// With a pair of the model's strokes.
  [[nodiscard]] StrokeDifference compare_with_pair(std::size_t drawn, std::size_t pair, float far);
  /// The cost of that alone; strokes far apart are not looked at.
  [[nodiscard]] float cost(std::size_t drawn, std::size_t model, float far);
  /// What the difference costs at least: that of the places.
  [[nodiscard]] float least_cost(std::size_t drawn, std::size_t model) const;
  [[nodiscard]] float least_cost_with_pair(std::size_t drawn, std::size_t pair);
  /// Whether the drawn stroke is rather as long as both strokes of a pair than as one of them.
  [[nodiscard]] bool is_as_long_as_pair(std::size_t drawn, std::size_t pair);
  [[nodiscard]] float least_cost_of_joined(std::size_t drawn, std::size_t model);
  /// Drawn strokes k and k + 1 written without lifting the pen.
  [[nodiscard]] const Shape& joined_drawn(std::size_t k);
  /// The whole drawn stroke.
  [[nodiscard]] Samples laid_line(std::size_t drawn) const { return transformed(drawn_[drawn].whole, map_); }
  /// The length of the whole drawn stroke and a floor, by that of the model's; natural logarithm.
  [[nodiscard]] float whole_length_log(std::size_t drawn, std::size_t model);
  /// Residue::turn_rad of both whole strokes.
  [[nodiscard]] float turn(std::size_t drawn, std::size_t model, bool reversed);

  /// Whatever the map is: what two strokes add to a fit.
  [[nodiscard]] PairMoments moments(std::size_t drawn, std::size_t model, bool reversed);
  [[nodiscard]] PairMoments moments_of_pair(std::size_t drawn, std::size_t pair, bool reversed);
  [[nodiscard]] PairMoments moments_of_joined(std::size_t drawn, std::size_t model, bool reversed) const;
  /// The map that fits best, from sums of such moments.
  [[nodiscard]] Affine fit(const FitSums& sums, double expected_scale) const;

 private:
  /// A drawn stroke, or one without its hook, about its centre, in units in which the drawing is about as
  /// large as the model.
  struct Part {
    alignas(32) std::array<float, kSamples> x{};
    alignas(32) std::array<float, kSamples> y{};
    double centre_x = 0, centre_y = 0;  // from the origin
    float xx = 0, xy = 0, yy = 0;       // sums of products
    StrokeSummary laid;
    bool is_measured = false;  // length and slope of `laid` are known
  };
  /// Sums of products of a drawn line and one of the model.
  struct Products {
    float xu = 0, yu = 0, xv = 0, yv = 0;
    bool are_known = false;
  };
  struct ModelPart {
    const Samples* samples = nullptr;
    ModelSummary summary;
  };
  /// What is drawn is compared with: whole lines, then those without hooks.
  struct Side {
    std::vector<ModelPart> parts;
    std::vector<std::size_t> bodies;  // of each whole line, in `parts`; kNone
    std::vector<Products> products;   // part by part, forwards and backwards
  };
  struct Best {
    std::size_t part = 0;
    std::size_t model_part = 0;
    CentredDifference centred;
  };
  /// Coefficients of the map from the units of Part.
  struct Linear {
    float a = 1, b = 0, c = 0, d = 1;
  };

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void add_part(const Samples& samples);
  Side side_of(std::span<const Shape> shapes) const;
  Side& pair_side();
  void place(Part& part) const;
  const StrokeSummary& measured(std::size_t part);
  const Products& products(Side& side, std::size_t part, std::size_t model_part, bool reversed);
  CentredDifference centred(Side& side, std::size_t part, std::size_t model_part);
  Best best_of(Side& side, std::size_t drawn, std::size_t model);
  [[nodiscard]] float least_of(const StrokeSummary& laid, const Side& side, std::size_t model) const;
  [[nodiscard]] float least_with(const Side& side, std::size_t drawn, std::size_t model) const;
  StrokeDifference compare_with(Side& side, std::size_t drawn, std::size_t model, float far);
  PairMoments moments_with(Side& side, std::size_t drawn, std::size_t model, bool reversed);

  std::span<const Shape> drawn_;
  std::span<const Shape> model_;
  std::span<const Shape> pairs_;
  double origin_x_ = 0, origin_y_ = 0;
  double unit_ = 1;
  Affine map_;
  Linear linear_;
  std::vector<Part> parts_;          // whole strokes, then those without hooks
  std::vector<std::size_t> bodies_;  // of each drawn stroke, in parts_; kNone
  Side side_;
  std::optional<Side> pair_side_;  // once it is asked for
  std::vector<std::optional<Shape>> joined_;
};

}  // namespace nazori::writing
