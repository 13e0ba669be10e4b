// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/plots.h"

#include <cmath>
#include <optional>
#include <string>

#include "nazori/functions/area.h"
#include "nazori/functions/braille.h"
#include "nazori/functions/curve_kinds.h"

namespace nazori::exchange {
namespace {

std::string kind_name(functions::StatementKind kind) { return std::string(functions::curve_kind(kind).name); }

std::string key_of(functions::PointKind kind) {
  std::string name = functions::in_words(kind, functions::Language::english);
  for (char& c : name) c = c == ' ' || c == '-' ? '_' : c;
  return name;
}

Value number_or_null(double v) { return std::isfinite(v) ? Value(v) : Value(nullptr); }

Value name_or_null(const std::optional<std::string>& name) { return name ? Value(*name) : Value(nullptr); }

/// Null where the area is not defined.
Value area_json(const functions::Statement& s) {
  const auto v = functions::area_value(s);
  if (!v) return nullptr;
  return {{"integral", v->integral},
          {"integral_name", name_or_null(v->integral_name)},
          {"area", v->area},
          {"area_name", name_or_null(v->area_name)}};
}

Value point_json(const functions::PointOfInterest& p, functions::Language language,
                 functions::SpeechStyle style) {
  Value point = {{"kind", key_of(p.kind)}, {"statement", p.statement + 1}};
  if (p.other >= 0) point["other_statement"] = p.other + 1;
  point["x"] = number_or_null(p.x);
  point["y"] = number_or_null(p.y);
  point["x_name"] = p.x_name.empty() ? Value(nullptr) : Value(p.x_name);
  point["y_name"] = p.y_name.empty() ? Value(nullptr) : Value(p.y_name);
  if (p.jump) {
    point["before"] = {number_or_null(p.jump->x_before), number_or_null(p.jump->y_before)};
    point["after"] = {number_or_null(p.jump->x_after), number_or_null(p.jump->y_after)};
    point["y_at"] = number_or_null(p.jump->y_at);
  }
  if (p.kind == functions::PointKind::slanted_asymptote) {
    point["slope"] = p.slope;
    point["intercept"] = p.intercept;
  }
  if (p.side != 0) point["side"] = p.side;
  point["words"] = functions::in_words(p, language, style);
  return point;
}

Value fit_json(const functions::Fit& fit) {
  Value letters = Value::array();
  for (const functions::FittedLetter& l : fit.letters)
    letters.push_back(Value{{"name", l.name}, {"value", l.value}});
  return {{"letters", std::move(letters)},
          {"points", fit.points},
          {"residual_sum", fit.residual_sum},
          {"r_squared", number_or_null(fit.r_squared)}};
}

Value statement_json(const functions::Statement& s, functions::Language language,
                     functions::SpeechStyle style) {
  const std::size_t points = functions::typed_points(s).size();
  Value statement = {{"kind", points == 0   ? kind_name(s.kind)
                              : points == 1 ? "point"
                                            : "points"},
                     {"canonical", functions::canonical(s)},
                     {"words", functions::in_words(s, language, style)},
                     {"braille",
                      {{"nemeth", functions::in_braille(s, functions::BrailleCode::nemeth)},
                       {"ueb", functions::in_braille(s, functions::BrailleCode::ueb)}}}};
  if (s.typed) statement["typed"] = functions::canonical(*s.typed);
  if (s.typed && !s.fit) statement["element"] = s.element + 1;
  if (s.fit) statement["fit"] = fit_json(*s.fit);
  if (s.area) statement["area"] = area_json(s);
  return statement;
}

Value lists_json(const functions::Plot& plot) {
  Value lists = Value::array();
  for (const functions::NamedList& l : plot.lists)
    lists.push_back(Value{{"name", l.name}, {"values", l.values()}});
  return lists;
}

}  // namespace

Value to_json(const functions::Plot& plot, const functions::Picture& picture,
              const std::vector<functions::PointOfInterest>& points, const PlotTimings& timings,
              functions::Language language, functions::SpeechStyle style) {
  Value statements = Value::array();
  for (const functions::Statement& s : plot.statements) {
    statements.push_back(statement_json(s, language, style));
  }
  Value list = Value::array();
  for (const auto& p : points) list.push_back(point_json(p, language, style));
  Value parameters = Value::array();
  for (const functions::Parameter& p : plot.parameters)
    parameters.push_back(Value{{"name", p.name}, {"value", p.value}, {"from", p.from}, {"to", p.to}});
  Value questions = Value::array();
  for (const functions::SyntaxError& q : plot.questions)
    questions.push_back(Value{{"column", q.column}, {"words", functions::question_words(q, language)}});
  const functions::Tracing& t = picture.tracing;
  Value document = {
      {"kind", plot.statements.size() > 1 ? "multi" : kind_name(plot.statements[0].kind)},
      {"canonical", functions::canonical(plot)},
      {"words", functions::in_words(plot, language, style)},
      {"summary", functions::summary(plot, t, points, language, style)},
      {"window", {t.window.x0, t.window.x1, t.window.y0, t.window.y1}},
      {"tick_step",
       {functions::tick_step(t.window.x0, t.window.x1), functions::tick_step(t.window.y0, t.window.y1)}},
      {"size", picture.plate.heights.size()},
      {"statements", std::move(statements)},
      {"parameters", std::move(parameters)},
      {"lists", lists_json(plot)},
      {"questions", std::move(questions)},
      {"points", std::move(list)},
      {"pieces", functions::pieces(plot, t)},
      {"dense", t.dense},
      {"undecided_share", t.undecided_share()},
      {"timings_ms", {{"draw", timings.draw_ms}, {"points", timings.points_ms}}}};
  if (plot.is_surface()) document["z"] = {picture.plate.range.low, picture.plate.range.high};
  return document;
}

Value to_json(const std::vector<functions::ValueRow>& table) {
  Value rows = Value::array();
  for (const functions::ValueRow& row : table) rows.push_back({number_or_null(row.x), number_or_null(row.y)});
  return rows;
}

}  // namespace nazori::exchange
