// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/touch_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "file_ending.h"
#include "nazori/base/utf8.h"
#include "nazori/model/laser.h"

namespace nazori::practice {
namespace {

// Where a stroke stops its groove is 15 % wider than along its body, and there may be a rim of a sample.
constexpr double kWidestShare = 1.15;
constexpr double kRim_mm = 0.3;

base::Result<SolidPlate> grooves(std::span<const SolidTablet> tablets, SolidSettings settings,
                                 const carving::Brush& brush, const char* where) {
  if (settings.raised || settings.mould) {
    return base::fail(base::Errc::bad_argument, "only grooves can be cut", where,
                      "leave out raised lines and the mould");
  }
  return tablet_plate(tablets, settings, brush);
}

/// The middle lines of the grooves that are carved from strokes; none where a tablet brought its own relief.
std::vector<model::MillGuide> guides_of(std::span<const SolidTablet> tablets,
                                        const model::TabletPlateSettings& settings,
                                        const carving::Brush& brush) {
  const auto corners = model::tablet_corners(tablets.size(), settings);
  std::vector<model::MillGuide> guides;
  for (std::size_t i = 0; i < tablets.size(); ++i) {
    if (tablets[i].relief) return {};
    const double width = carving::fitted(brush, tablets[i].strokes).width / geometry::kGlyphSide;
    for (model::RaisedStroke& stroke : raised_strokes(tablets[i].strokes)) {
      for (model::PlatePoint& p : stroke.line) p = corners[i] + p * settings.side_mm;
      guides.push_back({std::move(stroke.line), width / 2 * kWidestShare * settings.side_mm + kRim_mm});
    }
  }
  return guides;
}

/// "U+4F11 U+65E5": the comment of a program for a mill has ASCII only.
std::string code_points(const std::string& text) {
  std::string names;
  for (const char32_t c : base::decode_utf8(text).value_or(U""))
    names += c < 0x80 ? std::string(1, static_cast<char>(c))
                      : fmt::format("{}U+{:04X}", names.empty() ? "" : " ", static_cast<unsigned>(c));
  return names;
}

}  // namespace

base::Result<TouchFile> mill_file(std::span<const SolidTablet> tablets, const SolidSettings& settings,
                                  const model::MillSettings& mill, const std::string& subject,
                                  const carving::Brush& brush) {
  const auto made = grooves(tablets, settings, brush, "mill");
  if (!made) return tl::unexpected(made.error());
  auto path = model::mill_path(made->plate, guides_of(tablets, settings.plate, brush), mill);
  if (!path) return tl::unexpected(std::move(path.error()));
  TouchFile file{TouchKind::mill,
                 to_gcode(*path, mill, code_points(subject)),
                 made->plate.width_mm(),
                 made->plate.height_mm(),
                 1,
                 {},
                 {},
                 0};
  path->moves.clear();
  file.path = *std::move(path);
  return file;
}

base::Result<TouchFile> laser_file(std::span<const SolidTablet> tablets, const SolidSettings& settings,
                                   int layers, const std::string& subject, const carving::Brush& brush) {
  const auto made = grooves(tablets, settings, brush, "laser");
  if (!made) return tl::unexpected(made.error());
  auto svg = model::to_laser_svg(made->plate, layers, subject);
  if (!svg) return tl::unexpected(std::move(svg.error()));
  return TouchFile{
      TouchKind::laser, *std::move(svg), made->plate.width_mm(), made->plate.height_mm(), 1, {}, {}, 0};
}

std::vector<SolidTablet> without_labels(std::span<const LabelledTablet> tablets) {
  std::vector<SolidTablet> bare;
  for (const LabelledTablet& one : tablets) bare.push_back(one.tablet);
  return bare;
}

std::optional<TouchKind> touch_kind_of(const std::filesystem::path& name) {
  const std::string ending = file_ending(name);
  if (ending == ".nc") return TouchKind::mill;
  if (ending == ".svg") return TouchKind::laser;
  if (ending == ".pdf") return TouchKind::swell_paper;
  if (ending == ".brf") return TouchKind::embosser;
  return std::nullopt;
}

base::Result<TouchFile> touch_file(TouchKind kind, std::span<const LabelledTablet> tablets,
                                   SolidSettings settings, const TouchMachines& machines,
                                   const std::string& subject) {
  settings.raised = settings.mould = false;
  const std::vector<SolidTablet> bare = without_labels(tablets);
  const auto& strokes = settings.plate.strokes;
  switch (kind) {
    case TouchKind::mill:
      return mill_file(bare, settings, machines.mill, subject);
    case TouchKind::laser:
      return laser_file(bare, settings, machines.layers, subject);
    case TouchKind::swell_paper:
      return swell_file(tablets,
                        {settings.plate.side_mm, machines.paper, strokes.start_dots, strokes.numbers, true,
                         machines.english},
                        subject);
    case TouchKind::embosser:
      break;
  }
  return embosser_file(tablets,
                       {machines.embosser, {strokes.numbers, strokes.start_dots}, true, machines.english});
}

}  // namespace nazori::practice
