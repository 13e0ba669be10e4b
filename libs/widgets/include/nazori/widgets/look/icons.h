// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>
#include <QObject>
#include <cstdint>

namespace nazori::ui {
Q_NAMESPACE

/// Line drawings in the colours of the palette, sharp at any size. Each is resources/icons/<name>.svg.
enum class Icon : std::uint8_t {
  previous,
  next,
  strokes,
  numbers,
  arrows,
  snap,
  curve,
  sound,
  erase,
  library,
  information,
  reset_view,
  device,
  search,
  tick,
  cross,
  advice,
  hint,
  back,
  watch,
  trace,
  guided,
  memory,
  dictation,
  play,
  slower,
  faster,
  loop,
  undo,
  hint_lamp,
  eye,
  overlaid,
  beside,
  pen,
  progress,
  copy,
  home,
  brush,
  ink_stone,
  water,
  wipe,
  dry,
  sheet,
  redo,
  chisel,
};
Q_ENUM_NS(Icon)

/// The drawing in ink; in indigo where the icon's action is on.
[[nodiscard]] QIcon icon(Icon which, const QColor& ink, const QColor& on);

/// One colour, for signs.
[[nodiscard]] QPixmap sign(Icon which, const QColor& colour, int side, double device_pixel_ratio);

/// The program's own icon, a carved な in a wooden tile: apps/nazori/desktop/nazori.svg.
[[nodiscard]] QIcon program_icon();

}  // namespace nazori::ui
