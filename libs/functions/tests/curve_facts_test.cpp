// SPDX-License-Identifier: Apache-2.0
// Pictures against tables of facts. Another table and other sizes can be given in the environment:
// NAZORI_CURVES=FILE NAZORI_CURVE_SIZES=256,512,1024 NAZORI_HALF_WIDTH=0.0125 NAZORI_CURVE_TIMES=1
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "curve_facts.h"

namespace nazori::functions::test {
namespace {

std::string setting(const char* name, std::string otherwise) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): before any thread
  return value != nullptr ? value : std::move(otherwise);
}

constexpr std::size_t kParts = 8;

/// An eighth of the table, so that the parts run side by side.
class CurveFactsOfPart : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Parts, CurveFactsOfPart, testing::Range(std::size_t{0}, kParts));

TEST_P(CurveFactsOfPart, EveryPictureAgreesWithWhatIsKnownOfItBefore) {
  const auto table = facts_of_file(setting("NAZORI_CURVES", NAZORI_FIXTURES "/curves.json"));
  ASSERT_GT(table.size(), 0U);
  std::istringstream sizes(setting("NAZORI_CURVE_SIZES", "256"));
  const double half_width = std::stod(setting("NAZORI_HALF_WIDTH", "0.0125"));
  const bool times = setting("NAZORI_CURVE_TIMES", "0") == "1";
  for (std::string size; std::getline(sizes, size, ',');) {
    int good = 0;
    for (std::size_t i = GetParam(); i < table.size(); i += kParts) {
      const CurveFacts& f = table[i];
      const auto start = std::chrono::steady_clock::now();
      const auto bad = disagreements(f, std::stoi(size), half_width);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      if (times && took.count() > 0.3)
        std::printf("%6.2f s %s %s\n", took.count(), f.id.c_str(), size.c_str());
      good += bad.empty() ? 1 : 0;
      std::string lines;
      for (const std::string& line : bad) lines += "\n  " + line;
      EXPECT_TRUE(bad.empty()) << f.id << " " << f.expression << " at " << size << lines;
    }
    if (times) std::printf("%s: %d agree\n", size.c_str(), good);
  }
}

}  // namespace
}  // namespace nazori::functions::test
