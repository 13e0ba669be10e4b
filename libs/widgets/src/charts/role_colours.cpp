// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/charts/role_colours.h"

namespace nazori::ui {
namespace {

QColor plain(practice::ColourRole role, const Colours& c) {
  switch (role) {
    case practice::ColourRole::paper:
      return c.paper;
    case practice::ColourRole::surface:
      return c.surface;
    case practice::ColourRole::line:
      return c.line;
    case practice::ColourRole::text:
      return c.ink;
    case practice::ColourRole::muted:
      return c.muted;
    case practice::ColourRole::accent:
      return c.indigo;
    case practice::ColourRole::warning:
      return c.vermilion;
  }
  return c.ink;
}

}  // namespace

QColor colour_of(const practice::Colour& colour, const Colours& c) {
  return colour.share > 0 ? blend(plain(colour.role, c), plain(colour.over, c), colour.share)
                          : plain(colour.role, c);
}

}  // namespace nazori::ui
