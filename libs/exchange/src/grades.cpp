// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/grades.h"

#include <cmath>
#include <string_view>

#include "nazori/base/utf8.h"
#include "nazori/exchange/handwriting.h"

namespace nazori::exchange {
namespace {

std::string_view kind_name(kanji::MistakeKind kind) {
  using enum kanji::MistakeKind;
  switch (kind) {
    case order:
      return "order";
    case reversed:
      return "reversed";
    case missing:
      return "missing";
    case extra:
    case split:
      return "extra";
    case joined:
      return "joined";
    case ending:
      return "ending";
    case wrong:
    case other:
      break;
  }
  return "wrong";
}

std::string_view deviation_name(writing::Deviation deviation) {
  using enum writing::Deviation;
  switch (deviation) {
    case none:
      return "none";
    case place:
      return "place";
    case shape:
      return "shape";
    case direction:
      return "direction";
    case length:
      return "length";
  }
  return "none";
}

double rounded(double v) { return std::round(v * 1e4) / 1e4; }

Value mistake_json(const writing::Mistake& mistake) {
  Value json{{"kind", kind_name(mistake.kind)}, {"stroke", mistake.stroke}};
  if (mistake.second) json["second"] = *mistake.second;
  if (!mistake.model.empty()) json["model"] = mistake.model;
  if (mistake.kind == kanji::MistakeKind::split) json["split"] = true;
  if (mistake.deviation != writing::Deviation::none) json["deviation"] = deviation_name(mistake.deviation);
  if (mistake.character != 0) json["resembles"] = base::encode_utf8(mistake.character);
  return json;
}

Value mistakes_json(const std::vector<writing::Mistake>& mistakes) {
  Value array = Value::array();
  for (const auto& mistake : mistakes) array.push_back(mistake_json(mistake));
  return array;
}

Value stroke_json(const writing::StrokeVerdict& verdict) {
  return {{"ok", verdict.ok},
          {"matched", verdict.matched ? Value(*verdict.matched) : Value()},
          {"reversed", verdict.reversed},
          {"offset", {rounded(verdict.offset_x), rounded(verdict.offset_y)}},
          {"size", rounded(verdict.size)},
          {"angle", rounded(verdict.angle_rad)},
          {"shape", rounded(verdict.shape)},
          {"deviation", rounded(verdict.deviation)}};
}

Value motion_json(const std::vector<writing::PenMotion>& motions) {
  Value array = Value::array();
  for (const auto& m : motions) {
    Value json{{"duration_s", rounded(m.duration_s)},
               {"pause_before_s", rounded(m.pause_before_s)},
               {"speed_peaks", m.speed_peaks},
               {"speed_at_end", rounded(m.speed_at_end)},
               {"pauses", m.pauses.size()}};
    if (m.pressure) json["pressure"] = rounded(*m.pressure);
    if (m.pressure_at_end) json["pressure_at_end"] = rounded(*m.pressure_at_end);
    if (m.lift != writing::PenLift::unknown)
      json["lift"] = m.lift == writing::PenLift::swept ? "swept" : "stopped";
    array.push_back(std::move(json));
  }
  return array;
}

}  // namespace

base::Result<GradeRequest> read_grade_request(const Value& request) {
  const auto named = request.find("char");
  if (named == request.end() || !named->is_string())
    return base::fail(base::Errc::parse, "is missing or is not a text", "char");
  const auto decoded = base::decode_utf8(named->get<std::string>());
  if (!decoded || decoded->size() != 1)
    return base::fail(base::Errc::bad_argument, "must be one character", "char");
  auto ink = read_handwriting(request);
  if (!ink) return tl::unexpected(std::move(ink.error()));
  return GradeRequest{decoded->front(), *std::move(ink)};
}

Value to_json(const GradeAnswer& answer) {
  const writing::Grade& grade = answer.grade;
  Value strokes = Value::array();
  for (const auto& verdict : grade.strokes) strokes.push_back(stroke_json(verdict));
  const auto& p = grade.parts;
  Value json{{"char", base::encode_utf8(answer.character)},
             {"accepted", grade.accepted},
             {"strokes", std::move(strokes)},
             {"errors", mistakes_json(grade.mistakes)},
             {"advice", mistakes_json(grade.advice)},
             {"score", grade.score},
             {"form", grade.form ? Value(*grade.form) : Value()},
             {"parts",
              {{"strokes", rounded(p.strokes)},
               {"order", rounded(p.order)},
               {"direction", rounded(p.direction)},
               {"shape", rounded(p.shape)},
               {"place", rounded(p.place)}}}};
  if (grade.alternative) json["alternative"] = grade.alternative->source;
  if (!grade.variant.empty()) json["variant"] = grade.variant;
  if (!answer.motion.empty()) json["motion"] = motion_json(answer.motion);
  if (answer.explanation) {
    json["explanation"] = answer.explanation->verdict;
    json["score_explanation"] = answer.explanation->score;
    if (!answer.motion.empty()) json["motion_explanation"] = answer.explanation->motion;
  }
  return json;
}

Value refused_grade() {
  return {{"accepted", false}, {"strokes", Value::array()}, {"errors", Value::array()}};
}

}  // namespace nazori::exchange
