// SPDX-License-Identifier: Apache-2.0
#include "characters/writing_groove.h"

#include <algorithm>

#include "characters/blank_tablet.h"
#include "tablet_controller.h"

namespace nazori::ui {

void WritingGroove::put(Way way, const Tablet& model) {
  way_ = way;
  model_ = model;
  carved_.clear();
  if (model_) controller_.set_tablet(way == Way::shown ? without_strokes(model_) : blank_tablet());
}

void WritingGroove::carve(std::vector<int> strokes) {
  if (!model_ || way_ != Way::appears) return;
  std::sort(strokes.begin(), strokes.end());
  if (strokes == carved_) return;
  carved_ = strokes;
  const auto all = tablet::stroke_lines(model_->lines());
  std::vector<kanji::StrokeLine> lines;
  for (const int n : strokes) lines.push_back(all[static_cast<std::size_t>(n)]);
  if (lines.empty()) {
    controller_.set_tablet(blank_tablet());
    return;
  }
  carver_.post([this, lines = std::move(lines), strokes = std::move(strokes)] {
    auto made = tablet::CarvedTablet::from_lines(lines, Workshop::kSize);
    if (!made) return;
    Tablet bare = without_strokes(*made);
    carver_.answer([this, bare = std::move(bare), strokes] {
      if (model_ && way_ == Way::appears && strokes == carved_) controller_.set_tablet(bare);
    });
  });
}

void WritingGroove::leave() {
  model_ = nullptr;
  carved_.clear();
}

}  // namespace nazori::ui
