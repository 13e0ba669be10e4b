// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/motion_remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "explanation_texts.h"
#include "model_inside.h"

namespace nazori::writing {
namespace {

constexpr double kLongRest_s = 0.4;   // shorter ones belong to corners and to the beginning of a hook
constexpr double kAtAnEnd_s = 0.05;   // a rest this near to either end is the pen coming down or stopping
constexpr int kFluentMoves = 4;       // of a straight stroke, written with care
constexpr int kMovesPerTurn = 3;      // for each quarter turn of the model
constexpr double kStillMoving = 1.0;  // of the mean speed: certainly not stopped
constexpr double kAtRest = 0.15;      // and certainly not swept
constexpr double kVaries = 0.08;      // smallest range of pressures that counts as varying
constexpr double kStillHeavy = 0.85;  // of the mean pressure
constexpr double kFaded = 0.35;

/// An eighth of a turn due to trembling does not count.
int quarter_turns(const Samples& s) {
  double sum = 0;
  constexpr std::size_t kReach = 3;
  for (std::size_t k = kReach; k + kReach < kSamples; k += kReach) {
    const double ax = static_cast<double>(s.x[k] - s.x[k - kReach]);
    const double ay = static_cast<double>(s.y[k] - s.y[k - kReach]);
    const double bx = static_cast<double>(s.x[k + kReach] - s.x[k]);
    const double by = static_cast<double>(s.y[k + kReach] - s.y[k]);
    sum += std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by));
  }
  return static_cast<int>(std::lround(sum / (std::numbers::pi / 2)));
}

double longest_rest_s(const PenMotion& motion) {
  double longest_s = 0;
  for (const auto& pause : motion.pauses) {
    const bool within =
        pause.start_s > kAtAnEnd_s && pause.start_s + pause.duration_s < motion.duration_s - kAtAnEnd_s;
    if (within) longest_s = std::max(longest_s, pause.duration_s);
  }
  return longest_s;
}

std::optional<MotionRemarkKind> ending_remark(const PenMotion& motion, kanji::StrokeEnding ending,
                                              bool kicks) {
  const bool timed = motion.speed_peaks > 0;
  const bool pressed = motion.pressure && motion.pressure_at_end && motion.pressure_range >= kVaries;
  const double left = pressed ? *motion.pressure_at_end / std::max(*motion.pressure, 1e-6) : 0;
  switch (ending) {
    case kanji::StrokeEnding::stop:
      if (timed && motion.speed_at_end > kStillMoving) return MotionRemarkKind::not_stopped;
      if (pressed && left < kFaded) return MotionRemarkKind::light_end;
      break;
    case kanji::StrokeEnding::taper:
      if (timed && motion.speed_at_end < kAtRest && !(pressed && left < kFaded))
        return MotionRemarkKind::not_swept;
      if (pressed && left > kStillHeavy) return MotionRemarkKind::heavy_end;
      break;
    case kanji::StrokeEnding::hook:
      if (kicks && timed && motion.speed_at_end < kAtRest && !(pressed && left < kFaded))
        return MotionRemarkKind::kick_held;
      break;
    case kanji::StrokeEnding::either:
      break;
  }
  return std::nullopt;
}

Text text_of(MotionRemarkKind kind) {
  switch (kind) {
    case MotionRemarkKind::paused:
      return Text::paused;
    case MotionRemarkKind::hesitant:
      return Text::hesitant;
    case MotionRemarkKind::not_stopped:
      return Text::not_stopped;
    case MotionRemarkKind::not_swept:
      return Text::not_swept;
    case MotionRemarkKind::kick_held:
      return Text::kick_held;
    case MotionRemarkKind::heavy_end:
      return Text::heavy_end;
    case MotionRemarkKind::light_end:
      return Text::light_end;
  }
  return Text::paused;
}

/// "stroke 2", "strokes 1, 5 and 6"; "1・5・6画目".
std::string names_of(std::span<const int> strokes, Language language) {
  if (language == Language::japanese) return fmt::format("{}画目", fmt::join(strokes, "・"));
  if (strokes.size() == 1) return fmt::format("stroke {}", strokes.front());
  return fmt::format("strokes {} and {}", fmt::join(strokes.first(strokes.size() - 1), ", "), strokes.back());
}

bool is_of_flow(const MotionRemark& remark) {
  return remark.kind == MotionRemarkKind::paused || remark.kind == MotionRemarkKind::hesitant;
}

}  // namespace

std::vector<MotionRemark> motion_remarks(std::span<const PenMotion> motions, const Grade& grade,
                                         const Model& model) {
  std::vector<MotionRemark> remarks;
  const auto& inside = model.inside();
  const auto variant = std::find_if(inside.variants.begin(), inside.variants.end(),
                                    [&grade](const Form& form) { return form.variant == grade.variant; });
  const Form& form = grade.variant.empty() || variant == inside.variants.end() ? inside.main : *variant;
  for (std::size_t i = 0; i < std::min(motions.size(), grade.strokes.size()); ++i) {
    const auto& verdict = grade.strokes[i];
    const auto& motion = motions[i];
    if (!verdict.matched || static_cast<std::size_t>(*verdict.matched) >= form.shapes.size()) continue;
    const auto j = static_cast<std::size_t>(*verdict.matched);
    const int stroke = static_cast<int>(i);
    const int fluent = kFluentMoves + kMovesPerTurn * quarter_turns(form.shapes[j].whole);
    if (const double rest_s = longest_rest_s(motion); rest_s >= kLongRest_s)
      remarks.push_back({MotionRemarkKind::paused, stroke, *verdict.matched, rest_s});
    else if (motion.speed_peaks > fluent)
      remarks.push_back(
          {MotionRemarkKind::hesitant, stroke, *verdict.matched, static_cast<double>(motion.speed_peaks)});
    if (!verdict.ok || form.free_ending[j] != 0) continue;
    if (const auto kind = ending_remark(motion, form.endings[j], form.shapes[j].kicked))
      remarks.push_back({*kind, stroke, *verdict.matched, 0});
  }
  return remarks;
}

std::vector<std::string> explain(std::span<const MotionRemark> remarks, Language language) {
  std::vector<std::string> sentences;
  std::vector<MotionRemarkKind> kinds;
  for (const auto& first : remarks) {
    if (std::find(kinds.begin(), kinds.end(), first.kind) != kinds.end()) continue;
    kinds.push_back(first.kind);
    std::vector<int> strokes;
    double most = 0;
    for (const auto& remark : remarks) {
      if (remark.kind != first.kind) continue;
      strokes.push_back(remark.model + 1);
      most = std::max(most, remark.amount);
    }
    sentences.push_back(fmt::format(fmt::runtime(text(text_of(first.kind), language)),
                                    names_of(strokes, language), fmt::format("{:.1f}", most)));
  }
  return sentences;
}

std::string explain_pace(std::span<const PenMotion> motions, std::span<const MotionRemark> remarks,
                         Language language) {
  double duration_s = 0;
  for (const auto& m : motions) duration_s += m.duration_s + m.pause_before_s;
  if (!(duration_s > 0)) return {};
  const auto all = static_cast<int>(motions.size());
  const auto halting = std::count_if(remarks.begin(), remarks.end(), is_of_flow);
  return fmt::format(fmt::runtime(text(Text::pace, language)), fmt::format("{:.1f}", duration_s),
                     all - static_cast<int>(halting), all);
}

}  // namespace nazori::writing
