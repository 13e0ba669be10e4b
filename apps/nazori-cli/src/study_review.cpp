// SPDX-License-Identifier: Apache-2.0
// study review, study undo
#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "characters.h"
#include "nazori/base/utf8.h"
#include "nazori/exchange/cards.h"
#include "options.h"
#include "study_session.h"

namespace nazori::cli {
namespace {

using study::Stage;

struct ReviewSettings {
  StudyOptions options;
  std::string character;
  std::string rating;
  std::string stage = "memory";
  bool rejected = false;
  int score = 85;
  std::vector<std::string> mistakes;
  int hints = 0;
  int misses = 0;
  int shown = 0;
  double help = 0;
  double seconds = 0;
};

struct UndoSettings {
  StudyOptions options;
  int count = 1;
};

/// "wrong:3": the third stroke.
base::Result<study::StrokeMistake> parse_mistake(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto kind = kanji::mistake_named(text.substr(0, colon));
  int stroke = 0;
  if (kind && colon != std::string::npos) {
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data() + colon + 1, end, stroke);
    if (error == std::errc() && at == end && stroke >= 1 && stroke <= 1'000) {
      return study::StrokeMistake{*kind, stroke - 1};
    }
  }
  return base::fail(
      base::Errc::bad_argument, "is not a valid stroke mistake", text,
      "give order, reversed, missing, extra, joined, split, wrong, other or ending, and a stroke: "
      "wrong:3");
}

int review(Console& console, const ReviewSettings& settings) {
  auto session = StudySession::open(settings.options, study::Access::write);
  if (!session) return console.refuse(session.error());
  const auto characters = session->characters({settings.character});
  if (!characters) return console.refuse(characters.error());
  if (characters->size() != 1) {
    return console.refuse(
        {base::Errc::bad_argument, "must be one character", settings.character, "give one at a time"});
  }
  const char32_t character = characters->front();
  const int strokes = session->lists().facts(character)->strokes;
  study::Writing writing;
  writing.stage = *study::stage_named(settings.stage);
  study::WritingResult& result = writing.result;
  result.accepted = !settings.rejected && settings.rating != "again";
  result.score = settings.score;
  for (const std::string& text : settings.mistakes) {
    const auto mistake = parse_mistake(text);
    if (!mistake) return console.refuse(mistake.error());
    // An extra stroke is numbered among the written ones, all others among those of the character.
    if (mistake->kind != kanji::MistakeKind::extra && mistake->stroke >= strokes) {
      return console.refuse({base::Errc::bad_argument,
                             fmt::format("{} has {}", settings.character, counted(strokes, "stroke")), text,
                             fmt::format("give a stroke from 1 to {}", strokes)});
    }
    result.mistakes.push_back(*mistake);
  }
  result.hints = settings.hints;
  result.misses = settings.misses;
  result.shown_strokes = settings.shown;
  result.help = settings.help;
  result.duration = std::chrono::milliseconds(static_cast<std::int64_t>(settings.seconds * 1000));
  study::LearnerStore& learner = session->learner();
  const auto usual = learner.usual_writing(character);
  if (!usual) return console.refuse(usual.error());
  writing.proposed = study::proposed_rating(result, *usual);
  writing.rating = settings.rating.empty() ? writing.proposed : *study::rating_named(settings.rating);

  const auto card = learner.add_writing(character, strokes, writing);
  if (!card) return console.refuse(card.error());
  if (settings.options.json) {
    console.print(to_text(exchange::reviewed(*card, writing, learner)));
  } else if (writing.stage == Stage::memory) {
    console.print(fmt::format("{}  {} (suggested: {}), comes back {}{}\n", letter(character),
                              study::name_of(writing.rating), study::name_of(writing.proposed),
                              wait_text(*card, learner.now(), learner.today()),
                              card->leech ? "; forgotten too often, taken out of reviews" : ""));
  } else if (writing.stage == Stage::brush) {
    console.print(fmt::format("{}  {} with the brush, comes back with it on {}\n", letter(character),
                              study::name_of(writing.rating), study::to_text(*card->brush.due_day)));
  } else {
    console.print(fmt::format("{}  practised ({}), next: {}\n", letter(character), settings.stage,
                              study::name_of(card->next_stage)));
  }
  return kDone;
}

int undo(Console& console, const UndoSettings& settings) {
  if (const auto code = refuse_missing(console, settings.options)) return *code;
  auto learner = open_learner(settings.options, study::Access::write);
  if (!learner) return console.refuse(learner.error());
  Json undone = Json::array();
  std::string lines;
  for (int i = 0; i < settings.count; ++i) {
    const auto one = learner->undo();
    if (!one) return console.refuse(one.error());
    if (!*one) break;
    std::string characters;
    for (const char32_t c : (*one)->characters) characters += base::encode_utf8(c);
    undone.push_back({{"kind", study::name_of((*one)->kind)}, {"characters", characters}});
    lines += fmt::format("undone: {} {}\n", study::name_of((*one)->kind), characters);
  }
  console.print(settings.options.json ? to_text(undone) : lines);
  if (static_cast<int>(undone.size()) == settings.count) return kDone;
  return console.deny({base::Errc::not_found, "nothing left to undo", "", ""});
}

void add_review(CLI::App& study, Action& chosen) {
  auto settings = std::make_shared<ReviewSettings>();
  CLI::App* verb = add_study_verb(
      study, "review", "Record that a character was written, and schedule its next review",
      "Without --rating, the suggested rating is used; docs/study.md explains how it is computed.\n\n"
      "Examples:\n  nazori-cli study review 休 --rating good\n"
      "  nazori-cli study review 休 --score 72 --fault wrong:3 --hints 1 --seconds 14 --json\n"
      "  nazori-cli study review 休 --stage trace");
  verb->add_option("character", settings->character, "The character")->required();
  verb->add_option("--rating", settings->rating, "again, hard, good or easy")
      ->check(CLI::IsMember({"again", "hard", "good", "easy"}))
      ->type_name("RATING");
  verb->add_option("--stage", settings->stage,
                   "watch, trace, guided, memory or brush; memory and brush are scheduled")
      ->check(CLI::IsMember({"watch", "trace", "guided", "memory", "brush"}))
      ->capture_default_str()
      ->type_name("STAGE");
  verb->add_flag("--rejected", settings->rejected, "The writing was not accepted as the character");
  verb->add_option("--score", settings->score, "Score of the writing")
      ->check(within(0, 100))
      ->capture_default_str()
      ->type_name("N");
  verb->add_option("--fault", settings->mistakes,
                   "A mistake and its stroke (from 1), such as wrong:3; may be repeated")
      ->type_name("KIND:STROKE");
  verb->add_option("--hints", settings->hints, "Number of hints used")
      ->check(within(0, 1'000))
      ->type_name("N");
  verb->add_option("--misses", settings->misses, "Number of rejected strokes")
      ->check(within(0, 1'000))
      ->type_name("N");
  verb->add_option("--shown", settings->shown, "Number of strokes shown")
      ->check(within(0, 1'000))
      ->type_name("N");
  verb->add_option("--help-level", settings->help, "Average amount of help")
      ->check(within(0, 1))
      ->type_name("FRACTION");
  verb->add_option("--seconds", settings->seconds, "Time taken in seconds")
      ->check(within(0, 86'400))
      ->type_name("S");
  add_writer_options(*verb, settings->options);
  verb->add_option("--database", settings->options.database, "Kanji database to use")->type_name("FILE");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return review(console, *settings); }; });
}

void add_undo(CLI::App& study, Action& chosen) {
  auto settings = std::make_shared<UndoSettings>();
  CLI::App* verb =
      add_study_verb(study, "undo", "Undo the last review or other action",
                     "Nothing is deleted: the log says that it counts no more. Exit code 1 where "
                     "there is nothing\nto take back.\n\nExample:\n  nazori-cli study undo -n 3");
  verb->add_option("-n,--count", settings->count, "Number of actions to undo")
      ->check(within(1, 100'000))
      ->capture_default_str()
      ->type_name("N");
  add_writer_options(*verb, settings->options);
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return undo(console, *settings); }; });
}

}  // namespace

void add_study_review(CLI::App& study, Action& chosen) {
  add_review(study, chosen);
  add_undo(study, chosen);
}

}  // namespace nazori::cli
