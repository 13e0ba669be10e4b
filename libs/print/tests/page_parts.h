// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "nazori/kanji/character.h"
#include "nazori/print/page_drawing.h"

namespace nazori::print {

/// The box of a mark [mm]: left, top, right, bottom. Control points count, so it may be too large.
struct Box {
  double left = 1e9;
  double top = 1e9;
  double right = -1e9;
  double bottom = -1e9;
};

inline Box box_of(const PageMark& mark) {
  Box box;
  for (const PathStep& step : mark.path) {
    const std::size_t count = step.kind == PathStep::Kind::close   ? 0
                              : step.kind == PathStep::Kind::curve ? 3
                                                                   : 1;
    for (std::size_t i = 0; i < count; ++i) {
      box.left = std::min(box.left, step.points[i].x);
      box.right = std::max(box.right, step.points[i].x);
      box.top = std::min(box.top, step.points[i].y);
      box.bottom = std::max(box.bottom, step.points[i].y);
    }
  }
  return box;
}

/// A word as the database gives it; without glosses where `gloss` is empty.
inline kanji::Word word(std::string text, std::string reading, std::string gloss) {
  kanji::Word made;
  made.text = std::move(text);
  made.reading = std::move(reading);
  if (!gloss.empty()) made.glosses = {std::move(gloss)};
  return made;
}

}  // namespace nazori::print
