// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/sample_csv.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace nazori::recording {
namespace {

using haptics::ServoEvent;
using haptics::ServoSample;

std::string row(const ServoSample& sample) {
  std::string text;
  append_csv_row(text, sample);
  return text;
}

TEST(SampleCsv, HasTheDocumentedColumns) {
  EXPECT_EQ(kSampleCsvHeader, "t,x,y,z,proxy_x,proxy_y,proxy_z,fx,fy,fz,contact,stroke,event\n");
  ServoSample sample;
  sample.time_s = 0.25;
  sample.device_m = {1e-3, -2e-3, -0.0045};
  sample.proxy_m = {1e-3, -2e-3, -0.004};
  sample.force_n = {0, 0, 0.25};
  sample.touching = true;
  sample.stroke = 3;
  sample.events =
      static_cast<std::uint16_t>(ServoEvent::touch) | static_cast<std::uint16_t>(ServoEvent::capture);
  EXPECT_EQ(row(sample), "0.25,0.001,-0.002,-0.0045,0.001,-0.002,-0.004,0,0,0.25,1,3,touch|capture\n");
}

TEST(SampleCsv, LeavesTheEventEmptyWhereNothingHappened) {
  EXPECT_EQ(row(ServoSample{}), "0,0,0,0.02,0,0,0.02,0,0,0,0,0,\n");
}

TEST(SampleCsv, NamesEveryEvent) {
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::touch)), "touch");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::untouch)), "untouch");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::capture)), "capture");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::release)), "release");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::fault)), "fault");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::wrong_start)), "wrong_start");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::wrong_direction)), "wrong_direction");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::stroke_done)), "stroke_done");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::lesson_done)), "lesson_done");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::resisted)), "resisted");
  EXPECT_EQ(event_words(static_cast<unsigned>(ServoEvent::resumed)), "resumed");
  EXPECT_EQ(event_words(0), "");
  EXPECT_EQ(event_words(1U << 30), "bit30");
  EXPECT_EQ(event_words(1U | 1U << 11U | 1U << 31U), "touch|bit11|bit31")
      << "one without a name keeps its bit";
  EXPECT_EQ(event_name(0), "touch");
  EXPECT_EQ(event_name(10), "resumed");
  for (const int none : {-1, 11, 31}) EXPECT_EQ(event_name(none), "");
}

TEST(SampleCsv, ARowOfTheLongestNumbersIsWhole) {
  constexpr double kLongest = -2.2250738585072014e-308;
  ServoSample sample;
  sample.time_s = kLongest;
  sample.device_m = sample.force_n = {kLongest, kLongest, kLongest};
  sample.proxy_m = {-kLongest, -kLongest, kLongest};
  sample.stroke = std::numeric_limits<std::int32_t>::min();
  const std::string longest = "-2.2250738585072014e-308";
  const std::string three = longest + "," + longest + "," + longest;
  EXPECT_EQ(row(sample), longest + "," + three + "," + longest.substr(1) + "," + longest.substr(1) + "," +
                             longest + "," + three + ",0,-2147483648,\n");
}

TEST(SampleCsv, MinusZeroIsZero) {
  ServoSample sample;
  sample.device_m = {-0.0, 1, -1};
  sample.proxy_m = {0.0, -1, 1};
  EXPECT_EQ(row(sample), "0,0,1,-1,0,-1,1,0,0,0,0,0,\n");
}

TEST(SampleCsv, EveryNumberReadsBackAsItselfEvenTheLongest) {
  std::mt19937_64 random(7);
  std::vector<double> values{-2.2250738585072014e-308, 1.7976931348623157e308, 5e-324, -0.1, 1e21, 1.0 / 3};
  while (values.size() < 3000) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
  }
  for (const double value : values) {
    ServoSample sample;
    sample.time_s = value;
    sample.device_m = sample.proxy_m = sample.force_n = {value, -value, value};
    sample.proxy_m.x = -value;
    const std::string text = row(sample);
    double read = 0;
    const char* at = text.data();
    for (const double expected : {value, value, -value, value, -value, -value, value, value, -value, value}) {
      at = std::from_chars(at, text.data() + text.size(), read).ptr + 1;
      ASSERT_EQ(read, expected) << text;
    }
  }
}

}  // namespace
}  // namespace nazori::recording
