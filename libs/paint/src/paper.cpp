// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/paper.h"

#include <fmt/format.h>

#include <charconv>
#include <span>
#include <utility>
#include <vector>

#include "nazori/base/file.h"

namespace nazori::paint {
namespace {

using base::Errc;

constexpr std::size_t kLongest = 65536;

struct PaperNumber {
  std::string_view name;
  double Paper::*value;
  double least, most;
};

constexpr std::array kPaperNumbers{
    PaperNumber{"spread_m2_s", &Paper::spread_m2_s, 0, 4e-6},
    PaperNumber{"spread_variation", &Paper::spread_variation, 0, 1},
    PaperNumber{"pinning", &Paper::pinning, 0, 0.9},
    PaperNumber{"pinning_height", &Paper::pinning_height, 0, 0.9},
    PaperNumber{"pinning_fibre", &Paper::pinning_fibre, 0, 0.9},
    PaperNumber{"absorption_s", &Paper::absorption_s, 0, 100},
    PaperNumber{"drying_s", &Paper::drying_s, 0, 1e6},
    PaperNumber{"rim_drying", &Paper::rim_drying, 0, 10},
    PaperNumber{"fixing_s", &Paper::fixing_s, 0, 1e6},
    PaperNumber{"granulation", &Paper::granulation, 0, 1},
    PaperNumber{"kasure_s", &Paper::kasure_s, 0, 10},
    PaperNumber{"kasure_exponent", &Paper::kasure_exponent, 0.25, 4},
    PaperNumber{"film", &Paper::film, 0.05, 4},
    PaperNumber{"grain_m", &Paper::grain_m, 0.0001, 0.005},
    PaperNumber{"wet_darkening", &Paper::wet_darkening, 0, 0.95},
};
constexpr double kLeastColour = 0.05;
// Faster drying would take more than a rim cell can lose in one step.
constexpr double kFastestDrying_s = 0.5;

bool is_within(double value, double least, double most) { return value >= least && value <= most; }

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

template <class Number>
bool read_number(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

bool read_colour(std::string_view text, std::array<double, 3>& colour) {
  for (double& part : colour) {
    text = trimmed(text);
    const auto end = text.find_first_of(" \t");
    if (!read_number(text.substr(0, end), part)) return false;
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end);
  }
  return trimmed(text).empty();
}

bool is_name(std::string_view text) {
  if (text.empty() || text.size() > 100) return false;
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == '#' || c == 0x7F) return false;
  return true;
}

std::string names_of_fields() {
  std::string names = "name, paper, colour, seed";
  for (const PaperNumber& field : kPaperNumbers) names.append(", ").append(field.name);
  return names;
}

base::Result<void> read_value(Paper& paper, std::string_view name, std::string_view value) {
  if (name == "paper") {
    auto known = find_paper(value);
    if (!known) return tl::unexpected(std::move(known).error());
    paper = std::move(*known);
    return {};
  }
  if (name == "name") {
    if (!is_name(value)) return base::fail(Errc::parse, "is no name", {}, "give 1 to 100 letters");
    paper.name = value;
    return {};
  }
  if (name == "seed") {
    if (!read_number(value, paper.seed))
      return base::fail(Errc::parse, "is no seed", {}, "give 0 to 4294967295");
    return {};
  }
  if (name == "colour") {
    if (!read_colour(value, paper.colour))
      return base::fail(Errc::parse, "is no colour", {}, "give three numbers, as in 0.9 0.9 0.85");
    return {};
  }
  for (const PaperNumber& field : kPaperNumbers) {
    if (field.name != name) continue;
    if (!read_number(value, paper.*field.value))
      return base::fail(Errc::parse, "is no number", {},
                        fmt::format("give {} to {}", field.least, field.most));
    return {};
  }
  return base::fail(Errc::parse, fmt::format("there is no {}", name), {}, "names are " + names_of_fields());
}

Paper hanshi() { return {}; }

Paper gasenshi() {
  Paper paper;
  paper.name = "gasenshi";
  paper.spread_m2_s = 5e-8;
  paper.spread_variation = 0.8;
  paper.pinning = 0.01;
  paper.pinning_height = 0.08;
  paper.pinning_fibre = 0.16;
  paper.absorption_s = 0.02;
  paper.drying_s = 60;
  paper.fixing_s = 12;
  paper.granulation = 0.3;
  paper.film = 1.6;
  paper.grain_m = 0.0002;
  paper.colour = {0.94, 0.93, 0.90};
  return paper;
}

Paper gasenshi_slow() {
  Paper paper = gasenshi();
  paper.name = "gasenshi-slow";
  paper.spread_m2_s = 1.5e-8;
  paper.absorption_s = 0.3;
  paper.drying_s = 150;
  paper.fixing_s = 60;
  return paper;
}

Paper board() {
  Paper paper;
  paper.name = "board";
  paper.spread_m2_s = 1e-9;
  paper.pinning = 0.5;
  paper.absorption_s = 2;
  paper.drying_s = 30;
  paper.rim_drying = 3;
  paper.fixing_s = 0;
  paper.granulation = 0.2;
  paper.film = 3;
  paper.grain_m = 0.0004;
  paper.wet_darkening = 0.02;
  paper.colour = {0.95, 0.95, 0.93};
  return paper;
}

Paper water() {
  Paper paper;
  paper.name = "water";
  paper.spread_m2_s = 4e-9;
  paper.drying_s = 90;
  paper.rim_drying = 1;
  paper.wet_darkening = 0.85;
  paper.colour = {0.72, 0.70, 0.66};
  return paper;
}

}  // namespace

