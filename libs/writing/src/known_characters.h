// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "finder_net.h"
#include "ink_match.h"
#include "model_inside.h"
#include "nazori/base/result.h"
#include "nazori/geometry/svg_path.h"
#include "nazori/kanji/character.h"
#include "nazori/kanji/kanji_database.h"
#include "quick_strokes.h"
#include "stroke_picture.h"

namespace nazori::writing {

/// A character that can be found: the position of its strokes in the common arrays.
struct Known {
  char32_t code_point = 0;
  int place = 0;  ///< 0: the commonest
  std::size_t first_stroke = 0;
  std::size_t strokes = 0;
  float extent = 0;  ///< the larger side of its bounding box, in glyph units
};

/// A form in which a character is written, whatever its strokes. Characters have one or more.
struct KnownForm {
  std::size_t character = 0;  ///< index
  Embedding embedding{};
  InkPoints points;
};

/// Everything that recognising needs to know of the characters.
class KnownCharacters {
 public:
  [[nodiscard]] static base::Result<KnownCharacters> load(const kanji::KanjiDatabase& database);
  [[nodiscard]] static base::Result<KnownCharacters> load(const std::vector<kanji::Character>& characters);

  [[nodiscard]] std::span<const Known> characters() const { return characters_; }
  /// First the main form of each character, in the same order, then others.
  [[nodiscard]] std::span<const KnownForm> forms() const { return forms_; }
  /// The most similar form's.
  [[nodiscard]] InkDistance ink_distance(const InkPoints& drawn, std::size_t character) const;
  [[nodiscard]] const Picture& picture(std::size_t character) const { return pictures_[character]; }
  [[nodiscard]] std::span<const ThreePoints> points(const Known& known) const {
    return std::span(points_).subspan(known.first_stroke, known.strokes);
  }
  /// The strokes prepared for comparison.
  [[nodiscard]] Form form(const Known& known) const;

 private:
  [[nodiscard]] FlatLine line(std::size_t stroke) const {
    return FlatLine(lines_).subspan(starts_[stroke], starts_[stroke + 1] - starts_[stroke]);
  }
  [[nodiscard]] std::vector<FlatLine> lines_of(const Known& known) const;
  void begin_character(char32_t code_point, int place);
  void add_point(geometry::GlyphPoint p);
  void end_stroke();
  void add_path(const geometry::BezierPath& path);
  void finish();
  void add_form(std::size_t character, std::span<const FlatLine> lines);
  void add_handwritten_forms();

  std::vector<Known> characters_;
  std::vector<KnownForm> forms_;
  std::vector<Picture> pictures_;    // of each character
  std::vector<ThreePoints> points_;  // of each stroke
  std::vector<std::size_t> starts_;  // of each stroke in `lines_`, and one more
  std::vector<float> lines_;         // x and y alternating
};

}  // namespace nazori::writing
