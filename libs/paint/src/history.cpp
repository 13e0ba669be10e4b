// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/history.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "packed_tile.h"

namespace nazori::paint {

History::History(std::size_t limit) : limit_(std::max<std::size_t>(limit, 1)) {}

History::State History::state_of(const Sheet& sheet, const InkLoad& load) {
  const auto& tiles = sheet.inside().tiles;
  known_.resize(tiles.size());
  State state{{}, sheet.palette(), load};
  state.tiles.reserve(tiles.size());
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    Known& known = known_[i];
    if (!known.bytes || known.version != tiles[i]->version)
      known = {tiles[i]->version, std::make_shared<const std::vector<std::uint8_t>>(pack(*tiles[i]))};
    state.tiles.push_back(known.bytes);
  }
  return state;
}

void History::restore(const State& state, Sheet& sheet, InkLoad& load) {
  Sheet::Inside& inside = sheet.inside();
  assert(state.tiles.size() == inside.tiles.size());
  for (std::size_t i = 0; i < inside.tiles.size(); ++i) {
    Known& known = known_[i];
    Tile& tile = *inside.tiles[i];
    if (known.bytes == state.tiles[i] && known.version == tile.version) continue;
    const bool is_tile = unpack(*state.tiles[i], inside.paper_inside, tile);
    assert(is_tile);
    static_cast<void>(is_tile);
    inside.settle(tile);
    known = {tile.version, state.tiles[i]};
  }
  inside.palette = state.palette;
  inside.make_rules();
  load = state.load;
}

void History::remember(const Sheet& sheet, const InkLoad& load) {
  future_.clear();
  past_.push_back(state_of(sheet, load));
  if (past_.size() > limit_) past_.erase(past_.begin());
}

bool History::undo(Sheet& sheet, InkLoad& load) {
  if (past_.empty()) return false;
  future_.push_back(state_of(sheet, load));
  restore(past_.back(), sheet, load);
  past_.pop_back();
  return true;
}

bool History::redo(Sheet& sheet, InkLoad& load) {
  if (future_.empty()) return false;
  past_.push_back(state_of(sheet, load));
  restore(future_.back(), sheet, load);
  future_.pop_back();
  return true;
}

std::size_t History::bytes() const {
  std::set<const void*> counted;  // states share the tiles that did not change between them
  std::size_t sum = 0;
  for (const auto* states : {&past_, &future_})
    for (const State& state : *states)
      for (const Bytes& bytes : state.tiles)
        if (counted.insert(bytes.get()).second) sum += bytes->size();
  return sum;
}

}  // namespace nazori::paint
