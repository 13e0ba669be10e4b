// SPDX-License-Identifier: Apache-2.0
// Trains the net of draw to find on distorted models of the database alone, and writes its weights:
//   train_finder KANJI.DB OUT.net [BATCHES [SEED]]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <string>

#include "distortion.h"
#include "handwritten_forms.h"
#include "nazori/geometry/svg_path.h"
#include "nazori/kanji/kanji_database.h"
#include "trainer.h"

namespace nazori::writing::training {
namespace {

struct Known {
  char32_t character = 0;
  Lines lines;
  float weight = 1;  // how often it is drawn
};

Line flattened(const geometry::BezierPath& path) {
  constexpr int kPoints = 32;
  Line line{{static_cast<float>(path.start.x), static_cast<float>(path.start.y)}};
  auto from = path.start;
  for (const auto& piece : path.pieces) {
    for (int k = 1; k <= 8; ++k) {
      const double t = k / 8.0;
      const double s = 1 - t;
      const auto p = from * (s * s * s) + piece[0] * (3 * s * s * t) + piece[1] * (3 * s * t * t) +
                     piece[2] * (t * t * t);
      line.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
    }
    from = piece[2];
  }
  return resampled(line, kPoints);
}

std::vector<Known> load(const std::string& file) {
  const auto database = kanji::KanjiDatabase::open(file);
  if (!database) std::exit(2);
  std::vector<Known> all;
  database->for_each_stroke([&all](const kanji::StrokePath& stroke) {
    if (all.empty() || all.back().character != stroke.code_point) all.push_back({stroke.code_point, {}, 1});
    if (const auto path = geometry::parse_svg_path(stroke.path)) all.back().lines.push_back(flattened(*path));
  });
  for (const auto& form : handwritten_forms()) {
    all.push_back({form.character, {}, 1});
    std::string_view rest = form.strokes;
    while (!rest.empty()) {
      const auto end = std::min(rest.find('|'), rest.size());
      const auto path = geometry::parse_svg_path(std::string(rest.substr(0, end)));
      if (!path) std::exit(3);
      all.back().lines.push_back(flattened(*path));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  for (auto& k : all) {
    const auto c = k.character;
    k.weight = c < 0x2E80 || (c >= 0x3040 && c < 0x3100) ? 12 : k.lines.size() <= 7 ? 3 : 1;
  }
  return all;
}

InkField field_of(const Lines& lines) {
  std::vector<std::vector<float>> flat;
  for (const auto& line : lines) {
    auto& f = flat.emplace_back();
    for (const auto& p : line) {
      f.push_back(p.x);
      f.push_back(p.y);
    }
  }
  return make_field(std::vector<FlatLine>(flat.begin(), flat.end()));
}

/// Gives each row length 1; the lengths before.
Numbers normalise(Numbers& rows) {
  Numbers lengths;
  for (std::size_t i = 0; i < rows.size(); i += kNetOut) {
    float sum = 1e-12F;
    for (std::size_t k = 0; k < kNetOut; ++k) sum += rows[i + k] * rows[i + k];
    lengths.push_back(std::sqrt(sum));
    for (std::size_t k = 0; k < kNetOut; ++k) rows[i + k] /= lengths.back();
  }
  return lengths;
}

/// For each character the most similar others.
std::vector<std::vector<std::size_t>> neighbours(Trainer& net, const std::vector<InkField>& fields,
                                                 std::size_t most) {
  constexpr std::size_t kAtOnce = 256;
  Numbers all;
  for (std::size_t i = 0; i < fields.size(); i += kAtOnce) {
    std::vector<const InkField*> some;
    for (std::size_t k = i; k < std::min(i + kAtOnce, fields.size()); ++k) some.push_back(&fields[k]);
    auto rows = net.forward(some);
    normalise(rows);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  const std::size_t n = fields.size();
  const auto turned = transposed(n, kNetOut, all.data());
  std::vector<std::vector<std::size_t>> result(n);
  for (std::size_t i = 0; i < n; i += kAtOnce) {
    const std::size_t rows = std::min(kAtOnce, n - i);
    Numbers near(rows * n);
    multiply(rows, kNetOut, n, all.data() + i * kNetOut, turned.data(), near.data());
    for (std::size_t r = 0; r < rows; ++r) {
      std::vector<std::size_t> order(n);
      std::iota(order.begin(), order.end(), 0);
      const float* row = near.data() + r * n;
      std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most) + 1, order.end(),
                        [row](std::size_t a, std::size_t b) { return row[a] > row[b]; });
      for (std::size_t k = 0; k <= most; ++k)
        if (order[k] != i + r) result[i + r].push_back(order[k]);
    }
  }
  return result;
}

int train(const std::string& database, const std::string& out, int batches, unsigned seed) {
  constexpr std::size_t kSeeds = 96;  // characters of a batch, each
  constexpr std::size_t kNear = 5;    // with so many of those similar to it
  constexpr float kSharpness = 20;
  constexpr int kFindNeighbours = 400;  // batches between
  std::mt19937 random(seed);
  const auto known = load(database);
  std::vector<InkField> fields;
  Numbers weights;
  for (const auto& k : known) {
    fields.push_back(field_of(k.lines));
    weights.push_back(k.weight);
  }
  std::discrete_distribution<std::size_t> choose(weights.begin(), weights.end());
  Trainer net(random);
  std::vector<std::vector<std::size_t>> near;
  double loss_sum = 0;
  double right = 0;
  double seen = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (int batch = 0; batch < batches; ++batch) {
    if (batch % kFindNeighbours == 0) near = neighbours(net, fields, 30);
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < kSeeds; ++k) {
      chosen.push_back(choose(random));
      for (std::size_t j = 0; j < kNear; ++j)
        chosen.push_back(near[chosen[chosen.size() - 1 - j]][random() % 30]);
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    const std::size_t n = chosen.size();
    std::vector<InkField> drawn;
    for (const auto i : chosen) {
      const float wildness =
          std::uniform_real_distribution<float>(0.2F, known[i].weight > 2 ? 2.1F : 1.3F)(random);
      drawn.push_back(field_of(distorted(known[i].lines, wildness, random)));
    }
    std::vector<const InkField*> inputs;
    for (const auto& f : drawn) inputs.push_back(&f);
    for (const auto i : chosen) inputs.push_back(&fields[i]);
    auto rows = net.forward(inputs);
    const auto lengths = normalise(rows);
    const float* models = rows.data() + n * kNetOut;
    Numbers logits(n * n);
    const auto turned = transposed(n, kNetOut, models);
    multiply(n, kNetOut, n, rows.data(), turned.data(), logits.data());
    for (std::size_t i = 0; i < n; ++i) {
      float* row = logits.data() + i * n;
      float most = -1e9F;
      for (std::size_t j = 0; j < n; ++j) {
        row[j] *= kSharpness;
        if (i != j && known[chosen[i]].character == known[chosen[j]].character) row[j] = -1e9F;
        most = std::max(most, row[j]);
      }
      right += row[i] >= most ? 1 : 0;
      seen += 1;
      float sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += std::exp(row[j] - most);
      loss_sum += std::log(sum) - row[i] + most;
      for (std::size_t j = 0; j < n; ++j)
        row[j] =
            kSharpness / static_cast<float>(n) * (std::exp(row[j] - most) / sum - (i == j ? 1.0F : 0.0F));
    }
    Numbers gradient(2 * n * kNetOut);
    multiply(n, n, kNetOut, logits.data(), models, gradient.data());
    const auto logits_turned = transposed(n, n, logits.data());
    multiply(n, n, kNetOut, logits_turned.data(), rows.data(), gradient.data() + n * kNetOut);
    for (std::size_t i = 0; i < 2 * n; ++i) {
      float* g = gradient.data() + i * kNetOut;
      const float* u = rows.data() + i * kNetOut;
      float along = 0;
      for (std::size_t k = 0; k < kNetOut; ++k) along += g[k] * u[k];
      for (std::size_t k = 0; k < kNetOut; ++k) g[k] = (g[k] - along * u[k]) / lengths[i];
    }
    net.backward(gradient);
    const float progress = static_cast<float>(batch) / static_cast<float>(batches);
    net.step(0.0015F * std::min(1.0F, static_cast<float>(batch + 1) / 100) *
             (0.02F + 0.98F * 0.5F * (1 + std::cos(3.14159F * progress))));
    if (batch % 200 == 199 || batch + 1 == batches) {
      const auto took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      std::printf("%d  loss %.3f  right %.3f  %.0f s\n", batch + 1, loss_sum / seen, right / seen, took);
      std::fflush(stdout);
      loss_sum = right = seen = 0;
      const auto bytes = net.bytes();
      std::ofstream(out, std::ios::binary)
          .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
  }
  return 0;
}

}  // namespace
}  // namespace nazori::writing::training

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "train_finder KANJI.DB OUT.net [BATCHES [SEED]]\n");
    return 2;
  }
  return nazori::writing::training::train(argv[1], argv[2], argc > 3 ? std::atoi(argv[3]) : 8000,
                                          argc > 4 ? static_cast<unsigned>(std::atoi(argv[4])) : 1);
}
