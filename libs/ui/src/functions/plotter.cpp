// SPDX-License-Identifier: Apache-2.0
#include "functions/plotter.h"

#include <QElapsedTimer>
#include <algorithm>

#include "nazori/functions/tablet_curves.h"
#include "nazori/geometry/polyline.h"

namespace nazori::ui {
namespace {

/// More pieces than anyone can feel one by one only slow the servo down; the longest are kept.
constexpr std::size_t kMostLines = 300;
constexpr int kProgressStep_ms = 50;
constexpr double kUndefinedFriction = 0.6;

/// Each curve has a friction of its own; of a surface, what is undefined.
std::shared_ptr<const haptics::FrictionZones> friction_of(const functions::Plot& plot,
                                                          const functions::Plate& plate) {
  auto zones = std::make_shared<haptics::FrictionZones>();
  zones->size = plate.heights.size();
  zones->zone = plate.statement;
  if (plot.is_surface()) {
    for (std::size_t i = 0; i < zones->zone.size(); ++i) zones->zone[i] = plate.mask[i] != 0 ? 0 : 1;
    zones->added = {kUndefinedFriction};
    return zones;
  }
  for (std::size_t i = 0; i < plot.statements.size(); ++i)
    zones->added.push_back(functions::feel_of(static_cast<int>(i)).friction);
  return zones;
}

/// What is told of one statement alone: of its points those that no other statement has a part in.
functions::Plot told_plot(const PlotRequest& request) {
  if (request.plate.alone < 0) return request.plot;
  return {{request.plot.statements[static_cast<std::size_t>(request.plate.alone)]}};
}

base::Result<std::shared_ptr<Drawing>> finish(const PlotRequest& request, functions::Picture&& picture,
                                              bool final) {
  auto drawing = std::make_shared<Drawing>();
  drawing->asked = request;
  drawing->picture = std::move(picture);
  drawing->final = final;
  const auto& plate = drawing->picture.plate;
  const geometry::TabletShape shape;
  auto curves = functions::tablet_curves(drawing->picture.tracing, plate.heights.size(), shape);
  if (curves.size() > kMostLines) {
    std::stable_sort(curves.begin(), curves.end(), [](const auto& a, const auto& b) {
      return geometry::arc_length<geometry::TabletFrame>(a.points) >
             geometry::arc_length<geometry::TabletFrame>(b.points);
    });
    curves.resize(kMostLines);
  }
  std::vector<tablet::TabletLine> lines;
  for (const auto& curve : curves) {
    tablet::TabletLine line;
    for (const auto point : curve.points) line.points.push_back(geometry::tablet_to_glyph(point, shape));
    lines.push_back(std::move(line));
    drawing->statements.push_back(curve.statement);
  }
  auto carved = tablet::CarvedTablet::from_height_map(plate.heights, std::move(lines), shape,
                                                      friction_of(request.plot, plate));
  if (!carved) return tl::unexpected(std::move(carved.error()));
  drawing->tablet = std::move(*carved);
  if (final) {
    const auto& tracing = drawing->picture.tracing;
    drawing->points = functions::points_of_interest(request.plot, tracing);
    if (const int alone = request.plate.alone; alone >= 0) {
      std::erase_if(drawing->points, [alone](const functions::PointOfInterest& p) {
        return p.statement != alone || p.other >= 0;
      });
    }
    drawing->summary = functions::summary(told_plot(request), tracing, drawing->points, request.language);
  }
  return drawing;
}

}  // namespace

Plotter::Plotter(QObject* parent) : QObject(parent) {}

// Without this the destructor would wait until the drawing at hand is done.
Plotter::~Plotter() { ++newest_; }

void Plotter::draw(const PlotRequest& request) {
  const std::uint64_t ticket = ++newest_;
  busy_ = true;
  worker_.post([this, request, ticket] {
    const auto wanted = [this, ticket] { return newest_.load() == ticket; };
    if (!wanted()) return;
    QElapsedTimer since_told;
    base::Result<void> carved;
    const auto show = [&](functions::Picture&& picture, bool final) {
      auto drawing = finish(request, std::move(picture), final);
      if (!drawing) {
        carved = tl::unexpected(std::move(drawing.error()));
        return false;
      }
      worker_.answer([this, ticket, shown = SharedDrawing(std::move(*drawing))] {
        if (newest_.load() == ticket) emit drawn(shown);
      });
      return wanted();
    };
    const auto progress = [&](double done, std::string_view) {
      if (!since_told.isValid() || since_told.elapsed() >= kProgressStep_ms) {
        since_told.start();
        worker_.answer([this, ticket, done] {
          if (newest_.load() == ticket) emit progressed(done);
        });
      }
      return wanted();
    };
    auto result = functions::draw_coarse_to_fine(request.plot, request.window, request.plate, show, progress);
    if (!carved) result = std::move(carved);
    worker_.answer([this, ticket, result] {
      if (newest_.load() != ticket) return;
      rest(ticket);
      if (!result && result.error().code != base::Errc::cancelled) emit failed(result.error());
    });
  });
}

void Plotter::rest(std::uint64_t ticket) {
  if (newest_.load() != ticket) return;
  busy_ = false;
  emit rested();
}

void Plotter::stop() {
  if (!busy_) return;
  rest(++newest_);
}

}  // namespace nazori::ui
