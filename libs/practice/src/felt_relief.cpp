// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/felt_relief.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "nazori/author/own_character.h"

namespace nazori::practice {

/// The relief as the other thread has it.
struct FeltRelief::Relief {
  surface::HeightMap map;
};

namespace {

/// The place of the first sample of a row of a box.
std::ptrdiff_t row_of(const surface::HeightMap& map, const carving::GridBox& box, int row) {
  return static_cast<std::ptrdiff_t>(row) * map.size() + box.left;
}

}  // namespace

void FeltRelief::begin(const surface::HeightMap& map, const std::vector<author::OwnStroke>& strokes) {
  if (!background_) background_.emplace("felt relief", inbox_);
  relief_ = std::make_shared<Relief>();
  is_begun_ = true;
  size_ = map.size();
  send([map](Relief& relief) { relief.map = map; }, strokes);
}

void FeltRelief::update(const surface::HeightMap& map, const carving::GridBox& box,
                        const std::vector<author::OwnStroke>& strokes) {
  if (!is_begun_) return;
  if (map.size() != size_) return begin(map, strokes);
  std::vector<float> samples;
  const auto width = static_cast<std::ptrdiff_t>(box.right) - box.left;
  for (int row = box.top; row < box.bottom; ++row) {
    const auto from = map.samples().begin() + row_of(map, box, row);
    samples.insert(samples.end(), from, from + width);
  }
  send(
      [box, width, samples = std::move(samples)](Relief& relief) {
        auto from = samples.begin();
        for (int row = box.top; row < box.bottom; ++row, from += width)
          std::copy(from, from + width, relief.map.samples().begin() + row_of(relief.map, box, row));
      },
      strokes);
}

void FeltRelief::send(std::function<void(Relief&)> change, const std::vector<author::OwnStroke>& strokes) {
  const std::uint64_t ticket = ++*newest_;
  background_->post([this, background = &*background_, newest = newest_, relief = relief_, ticket,
                     change = std::move(change), strokes] {
    change(*relief);
    // The next edit is on its way: its tablet has this one, too.
    if (*newest != ticket) return;
    auto made = author::carved_tablet(relief->map, strokes);
    background->answer([this, ticket, tablet = made ? *std::move(made) : Tablet()] {
      if (!is_begun_ || *newest_ != ticket) return;
      answered_ = ticket;
      if (tablet) put_(tablet);
    });
  });
}

void FeltRelief::end() {
  is_begun_ = false;
  ++*newest_;
}

}  // namespace nazori::practice
