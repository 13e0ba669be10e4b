// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "nazori/ingest/kanjivg.h"

namespace nazori::ingest {

/// Determines the endings of strokes from data/stroke_endings.tsv and data/kana_endings.tsv.
class StrokeEndings {
 public:
  StrokeEndings();

  /// Sets the ending of every stroke of the form. A type that is not in the table ends like its first part
  /// ("㇔/㇕x" like "㇔"); if that is missing, too, and for letters and digits, the ending is a stop.
  void assign(DrawnForm& form) const;

 private:
  struct Rule {
    std::vector<std::string> in;  ///< elements, one of which is around the stroke; empty: any
    std::u32string characters;    ///< one of these; empty: any
    double shorter_than = 0;      ///< glyph units; 0: any length
    bool hooked = false;
    bool last_free = false;
    kanji::StrokeEnding ending = kanji::StrokeEnding::stop;
  };

  [[nodiscard]] bool fits(const Rule& rule, const DrawnForm& form, std::size_t stroke) const;
  [[nodiscard]] kanji::StrokeEnding ending_of(const DrawnForm& form, std::size_t stroke) const;

  std::map<std::string, std::vector<Rule>, std::less<>> rules_;  ///< by type
  std::map<char32_t, std::vector<kanji::StrokeEnding>> kana_;
};

/// Whether a line turns by more than 60 degrees in its last 20 glyph units, or its second half where it is
/// short.
[[nodiscard]] bool ends_in_a_hook(const geometry::Polyline<geometry::GlyphFrame>& line);

}  // namespace nazori::ingest
