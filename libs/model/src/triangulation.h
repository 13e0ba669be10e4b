// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <queue>
#include <span>
#include <vector>

namespace nazori::model {

/// A sample of a grid.
struct GridSample {
  int column = 0;
  int row = 0;
  friend bool operator==(GridSample, GridSample) = default;
};

/// A Delaunay triangulation of a rectangular grid into which samples are inserted one after another. All
/// decisions are made with whole numbers, so it is exact: no triangle is empty, none overlap.
/// @source Lawson's flips; Garland and Heckbert, CMU-CS-95-181, for the choice of the next sample.
class Triangulation {
 public:
  struct Triangle {
    std::array<std::int32_t, 3> corner{};  ///< indices into samples(), counter-clockwise
    std::array<std::int32_t, 3> across{};  ///< the triangle beyond the edge opposite that corner; -1: none
  };

  /// Two triangles between the four corners of the grid.
  /// @param heights  of the grid, row by row, or empty where only insert() is used; must outlive this.
  Triangulation(int columns, int rows, std::span<const float> heights);

  /// Inserts a sample of the grid; one that is there already changes nothing.
  void insert(GridSample sample);
  /// Inserts the sample farthest from the surface, again and again, until no sample is farther than
  /// `tolerance` from it or there are `most_triangles`.
  /// @return the distance of the farthest sample that is left.
  double refine(double tolerance, std::size_t most_triangles);

  [[nodiscard]] const std::vector<GridSample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  /// The farthest sample inside a triangle.
  struct Farthest {
    float error = 0;
    GridSample sample;
  };
  struct Waiting {
    float error;
    std::int32_t triangle;
    std::uint32_t version;
    friend bool operator<(const Waiting& a, const Waiting& b) {
      return a.error != b.error ? a.error < b.error : a.triangle > b.triangle;
    }
  };

  void insert_into(std::int32_t triangle, GridSample sample);
  void split(std::int32_t triangle, std::int32_t sample);
  void split_edge(std::int32_t triangle, int opposite, std::int32_t sample);
  void legalise();
  [[nodiscard]] std::int32_t locate(GridSample sample) const;
  [[nodiscard]] Farthest farthest_in(const Triangle& triangle) const;
  void examine_changed();
  void set(std::int32_t triangle, const Triangle& value);
  void relink(std::int32_t triangle, std::int32_t from, std::int32_t to);
  [[nodiscard]] float height(GridSample s) const {
    return heights_[static_cast<std::size_t>(s.row) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(s.column)];
  }
  Triangle& tri(std::int32_t i) { return triangles_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const Triangle& tri(std::int32_t i) const { return triangles_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] GridSample at(std::int32_t sample) const {
    return samples_[static_cast<std::size_t>(sample)];
  }

  int columns_;
  std::span<const float> heights_;
  std::vector<GridSample> samples_;
  std::vector<Triangle> triangles_;
  std::vector<Farthest> farthest_;      // per triangle
  std::vector<std::uint32_t> version_;  // per triangle; an older one in the queue is out of date
  std::vector<bool> is_changed_;
  std::vector<std::int32_t> changed_;
  std::vector<std::int32_t> unsettled_;  // triangles whose edge opposite corner 0 may have to be flipped
  std::priority_queue<Waiting> queue_;
  mutable std::int32_t last_found_ = 0;
};

}  // namespace nazori::model
