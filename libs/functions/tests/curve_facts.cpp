// SPDX-License-Identifier: Apache-2.0
#include "curve_facts.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace nazori::functions::test {
namespace {

using Json = nlohmann::json;

struct Cell {
  int row, column;
};

Cell cell_at(int n, double u, double v) {
  return {std::clamp(static_cast<int>((1 - v) * n), 0, n - 1), std::clamp(static_cast<int>(u * n), 0, n - 1)};
}

std::size_t index_of(int n, Cell c) {
  return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(c.column);
}

bool carved_at(const Plate& plate, double u, double v) {
  const int n = plate.heights.size();
  return plate.mask[index_of(n, cell_at(n, u, v))] != 0;
}

/// Height between sample centres.
double height_at(const Plate& plate, double u, double v) {
  const int n = plate.heights.size();
  const double column = std::clamp(u * n - 0.5, 0.0, n - 1.001);
  const double row = std::clamp((1 - v) * n - 0.5, 0.0, n - 1.001);
  const int c = static_cast<int>(column);
  const int r = static_cast<int>(row);
  const double fc = column - c;
  const double fr = row - r;
  return (plate.heights.at(c, r) * (1 - fc) + plate.heights.at(c + 1, r) * fc) * (1 - fr) +
         (plate.heights.at(c, r + 1) * (1 - fc) + plate.heights.at(c + 1, r + 1) * fc) * fr;
}

}  // namespace

double relative_width(const Plate& plate, double u, double v, double nu, double nv, double half_width) {
  double width = 0;
  for (const double side : {1.0, -1.0}) {
    const auto is_cut = [&](double d) {
      return height_at(plate, u + side * nu * d, v + side * nv * d) < 0.5;
    };
    const double step = half_width / 40;
    double d = 0;
    while (d < 3 * half_width && is_cut(d + step)) d += step;
    // Where exactly: the step itself would be a hundredth of the width.
    double beyond = d + step;
    for (int i = 0; i < 20; ++i) {
      const double middle = (d + beyond) / 2;
      (is_cut(middle) ? d : beyond) = middle;
    }
    width += d;
  }
  return width / half_width;
}

std::vector<CurveFacts> facts_of_file(const std::string& path) {
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  std::vector<CurveFacts> all;
  for (const Json& c : Json::parse(in)) {
    CurveFacts f;
    f.id = c.at("id").get<std::string>();
    f.expression = c.at("expr").get<std::string>();
    const auto& w = c.at("window");
    f.window = {w[0].get<double>(), w[1].get<double>(), w[2].get<double>(), w[3].get<double>()};
    f.is_error = c.at("kind") == "error";
    f.is_surface = c.at("kind") == "surface";
    if (c.contains("z") && !c["z"].is_null()) f.heights = {c["z"][0].get<double>(), c["z"][1].get<double>()};
    for (const auto& [key, places] : {std::pair{"on", &f.on}, std::pair{"off", &f.off}}) {
      for (const Json& p : c.at(key))
        places->push_back({p[0].get<double>(), p[1].get<double>(), p.size() > 2 ? p[2].get<double>() : 0.0});
    }
    if (!c.at("components").is_null()) f.pieces = c["components"].get<int>();
    for (const Json& s : c.value("width", Json::array()))
      f.sections.push_back({s[0].get<double>(), s[1].get<double>(), s[2].get<double>(), s[3].get<double>()});
    all.push_back(std::move(f));
  }
  return all;
}

int pieces_of(const Plate& plate) {
  const int n = plate.heights.size();
  std::vector<bool> seen(plate.mask.size(), false);
  std::vector<Cell> stack;
  int count = 0;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      if (plate.mask[index_of(n, {row, column})] == 0 || seen[index_of(n, {row, column})]) continue;
      ++count;
      seen[index_of(n, {row, column})] = true;
      stack.push_back({row, column});
      while (!stack.empty()) {
        const Cell at = stack.back();
        stack.pop_back();
        for (int r = std::max(0, at.row - 1); r <= std::min(n - 1, at.row + 1); ++r) {
          for (int c = std::max(0, at.column - 1); c <= std::min(n - 1, at.column + 1); ++c) {
            const std::size_t i = index_of(n, {r, c});
            if (plate.mask[i] == 0 || seen[i]) continue;
            seen[i] = true;
            stack.push_back({r, c});
          }
        }
      }
    }
  }
  return count;
}

bool is_carved(const Picture& p, double x, double y) {
  return carved_at(p.plate, p.tracing.window.u(x), p.tracing.window.v(y));
}

std::vector<std::string> disagreements(const CurveFacts& f, int size, double half_width) {
  const auto plot = parse(f.expression);
  if (f.is_error) {
    if (plot) return {"is read although it is wrong"};
    return {};
  }
  if (!plot) return {plot.error().to_error().what};
  PlateSettings settings;
  settings.size = size;
  settings.half_width = half_width;
  settings.layers = Layers::none();
  if (f.is_surface) settings.heights = f.heights;
  const auto picture = draw(*plot, f.window, settings);
  if (!picture) return {picture.error().what};
  const Plate& plate = picture->plate;
  std::vector<std::string> bad;
  for (const auto& p : f.on) {
    if (!is_carved(*picture, p.x, p.y)) bad.push_back(fmt::format("not carved at {}, {}", p.x, p.y));
  }
  for (const auto& p : f.off) {
    if (is_carved(*picture, p.x, p.y)) bad.push_back(fmt::format("carved at {}, {}", p.x, p.y));
  }
  if (f.is_surface) {
    for (const auto& p : f.on) {
      const Cell c = cell_at(size, f.window.u(p.x), f.window.v(p.y));
      const double wanted = std::clamp((p.z - f.heights.low) / (f.heights.high - f.heights.low), 0.0, 1.0);
      const double got = plate.heights.at(c.column, c.row);
      // The middle of the cell may lie half a cell away from the place.
      if (std::abs(got - wanted) > 0.03 + 2.0 / size)
        bad.push_back(fmt::format("height {:.3f}, not {:.3f}, at {}, {}", got, wanted, p.x, p.y));
    }
    return bad;
  }
  if (f.pieces >= 0 && pieces_of(plate) != f.pieces)
    bad.push_back(fmt::format("{} pieces, not {}", pieces_of(plate), f.pieces));
  for (const auto& s : f.sections) {
    const double u = f.window.u(s.x);
    const double v = f.window.v(s.y);
    const double away = std::min(std::min(u, 1 - u), std::min(v, 1 - v));
    if (away < 2 * half_width) continue;
    const double width = relative_width(plate, u, v, s.across_u, s.across_v, half_width);
    if (std::abs(width - 1) > 0.02)
      bad.push_back(fmt::format("width {:.4f} of the nominal one at {}, {}", width, s.x, s.y));
  }
  if (picture->tracing.undecided_share() > 0.02)
    bad.push_back(fmt::format("{:.2f} % undecided", 100 * picture->tracing.undecided_share()));
  return bad;
}

}  // namespace nazori::functions::test
