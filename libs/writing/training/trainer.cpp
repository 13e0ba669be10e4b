// SPDX-License-Identifier: Apache-2.0
#include "trainer.h"

#include <cstdint>
#include <cstring>

namespace nazori::writing::training {
namespace {

constexpr std::size_t kPatch = 9;

/// Calls `take(from, to)` with the places of each cell in the cells and in the patches; both are of `depth`
/// numbers.
template <class Take>
void each_patch(std::size_t count, std::size_t cells, std::size_t depth, Take&& take) {
  const std::size_t half = cells / 2;
  std::size_t to = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t row = 0; row < half; ++row)
      for (std::size_t column = 0; column < half; ++column)
        for (std::size_t part = 0; part < kPatch; ++part, to += depth) {
          const std::size_t y = 2 * row + part / 3;
          const std::size_t x = 2 * column + part % 3;
          if (y < 1 || x < 1 || y > cells || x > cells) continue;
          take(((i * cells + y - 1) * cells + x - 1) * depth, to);
        }
}

}  // namespace

Trainer::Trainer(std::mt19937& random) {
  const std::array<std::size_t, 3> inputs{kPatch * kFieldSlants, kPatch * kNetFirst, kNetDense};
  const std::array<std::size_t, 3> outputs{kNetFirst, kNetSecond, kNetOut};
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    auto& l = layers_[i];
    l.in = inputs[i];
    l.out = outputs[i];
    const std::size_t n = (l.in + 1) * l.out;
    l.weights.resize(n);
    l.gradient.resize(n);
    l.mean.resize(n);
    l.square.resize(n);
    std::normal_distribution<float> start(0, std::sqrt(2.0F / static_cast<float>(l.in)));
    for (std::size_t k = 0; k < l.in * l.out; ++k) l.weights[k] = start(random);
  }
}

void Trainer::run(Layer& l, std::size_t rows, bool cut) {
  l.output.assign(rows * l.out, 0);
  for (std::size_t i = 0; i < rows; ++i)
    std::copy_n(l.weights.data() + l.in * l.out, l.out, l.output.data() + i * l.out);
  multiply(rows, l.in, l.out, l.input.data(), l.weights.data(), l.output.data());
  if (cut)
    for (auto& v : l.output) v = std::max(v, 0.0F);
}

Numbers Trainer::forward(const std::vector<const InkField*>& fields) {
  constexpr std::size_t kHalf = kFieldCells / 2;
  constexpr std::size_t kQuarter = kFieldCells / 4;
  constexpr std::size_t kCut = kQuarter * kQuarter * kNetSecond;
  count_ = fields.size();
  Numbers cells(count_ * kFieldSize);
  for (std::size_t i = 0; i < count_; ++i)
    std::copy_n(fields[i]->data(), kFieldSize, cells.data() + i * kFieldSize);
  layers_[0].input.assign(count_ * kHalf * kHalf * layers_[0].in, 0);
  each_patch(count_, kFieldCells, kFieldSlants, [&](std::size_t from, std::size_t to) {
    std::copy_n(cells.data() + from, kFieldSlants, layers_[0].input.data() + to);
  });
  run(layers_[0], count_ * kHalf * kHalf, true);
  layers_[1].input.assign(count_ * kQuarter * kQuarter * layers_[1].in, 0);
  each_patch(count_, kHalf, kNetFirst, [&](std::size_t from, std::size_t to) {
    std::copy_n(layers_[0].output.data() + from, kNetFirst, layers_[1].input.data() + to);
  });
  run(layers_[1], count_ * kQuarter * kQuarter, true);
  layers_[2].input.resize(count_ * kNetDense);
  for (std::size_t i = 0; i < count_; ++i) {
    std::copy_n(layers_[1].output.data() + i * kCut, kCut, layers_[2].input.data() + i * kNetDense);
    std::copy_n(fields[i]->data() + kFieldSize, kFieldSums, layers_[2].input.data() + i * kNetDense + kCut);
  }
  run(layers_[2], count_, false);
  return layers_[2].output;
}

Numbers Trainer::back(Layer& l, const Numbers& gradient) {
  const std::size_t rows = gradient.size() / l.out;
  const auto turned = transposed(rows, l.in, l.input.data());
  multiply(l.in, rows, l.out, turned.data(), gradient.data(), l.gradient.data());
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < l.out; ++k) l.gradient[l.in * l.out + k] += gradient[i * l.out + k];
  if (&l == layers_.data()) return {};
  const auto weights = transposed(l.in, l.out, l.weights.data());
  Numbers result(rows * l.in);
  multiply(rows, l.out, l.in, gradient.data(), weights.data(), result.data());
  return result;
}

void Trainer::backward(const Numbers& gradient) {
  constexpr std::size_t kHalf = kFieldCells / 2;
  constexpr std::size_t kCut = kFieldCells / 4 * (kFieldCells / 4) * kNetSecond;
  const auto dense = back(layers_[2], gradient);
  Numbers second(count_ * kCut);
  for (std::size_t i = 0; i < count_; ++i)
    std::copy_n(dense.data() + i * kNetDense, kCut, second.data() + i * kCut);
  for (std::size_t k = 0; k < second.size(); ++k)
    if (layers_[1].output[k] <= 0) second[k] = 0;
  const auto patched = back(layers_[1], second);
  Numbers first(layers_[0].output.size());
  each_patch(count_, kHalf, kNetFirst, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = 0; k < kNetFirst; ++k) first[from + k] += patched[to + k];
  });
  for (std::size_t k = 0; k < first.size(); ++k)
    if (layers_[0].output[k] <= 0) first[k] = 0;
  back(layers_[0], first);
}

void Trainer::step(float rate) {
  ++steps_;
  const auto t = static_cast<float>(steps_);
  const float fair_mean = 1 - std::pow(0.9F, t);
  const float fair_square = 1 - std::pow(0.999F, t);
  for (auto& l : layers_)
    for (std::size_t k = 0; k < l.weights.size(); ++k) {
      const float g = l.gradient[k];
      l.mean[k] = 0.9F * l.mean[k] + 0.1F * g;
      l.square[k] = 0.999F * l.square[k] + 0.001F * g * g;
      l.weights[k] -= rate * (l.mean[k] / fair_mean) / (std::sqrt(l.square[k] / fair_square) + 1e-8F);
      l.gradient[k] = 0;
    }
}

std::vector<unsigned char> Trainer::bytes() const {
  std::vector<unsigned char> result;
  for (const auto& l : layers_) {
    Numbers scales(l.out);
    for (std::size_t k = 0; k < l.weights.size(); ++k)
      scales[k % l.out] = std::max(scales[k % l.out], std::abs(l.weights[k]) / 127);
    for (const float scale : scales) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &scale, sizeof bits);
      for (unsigned shift = 0; shift < 32; shift += 8)
        result.push_back(static_cast<unsigned char>(bits >> shift & 0xFFU));
    }
    for (std::size_t k = 0; k < l.weights.size(); ++k) {
      const float scale = scales[k % l.out];
      const auto v = static_cast<std::int8_t>(scale > 0 ? std::lround(l.weights[k] / scale) : 0);
      result.push_back(static_cast<unsigned char>(v));
    }
  }
  return result;
}

}  // namespace nazori::writing::training
