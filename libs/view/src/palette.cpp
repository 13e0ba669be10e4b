// SPDX-License-Identifier: Apache-2.0
#include "palette.h"

namespace nazori::view {
namespace {

constexpr Palette kClassic{
    .background = from_hex(0x0000FF),
    .shadow = 0,
    .ink = from_hex(0x000000),
    .current_ink = from_hex(0x000000),
    .ink_gloss = 0,
    .stroke = from_hex(0xFF0000),
    .current_stroke = from_hex(0xFF0000),
    .stroke_edge = from_hex(0xFF0000),
    .disc = from_hex(0xFFFFFF),
    .disc_edge = from_hex(0xFF0000),
    .number = from_hex(0xC00000),
    .current_disc = from_hex(0xFF0000),
    .current_number = from_hex(0xFFFFFF),
    .device = from_hex(0x00FF00),
};

constexpr Palette kWoodLight{
    .background = from_hex(0xF7F4EC),
    .shadow = 0.34F,
    .ink = from_hex(0x2A2623),
    .current_ink = from_hex(0xC0351F),
    .ink_gloss = 0.10F,
    .stroke = from_hex(0x3F372E),
    .current_stroke = from_hex(0xB5301F),
    .stroke_edge = from_hex(0xFBF0DA),
    .disc = from_hex(0xFFFDF8),
    .disc_edge = from_hex(0x8A8174),
    .number = from_hex(0x1F1B16),
    .current_disc = from_hex(0xB5301F),
    .current_number = from_hex(0xFFFDF8),
    .device = from_hex(0x274C84),
};

constexpr Palette kWoodDark{
    .background = from_hex(0x1B1917),
    .shadow = 0.60F,
    .ink = from_hex(0x12100F),
    .current_ink = from_hex(0xD9563D),
    .ink_gloss = 0.08F,
    .stroke = from_hex(0xD9CDB9),
    .current_stroke = from_hex(0xFF8F78),
    .stroke_edge = from_hex(0x2B221A),
    .disc = from_hex(0x26231F),
    .disc_edge = from_hex(0xB3AA9B),
    .number = from_hex(0xEFE9DD),
    .current_disc = from_hex(0xFF8F78),
    .current_number = from_hex(0x1B1917),
    .device = from_hex(0x9FBBEE),
};

constexpr Palette kSlateLight{
    .background = from_hex(0xF7F4EC),
    .shadow = 0.38F,
    .ink = from_hex(0xF1E7D0),
    .current_ink = from_hex(0xD8492F),
    .ink_gloss = 0.05F,
    .stroke = from_hex(0xCFCBC2),
    .current_stroke = from_hex(0xFF8F78),
    .stroke_edge = from_hex(0x2C3136),
    .disc = from_hex(0xFFFDF8),
    .disc_edge = from_hex(0x5A6168),
    .number = from_hex(0x1F1B16),
    .current_disc = from_hex(0xB5301F),
    .current_number = from_hex(0xFFFDF8),
    .device = from_hex(0x9FBBEE),
};

constexpr Palette kSlateDark{
    .background = from_hex(0x1B1917),
    .shadow = 0.60F,
    .ink = from_hex(0xD9CFBA),
    .current_ink = from_hex(0xE0583F),
    .ink_gloss = 0.04F,
    .stroke = from_hex(0xB3AFA6),
    .current_stroke = from_hex(0xFF8F78),
    .stroke_edge = from_hex(0x1A1C1F),
    .disc = from_hex(0x26231F),
    .disc_edge = from_hex(0xB3AA9B),
    .number = from_hex(0xEFE9DD),
    .current_disc = from_hex(0xFF8F78),
    .current_number = from_hex(0x1B1917),
    .device = from_hex(0x9FBBEE),
};

/// On a pale ground: wood by day, and the white plateau of 2005.
constexpr WritingColours kOnPale{
    .unjudged = from_hex(0x2A2623),
    .nearly = from_hex(0x7A5000),
    .wrong = from_hex(0xA82A1A),
    .shown = from_hex(0x274C84),
    .ground_of_sign = from_hex(0xFFFDF8),
};

/// On a dark one: slate, and wood by night.
constexpr WritingColours kOnDark{
    .unjudged = from_hex(0xF1E7D0),
    .nearly = from_hex(0xEBBB62),
    .wrong = from_hex(0xFFA28F),
    .shown = from_hex(0x9FBBEE),
    .ground_of_sign = from_hex(0x26231F),
};

}  // namespace

const WritingColours& writing_colours(Style style, Theme theme) {
  return style == Style::slate || (style == Style::wood && theme == Theme::dark) ? kOnDark : kOnPale;
}

const Palette& palette(Style style, Theme theme) {
  switch (style) {
    case Style::classic:
      return kClassic;
    case Style::slate:
      return theme == Theme::light ? kSlateLight : kSlateDark;
    case Style::wood:
      break;
  }
  return theme == Theme::light ? kWoodLight : kWoodDark;
}

}  // namespace nazori::view
