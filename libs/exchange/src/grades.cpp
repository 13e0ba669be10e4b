// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/grades.h"

#include <cmath>
#include <string_view>

#include "nazori/base/utf8.h"
#include "nazori/exchange/handwriting.h"
#include "reading.h"

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

constexpr int kMost = 1'000'000;
constexpr double kFarthest = 1e9;

/// Whole numbers of an array.
std::vector<int> read_wholes(JsonObject& from, const char* member) {
  std::vector<int> numbers;
  const Value* list = from.array(member);
  if (list == nullptr) return numbers;
  for (const auto& one : *list) {
    if (!one.is_number_integer() || one < 0 || one > kMost) {
      from.refuse(member, "is not a list of whole numbers");
      break;
    }
    numbers.push_back(one.get<int>());
  }
  return numbers;
}

std::vector<std::string> read_texts(JsonObject& from, const char* member) {
  std::vector<std::string> texts;
  const Value* list = from.array(member);
  if (list == nullptr) return texts;
  for (const auto& one : *list) {
    if (!one.is_string()) {
      from.refuse(member, "is not a list of texts");
      break;
    }
    texts.push_back(one.get<std::string>());
  }
  return texts;
}

writing::Mistake read_mistake(JsonObject& from) {
  using Kind = kanji::MistakeKind;
  writing::Mistake mistake;
  mistake.kind = read_name(from, "kind", [](std::string_view name) {
    return enumerator_named(name, kanji::MistakeKind::ending, kind_name);
  });
  mistake.stroke = static_cast<int>(from.whole("stroke", 0, kMost));
  if (from.is_there("second")) mistake.second = static_cast<int>(from.whole("second", 0, kMost));
  if (from.is_there("model")) mistake.model = read_wholes(from, "model");
  if (from.is_there("split") && from.truth("split")) mistake.kind = Kind::split;
  if (from.is_there("deviation"))
    mistake.deviation = read_name(from, "deviation", [](std::string_view name) {
      return enumerator_named(name, writing::Deviation::length, deviation_name);
    });
  if (from.is_there("resembles")) {
    mistake.character = read_character(from, "resembles");
    mistake.kind = Kind::other;
  }
  return mistake;
}

writing::StrokeVerdict read_verdict(JsonObject& from) {
  writing::StrokeVerdict verdict;
  verdict.ok = from.truth("ok");
  if (from.has("matched")) verdict.matched = static_cast<int>(from.whole("matched", 0, kMost));
  verdict.reversed = from.truth("reversed");
  if (const auto offset = from.numbers("offset", 2); offset.size() == 2) {
    verdict.offset_x = offset[0];
    verdict.offset_y = offset[1];
  }
  verdict.size = from.number("size", 0, kFarthest);
  verdict.angle_rad = from.number("angle", -kFarthest, kFarthest);
  verdict.shape = from.number("shape", 0, kFarthest);
  verdict.deviation = from.number("deviation", 0, kFarthest);
  return verdict;
}

writing::PenMotion read_motion(JsonObject& from) {
  writing::PenMotion motion;
  motion.duration_s = from.number("duration_s", 0, kFarthest);
  motion.pause_before_s = from.number("pause_before_s", -kFarthest, kFarthest);
  motion.speed_peaks = static_cast<int>(from.whole("speed_peaks", 0, kMost));
  motion.speed_at_end = from.number("speed_at_end", 0, kFarthest);
  motion.pauses.resize(static_cast<std::size_t>(from.whole("pauses", 0, kMost / 100)));
  if (from.is_there("pressure")) motion.pressure = from.number("pressure", 0, 1);
  if (from.is_there("pressure_at_end")) motion.pressure_at_end = from.number("pressure_at_end", 0, 1);
  if (from.is_there("lift")) {
    const std::string lift = from.text("lift");
    motion.lift = lift == "swept" ? writing::PenLift::swept : writing::PenLift::stopped;
    if (lift != "swept" && lift != "stopped") from.refuse("lift", "is a name that is not known");
  }
  return motion;
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
             {"probability", rounded(grade.probability)},
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

base::Result<GradeAnswer> read_grade(const Value& document) {
  json::Reader reader("");
  auto from = reader.root(document);
  GradeAnswer answer;
  writing::Grade& grade = answer.grade;
  answer.character = read_character(from, "char");
  grade.accepted = from.truth("accepted");
  from.each("strokes", [&](JsonObject& one) { grade.strokes.push_back(read_verdict(one)); });
  from.each("errors", [&](JsonObject& one) { grade.mistakes.push_back(read_mistake(one)); });
  from.each("advice", [&](JsonObject& one) { grade.advice.push_back(read_mistake(one)); });
  grade.score = static_cast<int>(from.whole("score", 0, 100));
  if (from.has("form")) grade.form = static_cast<int>(from.whole("form", 1, writing::kBestForm));
  grade.probability = from.number("probability", 0, 1);
  auto parts = from.object("parts");
  grade.parts = {parts.number("strokes", 0, 1), parts.number("order", 0, 1), parts.number("direction", 0, 1),
                 parts.number("shape", 0, 1), parts.number("place", 0, 1)};
  if (from.is_there("alternative")) grade.alternative.emplace().source = from.text("alternative");
  if (from.is_there("variant")) grade.variant = from.text("variant");
  if (from.is_there("motion"))
    from.each("motion", [&](JsonObject& one) { answer.motion.push_back(read_motion(one)); });
  if (from.is_there("explanation")) {
    auto& explanation = answer.explanation.emplace();
    explanation.verdict = read_texts(from, "explanation");
    explanation.score = read_texts(from, "score_explanation");
    if (from.is_there("motion_explanation")) explanation.motion = read_texts(from, "motion_explanation");
  }
  if (!reader.ok()) return tl::unexpected(reader.error());
  return answer;
}

Value refused_grade() {
  return {{"accepted", false}, {"strokes", Value::array()}, {"errors", Value::array()}};
}

}  // namespace nazori::exchange
