// SPDX-License-Identifier: Apache-2.0
#include "workshop.h"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "nazori/carving/carve.h"
#include "nazori/kanji/stroke_order.h"
#include "nazori/surface/height_map_file.h"

namespace nazori::ui {
namespace {

constexpr std::size_t kRecent = 6;

std::filesystem::path to_path(const QString& text) { return {text.toStdString()}; }

base::Result<OwnTablet> load_own(const QString& map_path, const QString& strokes_path, const OwnTablet& onto,
                                 int grid_size) {
  OwnTablet own;
  std::optional<surface::HeightMap> map;
  if (!map_path.isEmpty()) {
    auto loaded = surface::load_height_map(to_path(map_path));
    if (!loaded) return tl::unexpected(loaded.error());
    map = std::move(*loaded);
    own.name = QFileInfo(map_path).fileName();
  } else if (onto.tablet && onto.map_size > 0) {
    map = onto.tablet->height_map();
    own.name = onto.name.section(QStringLiteral(" + "), 0, 0);
  }
  own.map_size = map ? map->size() : 0;
  std::vector<kanji::StrokeLine> lines;
  if (!strokes_path.isEmpty()) {
    int side = grid_size > 0 ? grid_size : own.map_size;
    if (side == 0) {
      const auto guess = Workshop::guess_grid(strokes_path);
      if (!guess) return tl::unexpected(guess.error());
      side = guess->side;
    }
    auto order = kanji::StrokeOrder::load(to_path(strokes_path), side);
    if (!order) return tl::unexpected(order.error());
    lines = order->to_lines(side);
    own.has_strokes = true;
    const QString name = QFileInfo(strokes_path).fileName();
    own.name = own.name.isEmpty() ? name : own.name + QStringLiteral(" + ") + name;
  }
  auto tablet = map ? tablet::CarvedTablet::from_height_map(std::move(*map), tablet::tablet_lines(lines))
                    : tablet::CarvedTablet::from_lines(std::move(lines), Workshop::kSize);
  if (!tablet) return tl::unexpected(tablet.error());
  own.tablet = std::move(*tablet);
  return own;
}

base::Result<void> save_tablet(const tablet::CarvedTablet& carved, const QString& path, FileFormat format,
                               int size, bool own_map) {
  if (own_map) size = carved.height_map().size();
  if (format == FileFormat::strokes)
    return kanji::StrokeOrder::from_lines(tablet::stroke_lines(carved.lines()), size).save(to_path(path));
  const surface::HeightMap* map = &carved.height_map();
  surface::HeightMap again;
  if (!own_map && map->size() != size) {
    auto result = carving::carve(tablet::stroke_lines(carved.lines()), size);
    if (!result) return tl::unexpected(result.error());
    again = std::move(*result);
    map = &again;
  }
  return format == FileFormat::raw ? surface::save_raw(*map, to_path(path))
                                   : surface::save_png(*map, to_path(path), surface::PngDepth::bits_16);
}

}  // namespace

base::Result<Workshop::GridGuess> Workshop::guess_grid(const QString& strokes_path) {
  const auto order = kanji::StrokeOrder::load(to_path(strokes_path), kanji::StrokeOrder::kMaxGrid);
  if (!order) return tl::unexpected(order.error());
  int farthest = 0;
  for (const auto& stroke : order->all())
    for (const auto& point : stroke) farthest = std::max({farthest, point.x, point.y});
  GridGuess guess;
  while (guess.side <= farthest) guess.side *= 2;
  guess.certain = guess.side == kClassicSize && farthest >= kClassicSize / 2;
  return guess;
}

Workshop::Workshop(QObject* parent) : QObject(parent), recent_(std::make_shared<std::deque<Carved>>()) {}

Workshop::~Workshop() = default;

void Workshop::carve(const kanji::Character& character) {
  worker_.post([this, code_point = character.code_point, lines = character.lines(), ticket = ++newest_,
                recent = recent_]() mutable {
    if (ticket != newest_) return;
    const auto known = std::find_if(recent->begin(), recent->end(),
                                    [code_point](const Carved& c) { return c.code_point == code_point; });
    Tablet tablet;
    if (known != recent->end()) {
      tablet = known->tablet;
    } else {
      auto made = tablet::CarvedTablet::from_lines(std::move(lines), kSize);
      if (!made) {
        worker_.answer([this, error = made.error()] { emit failed({}, error); });
        return;
      }
      tablet = std::move(*made);
      recent->push_front({code_point, tablet});
      if (recent->size() > kRecent) recent->pop_back();
    }
    worker_.answer([this, code_point, ticket, tablet] {
      if (ticket == newest_) emit carved(code_point, tablet);
    });
  });
}

void Workshop::load(const QString& map_path, const QString& strokes_path, const OwnTablet& onto,
                    int grid_size) {
  worker_.post([this, map_path, strokes_path, onto, grid_size, ticket = ++newest_] {
    auto own = load_own(map_path, strokes_path, onto, grid_size);
    if (!own) {
      const QString path = map_path.isEmpty() ? strokes_path : map_path;
      worker_.answer([this, path, error = own.error()] { emit failed(path, error); });
      return;
    }
    worker_.answer([this, ticket, own = std::move(*own)] {
      if (ticket == newest_) emit loaded(own);
    });
  });
}

void Workshop::save(const Tablet& tablet, const QString& path, FileFormat format, int size, bool own_map) {
  worker_.post([this, tablet, path, format, size, own_map] {
    const auto result = save_tablet(*tablet, path, format, size, own_map);
    worker_.answer([this, path, result] {
      if (result)
        emit saved(path);
      else
        emit failed(path, result.error());
    });
  });
}

}  // namespace nazori::ui
