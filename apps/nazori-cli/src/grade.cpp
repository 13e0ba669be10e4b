// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/grade.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "characters.h"
#include "json_lines.h"
#include "nazori/base/utf8.h"
#include "nazori/writing/explanation.h"
#include "nazori/writing/model_library.h"
#include "nazori/writing/motion_remarks.h"
#include "nazori/writing/pen_motion.h"
#include "options.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct GradeSettings {
  std::string database;
  std::string strictness = "normal";
  std::string explain;
  bool live = false;
};

base::Result<double> read_strictness(const std::string& text) {
  if (text == "lenient") return writing::kLenient;
  if (text == "normal") return writing::kNormal;
  if (text == "strict") return writing::kStrict;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= 0 && value <= 1) return value;
  return base::fail(base::Errc::bad_argument, fmt::format("'{}' is no strictness", text), "--strictness",
                    "give lenient, normal, strict or a number 0..1");
}

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

Json mistake_json(const writing::Mistake& mistake) {
  Json json{{"kind", kind_name(mistake.kind)}, {"stroke", mistake.stroke}};
  if (mistake.second) json["second"] = *mistake.second;
  if (!mistake.model.empty()) json["model"] = mistake.model;
  if (mistake.kind == kanji::MistakeKind::split) json["split"] = true;
  if (mistake.deviation != writing::Deviation::none) json["deviation"] = deviation_name(mistake.deviation);
  if (mistake.character != 0) json["resembles"] = base::encode_utf8(mistake.character);
  return json;
}

Json mistakes_json(const std::vector<writing::Mistake>& mistakes) {
  Json array = Json::array();
  for (const auto& mistake : mistakes) array.push_back(mistake_json(mistake));
  return array;
}

Json stroke_json(const writing::StrokeVerdict& verdict) {
  return {{"ok", verdict.ok},
          {"matched", verdict.matched ? Json(*verdict.matched) : Json()},
          {"reversed", verdict.reversed},
          {"offset", {rounded(verdict.offset_x), rounded(verdict.offset_y)}},
          {"size", rounded(verdict.size)},
          {"angle", rounded(verdict.angle_rad)},
          {"shape", rounded(verdict.shape)},
          {"deviation", rounded(verdict.deviation)}};
}

Json motion_json(const std::vector<writing::PenMotion>& motions) {
  Json array = Json::array();
  for (const auto& m : motions) {
    Json json{{"duration_s", rounded(m.duration_s)},
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

Json grade_json(const writing::Grade& grade, const std::string& character) {
  Json strokes = Json::array();
  for (const auto& verdict : grade.strokes) strokes.push_back(stroke_json(verdict));
  const auto& p = grade.parts;
  Json json{{"char", character},
            {"accepted", grade.accepted},
            {"strokes", std::move(strokes)},
            {"errors", mistakes_json(grade.mistakes)},
            {"advice", mistakes_json(grade.advice)},
            {"score", grade.score},
            {"form", grade.form ? Json(*grade.form) : Json()},
            {"parts",
             {{"strokes", rounded(p.strokes)},
              {"order", rounded(p.order)},
              {"direction", rounded(p.direction)},
              {"shape", rounded(p.shape)},
              {"place", rounded(p.place)}}}};
  if (grade.alternative) json["alternative"] = grade.alternative->source;
  if (!grade.variant.empty()) json["variant"] = grade.variant;
  return json;
}

bool is_timed(const writing::WrittenCharacter& ink) {
  for (const auto& s : ink.strokes)
    for (const auto& point : s)
      if (point.time_s || point.pressure) return true;
  return false;
}

std::vector<std::string> motion_sentences(std::span<const writing::PenMotion> motions,
                                          std::span<const writing::MotionRemark> remarks,
                                          writing::Language language) {
  auto sentences = writing::explain(remarks, language);
  if (auto pace = writing::explain_pace(motions, remarks, language); !pace.empty())
    sentences.insert(sentences.begin(), std::move(pace));
  return sentences;
}

base::Result<Json> answer(const Json& request, writing::ModelLibrary& library, const GradeSettings& settings,
                          const writing::GradeOptions& options) {
  const auto named = request.find("char");
  if (named == request.end() || !named->is_string())
    return base::fail(base::Errc::parse, "is missing or is not a text", "char");
  const auto text = named->get<std::string>();
  const auto decoded = base::decode_utf8(text);
  if (!decoded || decoded->size() != 1)
    return base::fail(base::Errc::bad_argument, "is not one character", "char");
  const auto entry = library.find(decoded->front());
  if (!entry) return tl::unexpected(entry.error());
  const auto ink = read_ink(request);
  if (!ink) return tl::unexpected(ink.error());
  const auto judge = settings.live ? writing::grade_live : writing::grade;
  const auto grade = judge(*ink, (*entry)->model, options, (*entry)->lookalikes);
  if (!grade) return tl::unexpected(grade.error());
  auto json = grade_json(*grade, text);
  const auto motions = is_timed(*ink) ? writing::pen_motion(*ink) : std::vector<writing::PenMotion>();
  if (!motions.empty()) json["motion"] = motion_json(motions);
  if (!settings.explain.empty()) {
    const auto language = settings.explain == "ja" ? writing::Language::japanese : writing::Language::english;
    json["explanation"] = writing::explain(*grade, language);
    json["score_explanation"] = writing::explain_score(*grade, language);
    if (!motions.empty()) {
      const auto remarks = writing::motion_remarks(motions, *grade, (*entry)->model);
      json["motion_explanation"] = motion_sentences(motions, remarks, language);
    }
  }
  return json;
}

int run(Console& console, const GradeSettings& settings) {
  const auto strictness = read_strictness(settings.strictness);
  if (!strictness) return console.refuse(strictness.error());
  const auto database = open_database(settings.database);
  if (!database) return console.refuse(database.error());
  writing::ModelLibrary library(*database);
  writing::GradeOptions options;
  options.strictness = *strictness;
  const Json refusal{{"accepted", false}, {"strokes", Json::array()}, {"errors", Json::array()}};
  return answer_lines(console, refusal,
                      [&](const Json& request) { return answer(request, library, settings, options); });
}

}  // namespace

void add_grade(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<GradeSettings>();
  CLI::App* verb = app.add_subcommand("grade", "Judge handwriting: JSON Lines in and out");
  verb->add_option("--strictness", settings->strictness, "lenient, normal, strict, or a number from 0 to 1")
      ->capture_default_str()
      ->type_name("HOW");
  verb->add_flag("--live", settings->live, "Judge each stroke by what was written until it ended");
  verb->add_option("--explain", settings->explain, "Add sentences for the learner: en or ja")
      ->check(CLI::IsMember({"en", "ja"}))
      ->type_name("LANGUAGE");
  add_database_option(*verb, settings->database);
  verb->footer(
      "Each line of standard input is answered by one line, sent at once. Strokes are counted from 0.\n"
      "A line that cannot be read gets an answer with \"error\"; the exit code is then 2.\n\nExample:\n"
      "  echo '{\"char\":\"一\",\"strokes\":[[[0.1,0.5],[0.9,0.5]]]}' | nazori-cli grade --explain en");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
