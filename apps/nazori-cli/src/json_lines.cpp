// SPDX-License-Identifier: Apache-2.0
#include "json_lines.h"

#include <fmt/format.h>

#include <iostream>
#include <string>

namespace nazori::cli {
namespace {

using base::Errc;
using base::fail;

/// Numbers of an array; nullopt for anything else.
std::optional<std::vector<double>> read_numbers(const Json& array) {
  if (!array.is_array()) return std::nullopt;
  std::vector<double> numbers;
  for (const auto& one : array) {
    if (!one.is_number()) return std::nullopt;
    numbers.push_back(one.get<double>());
  }
  return numbers;
}

base::Result<void> read_per_point(const Json& request, const char* name, double scale,
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

Json refuse(const Json& refusal, const Json& request, int line, const base::Error& error) {
  Json answer = Json::object();
  if (request.is_object() && request.contains("id")) answer["id"] = request["id"];
  answer["line"] = line;
  answer["error"] = base::to_line(error);
  answer.update(refusal);
  return answer;
}

/// One line; text that is not UTF-8 was given back from the request and is replaced.
std::string to_one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

base::Result<writing::WrittenCharacter> read_ink(const Json& request) {
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
  constexpr double kSecondsPerMillisecond = 1e-3;
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

int answer_lines(Console& console, const Json& refusal,
                 const std::function<base::Result<Json>(const Json& request)>& answer) {
  int code = kDone;
  int number = 0;
  std::string line;
  while (std::getline(std::cin, line)) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto request = Json::parse(line, nullptr, false);
    auto result =
        request.is_object()
            ? answer(request)
            : base::Result<Json>(fail(Errc::parse, "is not a JSON object", fmt::format("line {}", number),
                                      "one object a line, with numbers that are finite"));
    if (!result) {
      code = kWrong;
      console.print(to_one_line(refuse(refusal, request, number, result.error())));
    } else {
      Json reply = Json::object();
      if (request.contains("id")) reply["id"] = request["id"];
      reply.update(*result);
      console.print(to_one_line(reply));
    }
    if (!console.flush()) break;
  }
  return code;
}

}  // namespace nazori::cli
