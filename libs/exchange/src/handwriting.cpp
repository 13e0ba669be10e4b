// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/handwriting.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

namespace nazori::exchange {
namespace {

using base::Errc;
using base::fail;

constexpr double kSecondsPerMillisecond = 1e-3;

/// Numbers of an array; nullopt for anything else.
std::optional<std::vector<double>> read_numbers(const Value& array) {
  if (!array.is_array()) return std::nullopt;
  std::vector<double> numbers;
  for (const auto& one : array) {
    if (!one.is_number()) return std::nullopt;
    numbers.push_back(one.get<double>());
  }
  return numbers;
}

base::Result<void> read_per_point(const Value& request, const char* name, double scale,
                                  writing::WrittenCharacter& ink,
                                  std::optional<double> writing::WrittenPoint::*value) {
  const auto found = request.find(name);
  if (found == request.end()) return {};
  if (!found->is_array() || found->size() != ink.strokes.size())
    return fail(Errc::parse, "is not one array for each stroke", name);
  for (std::size_t i = 0; i < ink.strokes.size(); ++i) {
    auto numbers = read_numbers((*found)[i]);
    if (!numbers) return fail(Errc::parse, "is not an array of numbers", fmt::format("{}[{}]", name, i));
    auto& stroke = ink.strokes[i];
    if (numbers->empty()) continue;
    if (numbers->size() != stroke.size())
      return fail(Errc::bad_argument, fmt::format("A stroke has not as many {} as points.", name),
                  fmt::format("stroke {}", i + 1));
    for (std::size_t k = 0; k < stroke.size(); ++k) stroke[k].*value = (*numbers)[k] * scale;
  }
  return {};
}

bool lies_in_unit_box(const writing::WrittenCharacter& ink) {
  for (const auto& stroke : ink.strokes)
    for (const auto& [x, y] : geometry::line_of(stroke))
      if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) return false;
  return true;
}

/// A number of each point, or nothing where a point has none.
std::optional<Value> per_point(const writing::WrittenCharacter& ink, double scale,
                               std::optional<double> writing::WrittenPoint::*value) {
  Value strokes = Value::array();
  for (const auto& stroke : ink.strokes) {
    Value numbers = Value::array();
    for (const auto& point : stroke) {
      if (!(point.*value)) return std::nullopt;
      numbers.push_back(*(point.*value) * scale);
    }
    strokes.push_back(std::move(numbers));
  }
  return strokes;
}

}  // namespace

base::Result<writing::WrittenCharacter> read_handwriting(const Value& request) {
  const auto strokes = request.find("strokes");
  if (strokes == request.end() || !strokes->is_array())
    return fail(Errc::parse, "is missing or is not an array", "strokes", "give [[[x, y], ...], ...]");
  writing::WrittenCharacter ink;
  for (const auto& stroke : *strokes) {
    const auto name = fmt::format("strokes[{}]", ink.strokes.size());
    if (!stroke.is_array()) return fail(Errc::parse, "is not an array of points", name);
    auto& points = ink.strokes.emplace_back();
    for (const auto& point : stroke) {
      if (!point.is_array() || point.size() < 2 || !point[0].is_number() || !point[1].is_number())
        return fail(Errc::parse, "is not a pair of numbers", fmt::format("{}[{}]", name, points.size()));
      points.push_back({{point[0].get<double>(), point[1].get<double>()}});
    }
  }
  if (auto r = read_per_point(request, "times", kSecondsPerMillisecond, ink, &writing::WrittenPoint::time_s);
      !r)
    return tl::unexpected(r.error());
  if (auto r = read_per_point(request, "pressures", 1, ink, &writing::WrittenPoint::pressure); !r)
    return tl::unexpected(r.error());
  if (const auto box = request.find("box"); box != request.end()) {
    const auto numbers = read_numbers(*box);
    if (!numbers || numbers->size() != 3)
      return fail(Errc::parse, "is not three numbers", "box", "give [left, top, side]");
    ink.box = writing::WritingBox{{(*numbers)[0], (*numbers)[1]}, (*numbers)[2]};
  } else if (lies_in_unit_box(ink)) {
    ink.box = writing::WritingBox{};
  }
  return ink;
}

Value to_json(const writing::WrittenCharacter& ink) {
  Value strokes = Value::array();
  for (const auto& stroke : ink.strokes) {
    Value points = Value::array();
    for (const auto& point : stroke) points.push_back(Value::array({point.at.x, point.at.y}));
    strokes.push_back(std::move(points));
  }
  Value json{{"strokes", std::move(strokes)}};
  if (auto times = per_point(ink, 1 / kSecondsPerMillisecond, &writing::WrittenPoint::time_s))
    json["times"] = *std::move(times);
  if (auto pressures = per_point(ink, 1, &writing::WrittenPoint::pressure))
    json["pressures"] = *std::move(pressures);
  if (ink.box) json["box"] = Value::array({ink.box->corner.x, ink.box->corner.y, ink.box->side});
  return json;
}

}  // namespace nazori::exchange
