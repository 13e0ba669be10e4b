// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

#include "nazori/author/workbench.h"

namespace nazori::author {

inline constexpr int kSize = 128;

inline OwnStroke bar(double y, kanji::StrokeEnding ending = kanji::StrokeEnding::stop) {
  OwnStroke stroke;
  stroke.points = {{{20, y}, 3, 1}, {{50, y}, 3, 1}, {{90, y}, 3, 1}};
  stroke.ending = ending;
  return stroke;
}

inline CharacterEditor editor_with(std::vector<OwnStroke> strokes) {
  auto made = CharacterEditor::create(from_strokes(std::move(strokes)), kSize);
  EXPECT_TRUE(made);
  return *std::move(made);
}

class WorkbenchTest : public testing::Test {
 protected:
  WorkbenchTest() { listen(); }
  void listen() {
    bench_.edited.connect([this](EditKind kind, EditWay way) { edits_.emplace_back(kind, way); });
    bench_.refused.connect([this](const base::Error&) { ++refusals_; });
    bench_.relief_changed.connect([this](const carving::GridBox& box) { box_ = carving::united(box_, box); });
  }
  void use(Tool tool) {
    auto held = bench_.settings();
    held.tool = tool;
    bench_.set_settings(held);
  }
  /// A movement of the pen through points, down at the first and up at the last.
  void move(const std::vector<geometry::GlyphPoint>& points, std::optional<double> pressure = {}) {
    for (std::size_t i = 0; i < points.size(); ++i)
      bench_.move_pen({points[i], 0.01 * static_cast<double>(i), pressure}, i + 1 < points.size());
  }
  void click(geometry::GlyphPoint at) { move({at, at}); }
  [[nodiscard]] const std::vector<OwnStroke>& strokes() const { return bench_.character().strokes; }

  Workbench bench_{editor_with({bar(30), bar(60, kanji::StrokeEnding::taper)})};
  std::vector<std::pair<EditKind, EditWay>> edits_;
  int refusals_ = 0;
  carving::GridBox box_;
};

}  // namespace nazori::author
