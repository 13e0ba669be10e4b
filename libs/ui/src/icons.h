// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>
#include <cstdint>

namespace nazori::ui {

/// Line drawings in the colours of the palette, sharp at any size.
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
};

/// The drawing in ink; in indigo where the icon's action is on.
[[nodiscard]] QIcon icon(Icon which, const QColor& ink, const QColor& on);

/// One colour, for signs.
[[nodiscard]] QPixmap sign(Icon which, const QColor& colour, int side, double device_pixel_ratio);

/// The program's own icon: a carved な in a wooden tile.
[[nodiscard]] QIcon program_icon();

}  // namespace nazori::ui
