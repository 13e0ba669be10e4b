// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "nazori/functions/plate.h"

namespace nazori::functions::test {

/// Facts about a picture that are known from closed forms. Distances are shares of the plate's side.
struct CurveFacts {
  std::string id;
  std::string expression;
  Window window;
  bool is_error = false;
  bool is_surface = false;
  HeightRange heights;
  struct Place {
    double x, y, z;
  };
  std::vector<Place> on;   ///< on the curve; of a surface with its height
  std::vector<Place> off;  ///< at least 0.03 away from it; of a surface where it is undefined
  int pieces = -1;         ///< connected grooves, -1 not known
  struct Section {
    double x, y;                ///< on the curve
    double across_u, across_v;  ///< unit normal on the plate
  };
  std::vector<Section> sections;
};

[[nodiscard]] std::vector<CurveFacts> facts_of_file(const std::string& path);

/// All disagreements between the picture and the facts, one per line; empty if there are none.
[[nodiscard]] std::vector<std::string> disagreements(const CurveFacts& facts, int size, double half_width);

/// Full width of a groove at half depth across (nu, nv) over the nominal one: a raised cosine is half as deep
/// at half its half width. Between samples heights are taken as bilinear.
[[nodiscard]] double relative_width(const Plate& plate, double u, double v, double nu, double nv,
                                    double half_width);

/// Connected parts of what is carved, corners count as connected.
[[nodiscard]] int pieces_of(const Plate& plate);

/// Whether the sample at a place of the window is carved.
[[nodiscard]] bool is_carved(const Picture& picture, double x, double y);

}  // namespace nazori::functions::test
