// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/grade.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "characters.h"
#include "json_lines.h"
#include "nazori/exchange/grades.h"
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
  return base::fail(base::Errc::bad_argument, fmt::format("'{}' is not a valid strictness", text),
                    "--strictness", "give lenient, normal, strict or a number 0..1");
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

exchange::GradeExplanation explained(const exchange::GradeAnswer& answer, const writing::Model& model,
                                     writing::Language language) {
  exchange::GradeExplanation explanation{
      writing::explain(answer.grade, language), writing::explain_score(answer.grade, language), {}};
  if (!answer.motion.empty()) {
    const auto remarks = writing::motion_remarks(answer.motion, answer.grade, model);
    explanation.motion = motion_sentences(answer.motion, remarks, language);
  }
  return explanation;
}

base::Result<Json> grade_one(const Json& json, writing::ModelLibrary& library, const GradeSettings& settings,
                             const writing::GradeOptions& options) {
  const auto asked = exchange::read_grade_request(json);
  if (!asked) return tl::unexpected(asked.error());
  const auto entry = library.find(asked->character);
  if (!entry) return tl::unexpected(entry.error());
  const auto judge = settings.live ? writing::grade_live : writing::grade;
  const auto grade = judge(asked->ink, (*entry)->model, options, (*entry)->lookalikes);
  if (!grade) return tl::unexpected(grade.error());
  exchange::GradeAnswer answer{asked->character, *grade, {}, {}};
  if (is_timed(asked->ink)) answer.motion = writing::pen_motion(asked->ink);
  if (!settings.explain.empty()) {
    const auto language = settings.explain == "ja" ? writing::Language::japanese : writing::Language::english;
    answer.explanation = explained(answer, (*entry)->model, language);
  }
  return exchange::to_json(answer);
}

int run(Console& console, const GradeSettings& settings) {
  const auto strictness = read_strictness(settings.strictness);
  if (!strictness) return console.refuse(strictness.error());
  const auto database = open_database(settings.database);
  if (!database) return console.refuse(database.error());
  writing::ModelLibrary library(*database);
  writing::GradeOptions options;
  options.strictness = *strictness;
  return answer_lines(console, exchange::refused_grade(),
                      [&](const Json& request) { return grade_one(request, library, settings, options); });
}

}  // namespace

void add_grade(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<GradeSettings>();
  CLI::App* verb = app.add_subcommand("grade", "Grade handwriting (JSON Lines in and out)");
  verb->add_option("--strictness", settings->strictness, "lenient, normal, strict, or a number from 0 to 1")
      ->capture_default_str()
      ->type_name("HOW");
  verb->add_flag("--live", settings->live, "Grade each stroke using only what was written up to its end");
  verb->add_option("--explain", settings->explain, "Add feedback sentences for the learner: en or ja")
      ->check(CLI::IsMember({"en", "ja"}))
      ->type_name("LANGUAGE");
  add_database_option(*verb, settings->database);
  verb->footer(
      "Each input line gets one output line at once. Strokes are counted from 0.\n"
      "An invalid line gets an answer with \"error\"; the exit code is then 2.\n\nExample:\n"
      "  echo '{\"char\":\"一\",\"strokes\":[[[0.1,0.5],[0.9,0.5]]]}' | nazori-cli grade --explain en");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
