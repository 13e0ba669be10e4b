// SPDX-License-Identifier: Apache-2.0
// Whole plots played: what is heard when, and the file of it.
#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "../src/voice.h"
#include "nazori/functions/sound.h"
#include "typed_plots.h"

namespace nazori::functions {
namespace {

constexpr int kRate = 44'100;

using test::read;

Sound swept(const std::string& text, const Window& window, SoundSettings settings = {}) {
  const Plot plot = read(text);
  const auto tracing = trace(plot, window);
  EXPECT_TRUE(tracing);
  settings.earcons = false;
  const auto sound = sweep(plot, *tracing, {}, settings);
  EXPECT_TRUE(sound);
  return *sound;
}

/// The loudest sample between two times.
double loudest(const Sound& s, double from_s, double to_s) {
  float most = 0;
  const auto last = std::min(s.samples.size() / 2, static_cast<std::size_t>(to_s * s.sample_rate));
  for (auto i = static_cast<std::size_t>(from_s * s.sample_rate); i < last; ++i)
    most = std::max({most, std::abs(s.samples[2 * i]), std::abs(s.samples[2 * i + 1])});
  return most;
}

double seconds_of(const Sound& s) { return static_cast<double>(s.samples.size()) / 2 / s.sample_rate; }

/// How much of a tone is in a stretch.
double share_of(const Sound& s, double hertz, double from_s, double to_s) {
  double re = 0;
  double im = 0;
  for (auto i = static_cast<std::size_t>(from_s * s.sample_rate);
       i < static_cast<std::size_t>(to_s * s.sample_rate); ++i) {
    const double angle = 2 * std::acos(-1.0) * hertz * static_cast<double>(i) / s.sample_rate;
    const double sample = static_cast<double>(s.samples[2 * i]) + s.samples[2 * i + 1];
    re += sample * std::cos(angle);
    im += sample * std::sin(angle);
  }
  return std::hypot(re, im);
}

/// A tracing made by hand.
Tracing tracing_of(std::vector<Branch> branches) {
  Tracing t;
  t.window = {0, 1, 0, 1};
  t.branches = std::move(branches);
  return t;
}

Branch line(std::vector<CurvePoint> points, int statement = 0) {
  Branch b;
  b.statement = statement;
  b.points = std::move(points);
  return b;
}

TEST(Cue, TellsHeightPlaceSignAndNearness) {
  const Window w{-2, 2, -1, 3};
  EXPECT_NEAR(cue_at({0.5, 0}, w, 1).hertz, 200, 1e-9);
  EXPECT_NEAR(cue_at({0.5, 0.5}, w, 1).hertz, 200 * std::sqrt(5), 1e-9);
  EXPECT_NEAR(cue_at({0.5, 1}, w, 1).hertz, 1000, 1e-9);
  EXPECT_NEAR(cue_at({0.5, 1.3}, w, 1).hertz, 1000, 1e-9);
  EXPECT_NEAR(cue_at({0.5, -0.3}, w, 1).hertz, 200, 1e-9);
  EXPECT_EQ(cue_at({0.25, 0.5}, w, 1).pan, -0.5);
  EXPECT_EQ(cue_at({1.3, 0.5}, w, 1).pan, 1);
  EXPECT_EQ(cue_at({-0.3, 0.5}, w, 1).pan, -1);
  // y = 0 is a quarter of the way up.
  EXPECT_EQ(cue_at({0.5, 0.25}, w, 1).noise, 0);
  EXPECT_EQ(cue_at({0.5, 0.249}, w, 1).noise, 0.35);
  EXPECT_EQ(cue_at({0.5, 0.5}, w, 0.3).loudness, 0.3);
  EXPECT_EQ(cue_at({0.5, 0.5}, w, 1.3).loudness, 1);
  EXPECT_EQ(cue_at({0.5, 0.5}, w, -1).loudness, 0);
  SoundSettings s;
  s.lowest_hz = 100;
  s.highest_hz = 400;
  EXPECT_NEAR(cue_at({0.5, 0.5}, w, 1, s).hertz, 200, 1e-9);
}

TEST(Sweep, TakesItsTimeForEachCurveWithAPauseBetween) {
  SoundSettings settings;
  settings.seconds = 1;
  const Sound one = swept("y = 0.5", {0, 1, 0, 1}, settings);
  EXPECT_EQ(one.sample_rate, kRate);
  EXPECT_NEAR(seconds_of(one), 1.1, 1e-3);
  EXPECT_GT(loudest(one, 0.95, 0.99), 0.2);
  EXPECT_EQ(loudest(one, 1.001, 1.1), 0) << "an end in silence";
  const Sound two = swept("y = 0.5; y = 0.25", {0, 1, 0, 1}, settings);
  EXPECT_NEAR(seconds_of(two), 2.6, 1e-3);
  EXPECT_GT(loudest(two, 0.9, 1), 0.2);
  EXPECT_EQ(loudest(two, 1.001, 1.499), 0);
  EXPECT_GT(loudest(two, 1.51, 1.6), 0.2);
  // A curve that is nowhere in the window takes no time.
  const Sound hidden = swept("y = 5; y = 0.25", {0, 1, 0, 1}, settings);
  EXPECT_NEAR(seconds_of(hidden), 1.1, 1e-3);
  EXPECT_NEAR(seconds_of(swept("y = 5", {0, 1, 0, 1}, settings)), 0.1, 1e-3);
}

TEST(Sweep, IsTheVoiceAtTheCueOfEveryPlace) {
  // A level line: the same cue but for the side. The click at its entry is over after 12 ms.
  SoundSettings settings;
  settings.seconds = 0.5;
  settings.volume = 0.8;
  const Window window{0, 1, 0, 1};
  const Sound sound = swept("y = 0.5", window, settings);
  Voice voice(kRate);
  const double per_step = kRate / 200.0;
  for (int i = 0; i < kRate / 2; ++i) {
    // Between steps of 5 ms, each the middle of a hundredth, the place is joined by a straight line.
    const double u = std::min(i / per_step, 99.0) / 100 + 0.005;
    const StereoSample wanted = voice.next(cue_at({u, 0.5}, window, 1, settings), false);
    if (i < 600) continue;
    ASSERT_NEAR(sound.samples[2 * static_cast<std::size_t>(i)], 0.8 * wanted.left, 2e-4) << i;
    ASSERT_NEAR(sound.samples[2 * static_cast<std::size_t>(i) + 1], 0.8 * wanted.right, 2e-4) << i;
  }
}

TEST(Sweep, ClicksWhereACurveBeginsAndEnds) {
  SoundSettings settings;
  settings.seconds = 2;
  // Defined in the middle half only.
  const Sound sound = swept("y = sqrt(1 - 4x^2)^2 + 0.25", {-1, 1, -1, 2}, settings);
  EXPECT_EQ(loudest(sound, 0, 0.49), 0);
  EXPECT_GT(loudest(sound, 0.5, 0.52), 0.02);
  // After the end the tone is gone within milliseconds, and the click with it.
  EXPECT_GT(loudest(sound, 1.5, 1.512), 0.01);
  EXPECT_EQ(loudest(sound, 1.57, 1.99), 0);
}

TEST(Sweep, OutsideTheWindowNothingIsHeard) {
  SoundSettings settings;
  settings.seconds = 1;
  // Leaves the window at the top at x = 1/2.
  const Sound sound = swept("y = 2x", {0, 1, 0, 1}, settings);
  EXPECT_GT(loudest(sound, 0.4, 0.5), 0.2);
  EXPECT_EQ(loudest(sound, 0.58, 1), 0);
  const Sound below = swept("y = 2x - 1", {0, 1, 0, 1}, settings);
  EXPECT_EQ(loudest(below, 0, 0.48), 0);
  EXPECT_GT(loudest(below, 0.55, 0.9), 0.2);
}

TEST(Sweep, ADenseBandTrembles) {
  // Level, with a band over the middle: there the loudness goes up and down.
  const Plot plot = read("y = 0.5");
  Tracing tracing = tracing_of({line({{0, 0.5, 0}, {1, 0.5, 1}})});
  for (int i = 40; i <= 60; ++i) tracing.bars.push_back({0, {i / 100.0, 0.4}, {i / 100.0, 0.6}});
  tracing.bars.push_back({1, {0.2, 0.4}, {0.2, 0.6}});
  SoundSettings settings;
  settings.earcons = false;
  const auto sound = sweep(plot, tracing, {}, settings);
  ASSERT_TRUE(sound);
  const auto least = [&](double from, double to) {
    double low = 1;
    for (double t = from; t < to; t += 0.01) low = std::min(low, loudest(*sound, t, t + 0.006));
    return low;
  };
  EXPECT_LT(least(1.7, 2.3), 0.5 * least(0.5, 1.5));
  EXPECT_NEAR(least(0.5, 1.5), least(2.6, 3.8), 0.05) << "the bar of another curve does not count";
}

TEST(Sweep, CurvesWithoutAFunctionArePlayedAlongEveryPieceTheLowestFirst) {
  const Plot plot = read("x^2 + y^2 = 1");
  SoundSettings settings;
  settings.seconds = 1;
  settings.earcons = false;
  // Three times as long a piece takes three times as long; the lower one of one height comes first.
  const Tracing tracing = tracing_of({line({{0.1, 0.9, 0}, {0.5, 0.9, 0}, {0.85, 0.9, 0}}),
                                      line({{0.5, 0.1, 0}, {0.75, 0.1, 0}}), line({{0.2, 0.2, 0}})});
  const auto sound = sweep(plot, tracing, {}, settings);
  ASSERT_TRUE(sound);
  // 0.25 s and 0.75 s, each with two steps of 5 ms more and 80 ms of silence behind, then 0.1 s.
  EXPECT_NEAR(seconds_of(*sound), 1.02 + 0.16 + 0.1, 2e-3);
  const double low = 200 * std::pow(5, 0.1);
  const double high = 200 * std::pow(5, 0.9);
  EXPECT_GT(share_of(*sound, low, 0.05, 0.2), 5 * share_of(*sound, high, 0.05, 0.2));
  EXPECT_GT(share_of(*sound, high, 0.5, 0.9), 5 * share_of(*sound, low, 0.5, 0.9));
  EXPECT_EQ(loudest(*sound, 0.262, 0.338), 0);
  EXPECT_GT(loudest(*sound, 0.35, 0.4), 0.1);
  // From left to right as the points go: at the start of the second piece on the left.
  const auto side = [&](double t, std::size_t channel) {
    double power = 0;
    const auto from = static_cast<std::size_t>(t * kRate);
    for (std::size_t i = from; i < from + 1'000; ++i)
      power += std::pow(static_cast<double>(sound->samples[2 * i + channel]), 2);
    return power;
  };
  // A tenth from the left side a quarter turn gives cos^2(0.05 pi) to the left.
  EXPECT_NEAR(side(0.37, 0) / (side(0.37, 0) + side(0.37, 1)), std::pow(std::cos(0.06 * 3.14159), 2), 0.03);
  const double u = 0.1 + 0.75 * (0.8 - 0.34) / 0.76;
  EXPECT_NEAR(side(0.8 - 0.011, 0) / (side(0.8 - 0.011, 0) + side(0.8 - 0.011, 1)),
              std::pow(std::cos(u * std::acos(-1.0) / 2), 2), 0.03);
}

TEST(Sweep, OfPiecesOutsideTheWindowNothingIsHeardAndPointsTakeNoTime) {
  const Plot plot = read("x^2 + y^2 = 1");
  SoundSettings settings;
  settings.seconds = 1;
  const Tracing tracing = tracing_of({line({{0, 0.5, 0}, {2, 0.5, 0}})});
  const auto sound = sweep(plot, tracing, {}, settings);
  ASSERT_TRUE(sound);
  EXPECT_GT(loudest(*sound, 0.1, 0.5), 0.2);
  EXPECT_EQ(loudest(*sound, 0.6, 1), 0);
  Tracing points = tracing_of({});
  points.dots.push_back({0, {0.5, 0.5}});
  EXPECT_NEAR(seconds_of(*sweep(plot, points, {}, settings)), 0.1, 1e-3);
}

TEST(Sweep, PointsOfInterestHaveTheirSignsAtTheirTimeAndPlace) {
  const Plot plot = read("y = 0.5");
  const Tracing tracing = tracing_of({line({{0, 0.5, 0}, {1, 0.5, 1}})});
  SoundSettings settings;
  settings.seconds = 1;
  settings.volume = 0.4;
  PointOfInterest hole;
  hole.kind = PointKind::hole;
  hole.x = 0.25;
  PointOfInterest other = hole;
  other.statement = 1;
  other.x = 0.6;
  PointOfInterest nowhere = hole;
  nowhere.x = std::numeric_limits<double>::quiet_NaN();
  const auto with = sweep(plot, tracing, {hole, other, nowhere}, settings);
  settings.earcons = false;
  const auto without = sweep(plot, tracing, {hole}, settings);
  ASSERT_TRUE(with && without);
  ASSERT_EQ(with->samples.size(), without->samples.size());
  Earcon earcon(PointKind::hole, -0.5, kRate);
  const std::size_t start = kRate / 4;
  for (std::size_t i = 0; i < with->samples.size() / 2; ++i) {
    const StereoSample sign = i >= start ? earcon.next() : StereoSample{};
    ASSERT_NEAR(with->samples[2 * i] - without->samples[2 * i], 0.4 * sign.left, 1e-6) << i;
    ASSERT_NEAR(with->samples[2 * i + 1] - without->samples[2 * i + 1], 0.4 * sign.right, 1e-6) << i;
  }
  EXPECT_TRUE(earcon.is_over());
}

TEST(Sweep, ASignAtTheEndOfTheSoundIsHeardToItsEnd) {
  const Plot plot = read("y = 0.5");
  const Tracing tracing = tracing_of({line({{0, 0.5, 0}, {1, 0.5, 1}})});
  SoundSettings settings;
  settings.seconds = 0.2;
  PointOfInterest end;
  end.kind = PointKind::end;
  end.x = 1;
  const auto sound = sweep(plot, tracing, {end}, settings);
  ASSERT_TRUE(sound);
  Earcon earcon(PointKind::end, 1, settings.sample_rate);
  std::size_t count = 0;
  for (; !earcon.is_over(); ++count) (void)earcon.next();
  // 0.2 s of the curve, the sign that begins at its end, and 0.1 s of silence.
  EXPECT_NEAR(seconds_of(*sound), 0.3 + static_cast<double>(count) / settings.sample_rate, 1e-3);
}

TEST(Sweep, RefusesSettingsOutOfRangeAndTakesThoseOnItsEnds) {
  const Plot plot = read("y = 0.5");
  const Tracing tracing = tracing_of({line({{0, 0.5, 0}, {1, 0.5, 1}})});
  const auto good = [&](const SoundSettings& s) { return sweep(plot, tracing, {}, s).has_value(); };
  //                     rate     s    low   high  volume
  EXPECT_TRUE(good({8'000, 0.2, 200, 1'000, 0.5, true}));
  EXPECT_FALSE(good({7'999, 0.2, 200, 1'000, 0.5, true}));
  EXPECT_TRUE(good({192'000, 0.2, 200, 1'000, 0.5, true}));
  EXPECT_FALSE(good({192'001, 0.2, 200, 1'000, 0.5, true}));
  EXPECT_FALSE(good({44'100, 0.19, 200, 1'000, 0.5, true}));
  EXPECT_TRUE(good({8'000, 60, 200, 1'000, 0.5, true}));
  EXPECT_FALSE(good({8'000, 61, 200, 1'000, 0.5, true}));
  EXPECT_TRUE(good({44'100, 0.2, 0.5, 1'000, 0.5, true}));
  EXPECT_FALSE(good({44'100, 0.2, 0, 1'000, 0.5, true}));
  EXPECT_FALSE(good({44'100, 0.2, 300, 300, 0.5, true}));
  EXPECT_TRUE(good({8'000, 0.2, 200, 3'999, 0.5, true}));
  EXPECT_FALSE(good({8'000, 0.2, 200, 4'000, 0.5, true})) << "half the rate cannot be played";
  EXPECT_TRUE(good({44'100, 0.2, 200, 1'000, 0, true}));
  EXPECT_FALSE(good({44'100, 0.2, 200, 1'000, -0.1, true}));
  EXPECT_TRUE(good({44'100, 0.2, 200, 1'000, 1, true}));
  EXPECT_FALSE(good({44'100, 0.2, 200, 1'000, 1.1, true}));
}

TEST(Sweep, ToneSignAndClickTogetherStayWithinTheRange) {
  const Plot plot = read("y = 0.5");
  const Tracing tracing = tracing_of({line({{0, 0.5, 0}, {1, 0.5, 1}})});
  SoundSettings settings;
  settings.seconds = 0.5;
  settings.volume = 1;
  PointOfInterest zero;
  zero.x = 0.2;
  const auto sound = sweep(plot, tracing, std::vector<PointOfInterest>(6, zero), settings);
  ASSERT_TRUE(sound);
  EXPECT_EQ(loudest(*sound, 0, 0.5), 1);
}

TEST(WavFile, HoldsTheSamplesInSixteenBitsAndStereo) {
  const auto file = std::filesystem::path(testing::TempDir()) / "nazori_sweep_test.wav";
  Sound sound;
  sound.sample_rate = 22'050;
  for (int i = 0; i < 1'000; ++i) {
    sound.samples.push_back(static_cast<float>(std::sin(0.1 * i)));
    sound.samples.push_back(static_cast<float>(i % 100) / 200.0F - 0.5F);
  }
  ASSERT_TRUE(save_wav(sound, file));
  EXPECT_EQ(std::filesystem::file_size(file), 44U + 4'000U);
  SF_INFO info{};
  SNDFILE* wav = sf_open(file.c_str(), SFM_READ, &info);
  ASSERT_NE(wav, nullptr);
  EXPECT_EQ(info.samplerate, 22'050);
  EXPECT_EQ(info.channels, 2);
  EXPECT_EQ(info.frames, 1'000);
  EXPECT_EQ(info.format, SF_FORMAT_WAV | SF_FORMAT_PCM_16);
  std::vector<float> back(2'000);
  EXPECT_EQ(sf_readf_float(wav, back.data(), 1'000), 1'000);
  sf_close(wav);
  for (std::size_t i = 0; i < back.size(); ++i) ASSERT_NEAR(back[i], sound.samples[i], 6.2e-5) << i;
  std::filesystem::remove(file);
  EXPECT_FALSE(save_wav(sound, "/no such folder/sound.wav"));
  EXPECT_FALSE(save_wav({0, {0, 0}}, file)) << "no rate";
}

}  // namespace
}  // namespace nazori::functions
