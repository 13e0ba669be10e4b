// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/grade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "alignment.h"
#include "endings.h"
#include "form.h"
#include "grade_shapes.h"
#include "judgement.h"
#include "lookalike_contrast.h"
#include "model_inside.h"
#include "placement.h"
#include "probability.h"
#include "standing_out.h"
#include "strangeness.h"
#include "stroke_comparer.h"
#include "stroke_order_mistakes.h"
#include "voicing_marks.h"

namespace nazori::writing {
namespace {

Affine box_map(const WritingBox& box) {
  const double s = geometry::kGlyphSide / box.side;
  return {s, 0, -s * box.corner.x, 0, s, -s * box.corner.y};
}

Side start_of(const Samples& model) {
  const float dx = model.x.back() - model.x.front();
  const float dy = model.y.back() - model.y.front();
  if (std::abs(dy) >= std::abs(dx)) return dy >= 0 ? Side::top : Side::bottom;
  return dx >= 0 ? Side::left : Side::right;
}

/// Turn from the model's start-to-end line to the drawn one; 0 where either is closed.
double chord_angle(const Samples& drawn, const Samples& model) {
  const auto chord = [](const Samples& s) {
    return std::pair{static_cast<double>(s.x.back() - s.x.front()),
                     static_cast<double>(s.y.back() - s.y.front())};
  };
  const auto [dx, dy] = chord(drawn);
  const auto [mx, my] = chord(model);
  constexpr double kClosed = 0.2;  // chord by length
  if (std::hypot(dx, dy) < kClosed * static_cast<double>(drawn.length) ||
      std::hypot(mx, my) < kClosed * static_cast<double>(model.length))
    return 0;
  return std::atan2(mx * dy - my * dx, mx * dx + my * dy);
}

/// Share of the limit below which a stroke that seems to run backwards is not simply a wrong one.
constexpr double kCertainly = 0.5;
/// Share of the limit that counts for forms other than the one that was asked for.
constexpr double kOtherForm = 0.45;
const std::vector<kanji::AlternativeOrder> no_orders;

int points_of(const ScoreParts& p) {
  return static_cast<int>(std::lround(kPointsForStrokes * p.strokes + kPointsForOrder * p.order +
                                      kPointsForDirection * p.direction + kPointsForShape * p.shape +
                                      kPointsForPlace * p.place));
}

/// Judges against one form.
class Judge {
 public:
  /// @param strokes  of the drawing and the form, with their alignment
  Judge(StrokeComparer& strokes, Alignment alignment, const Form& form,
        const std::vector<kanji::AlternativeOrder>& orders, const GradeOptions& options)
      : strokes_(strokes),
        drawn_(strokes.drawn()),
        form_(form),
        orders_(orders),
        options_(options),
        limit_(deviation_limit(options.strictness)),
        alignment_(std::move(alignment)) {
    grade_.variant = form.variant;
    grade_.strokes.resize(drawn_.size());
  }

  /// A form that is not the one that was asked for must fit better, and no stroke of it may stand out.
  void demand(double share) {
    limit_ *= share;
    share_ = share;
    is_other_form_ = true;
  }

  /// A stroke that looks like the missing one, which may be missing instead.
  void doubt(std::optional<int> alike) { alike_ = alike; }

  Grade run() {
    judge_strokes();
    judge_count();
    judge_order();
    judge_standing_out();
    finish();
    return std::move(grade_);
  }

 private:
  void judge_strokes() {
    const auto strokes = judged_strokes(alignment_, drawn_, form_);
    const auto features = stroke_features(strokes, form_.shapes.size(), alignment_.map);
    for (std::size_t k = 0; k < alignment_.links.size(); ++k) {
      const auto& link = alignment_.links[k];
      const auto& judged = strokes[k].judgement;
      const double of_limit =
          strangeness(features[k], strokes[k].used_freedom) / (link.difference.reversed ? kCertainly : 1);
      strangest_ = std::max(strangest_, of_limit / share_);
      auto& verdict = grade_.strokes[static_cast<std::size_t>(link.drawn)];
      describe(link, judged, verdict);
      if (link.drawn_count == 2) {
        auto& second = grade_.strokes[static_cast<std::size_t>(link.drawn) + 1];
        second = verdict;
        add({kanji::MistakeKind::split, link.drawn, link.drawn + 1, {link.model}});
      } else if (link.model_count == 2) {
        add({kanji::MistakeKind::joined, link.drawn, {}, {link.model, link.model + 1}});
      } else if (of_limit > limit_) {
        auto most = judged.most;
        if (most == Deviation::shape && std::abs(verdict.angle_rad) > std::numbers::pi / 5)
          most = Deviation::direction;
        add({kanji::MistakeKind::wrong, link.drawn, {}, {link.model}, most});
        if (is_other_form_) return;  // it will not be taken
      } else if (link.difference.reversed) {
        Mistake mistake{kanji::MistakeKind::reversed, link.drawn, {}, {link.model}};
        mistake.start = start_of(form_.shapes[static_cast<std::size_t>(link.model)].whole);
        add(std::move(mistake));
      } else {
        verdict.ok = true;
      }
      shape_sum_ += std::min(judged.deviation - judged.place, 2.0);
      place_sum_ += std::min(judged.place, 2.0);
    }
  }

