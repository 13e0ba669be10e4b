// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/tablet_plate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nazori::model {
namespace {

constexpr double kHoleStrip_mm = 8;
constexpr double kHoleFromEdge_mm = 5;
constexpr double kHoleRadius_mm = 2;
constexpr double kMouldBorder_mm = 3;
constexpr double kFinestGroove = 512;       // steps a side
constexpr double kFinestRaised_mm = 0.125;  // eight steps across a raised line at half its height
constexpr double kMostSamples = 1'500'000;  // so that a model takes well under half a second

class Layout {
 public:
  Layout(std::size_t count, const TabletPlateSettings& settings) : s_(settings) {
    const std::size_t all = std::max<std::size_t>(count, 1);
    columns_ = settings.vertical ? 1 : all;
    if (settings.columns > 0) columns_ = std::min(all, static_cast<std::size_t>(settings.columns));
    rows_ = (all + columns_ - 1) / columns_;
  }

  [[nodiscard]] double width() const { return extent(columns_); }
  [[nodiscard]] double height() const { return extent(rows_) + (s_.hanging_hole ? kHoleStrip_mm : 0); }
  [[nodiscard]] PlatePoint lower_left(std::size_t i) const {
    const double pitch = s_.side_mm + s_.gap_mm;
    const auto column = i % columns_;
    const auto row_above_last = rows_ - 1 - i / columns_;
    return {s_.margin_mm + static_cast<double>(column) * pitch,
            s_.margin_mm + static_cast<double>(row_above_last) * pitch};
  }
  [[nodiscard]] base::Result<Plate> plate(double finest_mm) const {
    const double step =
        std::max({finest_mm, Plate::kFinestStep_mm, std::sqrt(width() * height() / kMostSamples)});
    auto made = Plate::create(width(), height(), step, s_.thickness_mm);
    if (!made || !s_.hanging_hole) return made;
    const Hole hole{{made->width_mm() / 2, made->height_mm() - kHoleFromEdge_mm}, kHoleRadius_mm};
    if (auto done = made->add_hole(hole); !done) return tl::unexpected(std::move(done.error()));
    return made;
  }

 private:
  [[nodiscard]] double extent(std::size_t count) const {
    return static_cast<double>(count) * (s_.side_mm + s_.gap_mm) - s_.gap_mm + 2 * s_.margin_mm;
  }

  const TabletPlateSettings& s_;
  std::size_t columns_;
  std::size_t rows_;
};

base::Result<void> check(std::size_t count, const TabletPlateSettings& s) {
  if (count == 0)
    return base::fail(base::Errc::bad_argument, "there is no tablet", "plate", "give one or more");
  if (!(s.side_mm >= 10 && s.side_mm <= 500) || !(s.margin_mm >= 0 && s.margin_mm <= 100) ||
      !(s.gap_mm >= 0 && s.gap_mm <= 100) || s.columns < 0) {
    return base::fail(base::Errc::bad_argument, "the size is out of range", "plate",
                      "give tablets of 10 to 500 mm, and a margin and a gap of 0 to 100 mm");
  }
  return {};
}

}  // namespace

std::vector<PlatePoint> tablet_corners(std::size_t count, const TabletPlateSettings& settings) {
  const Layout layout(count, settings);
  std::vector<PlatePoint> corners;
  for (std::size_t i = 0; i < count; ++i) corners.push_back(layout.lower_left(i));
  return corners;
}

base::Result<Plate> grooved_plate(std::span<const surface::HeightMap> maps,
                                  const TabletPlateSettings& settings) {
  if (auto fine = check(maps.size(), settings); !fine) return tl::unexpected(std::move(fine.error()));
  if (!(settings.depth_mm > 0) || settings.depth_mm > settings.thickness_mm - 1) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("a groove of {:.4g} mm would weaken a plate of {:.4g} mm",
                                  settings.depth_mm, settings.thickness_mm),
                      "plate", "leave 1 mm or more under the grooves");
  }
  const Layout layout(maps.size(), settings);
  auto plate = layout.plate(settings.side_mm / kFinestGroove);
  if (!plate) return plate;
  for (std::size_t i = 0; i < maps.size(); ++i)
    plate->sink(maps[i], layout.lower_left(i), settings.side_mm, settings.depth_mm);
  return plate;
}

base::Result<RaisedTablets> raised_plate(std::span<const std::vector<RaisedStroke>> tablets,
                                         const TabletPlateSettings& settings) {
  if (auto fine = check(tablets.size(), settings); !fine) return tl::unexpected(std::move(fine.error()));
  const Layout layout(tablets.size(), settings);
  auto plate = layout.plate(kFinestRaised_mm);
  if (!plate) return tl::unexpected(std::move(plate.error()));
  std::vector<std::vector<RaisedStroke>> placed(tablets.begin(), tablets.end());
  for (std::size_t i = 0; i < placed.size(); ++i)
    for (RaisedStroke& stroke : placed[i])
      for (PlatePoint& p : stroke.line) p = layout.lower_left(i) + p * settings.side_mm;
  RaisedTablets made{*std::move(plate), {}};
  made.without_number = add_strokes(made.plate, placed, settings.strokes);
  return made;
}

Plate mould_of(const Plate& plate, double border_mm) {
  Plate mould = plate.negative();
  const auto [low, high] = std::minmax_element(mould.heights().begin(), mould.heights().end());
  mould.add_border(kMouldBorder_mm, static_cast<double>(*high - *low) + border_mm);
  return mould;
}

}  // namespace nazori::model
