// SPDX-License-Identifier: Apache-2.0
#include "change.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "hand_layer.h"

namespace nazori::author {
namespace {

using carving::GridBox;

std::size_t bytes_of(const OwnStroke& stroke) {
  return sizeof(OwnStroke) + stroke.points.size() * sizeof(GroovePoint);
}

/// The samples of grooves that are in one list and not in the other.
GridBox box_of_others(const std::vector<OwnStroke>& strokes, const std::vector<OwnStroke>& others, int size) {
  GridBox box;
  for (const OwnStroke& stroke : strokes) {
    const auto same = [&stroke](const OwnStroke& other) { return other.points == stroke.points; };
    if (!std::ranges::any_of(others, same)) box = carving::united(box, carving::box_of(stroke.points, size));
  }
  return box;
}

GridBox exchange_strokes(Change::Strokes& change, std::vector<OwnStroke>& strokes, int size) {
  assert(change.first + change.count <= strokes.size());
  const auto begin = strokes.begin() + static_cast<std::ptrdiff_t>(change.first);
  const auto end = begin + static_cast<std::ptrdiff_t>(change.count);
  std::vector<OwnStroke> before(std::make_move_iterator(begin), std::make_move_iterator(end));
  const GridBox box =
      carving::united(box_of_others(before, change.held, size), box_of_others(change.held, before, size));
  strokes.insert(strokes.erase(begin, end), change.held.begin(), change.held.end());
  change.count = change.held.size();
  change.held = std::move(before);
  return box;
}

GridBox exchange_patch(Change::Patch& patch, HandLayer& hand, int size) {
  std::vector<float> before;
  assert(hand.is_untouched() || hand.size == patch.size);
  if (!hand.is_untouched()) before = cut_out(hand, patch.box);
  if (patch.heights.empty()) {
    hand = {};
  } else {
    if (hand.is_untouched())
      hand = {patch.size,
              std::vector<float>(static_cast<std::size_t>(patch.size) * static_cast<std::size_t>(patch.size),
                                 0.0F)};
    auto from = patch.heights.begin();
    for (int row = patch.box.top; row < patch.box.bottom; ++row) {
      const auto width = patch.box.right - patch.box.left;
      std::copy(
          from, from + width,
          hand.heights.begin() + static_cast<std::ptrdiff_t>(sample_index(hand.size, patch.box.left, row)));
      from += width;
    }
  }
  patch.heights = std::move(before);
  return patch.size == size ? patch.box : carving::whole_map(size);
}

}  // namespace

std::size_t bytes_of(const Change& change) {
  std::size_t bytes = sizeof(Change);
  if (change.strokes)
    for (const OwnStroke& stroke : change.strokes->held) bytes += bytes_of(stroke);
  if (change.facts) {
    for (const auto* texts : {&change.facts->readings, &change.facts->meanings})
      for (const std::string& text : *texts) bytes += sizeof(text) + text.size();
    for (const OwnPart& part : change.facts->parts)
      bytes += sizeof(part) + part.name.size() + part.strokes.size() * sizeof(int);
  }
  if (change.patch) bytes += change.patch->heights.size() * sizeof(float);
  if (change.layer) bytes += change.layer->heights.size() * sizeof(float);
  return bytes;
}

GridBox exchange(Change& change, OwnCharacter& character, int size) {
  GridBox box;
  if (change.strokes) box = exchange_strokes(*change.strokes, character.strokes, size);
  if (change.facts) std::swap(*change.facts, character.facts);
  if (change.patch) box = carving::united(box, exchange_patch(*change.patch, character.hand, size));
  if (change.layer) {
    std::swap(*change.layer, character.hand);
    box = carving::whole_map(size);
  }
  return box;
}

}  // namespace nazori::author
