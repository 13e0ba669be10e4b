// SPDX-License-Identifier: Apache-2.0
#include "colour_tables.h"

#include <cmath>

namespace nazori::paint {
namespace {

constexpr double kMostAmount = 1e4;  // of paint that lets nothing through

Layer mixture(const std::array<Pigment, kSlots>& palette, const std::array<double, kSlots>& amounts,
              std::size_t band) {
  double kx = 0, sx = 0;
  for (std::size_t k = 0; k < kSlots; ++k) {
    kx += palette[k].absorption[band] * amounts[k];
    sx += palette[k].scattering[band] * amounts[k];
  }
  return layer_of(kx, sx);
}

}  // namespace

double ColourTables::amount_at(double place) {
  return std::min(static_cast<double>(kHalfWay) * place / std::max(1 - place, 1e-9), kMostAmount);
}

const std::array<std::uint8_t, ColourTables::kScreenSteps + 1>& ColourTables::screen_table() {
  static const auto made = [] {
    std::array<std::uint8_t, kScreenSteps + 1> table{};
    for (std::size_t i = 0; i <= kScreenSteps; ++i)
      table[i] = to_screen(static_cast<double>(i) / static_cast<double>(kScreenSteps));
    return table;
  }();
  return made;
}

ColourTables::ColourTables(const std::array<Pigment, kSlots>& palette, const Bands& paper) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    lines_[slot].resize(kSteps + 1);
    for (std::size_t i = 0; i <= kSteps; ++i) {
      std::array<double, kSlots> amounts{};
      amounts[slot] = amount_at(static_cast<double>(i) / kSteps);
      for (std::size_t band = 0; band < 3; ++band)
        lines_[slot][i][band] = static_cast<float>(
            seen_from_inside(reflectance_over(mixture(palette, amounts, band), paper[band])));
    }
  }
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    for (std::size_t band = 0; band < 3; ++band) {
      absorption_[slot][band] = static_cast<float>(palette[slot].absorption[band]);
      scattering_[slot][band] = static_cast<float>(palette[slot].scattering[band]);
    }
  }
}

const std::vector<ColourTables::Node>& ColourTables::nodes() {
  static const std::vector<Node> made = [] {
    constexpr double kLast = kNodes - 1;
    std::vector<Node> table(kNodes * kNodes);
    for (std::size_t i = 0; i < table.size(); ++i) {
      const std::size_t row = i / kNodes;
      const Layer layer = layer_of(amount_at(static_cast<double>(i % kNodes) / kLast),
                                   amount_at(static_cast<double>(row) / kLast));
      table[i] = {static_cast<float>(layer.reflected), static_cast<float>(layer.transmitted)};
    }
    return table;
  }();
  return made;
}

BandValues ColourTables::over_ground(const std::array<float, kSlots>& amounts,
                                     const BandValues& ground) const {
  const Node* table = nodes().data();
  BandValues seen{};
  for (std::size_t band = 0; band < 3; ++band) {
    float kx = 0, sx = 0;
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      kx += absorption_[slot][band] * amounts[slot];
      sx += scattering_[slot][band] * amounts[slot];
    }
    const float x = place_of(kx) * static_cast<float>(kNodes - 1),
                y = place_of(sx) * static_cast<float>(kNodes - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(x), kNodes - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(y), kNodes - 2);
    const float u = x - static_cast<float>(i), v = y - static_cast<float>(j);
    const Node *upper = table + j * kNodes + i, *lower = upper + kNodes;
    const auto mean = [&](float Node::*part) {
      const float above = upper[0].*part + u * (upper[1].*part - upper[0].*part);
      const float below = lower[0].*part + u * (lower[1].*part - lower[0].*part);
      return above + v * (below - above);
    };
    const float r = mean(&Node::reflected), t = mean(&Node::transmitted);
    const float inside = r + t * t * ground[band] / (1 - r * ground[band]);
    seen[band] = static_cast<float>(seen_from_inside(static_cast<double>(std::min(inside, 1.0F))));
  }
  return seen;
}

}  // namespace nazori::paint
