// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/tablet_plot.h"

#include <utility>

#include "nazori/functions/axis_labels.h"

namespace nazori::practice {

base::Result<TabletPlot> on_tablet(functions::Drawing&& drawing) {
  const geometry::TabletShape shape;
  std::vector<tablet::TabletLine> lines;
  for (const auto& groove : drawing.grooves) {
    tablet::TabletLine line;
    for (const auto point : groove.points) line.points.push_back(geometry::tablet_to_glyph(point, shape));
    lines.push_back(std::move(line));
  }
  const auto& heights = drawing.picture.plate.heights;
  auto zones = std::make_shared<haptics::FrictionZones>();
  zones->size = heights.size();
  zones->zone = drawing.friction.zone;
  zones->added = drawing.friction.added;
  // A surface has no ticks.
  const auto& request = drawing.request;
  auto labels = request.plot.is_surface()
                    ? std::vector<geometry::Label>{}
                    : functions::axis_labels(request.window, request.plate.layers, shape);
  auto carved = tablet::CarvedTablet::from_height_map(heights, std::move(lines), shape, std::move(zones),
                                                      std::move(labels));
  if (!carved) return tl::unexpected(std::move(carved.error()));
  return TabletPlot{std::make_shared<const functions::Drawing>(std::move(drawing)), std::move(*carved)};
}

}  // namespace nazori::practice