  void describe(const Link& link, const Judgement& judged, StrokeVerdict& verdict) const {
    const auto& d = link.difference;
    verdict.matched = link.model;
    verdict.reversed = d.reversed;
    verdict.offset_x = static_cast<double>(d.offset_x) / geometry::kGlyphSide;
    verdict.offset_y = static_cast<double>(d.offset_y) / geometry::kGlyphSide;
    verdict.size = std::exp(static_cast<double>(d.length_log));
    verdict.shape = static_cast<double>(d.proportion);
    verdict.deviation = judged.deviation;
    const auto mapped = transformed(drawn_[static_cast<std::size_t>(link.drawn)].whole, alignment_.map);
    verdict.angle_rad = chord_angle(mapped, form_.shapes[static_cast<std::size_t>(link.model)].whole);
    if (d.reversed)
      verdict.angle_rad = std::remainder(verdict.angle_rad + std::numbers::pi, 2 * std::numbers::pi);
  }

  void judge_count() {
    for (const int i : alignment_.extra) add({kanji::MistakeKind::extra, i, {}, {}});
    for (const int j : alignment_.missing) {
      Mistake mistake{kanji::MistakeKind::missing, j, {}, {j}};
      if (alike_) mistake.model.push_back(*alike_);
      add(std::move(mistake));
    }
  }

  void judge_order() {
    const auto turns = strokes_out_of_turn(alignment_.links);
    const auto too_early = passed_over();
    if (turns.empty() && !too_early) return;
    if (const auto* listed = listed_order()) {
      grade_.alternative = *listed;
      return;
    }
    const bool advice = options_.strictness <= kOrderIsAdvice;
    const auto blame = [&](Mistake mistake, std::span<const int> to_blame) {
      for (const int i : to_blame) {
        ++out_of_turn_;
        if (!advice) grade_.strokes[static_cast<std::size_t>(i)].ok = false;
      }
      if (advice)
        grade_.advice.push_back(std::move(mistake));
      else
        add(std::move(mistake));
    };
    for (const auto& turn : turns) {
      Mistake mistake{kanji::MistakeKind::order, turn.drawn, turn.before, {}};
      for (const int i : {turn.drawn, turn.before})
        if (const auto m = grade_.strokes[static_cast<std::size_t>(i)].matched) mistake.model.push_back(*m);
      blame(std::move(mistake), turn.misplaced);
    }
    if (too_early) blame(*too_early, std::span(&too_early->stroke, 1));
  }

  /// While the character is being written: the last stroke, if the one right before it in the model is not
  /// there yet. Only a stroke that is right in all else is told so: of a strange one nobody knows which it
  /// is.
  std::optional<Mistake> passed_over() const {
    if (!options_.unfinished || alignment_.links.empty()) return {};
    const auto& last = alignment_.links.back();
    if (last.drawn + last.drawn_count != static_cast<int>(drawn_.size()) || !grade_.strokes.back().ok)
      return {};
    const auto is_missing = [this](int stroke) {
      return std::find(alignment_.missing.begin(), alignment_.missing.end(), stroke) !=
             alignment_.missing.end();
    };
    int first = last.model;
    while (first > 0 && is_missing(first - 1)) --first;
    if (first == last.model) return {};
    return Mistake{kanji::MistakeKind::order, last.drawn, {}, {last.model, first}};
  }

  /// The listed order that was followed from the first stroke to the last drawn one.
  const kanji::AlternativeOrder* listed_order() const {
    for (const auto& order : orders_) {
      if (order.order.size() != form_.shapes.size()) continue;
      const bool follows = std::all_of(alignment_.links.begin(), alignment_.links.end(), [&](const Link& l) {
        return static_cast<std::size_t>(l.drawn) < order.order.size() && l.model_count == 1 &&
               l.drawn_count == 1 && order.order[static_cast<std::size_t>(l.drawn)] == l.model + 1;
      });
      if (follows) return &order;
    }
    return nullptr;
  }

