// SPDX-License-Identifier: Apache-2.0
// Judging each stroke as it is written: what was told of a stroke is not taken back when others come.
#include <algorithm>
#include <utility>

#include "grade_shapes.h"
#include "judgement.h"
#include "probability.h"

namespace nazori::writing {
namespace {

/// Whether the stroke is one of the model's, if perhaps out of turn, backwards or with another ending.
bool is_a_stroke_of_its_own(int stroke, const Grade& whole) {
  return std::none_of(whole.mistakes.begin(), whole.mistakes.end(), [stroke](const Mistake& f) {
    return f.stroke == stroke && f.kind != kanji::MistakeKind::missing &&
           f.kind != kanji::MistakeKind::order && f.kind != kanji::MistakeKind::reversed &&
           f.kind != kanji::MistakeKind::ending;
  });
}

bool is_warning_of_the_moment(const Mistake& mistake) {
  return mistake.kind == kanji::MistakeKind::order && !mistake.second;
}

/// A stroke that was told right does not become the one too many because of a stroke written after it: that
/// is the newest then. @return whether it is.
bool blame_the_newest(Grade& now, const Grade& told) {
  const int newest = static_cast<int>(now.strokes.size()) - 1;
  const auto extra = std::find_if(now.mistakes.begin(), now.mistakes.end(), [&](const Mistake& f) {
    return f.kind == kanji::MistakeKind::extra && f.stroke != newest &&
           told.strokes[static_cast<std::size_t>(f.stroke)].ok;
  });
  const bool is_told = std::any_of(now.mistakes.begin(), now.mistakes.end(), [newest](const Mistake& f) {
    return f.stroke == newest || f.second == newest;
  });
  if (extra == now.mistakes.end() || is_told) return false;
  std::swap(now.strokes[static_cast<std::size_t>(extra->stroke)], now.strokes.back());
  extra->stroke = newest;
  return true;
}

/// What is said of strokes judged one by one once all of them are known: the whole tells better what a stroke
/// that was not right is (two in one, say), and only it what is missing.
void finish_live(Grade& live, const Grade& whole) {
  // A stroke that was too early either has its exchange in the whole, or what it passed over is missing
  // there.
  for (const auto& f : live.mistakes) {
    const auto names_it = [&f](const Mistake& other) {
      return other.kind != kanji::MistakeKind::missing &&
             (other.stroke == f.stroke || other.second == f.stroke);
    };
    if (is_warning_of_the_moment(f) && std::none_of(whole.mistakes.begin(), whole.mistakes.end(), names_it))
      live.strokes[static_cast<std::size_t>(f.stroke)].ok = true;
  }
  std::erase_if(live.mistakes, is_warning_of_the_moment);
  if (whole.accepted) return;
  const auto touch = [](const Mistake& a, const Mistake& b) {
    const auto both_have = [&b](int stroke) { return b.stroke == stroke || b.second == stroke; };
    return both_have(a.stroke) || (a.second && both_have(*a.second));
  };
  std::erase_if(live.mistakes, [&](const Mistake& before) {
    return std::any_of(whole.mistakes.begin(), whole.mistakes.end(), [&](const Mistake& f) {
      return f.kind != kanji::MistakeKind::missing && touch(before, f);
    });
  });
  live.mistakes.insert(live.mistakes.end(), whole.mistakes.begin(), whole.mistakes.end());
  std::stable_sort(live.mistakes.begin(), live.mistakes.end(),
                   [](const Mistake& a, const Mistake& b) { return a.stroke < b.stroke; });
}

}  // namespace

base::Result<Grade> grade_live(const WrittenCharacter& ink, const Model& model, const GradeOptions& options,
                               std::span<const Model> lookalikes) {
  const auto p = prepare(ink, options);
  if (!p) return tl::unexpected(p.error());
  const std::span<const Shape> drawn(p->drawn);
  const auto whole = grade_shapes(drawn, p->box, model.inside(), options, lookalikes);
  auto live = whole;
  live.mistakes.clear();
  auto beginning = options;
  beginning.unfinished = true;
  for (std::size_t n = 1; n <= drawn.size(); ++n) {
    auto now = grade_shapes(drawn.first(n), p->box, model.inside(), beginning, {});
    const bool is_extra = blame_the_newest(now, live);
    const int stroke = static_cast<int>(n) - 1;
    auto& verdict = live.strokes[n - 1];
    const auto in_the_whole = verdict.matched;
    verdict = now.strokes.back();
    // Which stroke a first bar is shows only when the others are there.
    if (in_the_whole && !is_extra && is_a_stroke_of_its_own(stroke, whole)) verdict.matched = in_the_whole;
    bool is_blamed = false;
    for (auto& f : now.mistakes) {
      if (f.stroke != stroke && f.second != stroke) continue;
      if (is_warning_of_the_moment(f) && verdict.matched != f.model.front()) continue;
      // Once is enough for a stroke drawn too early, however many come after it; and those that come late
      // are what it was told to wait for.
      const bool said = f.kind == kanji::MistakeKind::order &&
                        std::any_of(live.mistakes.begin(), live.mistakes.end(), [&f](const Mistake& before) {
                          return before.kind == kanji::MistakeKind::order && before.stroke == f.stroke;
                        });
      if (said) continue;
      is_blamed = true;
      live.mistakes.push_back(std::move(f));
    }
    if (!is_blamed && verdict.matched) verdict.ok = true;
  }
  if (!options.unfinished) finish_live(live, whole);
  live.accepted = live.mistakes.empty();
  if (!live.accepted) live.form.reset();
  if (!live.accepted && whole.accepted)
    live.probability = probability_of(live, kJustBeyond * deviation_limit(options.strictness));
  return live;
}

}  // namespace nazori::writing
