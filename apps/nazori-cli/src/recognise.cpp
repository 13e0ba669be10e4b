// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "characters.h"
#include "json_lines.h"
#include "nazori/exchange/candidates.h"
#include "nazori/exchange/handwriting.h"
#include "nazori/writing/recogniser.h"
#include "options.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

struct RecogniseSettings {
  std::string database;
  std::string among = "all";
  writing::RecogniseOptions options;
};

writing::Among among_of(const std::string& word) {
  if (word == "kana") return writing::Among::kana;
  if (word == "kanji") return writing::Among::kanji;
  if (word == "letters") return writing::Among::letters;
  return writing::Among::all;
}

base::Result<Json> recognise_one(const Json& request, const writing::Recogniser& recogniser,
                                 const writing::RecogniseOptions& options) {
  const auto ink = exchange::read_handwriting(request);
  if (!ink) return tl::unexpected(ink.error());
  const auto candidates = recogniser.recognise(*ink, options);
  if (!candidates) return tl::unexpected(candidates.error());
  return exchange::to_json(*candidates);
}

int run(Console& console, const RecogniseSettings& settings) {
  const auto database = open_database(settings.database);
  if (!database) return console.refuse(database.error());
  const auto recogniser = writing::Recogniser::make(*database);
  if (!recogniser) return console.refuse(recogniser.error());
  auto options = settings.options;
  options.among = among_of(settings.among);
  return answer_lines(console, exchange::refused_candidates(),
                      [&](const Json& request) { return recognise_one(request, *recogniser, options); });
}

}  // namespace

void add_recognise(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<RecogniseSettings>();
  CLI::App* verb =
      app.add_subcommand("recognise", "Find characters from drawn strokes (JSON Lines in and out)");
  verb->add_option("--top", settings->options.limit, "Maximum number of candidates")
      ->check(within(1, 1000))
      ->capture_default_str()
      ->type_name("N");
  verb->add_flag("--unfinished", settings->options.unfinished,
                 "The drawing may be unfinished: also suggest characters that start like it");
  verb->add_option("--among", settings->among, "Search only these characters (letters: also digits)")
      ->check(CLI::IsMember({"all", "kana", "kanji", "letters"}))
      ->capture_default_str()
      ->type_name("SCRIPT");
  add_database_option(*verb, settings->database);
  verb->footer(
      "Each input line gets one output line at once, best candidates first.\n"
      "An invalid line gets an answer with \"error\"; the exit code is then 2.\n\nExample:\n"
      "  echo '{\"strokes\":[[[0.1,0.5],[0.9,0.5]],[[0.5,0.1],[0.5,0.9]]]}' | nazori-cli recognise --top 5");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
