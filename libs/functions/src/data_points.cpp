// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/data_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "nazori/base/file.h"

namespace nazori::functions {
namespace {

constexpr std::size_t kMostBytes = 1'000'000;

/// The text without spaces and quotes around it.
std::string_view bare(std::string_view text) {
  constexpr std::string_view kAround = " \t\r\"";
  const std::size_t first = text.find_first_not_of(kAround);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kAround) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line, bool decimal_comma) {
  std::string_view signs = ",;\t";
  if (decimal_comma) signs.remove_prefix(1);
  // Where there is none of these signs, spaces separate.
  if (line.find_first_of(signs) == std::string_view::npos) signs = " ";
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t end = line.find_first_of(signs);
    const std::string_view cell = bare(line.substr(0, end));
    if (!cell.empty() || signs != " ") cells.push_back(cell);
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
  }
  // A sign behind the last column.
  if (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

std::optional<double> number_of(std::string_view cell, bool decimal_comma) {
  std::string digits(cell);
  if (decimal_comma) std::replace(digits.begin(), digits.end(), ',', '.');
  // from_chars takes no plus, and the minus of typography is not one for it.
  if (digits.starts_with("+")) digits.erase(0, 1);
  if (digits.starts_with("−")) digits.replace(0, std::string_view("−").size(), "-");
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

tl::unexpected<base::Error> refuse(int line, std::string what, std::string remedy) {
  return base::fail(base::Errc::parse, std::move(what), fmt::format("line {}", line), std::move(remedy));
}

}  // namespace

base::Result<std::vector<DataPoint>> parse_data_points(std::string_view text, bool decimal_comma) {
  std::vector<DataPoint> points;
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  bool may_be_header = true;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = bare(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with("#")) continue;
    const auto cells = cells_of(line, decimal_comma);
    std::vector<double> values;
    for (const std::string_view cell : cells) {
      if (const auto value = number_of(cell, decimal_comma)) values.push_back(*value);
    }
    const bool is_header = std::exchange(may_be_header, false) && values.empty() && cells.size() == 2;
    if (is_header) continue;
    if (cells.size() != 2 || values.size() != 2)
      return refuse(number, "is not x and y", "give two numbers, such as 1.5, 2");
    if (points.size() == kMostDataPoints)
      return refuse(number, fmt::format("there are more than {} points", kMostDataPoints), "give fewer");
    points.push_back({values[0], values[1]});
  }
  if (points.empty()) return refuse(1, "there are no points", "give lines with x and y, such as 1.5, 2");
  return points;
}

base::Result<std::vector<DataPoint>> load_data_points(const std::filesystem::path& path, bool decimal_comma) {
  const auto bytes = base::read_file(path, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto points =
      parse_data_points({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, decimal_comma);
  if (!points) points.error().where = path.filename().string() + ": " + points.error().where;
  return points;
}

}  // namespace nazori::functions
