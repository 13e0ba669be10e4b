// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/solid_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "file_ending.h"
#include "nazori/base/file.h"
#include "nazori/functions/plate.h"
#include "nazori/functions/tablet_curves.h"
#include "nazori/geometry/point.h"
#include "nazori/model/mesh_file.h"
#include "nazori/model/raised.h"

namespace nazori::practice {
namespace {

constexpr int kMapSize = 513;
constexpr double kGroovedTolerance_mm = 0.01;
constexpr double kRaisedTolerance_mm = 0.02;

std::vector<model::RaisedTick> ticks_of(double low, double high) {
  std::vector<model::RaisedTick> ticks;
  const double step = functions::tick_step(low, high);
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    std::array<char, 32> label{};
    std::snprintf(label.data(), label.size(), "%.6g", k == 0 ? 0.0 : k * step);
    ticks.push_back({(k * step - low) / (high - low), label.data()});
  }
  return ticks;
}

}  // namespace

std::vector<model::RaisedStroke> raised_strokes(std::span<const kanji::StrokeLine> strokes) {
  std::vector<model::RaisedStroke> raised;
  for (const kanji::StrokeLine& line : strokes) {
    model::RaisedStroke stroke;
    for (const geometry::GlyphPoint p : line.points)
      stroke.line.push_back({p.x / geometry::kGlyphSide, 1 - p.y / geometry::kGlyphSide});
    const bool sinks = line.ending == kanji::StrokeEnding::taper || line.ending == kanji::StrokeEnding::hook;
    stroke.end = sinks ? model::LineEnd::sinks : model::LineEnd::full;
    raised.push_back(std::move(stroke));
  }
  return raised;
}

base::Result<SolidPlate> tablet_plate(std::span<const SolidTablet> tablets, const SolidSettings& settings,
                                      const carving::Brush& brush) {
  model::TabletPlateSettings of_plate = settings.plate;
  of_plate.thickness_mm = settings.thickness();
  if (settings.mould) of_plate.hanging_hole = false;
  const auto finished = [&settings](model::Plate plate, double tolerance_mm,
                                    std::vector<int> without_number) {
    if (settings.mould) plate = model::mould_of(plate);
    return SolidPlate{std::move(plate), tolerance_mm, std::move(without_number)};
  };
  if (settings.raised) {
    std::vector<std::vector<model::RaisedStroke>> strokes;
    for (const SolidTablet& tablet : tablets) {
      if (tablet.strokes.empty())
        return base::fail(base::Errc::bad_argument, "a height map alone has no lines to raise",
                          "raised lines", "add its strokes, or make grooves");
      strokes.push_back(raised_strokes(tablet.strokes));
    }
    auto made = model::raised_plate(strokes, of_plate);
    if (!made) return tl::unexpected(std::move(made.error()));
    return finished(std::move(made->plate), kRaisedTolerance_mm, std::move(made->without_number));
  }
  std::vector<surface::HeightMap> maps;
  for (const SolidTablet& tablet : tablets) {
    if (tablet.relief) {
      maps.push_back(*tablet.relief);
      continue;
    }
    auto map = carving::carve(tablet.strokes, kMapSize, brush);
    if (!map) return tl::unexpected(std::move(map.error()));
    maps.push_back(*std::move(map));
  }
  auto plate = model::grooved_plate(maps, of_plate);
  if (!plate) return tl::unexpected(std::move(plate.error()));
  return finished(*std::move(plate), kGroovedTolerance_mm, {});
}

