// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/drawing.h"

#include <algorithm>
#include <utility>

#include "nazori/geometry/polyline.h"

namespace nazori::functions {
namespace {

constexpr double kUndefinedFriction = 0.6;

/// The summary of one statement alone does not mention the others.
Plot summarised_plot(const PlotRequest& request) {
  if (request.plate.alone < 0) return request.plot;
  Plot alone{{request.plot.statements[static_cast<std::size_t>(request.plate.alone)]}};
  // One curve of a list is told as itself, not as what was typed.
  Statement& shown = alone.statements.front();
  if (shown.elements > 1) shown.typed = nullptr;
  shown.element = 0;
  return alone;
}

std::vector<TabletCurve> grooves_of(const Picture& picture) {
  auto grooves = tablet_curves(picture.tracing, picture.plate.heights.size());
  if (grooves.size() <= Drawing::kMostGrooves) return grooves;
  std::stable_sort(grooves.begin(), grooves.end(), [](const TabletCurve& a, const TabletCurve& b) {
    return geometry::arc_length<geometry::TabletFrame>(a.points) >
           geometry::arc_length<geometry::TabletFrame>(b.points);
  });
  grooves.resize(Drawing::kMostGrooves);
  return grooves;
}

Drawing drawing_of(const PlotRequest& request, Picture&& picture, bool final) {
  Drawing drawing;
  drawing.request = request;
  drawing.picture = std::move(picture);
  drawing.final = final;
  drawing.grooves = grooves_of(drawing.picture);
  drawing.friction = friction_of(request.plot, drawing.picture.plate);
  if (!final) return drawing;
  const Tracing& tracing = drawing.picture.tracing;
  drawing.points = points_of_interest(request.plot, tracing);
  if (const int alone = request.plate.alone; alone >= 0) {
    std::erase_if(drawing.points,
                  [alone](const PointOfInterest& p) { return p.statement != alone || p.other >= 0; });
  }
  drawing.summary =
      summary(summarised_plot(request), tracing, drawing.points, request.language, request.speech);
  return drawing;
}

}  // namespace

PlateFriction friction_of(const Plot& plot, const Plate& plate) {
  PlateFriction friction;
  friction.zone = plate.statement;
  if (plot.is_surface()) {
    for (std::size_t i = 0; i < friction.zone.size(); ++i) friction.zone[i] = plate.mask[i] != 0 ? 0 : 1;
    friction.added = {kUndefinedFriction};
    return friction;
  }
  for (std::size_t i = 0; i < plot.statements.size(); ++i)
    friction.added.push_back(feel_of(static_cast<int>(i)).friction);
  return friction;
}

base::Result<void> draw_plot(const PlotRequest& request, const std::function<bool(Drawing&&)>& show,
                             const base::Progress& progress) {
  return draw_coarse_to_fine(
      request.plot, request.window, request.plate,
      [&](Picture&& picture, bool final) { return show(drawing_of(request, std::move(picture), final)); },
      progress);
}

}  // namespace nazori::functions
