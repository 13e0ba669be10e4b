// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::surface {

/// A square grid of heights: 1 is the plateau, 0 the deepest groove. Row-major, row 0 at the top of the
/// picture.
///
/// Heights are floats; 8-bit RAW and PNG are exchange formats. Loading never changes an existing map: it
/// returns a new one or an error, so a caller that assigns on success keeps the old map on failure.
/// Thread-safe: reading yes, writing no.
class HeightMap {
 public:
  static constexpr int kMinSize = 2;
  static constexpr int kMaxSize = 8192;

  /// An empty map, size 0: nothing loaded.
  HeightMap() = default;

  /// @param size  samples a side, kMinSize..kMaxSize, else Errc::bad_argument.
  [[nodiscard]] static base::Result<HeightMap> create(int size, float height = 1.0F);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool is_loaded() const { return !samples_.empty(); }
  /// Makes it an empty map and frees the memory.
  void unload();

  /// Height in [0, 1]. @param column,row  within [0, size).
  [[nodiscard]] float at(int column, int row) const { return samples_[index(column, row)]; }
  /// Height times `scale`, in the scale's unit: scale = 12.75 gives the grid units of 2005, scale = depth_m
  /// metres.
  [[nodiscard]] double scaled(int column, int row, double scale) const { return at(column, row) * scale; }
  /// @param height  limited to [0, 1]; not finite counts as 1.
  void set(int column, int row, float height);

  [[nodiscard]] std::span<const float> samples() const { return samples_; }
  /// For code that makes reliefs; values must be in [0, 1].
  [[nodiscard]] std::span<float> samples() { return samples_; }

  friend bool operator==(const HeightMap&, const HeightMap&) = default;

 private:
  HeightMap(int size, float height);
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column);
  }
  int size_ = 0;
  std::vector<float> samples_;
};

/// 8-bit RAW: size x size bytes, no header, row-major, first row the top of the picture; 255 the plateau, 0
/// the deepest.
/// @source the 2005 program.
/// @param size  side in samples; without it the length must be a perfect square.
/// @return Errc::parse with the actual length and a valid one.
[[nodiscard]] base::Result<HeightMap> parse_raw(std::span<const std::uint8_t> bytes,
                                                std::optional<int> size = {});
[[nodiscard]] std::vector<std::uint8_t> to_raw(const HeightMap& map);
[[nodiscard]] base::Result<HeightMap> load_raw(const std::filesystem::path& path,
                                               std::optional<int> size = {});
[[nodiscard]] base::Result<void> save_raw(const HeightMap& map, const std::filesystem::path& path);

enum class PngDepth : std::uint8_t { bits_8, bits_16 };

/// Square greyscale PNG of 1 to 16 bits per sample, white the plateau. Colour pictures are refused
/// (Errc::schema), as are pictures that are not square or over kMaxSize, before their pixels are read.
[[nodiscard]] base::Result<HeightMap> parse_png(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::vector<std::uint8_t> to_png(const HeightMap& map, PngDepth depth);
[[nodiscard]] base::Result<HeightMap> load_png(const std::filesystem::path& path);
[[nodiscard]] base::Result<void> save_png(const HeightMap& map, const std::filesystem::path& path,
                                          PngDepth depth);

}  // namespace nazori::surface