  /// A right stroke of a strange length, slant or place is told; one that is far too short is refused. Only
  /// the whole character shows how long a stroke should be.
  void judge_standing_out() {
    const bool is_refused_variant = is_other_form_ && !grade_.mistakes.empty();  // nobody sees its advice
    if (options_.unfinished || is_refused_variant) return;
    constexpr double kToleranceOfOtherForm = 0.6;
    const double tolerance =
        std::sqrt(deviation_limit(options_.strictness)) * (is_other_form_ ? kToleranceOfOtherForm : 1);
    for (const auto& c : conspicuous_strokes(strokes_, alignment_.links, alignment_.map, tolerance)) {
      const auto& link = alignment_.links[c.link];
      auto& verdict = grade_.strokes[static_cast<std::size_t>(link.drawn)];
      if (!verdict.ok) continue;
      // Beside one strange stroke nothing tells how long the other one should be.
      if (!c.is_the_stroke && alignment_.links.size() == 2 && !grade_.mistakes.empty()) continue;
      // The figures beside the sentence are those it is about.
      verdict.size = std::exp(static_cast<double>(c.by.length_log));
      verdict.offset_x = static_cast<double>(c.by.offset_x) / geometry::kGlyphSide;
      verdict.offset_y = static_cast<double>(c.by.offset_y) / geometry::kGlyphSide;
      Mistake mistake{kanji::MistakeKind::wrong, link.drawn, {}, {link.model}, c.deviation};
      if (c.is_the_stroke && !is_other_form_) {
        grade_.advice.push_back(std::move(mistake));
      } else {
        verdict.ok = false;
        strangest_ = std::max(strangest_, kJustBeyond * limit_ / share_);
        add(std::move(mistake));
      }
    }
  }

  void add(Mistake mistake) { grade_.mistakes.push_back(std::move(mistake)); }

  void finish() {
    const auto strict_endings = options_.strictness >= kEndingsCount;
    for (auto& mistake : ending_mistakes(drawn_, alignment_, form_)) {
      if (!grade_.strokes[static_cast<std::size_t>(mistake.stroke)].ok) continue;
      if (strict_endings) {
        grade_.strokes[static_cast<std::size_t>(mistake.stroke)].ok = false;
        add(std::move(mistake));
      } else {
        grade_.advice.push_back(std::move(mistake));
      }
    }
    std::stable_sort(grade_.mistakes.begin(), grade_.mistakes.end(),
                     [](const Mistake& a, const Mistake& b) { return a.stroke < b.stroke; });
    if (options_.unfinished) {
      // A stroke of the model may still follow; that it was passed over is already in the turns.
      std::erase_if(grade_.mistakes, [](const Mistake& f) { return f.kind == kanji::MistakeKind::missing; });
    }
    grade_.accepted = grade_.mistakes.empty();
    grade_.probability = probability_of(grade_, strangest_);
    score();
    if (grade_.accepted && !options_.unfinished) grade_.form = form_stars(grade_);
  }

  void score() {
    // Unfinished writing is scored as far as it goes; else what is missing has neither order nor shape.
    const auto count = static_cast<double>(
        options_.unfinished ? drawn_.size() : std::max(drawn_.size(), form_.shapes.size()));
    const double found = std::min(static_cast<double>(alignment_.links.size()), count);
    double present = 0;
    double backwards = 0;
    for (const auto& f : grade_.mistakes) {
      if (f.kind == kanji::MistakeKind::reversed) ++backwards;
      if (f.kind == kanji::MistakeKind::missing || f.kind == kanji::MistakeKind::extra ||
          f.kind == kanji::MistakeKind::wrong || f.kind == kanji::MistakeKind::joined ||
          f.kind == kanji::MistakeKind::split)
        ++present;
    }
    auto& p = grade_.parts;
    p.strokes = std::clamp(1 - present / count, 0.0, 1.0);
    p.order = std::clamp((found - static_cast<double>(out_of_turn_)) / count, 0.0, 1.0);
    p.direction = std::clamp((found - backwards) / count, 0.0, 1.0);
    p.shape = std::clamp((found - 0.7 * shape_sum_) / count, 0.0, 1.0);
    p.place = std::clamp((found - 0.7 * place_sum_) / count, 0.0, 1.0);
    grade_.score = points_of(p);
  }

