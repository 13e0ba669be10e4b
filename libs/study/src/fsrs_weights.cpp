// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "nazori/study/fsrs.h"

namespace nazori::study {
namespace {

struct Range {
  double lowest, highest;
};

/// The range of each weight in the optimiser. @source fsrs-rs and ts-fsrs 5.4.2.
constexpr std::array<Range, 21> kRanges{
    {{0.001, 100},  {0.001, 100}, {0.001, 100}, {0.001, 100}, {1, 10},    {0.001, 4},    {0.001, 4},
     {0.001, 0.75}, {0, 4.5},     {0, 0.8},     {0.001, 3.5}, {0.001, 5}, {0.001, 0.25}, {0.001, 0.9},
     {0, 4},        {0, 1},       {1, 6},       {0, 2},       {0, 2},     {0, 0.8},      {0.1, 0.8}}};
constexpr double kDecayBeforeFsrs6 = 0.5;

}  // namespace

base::Result<FsrsWeights> weights_from(std::span<const double> numbers) {
  if (!std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::isfinite(one); })) {
    return base::fail(base::Errc::bad_argument, "contain a number that is not finite", "weights");
  }
  if (numbers.size() != 21 && numbers.size() != 19 && numbers.size() != 17) {
    return base::fail(base::Errc::bad_argument, fmt::format("{} numbers", numbers.size()), "weights",
                      "give 21 (FSRS-6), 19 (FSRS-5) or 17 (FSRS-4.5)");
  }
  FsrsWeights weights{};
  std::copy(numbers.begin(), numbers.end(), weights.begin());
  const auto bring_into_range = [&weights](std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      weights[i] = std::clamp(weights[i], kRanges[i].lowest, kRanges[i].highest);
    }
  };
  bring_into_range(numbers.size());
  if (numbers.size() == 17) {
    weights[4] = weights[5] * 2 + weights[4];
    weights[5] = std::log(weights[5] * 3 + 1) / 3;
    weights[6] += 0.5;
  }
  if (numbers.size() < 21) weights[20] = kDecayBeforeFsrs6;
  bring_into_range(numbers.size());  // converted weights may be outside
  return weights;
}

base::Result<FsrsWeights> parse_weights(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  constexpr std::string_view kBetween = " \t\r\n,;[]";
  while (at != end) {
    if (kBetween.find(*at) != std::string_view::npos) {
      ++at;
      continue;
    }
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    const bool whole =
        read.ec == std::errc() && (read.ptr == end || kBetween.find(*read.ptr) != std::string_view::npos);
    if (!whole || numbers.size() > 21) {
      const std::string_view rest(at, static_cast<std::size_t>(end - at));
      const std::string_view word = rest.substr(0, std::min(rest.find_first_of(kBetween), std::size_t{40}));
      return base::fail(base::Errc::parse, "is not a number", std::string(word),
                        "give 21 numbers separated by commas");
    }
    numbers.push_back(value);
    at = read.ptr;
  }
  return weights_from(numbers);
}

}  // namespace nazori::study
