// SPDX-License-Identifier: Apache-2.0
#include "finder_net.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace nazori::writing {

/// libs/writing/data/finder.net, made part of the program by CMake.
extern const unsigned char finder_net_bytes[];
extern const std::size_t finder_net_size;

namespace {

constexpr std::size_t kPatch = 9;

/// sums += x * row
void add_scaled(float* __restrict sums, const float* __restrict row, float x, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) sums[i] += x * row[i];
}

/// A layer of patches: `cells` x `cells` x `depth` to half as many cells of `Out` numbers, none below 0.
template <std::size_t Out>
void patches(const float* in, std::size_t cells, std::size_t depth, const std::vector<float>& weights,
             float* out) {
  const std::size_t half = cells / 2;
  const float* constants = weights.data() + kPatch * depth * Out;
  for (std::size_t row = 0; row < half; ++row)
    for (std::size_t column = 0; column < half; ++column) {
      std::array<float, Out> sums;
      std::copy_n(constants, Out, sums.begin());
      for (std::size_t part = 0; part < kPatch; ++part) {
        const std::size_t y = 2 * row + part / 3;  // one more than the cell's, so that it is never negative
        const std::size_t x = 2 * column + part % 3;
        if (y < 1 || x < 1 || y > cells || x > cells) continue;
        const float* cell = in + ((y - 1) * cells + x - 1) * depth;
        for (std::size_t k = 0; k < depth; ++k)
          if (cell[k] != 0) add_scaled(sums.data(), weights.data() + (part * depth + k) * Out, cell[k], Out);
      }
      for (const float v : sums) *out++ = std::max(v, 0.0F);
    }
}

}  // namespace

NetWeights read_weights(std::span<const unsigned char> bytes) {
  NetWeights result;
  const std::array<std::size_t, 3> inputs{kPatch * kFieldSlants + 1, kPatch * kNetFirst + 1, kNetDense + 1};
  const std::array<std::size_t, 3> outputs{kNetFirst, kNetSecond, kNetOut};
  const std::array<std::vector<float>*, 3> layers{&result.first, &result.second, &result.dense};
  std::size_t size = 0;
  for (std::size_t i = 0; i < 3; ++i) size += outputs[i] * (sizeof(float) + inputs[i]);
  if (bytes.size() != size) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<float> scales(outputs[i]);
    for (auto& scale : scales) {
      const std::uint32_t bits = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U |
                                 static_cast<std::uint32_t>(bytes[2]) << 16U |
                                 static_cast<std::uint32_t>(bytes[3]) << 24U;
      std::memcpy(&scale, &bits, sizeof scale);
      bytes = bytes.subspan(sizeof scale);
    }
    const std::size_t count = inputs[i] * outputs[i];
    layers[i]->resize(count);
    for (std::size_t k = 0; k < count; ++k)
      (*layers[i])[k] = static_cast<float>(static_cast<std::int8_t>(bytes[k])) * scales[k % outputs[i]];
    bytes = bytes.subspan(count);
  }
  return result;
}

Embedding embed(const NetWeights& weights, const InkField& field) {
  constexpr std::size_t kHalf = kFieldCells / 2;
  constexpr std::size_t kQuarter = kFieldCells / 4;
  std::array<float, kHalf * kHalf * kNetFirst> first;
  std::array<float, kNetDense> second;
  patches<kNetFirst>(field.data(), kFieldCells, kFieldSlants, weights.first, first.data());
  patches<kNetSecond>(first.data(), kHalf, kNetFirst, weights.second, second.data());
  std::copy_n(field.data() + kFieldSize, kFieldSums, second.data() + kQuarter * kQuarter * kNetSecond);
  Embedding result;
  std::copy_n(weights.dense.data() + kNetDense * kNetOut, kNetOut, result.begin());
  for (std::size_t k = 0; k < kNetDense; ++k)
    if (second[k] != 0) add_scaled(result.data(), weights.dense.data() + k * kNetOut, second[k], kNetOut);
  float length2 = 0;
  for (const float v : result) length2 += v * v;
  const float scale = 1 / std::sqrt(std::max(length2, 1e-20F));
  for (auto& v : result) v *= scale;
  return result;
}

const NetWeights& trained_weights() {
  static const NetWeights kWeights = read_weights({finder_net_bytes, finder_net_size});
  return kWeights;
}

float likeness(const Embedding& a, const Embedding& b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace nazori::writing
