// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <random>
#include <vector>

#include "finder_net.h"
#include "numbers.h"

namespace nazori::writing::training {

/// The net with what training needs: weights, and the steps of Adam (D. P. Kingma and J. Ba, "Adam: a method
/// for stochastic optimization", 2015).
class Trainer {
 public:
  explicit Trainer(std::mt19937& random);

  /// Embeddings of many fields, one row each, before they are given length 1. Keeps what backward() needs.
  [[nodiscard]] Numbers forward(const std::vector<const InkField*>& fields);
  /// Adds up the gradients of the weights from that of the embeddings of the last forward().
  void backward(const Numbers& gradient);
  void step(float rate);

  /// As bytes, see read_weights().
  [[nodiscard]] std::vector<unsigned char> bytes() const;
  [[nodiscard]] NetWeights weights() const { return read_weights(bytes()); }

 private:
  struct Layer {
    std::size_t in = 0;
    std::size_t out = 0;
    Numbers weights, gradient, mean, square;  // in + 1 rows, the last one the constants
    Numbers input;                            // of the last forward(), one row for each patch
    Numbers output;
  };
  void run(Layer& layer, std::size_t rows, bool cut);
  /// Gradient of the layer's input.
  Numbers back(Layer& layer, const Numbers& gradient);

  std::array<Layer, 3> layers_;
  std::size_t count_ = 0;
  int steps_ = 0;
};

}  // namespace nazori::writing::training
