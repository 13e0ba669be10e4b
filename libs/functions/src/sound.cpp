// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/sound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "arcs.h"
#include "nazori/functions/curve_kinds.h"
#include "voice.h"

namespace nazori::functions {
namespace {

constexpr double kStepsPerSecond = 200;
constexpr double kGapSeconds = 0.5;
constexpr double kClickSeconds = 0.012;
constexpr double kNoiseBelowZero = 0.35;

/// One moment of a sweep.
struct Moment {
  PlatePoint at;
  bool audible = false;
  bool dense = false;
};

class Synthesizer {
 public:
  explicit Synthesizer(const SoundSettings& settings, const Window& window)
      : settings_(settings), window_(window), voice_(settings.sample_rate) {
    sound_.sample_rate = settings.sample_rate;
  }

  void silence(double seconds) {
    sound_.samples.resize(
        sound_.samples.size() + 2 * static_cast<std::size_t>(seconds * settings_.sample_rate), 0.0F);
  }

  [[nodiscard]] std::size_t position() const { return sound_.samples.size() / 2; }

  void play(const std::vector<Moment>& moments) {
    if (moments.empty()) return;
    const double per_step = settings_.sample_rate / kStepsPerSecond;
    const auto count = static_cast<std::size_t>(per_step * static_cast<double>(moments.size()));
    bool before = false;
    const std::size_t start = position();
    for (std::size_t i = 0; i < count; ++i) {
      const double exact = static_cast<double>(i) / per_step;
      const std::size_t k = std::min(moments.size() - 1, static_cast<std::size_t>(exact));
      Moment m = moments[k];
      if (m.audible && k + 1 < moments.size() && moments[k + 1].audible) {
        const double share = exact - static_cast<double>(k);
        m.at.u += (moments[k + 1].at.u - m.at.u) * share;
        m.at.v += (moments[k + 1].at.v - m.at.v) * share;
      }
      if (m.audible != before) clicks_.push_back(start + i);
      before = m.audible;
      const StereoSample s = voice_.next(cue_at(m.at, window_, m.audible ? 1 : 0, settings_), m.dense);
      sound_.samples.push_back(static_cast<float>(s.left * settings_.volume));
      sound_.samples.push_back(static_cast<float>(s.right * settings_.volume));
    }
  }

  /// Adds an earcon to the existing samples.
  void mark(std::size_t at, PointKind kind, double pan) {
    Earcon earcon(kind, pan, settings_.sample_rate);
    while (!earcon.is_over()) {
      // A sign at the right border is heard to its end.
      while (position() <= at) sound_.samples.insert(sound_.samples.end(), 2, 0.0F);
      add(at++, earcon.next());
    }
  }

  Sound finish() {
    for (const std::size_t at : clicks_) {
      const auto n = static_cast<std::size_t>(kClickSeconds * settings_.sample_rate);
      for (std::size_t i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(n);
        add(at + i, panned(0.2 * (1 - t) * std::sin(60 * t), 0));
      }
    }
    for (float& s : sound_.samples) s = std::clamp(s, -1.0F, 1.0F);
    return std::move(sound_);
  }

 private:
  void add(std::size_t at, const StereoSample& s) {
    if (2 * at + 1 >= sound_.samples.size()) return;
    sound_.samples[2 * at] += static_cast<float>(s.left * settings_.volume);
    sound_.samples[2 * at + 1] += static_cast<float>(s.right * settings_.volume);
  }

  SoundSettings settings_;
  Window window_;
  Voice voice_;
  Sound sound_;
  std::vector<std::size_t> clicks_;
};

class Sweeper {
 public:
  Sweeper(const Plot& plot, const Tracing& tracing, const std::vector<PointOfInterest>& points,
          const SoundSettings& settings)
      : plot_(plot),
        tracing_(tracing),
        points_(points),
        settings_(settings),
        synthesizer_(settings, tracing.window) {}

  Sound run() {
    bool first = true;
    for (std::size_t i = 0; i < plot_.statements.size(); ++i) {
      // A curve that is not shown, or nowhere in the window, makes no sound.
      if (!is_shown(static_cast<int>(i))) continue;
      if (!first) synthesizer_.silence(kGapSeconds);
      first = false;
      const Statement& s = plot_.statements[i];
      if (curve_kind(s.kind).is_graph_of_x()) {
        across(s, static_cast<int>(i));
      } else {
        along(static_cast<int>(i));
      }
    }
    synthesizer_.silence(0.1);
    return synthesizer_.finish();
  }

