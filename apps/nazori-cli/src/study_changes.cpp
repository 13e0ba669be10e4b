// SPDX-License-Identifier: Apache-2.0
// study know, postpone, pause, resume, reset, leech, settings
#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <set>

#include "characters.h"
#include "nazori/base/file.h"
#include "nazori/exchange/cards.h"
#include "nazori/practice/learning_choices.h"
#include "options.h"
#include "study_session.h"

namespace nazori::cli {
namespace {

using study::LearnerStore;

constexpr std::size_t kMostSettingsBytes = 1 << 20;
constexpr std::size_t kMostTextBytes = 1 << 20;

struct ChangeSettings {
  StudyOptions options;
  std::vector<std::string> characters;
  int days = 1;
};

using Change = base::Result<void> (*)(LearnerStore&, std::span<const char32_t>, const ChangeSettings&);

int change(Console& console, const ChangeSettings& settings, const char* word, Change apply) {
  auto session = StudySession::open(settings.options, study::Access::write);
  if (!session) return console.refuse(session.error());
  const auto characters = session->characters(settings.characters);
  if (!characters) return console.refuse(characters.error());
  if (auto done = apply(session->learner(), *characters, settings); !done)
    return console.refuse(done.error());
  if (settings.options.json) {
    Json cards = Json::array();
    for (const char32_t one : *characters) {
      cards.push_back(exchange::to_json(session->learner().card(one), session->learner()));
    }
    console.print(to_text(cards));
  } else {
    console.print(fmt::format("{}: {}\n", word, counted(std::ssize(*characters), "character")));
  }
  return kDone;
}

struct KnowSettings {
  StudyOptions options;
  std::vector<std::string> characters;
  std::string text;
};

/// The characters of the arguments and of the text, easiest first, without those that were studied.
base::Result<std::vector<char32_t>> unstudied(StudySession& session, const KnowSettings& settings) {
  std::vector<char32_t> all;
  if (!settings.characters.empty()) {
    auto named = session.characters(settings.characters);
    if (!named) return named;
    all = *std::move(named);
  }
  if (!settings.text.empty()) {
    const auto bytes = base::read_file(settings.text, kMostTextBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto found =
        practice::kanji_and_kana_in({reinterpret_cast<const char*>(bytes->data()), bytes->size()},
                                    [&](char32_t one) { return session.lists().facts(one) != nullptr; });
    if (found.empty())
      return base::fail(base::Errc::parse, "has no kanji or kana", settings.text, "save the text as UTF-8");
    all.insert(all.end(), found.begin(), found.end());
  }
  if (all.empty())
    return base::fail(base::Errc::bad_argument, "are missing", "the characters",
                      "name them, or a text that holds them with --text FILE");
  std::set<char32_t> seen;
  std::erase_if(all, [&](char32_t one) {
    return !seen.insert(one).second || session.learner().card(one).introduced.has_value();
  });
  return study::sort_for_learning(std::move(all), study::NewOrder::grade,
                                  [&](char32_t one) { return session.lists().facts(one); });
}

int know(Console& console, const KnowSettings& settings) {
  auto session = StudySession::open(settings.options, study::Access::write);
  if (!session) return console.refuse(session.error());
  const auto characters = unstudied(*session, settings);
  if (!characters) return console.refuse(characters.error());
  auto& learner = session->learner();
  const auto known =
      practice::first_reviews(*characters, learner.today(), learner.settings().reviews_per_day);
  if (!known.empty())
    if (auto done = learner.know(known); !done) return console.refuse(done.error());
  if (settings.options.json) {
    Json cards = Json::array();
    for (const char32_t one : *characters) cards.push_back(exchange::to_json(learner.card(one), learner));
    console.print(to_text(cards));
  } else {
    console.print(fmt::format("known: {}\n", counted(std::ssize(known), "character")));
  }
  return known.empty() ? kNo : kDone;
}

void add_know(CLI::App& study, Action& chosen) {
  auto settings = std::make_shared<KnowSettings>();
  CLI::App* verb = add_study_verb(study, "know", "Mark characters as known, to be reviewed from memory later",
                                  "They are reviewed from the seventh day on, not all at once. Those that "
                                  "were studied stay as they are. Undo takes all "
                                  "of them back. Exit code 1 if nothing was marked.\n\nExamples:\n  "
                                  "nazori-cli study know grade-1 grade-2\n"
                                  "  nazori-cli study know --text known.txt");
  verb->add_option("characters", settings->characters, "Characters, or lists: grade-1, list:NAME, tag:NAME");
  verb->add_option("--text", settings->text, "Every kanji and kana of a text (UTF-8)")->type_name("FILE");
  add_writer_options(*verb, settings->options);
  verb->add_option("--database", settings->options.database, "Kanji database to use")->type_name("FILE");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return know(console, *settings); }; });
}

int list_leeches(Console& console, const StudyOptions& options) {
  auto learner = open_learner(options, study::Access::read);
  if (!learner) return console.refuse(learner.error());
  Json json = Json::array();
  std::string lines;
  for (const auto& [character, card] : learner->cards()) {
    if (!card.leech) continue;
    json.push_back(exchange::to_json(card, *learner));
    lines += fmt::format("{}  forgotten {}\n", letter(character), counted(card.memory.lapses, "time"));
  }
  console.print(options.json ? to_text(json) : lines);
  return json.empty() ? kNo : kDone;
}