  StrokeComparer& strokes_;
  std::span<const Shape> drawn_;
  const Form& form_;
  const std::vector<kanji::AlternativeOrder>& orders_;
  const GradeOptions& options_;
  double limit_;
  double share_ = 1;      // of the limit
  double strangest_ = 0;  // deviation of the strangest stroke, 1 at the limit of normal strictness
  bool is_other_form_ = false;
  std::optional<int> alike_;
  Alignment alignment_;
  Grade grade_;
  double shape_sum_ = 0;
  double place_sum_ = 0;
  int out_of_turn_ = 0;
};

Extent extent_of(const GradeOptions& options) {
  return options.unfinished ? Extent::beginning : Extent::whole;
}

bool is_order(const Mistake& mistake) { return mistake.kind == kanji::MistakeKind::order; }

/// Mistakes, and what is one at normal strictness.
std::ptrdiff_t faults_of(const Grade& grade) {
  return static_cast<std::ptrdiff_t>(grade.mistakes.size()) +
         std::count_if(grade.advice.begin(), grade.advice.end(), is_order);
}

/// A strange stroke that looks a little like another one is taken for it, and that one is then blamed, too.
/// One mistake is likelier than two: perhaps all strokes came in their turn. Many mistakes are a scribble.
bool may_be_in_turn(const Grade& grade) {
  constexpr int kFew = 4;
  const auto faults = faults_of(grade);
  return faults > 1 && faults <= kFew &&
         (std::any_of(grade.mistakes.begin(), grade.mistakes.end(), is_order) ||
          std::any_of(grade.advice.begin(), grade.advice.end(), is_order));
}

Grade judge_main_form(std::span<const Shape> drawn, const std::optional<Affine>& box,
                      const ModelInside& model, const GradeOptions& options) {
  StrokeComparer strokes(drawn, model.main.shapes, model.main.pairs);
  auto alignment = align(strokes, box, extent_of(options));
  std::optional<int> alike;
  if (const auto mark = model.main.first_voicing_mark; mark && !options.unfinished)
    alike = settle_voicing_marks(strokes, alignment, *mark, box);
  Judge judge(strokes, std::move(alignment), model.main, model.orders, options);
  judge.doubt(alike);
  auto grade = judge.run();
  if (!options.unfinished && drawn.size() == model.main.shapes.size() && may_be_in_turn(grade)) {
    Judge in_turn(strokes, align_in_order(strokes, box), model.main, model.orders, options);
    if (auto simpler = in_turn.run(); faults_of(simpler) < faults_of(grade)) return simpler;
  }
  return grade;
}

/// What is accepted as another form.
std::optional<Grade> accepted_as(const Form& form, std::span<const Shape> drawn,
                                 const std::optional<Affine>& box, const GradeOptions& options) {
  if (!options.unfinished && drawn.size() != form.shapes.size()) return {};
  StrokeComparer strokes(drawn, form.shapes, form.pairs);
  const bool order_counts = options.strictness > kOrderIsAdvice;
  if (!options.unfinished && order_counts && is_one_wrong_in_order(strokes, box)) return {};
  Judge judge(strokes, align(strokes, box, extent_of(options)), form, no_orders, options);
  judge.demand(kOtherForm);
  auto grade = judge.run();
  return grade.accepted ? std::optional(std::move(grade)) : std::nullopt;
}

}  // namespace

Grade grade_shapes(std::span<const Shape> drawn, const std::optional<Affine>& box, const ModelInside& model,
                   const GradeOptions& options, std::span<const Model> lookalikes) {
  auto best = judge_main_form(drawn, box, model, options);
  for (const auto& variant : model.variants) {
    if (best.accepted) break;
    if (auto other = accepted_as(variant, drawn, box, options)) best = std::move(*other);
  }
  if (best.accepted && !options.unfinished && !best.alternative && best.variant.empty() &&
      drawn.size() == model.main.shapes.size()) {
    if (const auto mistaken = mistaken_for(drawn, model.main, lookalikes)) {
      best.accepted = false;
      best.form.reset();
      best.strokes[static_cast<std::size_t>(mistaken->stroke)].ok = false;
      Mistake mistake{kanji::MistakeKind::other, mistaken->stroke, {}, {mistaken->stroke}};
      mistake.character = mistaken->character;
      best.mistakes.push_back(std::move(mistake));
      best.parts.strokes = 0;  // however well they were written, they are not this character's
      best.score = points_of(best.parts);
      best.probability = probability_of(best, 1);
    }
  }
  return best;
}

base::Result<Prepared> prepare(const WrittenCharacter& ink, const GradeOptions& options) {
  if (auto good = check(ink); !good) return tl::unexpected(good.error());
  if (!(options.strictness >= 0 && options.strictness <= 1))
    return base::fail(base::Errc::bad_argument, "must be between 0 and 1", "strictness");
  Prepared p;
  p.drawn.reserve(ink.strokes.size());
  for (const auto& s : ink.strokes) p.drawn.push_back(make_shape<WritingFrame>(geometry::line_of(s)));
  if (ink.box) p.box = box_map(*ink.box);
  return p;
}

base::Result<Grade> grade(const WrittenCharacter& ink, const Model& model, const GradeOptions& options,
                          std::span<const Model> lookalikes) {
  const auto p = prepare(ink, options);
  if (!p) return tl::unexpected(p.error());
  return grade_shapes(p->drawn, p->box, model.inside(), options, lookalikes);
}

}  // namespace nazori::writing