const std::array<std::string_view, 5>& paper_names() {
  static constexpr std::array<std::string_view, 5> kNames{"hanshi", "gasenshi", "gasenshi-slow", "board",
                                                          "water"};
  return kNames;
}

base::Result<Paper> find_paper(std::string_view name) {
  constexpr std::array kMakers{hanshi, gasenshi, gasenshi_slow, board, water};
  for (std::size_t i = 0; i < kMakers.size(); ++i)
    if (name == paper_names()[i]) return kMakers[i]();
  std::string names;
  for (const std::string_view known : paper_names()) names.append(names.empty() ? "" : ", ").append(known);
  return base::fail(Errc::not_found, "there is no such paper", std::string(name), "papers are " + names);
}

base::Result<void> check(const Paper& paper) {
  for (const PaperNumber& field : kPaperNumbers)
    if (!is_within(paper.*field.value, field.least, field.most))
      return base::fail(Errc::bad_argument, fmt::format("{} is outside its range", paper.*field.value),
                        std::string(field.name), fmt::format("give {} to {}", field.least, field.most));
  if (paper.drying_s > 0 && paper.drying_s < kFastestDrying_s)
    return base::fail(Errc::bad_argument, fmt::format("{} is too short", paper.drying_s), "drying_s",
                      fmt::format("give {} or longer, or 0 for never", kFastestDrying_s));
  for (const double part : paper.colour)
    if (!is_within(part, kLeastColour, 1))
      return base::fail(Errc::bad_argument, fmt::format("{} is outside its range", part), "colour",
                        fmt::format("give {} to 1", kLeastColour));
  if (!is_name(paper.name))
    return base::fail(Errc::bad_argument, "is no name", "name", "give 1 to 100 letters");
  return {};
}

base::Result<Paper> parse_paper(std::string_view text) {
  if (text.size() > kLongest)
    return base::fail(Errc::parse, "is too long", {}, fmt::format("give at most {} bytes", kLongest));
  Paper paper;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    const auto equals = line.find('=');
    const auto where = fmt::format("line {}", number);
    if (equals == std::string_view::npos)
      return base::fail(Errc::parse, "has no =", where, "write name = value");
    const std::string_view name = trimmed(line.substr(0, equals));
    auto read = read_value(paper, name, trimmed(line.substr(equals + 1)));
    if (!read) {
      base::Error error = std::move(read).error();
      error.code = Errc::parse;
      error.where = fmt::format("{}, {}", where, name);
      return tl::unexpected(std::move(error));
    }
  }
  if (auto fine = check(paper); !fine) {
    base::Error error = std::move(fine).error();
    error.code = Errc::parse;
    return tl::unexpected(std::move(error));
  }
  return paper;
}

std::string to_text(const Paper& paper) {
  std::string text = fmt::format("name = {}\n", paper.name);
  for (const PaperNumber& field : kPaperNumbers)
    text += fmt::format("{} = {}\n", field.name, paper.*field.value);
  text += fmt::format("colour = {} {} {}\nseed = {}\n", paper.colour[0], paper.colour[1], paper.colour[2],
                      paper.seed);
  return text;
}

base::Result<Paper> load_paper(const std::filesystem::path& path) {
  const auto bytes = base::read_file(path, kLongest);
  if (!bytes) return tl::unexpected(bytes.error());
  auto paper = parse_paper({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (paper) return paper;
  base::Error error = std::move(paper).error();
  error.where = error.where.empty() ? path.string() : fmt::format("{}: {}", path.string(), error.where);
  return tl::unexpected(std::move(error));
}

}  // namespace nazori::paint
