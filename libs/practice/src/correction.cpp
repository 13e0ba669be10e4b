// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/correction.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace nazori::practice {
namespace {

void add_strokes_of(const writing::Mistake& mistake, const writing::Grade& grade, std::set<int>& strokes) {
  if (!mistake.model.empty()) {
    strokes.insert(mistake.model.begin(), mistake.model.end());
    return;
  }
  if (mistake.kind == kanji::MistakeKind::missing) {
    strokes.insert(mistake.stroke);
    return;
  }
  const auto add_drawn = [&](int drawn) {
    if (drawn < 0 || static_cast<std::size_t>(drawn) >= grade.strokes.size()) return;
    if (const auto& matched = grade.strokes[static_cast<std::size_t>(drawn)].matched)
      strokes.insert(*matched);
  };
  add_drawn(mistake.stroke);
  if (mistake.kind == kanji::MistakeKind::order && mistake.second) add_drawn(*mistake.second);
}

}  // namespace

std::vector<int> strokes_to_show(const writing::Grade& grade, int model_strokes) {
  std::set<int> strokes;
  const auto& about = grade.mistakes.empty() ? grade.advice : grade.mistakes;
  const bool is_other = std::any_of(about.begin(), about.end(), [](const writing::Mistake& one) {
    return one.kind == kanji::MistakeKind::other;
  });
  if (!is_other)
    for (const auto& one : about) add_strokes_of(one, grade, strokes);
  std::vector<int> found;
  for (const int stroke : strokes)
    if (stroke >= 0 && stroke < model_strokes) found.push_back(stroke);
  if (found.empty() && !about.empty()) {
    // A stroke too many has none in the model: the whole character shows what belongs to it.
    found.resize(static_cast<std::size_t>(std::max(model_strokes, 0)));
    std::iota(found.begin(), found.end(), 0);
  }
  return found;
}

void Correction::begin(const tablet::CarvedTablet& model, std::vector<int> strokes) {
  std::vector<haptics::StrokePath> paths;
  std::vector<tablet::TabletLine> lines;
  for (const int stroke : strokes) {
    paths.push_back(model.paths()[static_cast<std::size_t>(stroke)]);
    lines.push_back(model.lines()[static_cast<std::size_t>(stroke)]);
  }
  player_.set_strokes(paths, lines);
  strokes_ = std::move(strokes);
  time_s_ = 0;
}

void Correction::advance(double passed_s) {
  time_s_ = std::min(time_s_ + std::max(passed_s, 0.0), player_.duration_s());
}

std::vector<Correction::Part> Correction::parts() const {
  std::vector<Part> drawn;
  for (std::size_t i = 0; i < strokes_.size(); ++i)
    if (const double share = player_.share_at(static_cast<int>(i) + 1, time_s_); share > 0)
      drawn.push_back({strokes_[i], share});
  return drawn;
}

}  // namespace nazori::practice
