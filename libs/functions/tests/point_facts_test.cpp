// SPDX-License-Identifier: Apache-2.0
// Points of interest and numbers of pieces against two tables of facts: one derived by hand ("how"), one by a
// computer algebra system (tools/make-function-facts). Another table can be given in the environment:
// NAZORI_FACTS=FILE
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "nazori/functions/points.h"
#include "test_paths.h"

namespace nazori::functions {
namespace {

using Json = nlohmann::json;

std::string key_of(PointKind kind) {
  std::string name = in_words(kind, Language::english);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
}

bool is_same(double a, const Json& b) {
  if (b.is_null()) return std::isnan(a);
  return std::abs(a - b.get<double>()) <= 1e-9 * std::max(1.0, std::abs(b.get<double>()));
}

std::string text_of(const PointOfInterest& p) { return in_words(p, Language::english); }

/// Every wanted place once, and no other.
template <class Same>
std::string compare(const std::string& what, const std::vector<PointOfInterest>& found, const Json& wanted,
                    const Same& same) {
  std::string bad;
  std::vector<bool> used(found.size(), false);
  for (const Json& w : wanted) {
    bool hit = false;
    for (std::size_t i = 0; i < found.size() && !hit; ++i) {
      if (used[i] || !same(found[i], w)) continue;
      used[i] = hit = true;
    }
    if (!hit) bad += fmt::format("\n  missing {} {}", what, w.dump());
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!used[i]) bad += "\n  wrong " + text_of(found[i]);
  }
  return bad;
}

std::string disagreements(const Json& fact) {
  const auto plot = parse(fact["expr"].get<std::string>());
  if (!plot) return "\n  is not read";
  const Json& w = fact["window"];
  const auto tracing = trace(*plot, {w[0], w[1], w[2], w[3]});
  if (!tracing) return "\n  is not traced";
  const auto points = points_of_interest(*plot, *tracing);
  const auto of_kind = [&](const std::string& kind) {
    std::vector<PointOfInterest> some;
    std::copy_if(points.begin(), points.end(), std::back_inserter(some),
                 [&](const PointOfInterest& p) { return key_of(p.kind) == kind; });
    return some;
  };
  std::string bad;
  for (const auto& [kind, wanted] : fact["points"].items()) {
    bad += compare(kind, of_kind(kind), wanted, [](const PointOfInterest& p, const Json& at) {
      return is_same(p.x, at[0]) && is_same(p.y, at[1]);
    });
  }
  if (fact.contains("jumps")) {
    bad += compare("jump", of_kind("jump"), fact["jumps"], [](const PointOfInterest& p, const Json& j) {
      return p.jump && is_same(p.x, j[0]) && is_same(p.jump->y_before, j[1]) &&
             is_same(p.jump->y_after, j[2]) && is_same(p.jump->y_at, j[3]);
    });
  }
  if (fact.contains("slanted")) {
    bad += compare("line", of_kind("slanted_asymptote"), fact["slanted"],
                   [](const PointOfInterest& p, const Json& line) {
                     return is_same(p.slope, line[0]) && is_same(p.intercept, line[1]);
                   });
  }
  if (fact.contains("pieces") && pieces(*plot, *tracing) != fact["pieces"].get<int>())
    bad += fmt::format("\n  {} pieces, not {}", pieces(*plot, *tracing), fact["pieces"].get<int>());
  for (const PointOfInterest& p : points) {
    // A rounding error is no number to be told.
    const std::string said = text_of(p);
    if (said.find("e-") != std::string::npos || said.find("nan") != std::string::npos)
      bad += "\n  said " + said;
  }
  return bad;
}

constexpr std::size_t kParts = 4;

/// A quarter of the table, so that the parts run in parallel.
class PointFactsOfPart : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Parts, PointFactsOfPart, testing::Range(std::size_t{0}, kParts));

TEST_P(PointFactsOfPart, WhatIsToldOfACurveIsWhatMathematicsSays) {
  const char* other = std::getenv("NAZORI_FACTS");  // NOLINT(concurrency-mt-unsafe): before any thread
  const std::string folder = std::string(test_paths::kFixtures) + "/";
  const std::vector<std::string> tables =
      other != nullptr ? std::vector<std::string>{other}
                       : std::vector<std::string>{folder + "facts.json", folder + "facts_from_algebra.json"};
  for (const std::string& path : tables) {
    std::ifstream file(path);
    const Json table = Json::parse(file);
    ASSERT_GE(table.size(), 1U);
    for (std::size_t i = GetParam(); i < table.size(); i += kParts) {
      const std::string bad = disagreements(table[i]);
      EXPECT_TRUE(bad.empty()) << table[i]["id"] << " " << table[i]["expr"] << bad;
    }
  }
}

}  // namespace
}  // namespace nazori::functions
