// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_groove.h"

#include <algorithm>
#include <utility>

#include "nazori/practice/blank_tablet.h"

namespace nazori::practice {

WritingGroove::WritingGroove(base::Inbox& inbox, std::function<void(const Tablet&)> put)
    : put_(std::move(put)),
      carver_(
          "carver", inbox,
          [](const std::vector<std::pair<int, tablet::TabletLine>>& strokes, const auto&) {
            Carved carved;
            std::vector<tablet::TabletLine> lines;
            for (const auto& [n, line] : strokes) {
              carved.strokes.push_back(n);
              lines.push_back(line);
            }
            if (auto made = tablet::CarvedTablet::from_lines(std::move(lines), TabletWorkshop::kSize))
              carved.tablet = without_strokes(*made);
            return carved;
          },
          [this](const Carved& carved) {
            if (carved.tablet && carved.strokes == carved_) put_(carved.tablet);
          }) {}

void WritingGroove::begin(Mode mode, const Tablet& model) {
  carver_.cancel();
  mode_ = mode;
  model_ = model;
  carved_.clear();
  if (model_) put_(mode == Mode::shown ? without_strokes(model_) : blank_tablet());
}

void WritingGroove::carve(std::vector<int> strokes) {
  if (!model_ || mode_ != Mode::appears) return;
  std::sort(strokes.begin(), strokes.end());
  if (strokes == carved_) return;
  carved_ = strokes;
  carver_.cancel();
  if (strokes.empty()) {
    put_(blank_tablet());
    return;
  }
  std::vector<std::pair<int, tablet::TabletLine>> lines;
  const auto& all = model_->lines();
  lines.reserve(strokes.size());
  for (const int n : strokes) lines.emplace_back(n, all[static_cast<std::size_t>(n)]);
  carver_.request(std::move(lines));
}

void WritingGroove::end() {
  carver_.cancel();
  model_ = nullptr;
  carved_.clear();
}

}  // namespace nazori::practice
