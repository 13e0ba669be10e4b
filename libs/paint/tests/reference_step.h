// SPDX-License-Identifier: Apache-2.0
// One step of a whole sheet, cell by cell, with the same roundings as the fast one. It must be compiled
// without fused multiplication.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "inside.h"

namespace nazori::paint::test {

class ReferenceStep {
 public:
  struct Grain {
    float height, pinning, conductivity;
  };
  struct Held {
    Amount surface = 0, fibre = 0;
    PigmentAmounts moving{}, fixed{};
    friend bool operator==(const Held&, const Held&) = default;
  };

  explicit ReferenceStep(const Sheet::Inside& sheet) : size_(sheet.size), rules_(sheet.rules) {
    for (int row = 0; row < size_; ++row)
      for (int column = 0; column < size_; ++column) {
        held_.push_back(held_by(sheet, column, row));
        grain_.push_back(grain_of(sheet, column, row));
      }
  }

  [[nodiscard]] static Held held_by(const Sheet::Inside& sheet, int column, int row) {
    const Tile& tile = sheet.tile_at(column, row);
    const std::size_t i = Sheet::Inside::cell_at(column, row);
    Held held{tile.surface[i], tile.fibre[i], {}, {}};
    for (std::size_t k = 0; k < kSlots; ++k) {
      held.moving[k] = tile.moving[k][i];
      held.fixed[k] = tile.fixed[k][i];
    }
    return held;
  }
  [[nodiscard]] const Held& at(int column, int row) const { return held_[index(column, row)]; }

  /// @return the water that evaporated.
  TotalAmount step() {
    TotalAmount evaporated = 0;
    std::vector<Held> next;
    for (int row = 0; row < size_; ++row)
      for (int column = 0; column < size_; ++column) next.push_back(next_of(column, row, evaporated));
    held_ = std::move(next);
    return evaporated;
  }

 private:
  struct Flow {
    Amount water = 0;
    PigmentAmounts pigment{};
  };

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool is_inside(int column, int row) const {
    return column >= 0 && row >= 0 && column < size_ && row < size_;
  }

  [[nodiscard]] Grain grain_of(const Sheet::Inside& sheet, int column, int row) const {
    const Tile& tile = sheet.tile_at(column, row);
    const std::size_t i = Sheet::Inside::paper_at(column, row);
    const float height = static_cast<float>(tile.height[i]) * (1.0F / 65535.0F);
    const float density = static_cast<float>(tile.density[i]) * (1.0F / 65535.0F);
    return {height, rules_.pinning + rules_.pinning_height * height + rules_.pinning_density * density,
            rules_.conductivity - rules_.conductivity_loss * density};
  }

  /// What flows from one cell to another, less than nothing where it comes from there.
  [[nodiscard]] Flow flow(std::size_t from, std::size_t to) const {
    const auto a = static_cast<float>(held_[from].fibre), b = static_cast<float>(held_[to].fibre);
    if (b == 0 && a <= grain_[to].pinning) return {};
    if (a == 0 && b <= grain_[from].pinning) return {};
    const float conductivity = 0.5F * (grain_[from].conductivity + grain_[to].conductivity);
    Flow flow;
    flow.water = static_cast<Amount>(conductivity * ((a - b) * (a + b)));
    const Held& giver = flow.water > 0 ? held_[from] : held_[to];
    const Held& taker = flow.water > 0 ? held_[to] : held_[from];
    const Amount water = giver.surface + giver.fibre;
    for (std::size_t k = 0; k < kSlots; ++k) {
      if (water == 0 || taker.moving[k] > kMostMoving) continue;
      const float concentration = static_cast<float>(giver.moving[k]) / static_cast<float>(water);
      flow.pigment[k] =
          static_cast<Amount>(rules_.mobility[k] * static_cast<float>(flow.water) * concentration);
    }
    return flow;
  }

  /// What a cell holds after the flow, but before anything seeps or dries.
  [[nodiscard]] Held flowed(int column, int row, int& dry_sides) const {
    const std::size_t here = index(column, row);
    Held held = held_[here];
    const auto add = [&](const Flow& flow, int sign) {
      held.fibre += sign * flow.water;
      for (std::size_t k = 0; k < kSlots; ++k) held.moving[k] += sign * flow.pigment[k];
    };
    for (const auto& [x, y] : {std::array{-1, 0}, std::array{1, 0}, std::array{0, -1}, std::array{0, 1}}) {
      // Beyond the border of the sheet is as much water as before it.
      const std::size_t other = is_inside(column + x, row + y) ? index(column + x, row + y) : here;
      if (held_[other].fibre == 0) ++dry_sides;
      if (x + y < 0)
        add(flow(other, here), 1);
      else
        add(flow(here, other), -1);
    }
    return held;
  }

  void fix(Held& held, std::size_t cell, std::size_t slot, float loss, bool is_dry) const {
    const float granulation = rules_.granulation[slot] * (1.0F - 2.0F * grain_[cell].height);
    const float share = std::max(loss, rules_.fixing * (1.0F + granulation));
    Amount& moving = held.moving[slot];
    Amount fixes = moving;
    if (!is_dry) fixes = std::min(static_cast<Amount>(static_cast<float>(moving) * share), moving);
    fixes = std::min(fixes, kMostFixed - held.fixed[slot]);
    moving -= fixes;
    held.fixed[slot] += fixes;
  }

  [[nodiscard]] Held next_of(int column, int row, TotalAmount& evaporated) const {
    int dry_sides = 0;
    Held held = flowed(column, row, dry_sides);
    const Amount seeps = std::min({held.surface, std::max(kOne - held.fibre, 0), rules_.absorption});
    held.surface -= seeps;
    held.fibre += seeps;
    const Amount had = held.surface + held.fibre;
    const Amount gone = std::min(had, rules_.evaporation + dry_sides * rules_.rim_evaporation);
    const Amount from_surface = std::min(held.surface, gone);
    held.surface -= from_surface;
    held.fibre -= gone - from_surface;
    evaporated += gone;
    const float loss = had > 0 ? static_cast<float>(gone) / static_cast<float>(had) : 0.0F;
    for (std::size_t k = 0; k < kSlots; ++k) fix(held, index(column, row), k, loss, gone == had);
    return held;
  }

  int size_;
  StepRules rules_;
  std::vector<Held> held_;
  std::vector<Grain> grain_;
};

}  // namespace nazori::paint::test