model::RaisedPlot raised_plot_of(const functions::Plot& plot, const functions::Picture& picture) {
  constexpr int kStyles = 3;
  const functions::Window& w = picture.tracing.window;
  model::RaisedPlot raised;
  raised.x_ticks = ticks_of(w.x0, w.x1);
  raised.y_ticks = ticks_of(w.y0, w.y1);
  if (w.y0 <= 0 && w.y1 >= 0) raised.x_axis = w.v(0);
  if (w.x0 <= 0 && w.x1 >= 0) raised.y_axis = w.u(0);
  if (plot.is_surface()) {
    raised.surface = &picture.plate.heights;
  } else {
    const geometry::TabletShape shape{1, 1};
    for (const functions::TabletCurve& curve :
         functions::tablet_curves(picture.tracing, picture.plate.heights.size(), shape, 1e-4)) {
      model::RaisedCurve line;
      line.style = static_cast<model::CurveStyle>(curve.statement % kStyles);
      for (const geometry::TabletPoint p : curve.points) {
        const auto at = functions::plate_place(p, picture.plate.heights.size(), shape);
        line.line.push_back({at.u, at.v});
      }
      raised.curves.push_back(std::move(line));
    }
  }
  return raised;
}

base::Result<SolidPlate> plot_plate(const functions::Plot& plot, const functions::Picture& picture,
                                    double side_mm, bool mould) {
  model::RaisedPlotSettings settings;
  settings.side_mm = side_mm;
  auto plate = model::raised_plot(raised_plot_of(plot, picture), settings);
  if (!plate) return tl::unexpected(std::move(plate.error()));
  return SolidPlate{mould ? model::mould_of(*plate) : *std::move(plate), kRaisedTolerance_mm, {}};
}

base::Result<Solid> solid_of(const SolidPlate& plate) {
  model::MeshSettings settings;
  settings.tolerance_mm = plate.tolerance_mm;
  auto made = model::mesh_of(plate.plate, settings);
  if (!made) return tl::unexpected(std::move(made.error()));
  Solid solid;
  solid.mesh = std::move(made->mesh);
  solid.error_mm = made->error_mm;
  solid.width_mm = plate.plate.width_mm();
  solid.height_mm = plate.plate.height_mm();
  const auto heights = plate.plate.heights();
  solid.thickness_mm = static_cast<double>(*std::max_element(heights.begin(), heights.end()));
  solid.without_number = plate.without_number;
  return solid;
}

base::Result<void> save_solid(const Solid& solid, const std::filesystem::path& path,
                              const std::string& subject) {
  if (file_ending(path) != ".3mf") return base::write_file(path, model::to_stl(solid.mesh));
  const auto packed = model::to_3mf(solid.mesh, subject);
  if (!packed) return tl::unexpected(packed.error());
  return base::write_file(path, *packed);
}

ReliefPicture relief_picture(const model::Plate& plate, int most) {
  const int step = std::max(1, (std::max(plate.columns(), plate.rows()) + most - 1) / most);
  ReliefPicture picture;
  picture.width = (plate.columns() - 1) / step;
  picture.height = (plate.rows() - 1) / step;
  picture.grey.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  const double distance = step * plate.step_mm();
  for (int y = 0; y < picture.height; ++y) {
    const int row = plate.rows() - 1 - (y + 1) * step;  // row 0 of a plate is its lower edge
    for (int x = 0; x < picture.width; ++x) {
      const int column = x * step;
      const auto here = static_cast<double>(plate.at(column, row));
      const double right = (static_cast<double>(plate.at(column + step, row)) - here) / distance;
      const double up = (static_cast<double>(plate.at(column, row + step)) - here) / distance;
      // A slope that falls away from the light is dark. The light comes from the upper left.
      const double towards_light = (right - up) / std::sqrt(2 * (1 + right * right + up * up));
      bool is_hole = false;
      for (const model::Hole& hole : plate.holes()) {
        const double dx = column * plate.step_mm() - hole.centre.x;
        const double dy = row * plate.step_mm() - hole.centre.y;
        is_hole = is_hole || dx * dx + dy * dy < hole.radius_mm * hole.radius_mm;
      }
      const double grey = is_hole ? 0.1 : 0.72 + 0.4 * towards_light;
      picture.grey.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 1.0) * 255)));
    }
  }
  return picture;
}

}  // namespace nazori::practice
