// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/blank_tablet.h"

#include <cassert>
#include <utility>

namespace nazori::practice {
namespace {

constexpr int kBlankSize = 64;

}  // namespace

Tablet blank_tablet(std::vector<kanji::StrokeLine> lines) {
  auto map = surface::HeightMap::create(kBlankSize);
  assert(map);
  auto tablet = tablet::CarvedTablet::from_height_map(std::move(*map), std::move(lines));
  assert(tablet);
  return *tablet;
}

Tablet without_strokes(const Tablet& tablet) {
  auto bare = tablet::CarvedTablet::from_height_map(tablet->height_map(), {}, tablet->shape());
  assert(bare);
  return *bare;
}

}  // namespace nazori::practice
