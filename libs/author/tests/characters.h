// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "nazori/geometry/svg_path.h"
#include "nazori/kanji/stroke.h"
#include "test_paths.h"

namespace nazori::author::test {

/// The strokes of a character of carving's fixture as KanjiVG draws them.
inline std::vector<kanji::StrokeLine> kanjivg(const std::string& character) {
  std::ifstream file(std::string(test_paths::kCarvingFixtures) + "/kanjivg.tsv");
  std::vector<kanji::StrokeLine> strokes;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string column[5];
    for (std::string& text : column) std::getline(fields, text, '\t');
    if (column[0] != character) continue;
    const auto path = geometry::parse_svg_path(column[4]);
    if (!path) continue;
    strokes.push_back({geometry::flatten(*path, 0.05),
                       column[3] == "hook"    ? kanji::StrokeEnding::hook
                       : column[3] == "taper" ? kanji::StrokeEnding::taper
                                              : kanji::StrokeEnding::stop,
                       {}});
  }
  return strokes;
}

}  // namespace nazori::author::test