 private:
  /// y = f(x): equal time for equal x.
  void across(const Statement& s, int statement) {
    const Tape tape = Tape::compile(std::array{s.terms[0]}, std::array{Variable::x});
    std::vector<double> registers(tape.size());
    const Window& w = tracing_.window;
    const auto count = static_cast<std::size_t>(settings_.seconds * kStepsPerSecond);
    std::vector<Moment> moments(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double u = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
      tape.evaluate<double>(std::array{w.x(u)}, registers);
      const double v = w.v(registers[tape.output(0)]);
      moments[k] = {{u, v}, std::isfinite(v) && v >= -0.02 && v <= 1.02, is_dense(u, statement)};
    }
    const std::size_t start = synthesizer_.position();
    synthesizer_.play(moments);
    if (!settings_.earcons) return;
    for (const PointOfInterest& p : points_) {
      if (p.statement != statement || std::isnan(p.x)) continue;
      const double u = w.u(p.x);
      synthesizer_.mark(start + static_cast<std::size_t>(std::clamp(u, 0.0, 1.0) * settings_.seconds *
                                                         settings_.sample_rate),
                        p.kind, 2 * u - 1);
    }
  }

  [[nodiscard]] bool is_shown(int statement) const {
    const auto owned = [statement](const auto& part) { return part.statement == statement; };
    return std::any_of(tracing_.branches.begin(), tracing_.branches.end(), owned) ||
           std::any_of(tracing_.bars.begin(), tracing_.bars.end(), owned) ||
           std::any_of(tracing_.dots.begin(), tracing_.dots.end(), owned);
  }

  [[nodiscard]] bool is_dense(double u, int statement) const {
    return std::any_of(tracing_.bars.begin(), tracing_.bars.end(), [&](const Bar& b) {
      return b.statement == statement && std::abs(b.from.u - u) < 0.004;
    });
  }

  /// Every branch from end to end, equal time for equal length; the lower ones first.
  void along(int statement) {
    std::vector<const Branch*> branches;
    double total = 0;
    const auto length_of = [](const Branch& b) {
      double length = 0;
      for (std::size_t i = 0; i + 1 < b.points.size(); ++i)
        length += std::hypot(b.points[i + 1].u - b.points[i].u, b.points[i + 1].v - b.points[i].v);
      return length;
    };
    const auto lowest = [](const Branch* b) {
      double v = std::numeric_limits<double>::infinity();
      for (const CurvePoint& p : b->points) v = std::min(v, p.v);
      return v;
    };
    for (const Branch& b : tracing_.branches) {
      if (b.statement != statement || b.points.size() < 2) continue;
      branches.push_back(&b);
      total += length_of(b);
    }
    if (total == 0) return;
    std::stable_sort(branches.begin(), branches.end(),
                     [&](const Branch* a, const Branch* b) { return lowest(a) < lowest(b); });
    for (const Branch* b : branches) {
      const double length = length_of(*b);
      const auto count = static_cast<std::size_t>(settings_.seconds * length / total * kStepsPerSecond) + 2;
      std::vector<Moment> moments;
      std::size_t piece = 0;
      double walked = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const double goal = length * static_cast<double>(k) / static_cast<double>(count - 1);
        const auto piece_length = [&] {
          return std::hypot(b->points[piece + 1].u - b->points[piece].u,
                            b->points[piece + 1].v - b->points[piece].v);
        };
        while (piece + 2 < b->points.size() && walked + piece_length() < goal)
          walked += piece_length(), ++piece;
        const double share = piece_length() > 0 ? std::clamp((goal - walked) / piece_length(), 0.0, 1.0) : 0;
        const CurvePoint& p = b->points[piece];
        const CurvePoint& q = b->points[piece + 1];
        const PlatePoint at{p.u + (q.u - p.u) * share, p.v + (q.v - p.v) * share};
        moments.push_back({at, at.u >= -0.02 && at.u <= 1.02 && at.v >= -0.02 && at.v <= 1.02, false});
      }
      synthesizer_.play(moments);
      synthesizer_.silence(0.08);
    }
  }

  const Plot& plot_;
  const Tracing& tracing_;
  const std::vector<PointOfInterest>& points_;
  SoundSettings settings_;
  Synthesizer synthesizer_;
};

}  // namespace

Cue cue_at(PlatePoint at, const Window& window, double nearness, const SoundSettings& settings) {
  Cue cue;
  const double v = std::clamp(at.v, 0.0, 1.0);
  cue.hertz = settings.lowest_hz * std::pow(settings.highest_hz / settings.lowest_hz, v);
  cue.pan = std::clamp(2 * at.u - 1, -1.0, 1.0);
  cue.noise = window.y(at.v) < 0 ? kNoiseBelowZero : 0;
  cue.loudness = std::clamp(nearness, 0.0, 1.0);
  return cue;
}

base::Result<Sound> sweep(const Plot& plot, const Tracing& tracing,
                          const std::vector<PointOfInterest>& points, const SoundSettings& s) {
  const bool good = s.sample_rate >= 8000 && s.sample_rate <= 192'000 && s.seconds >= 0.2 &&
                    s.seconds <= 60 && s.lowest_hz > 0 && s.highest_hz > s.lowest_hz &&
                    s.highest_hz < s.sample_rate / 2.0 && s.volume >= 0 && s.volume <= 1;
  if (!good) return base::fail(base::Errc::bad_argument, "a setting of the sound is out of range", "sound");
  return Sweeper(plot, tracing, points, s).run();
}

}  // namespace nazori::functions