void add_change(CLI::App& study, Action& chosen, const char* name, const char* description,
                const char* footer, const char* word, Change apply, bool days = false) {
  auto settings = std::make_shared<ChangeSettings>();
  CLI::App* verb = add_study_verb(study, name, description, footer);
  auto* characters = verb->add_option("characters", settings->characters,
                                      "Characters, or lists: grade-1, list:NAME, tag:NAME");
  const bool leech = std::string_view(name) == "leech";
  if (!leech) characters->required();
  if (days) {
    verb->add_option("--days", settings->days, "Number of days from today")
        ->check(within(1, 3'650))
        ->capture_default_str()
        ->type_name("N");
  }
  add_writer_options(*verb, settings->options);
  verb->add_option("--database", settings->options.database, "Kanji database to use")->type_name("FILE");
  verb->callback([settings, &chosen, word, apply, leech] {
    chosen = [=](Console& console) {
      if (leech && settings->characters.empty()) return list_leeches(console, settings->options);
      return change(console, *settings, word, apply);
    };
  });
}

struct SettingsSettings {
  StudyOptions options;
  std::string file;
  std::string weights;
  std::vector<std::string> changes;
};

/// The settings with changes such as "new_per_day=7" applied.
base::Result<study::Settings> changed_settings(const study::Settings& before, const SettingsSettings& asked) {
  Json json = json::parse(study::to_json(before)).value_or(Json());
  for (const std::string& change : asked.changes) {
    const std::size_t equals = change.find('=');
    const std::string name = change.substr(0, equals);
    if (equals == std::string::npos || !json.contains(name)) {
      return base::fail(base::Errc::bad_argument, "is not a setting", change,
                        "give NAME=VALUE, as printed by nazori-cli study settings");
    }
    const std::string text = change.substr(equals + 1);
    json[name] = json::parse(text).value_or(Json(text));
  }
  auto settings = study::parse_settings(json::to_line(json));
  if (!settings) {
    // The text was made here, so its line number would mean nothing to the user.
    base::Error error = std::move(settings.error());
    error.code = base::Errc::bad_argument;
    if (const std::size_t comma = error.where.find(", "); comma != std::string::npos)
      error.where.erase(0, comma + 2);
    return tl::unexpected(std::move(error));
  }
  if (!asked.weights.empty()) {
    const auto bytes = base::read_file(asked.weights, kMostSettingsBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    auto weights = study::parse_weights({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (!weights) {
      weights.error().where = asked.weights + ": " + weights.error().where;
      return tl::unexpected(std::move(weights.error()));
    }
    settings->fsrs.weights = *weights;
  }
  return settings;
}

int settings(Console& console, const SettingsSettings& asked) {
  const bool changes = !asked.changes.empty() || !asked.weights.empty();
  auto learner = open_learner(asked.options, changes ? study::Access::write : study::Access::read);
  if (!learner) return console.refuse(learner.error());
  if (changes) {
    const auto wanted = changed_settings(learner->settings(), asked);
    if (!wanted) return console.refuse(wanted.error());
    if (auto done = learner->change_settings(*wanted); !done) return console.refuse(done.error());
  }
  const Json json = json::parse(study::to_json(learner->settings())).value_or(Json());
  if (asked.options.json) {
    console.print(to_text(json));
  } else {
    for (const auto& [name, value] : json.items()) console.print(name + "=" + value.dump() + "\n");
  }
  return kDone;
}

}  // namespace

void add_study_changes(CLI::App& study, Action& chosen) {
  using Characters = std::span<const char32_t>;
  add_know(study, chosen);
  add_change(
      study, chosen, "postpone", "Postpone characters by some days",
      "Example:\n  nazori-cli study postpone 休 --days 3", "postponed",
      [](LearnerStore& store, Characters characters, const ChangeSettings& settings) {
        return store.postpone(characters, store.today() + std::chrono::days(settings.days));
      },
      true);
  add_change(study, chosen, "pause", "Suspend characters until they are resumed",
             "Example:\n  nazori-cli study pause list:rare", "paused",
             [](LearnerStore& store, Characters characters, const ChangeSettings& /*settings*/) {
               return store.pause(characters);
             });
  add_change(study, chosen, "resume", "Resume suspended characters", "Example:\n  nazori-cli study resume 休",
             "resumed", [](LearnerStore& store, Characters characters, const ChangeSettings& /*settings*/) {
               return store.resume(characters);
             });
  add_change(study, chosen, "reset", "Start characters over as new",
             "The study history is kept; undo reverts this.\n\nExample:\n  nazori-cli study reset grade-1",
             "started over",
             [](LearnerStore& store, Characters characters, const ChangeSettings& /*settings*/) {
               return store.reset(characters);
             });
  add_change(
      study, chosen, "leech", "List difficult characters, or put some back into reviews after relearning",
      "Exit code 1 if there are none.\n\nExamples:\n  nazori-cli study leech\n  nazori-cli study leech "
      "鬱",
      "back in reviews", [](LearnerStore& store, Characters characters, const ChangeSettings& /*settings*/) {
        return store.leech_met(characters);
      });
  auto asked = std::make_shared<SettingsSettings>();
  CLI::App* verb = add_study_verb(study, "settings", "Show or change a learner's settings",
                                  "Examples:\n  nazori-cli study settings\n"
                                  "  nazori-cli study settings new_per_day=7 desired_retention=0.92\n"
                                  "  nazori-cli study settings --weights weights.txt");
  verb->add_option("changes", asked->changes, "NAME=VALUE");
  verb->add_option("--weights", asked->weights,
                   "FSRS parameters (weights): 21, 19 or 17 numbers, as shown in Anki")
      ->type_name("FILE");
  add_writer_options(*verb, asked->options);
  verb->callback(
      [asked, &chosen] { chosen = [asked](Console& console) { return settings(console, *asked); }; });
}

}  // namespace nazori::cli
