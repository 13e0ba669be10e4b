// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "nazori/kanji/character.h"
#include "nazori/writing/model.h"
#include "shape.h"

namespace nazori::writing {

/// One drawn form of a character.
struct Form {
  std::string variant;
  std::vector<Shape> shapes;
  std::vector<std::vector<Shape>> other_ways;  ///< to write each stroke; kana only
  std::vector<Shape> pairs;                    ///< strokes k and k + 1 written without lifting the pen, at k
  std::vector<kanji::StrokeEnding> endings;
  std::optional<std::size_t> first_voicing_mark;  ///< the stroke; the second mark follows it
  std::vector<char> free_ending;                  ///< the source names two types: both endings are right
};

struct ModelInside {
  char32_t code_point = 0;
  Form main;
  std::vector<Form> variants;
  std::vector<kanji::AlternativeOrder> orders;
};

}  // namespace nazori::writing
