// SPDX-License-Identifier: Apache-2.0
// practise: a character, or a day's study, stage by stage: JSON Lines in and out.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "json_lines.h"
#include "nazori/author/collection.h"
#include "nazori/base/utf8.h"
#include "nazori/exchange/practice_events.h"
#include "nazori/exchange/practice_requests.h"
#include "nazori/practice/character_practice.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/stage_table.h"
#include "nazori/study/profiles.h"
#include "options.h"
#include "practised_hand.h"
#include "study_session.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

using base::Errc;
using base::fail;

struct PractiseSettings {
  StudyOptions options;
  std::string character;
  std::string stage = "watch";
  bool study = false;
};

/// The program without a window, and its reports since the last request.
class Practice {
 public:
  explicit Practice(const practice::Learner::Place& place)
      : learner_(inbox_, place), library_(inbox_, place.characters), judge_(inbox_, place.characters) {
    connect();
  }

  [[nodiscard]] base::Result<void> open_learner(const std::string& profile) {
    if (learner_.switch_profile(profile)) return {};
    const auto trouble = learner_.trouble();
    if (trouble && !trouble->error.what.empty()) return tl::unexpected(trouble->error);
    return fail(Errc::bad_argument, "cannot be opened for writing", profile, "close what has it open");
  }
  /// Shows a character at a stage, and waits until it is there.
  [[nodiscard]] base::Result<void> show(char32_t character, std::string_view stage);
  /// Begins today's session. @return false where nothing is due.
  bool start_study() {
    if (!session_.start()) return false;
    wait();
    return true;
  }
  /// Executes a request. @return the errors of an invalid request.
  [[nodiscard]] base::Result<void> execute(const Json& request);
  /// What happened since the last call, in order.
  [[nodiscard]] Json take_events() { return std::exchange(events_, Json::array()); }

 private:
  void connect();
  void report(const practice::PracticeStage& stage, const practice::StageFeedback& what);
  void report_session();
  template <class Event>
  void report(const Event& event) {
    events_.push_back(exchange::to_json(event));
  }
  [[nodiscard]] base::Result<void> obey(const writing::WrittenCharacter& ink);
  [[nodiscard]] base::Result<void> obey(const exchange::StageChoice& choice);
  [[nodiscard]] base::Result<void> obey(study::Rating rating);
  [[nodiscard]] base::Result<void> obey(const exchange::PracticeCommand& command);
  /// Waits until nothing is being looked up, carved or graded.
  void wait();

  base::Inbox inbox_;
  base::SystemClock clock_;
  practice::Learner learner_;
  practice::CharacterLibrary library_;
  practice::TabletWorkshop workshop_{inbox_};
  practice::WritingJudge judge_;
  practice::TabletControl tablet_{inbox_, clock_, {}};
  practice::StudySession session_{learner_, clock_};
  practice::CharacterPractice practice_{{inbox_, clock_, tablet_, library_, workshop_, judge_, session_}};
  PractisedHand hand_{tablet_};
  Json events_ = Json::array();
  char32_t coming_ = 0;  ///< the requested character, while it is not there yet
  bool is_missing_ = false;
  bool has_failed_ = false;
};

void Practice::connect() {
  practice_.feedback.connect([this](const practice::PracticeStage& stage,
                                    const practice::StageFeedback& what) { report(stage, what); });
  practice_.character_shown.connect([this](char32_t character) {
    coming_ = 0;
    report(exchange::CharacterShown{character, static_cast<int>(practice_.tablet()->lines().size()),
                                    std::string(practice_.current_stage().id())});
  });
  practice_.character_missing.connect([this](char32_t) {
    coming_ = 0;
    is_missing_ = true;
  });
  practice_.wanted.connect([this] {
    if (!practice_.is_entered()) practice_.enter();
  });
  for (const auto& stage : practice_.stages())
    stage->finished.connect([this, id = std::string(stage->id())](const study::WritingResult&) {
      report(exchange::StageFinished{id});
    });
  library_.failed.connect([this](const base::Error& error) {
    has_failed_ = true;
    events_.push_back(exchange::error_event(error));
  });
  session_.character_wanted.connect([this](char32_t character) {
    // A character that lies on the tablet is studied at once: it has been shown before this is called.
    const bool is_there = practice_.sheet() && practice_.sheet()->character.code_point == character;
    coming_ = is_there ? 0 : character;
  });
  session_.changed.connect([this] { report_session(); });
  session_.announced.connect([this](const practice::SessionFeedback& what) { report(what); });
}

void Practice::report(const practice::PracticeStage& stage, const practice::StageFeedback& what) {
  report(exchange::StageReport{std::string(stage.id()), what, stage.details(what)});
}

void Practice::report_session() {
  exchange::SessionProgress progress{session_.state(), {}, {}};
  if (session_.is_running()) {
    progress.task = {session_.character(), session_.stage(), session_.done(), session_.total()};
    if (session_.state() == practice::SessionState::judged) progress.proposed = session_.proposed();
  }
  Json event = exchange::to_json(progress);
  // Several things may change at once, and each emits a signal.
  if (events_.empty() || events_.back() != event) events_.push_back(std::move(event));
}

void Practice::wait() {
  inbox_.run_until([this] { return has_failed_ || (coming_ == 0 && !practice_.current_stage().is_busy()); });
}

base::Result<void> Practice::show(char32_t character, std::string_view stage) {
  practice_.set_first_character(character);
  if (auto* const first = practice_.stage_named(stage)) practice_.enter_stage(*first);
  coming_ = character;
  is_missing_ = false;
  if (practice_.is_entered())
    practice_.show(character);
  else
    practice_.enter();
  wait();
  if (is_missing_)
    return fail(Errc::not_found, "has no strokes in the database", base::encode_utf8(character));
  return {};
}

base::Result<void> Practice::execute(const Json& json) {
  const auto request = exchange::read_practice_request(json);
  if (!request) return tl::unexpected(request.error());
  auto done = std::visit([this](const auto& what) { return obey(what); }, *request);
  wait();
  return done;
}

base::Result<void> Practice::obey(const writing::WrittenCharacter& ink) {
  const writing::WritingBox box = ink.box.value_or(writing::WritingBox{{0, 0}, geometry::kGlyphSide});
  for (const auto& stroke : ink.strokes) {
    hand_.write(stroke, box);
    wait();
  }
  return {};
}

base::Result<void> Practice::obey(const exchange::StageChoice& choice) {
  auto* const stage = practice_.stage_named(choice.stage);
  if (stage == nullptr)
    return fail(Errc::bad_argument, "is not a stage", choice.stage, "give " + practice::stage_names());
  practice_.enter_stage(*stage);
  return {};
}

base::Result<void> Practice::obey(study::Rating rating) {
  session_.rate(rating);
  return {};
}

base::Result<void> Practice::obey(const exchange::PracticeCommand& command) {
  if (command.name == "go_on") {
    session_.go_on();
    return {};
  }
  if (command.name == "end") {
    session_.end();
    return {};
  }
  std::string names;
  for (const auto& can : practice_.current_stage().commands()) {
    if (can.name == command.name) {
      can.run();
      return {};
    }
    names += std::string(can.name) + ", ";
  }
  return fail(Errc::bad_argument, "cannot be done now", command.name,
              "give " + names + "or with --study go_on, end or a rating");
}

base::Result<char32_t> one_character(const std::string& text) {
  const auto decoded = base::decode_utf8(text);
  if (!decoded || decoded->size() != 1)
    return fail(Errc::bad_argument, "must be one character", text, "give one, or --study");
  return decoded->front();
}

std::vector<std::string> names_of_stages() {
  std::vector<std::string> names;
  for (const auto& kind : practice::stage_kinds()) names.emplace_back(kind.id);
  return names;
}

int run(Console& console, const PractiseSettings& settings) {
  if (settings.study != settings.character.empty())
    return console.refuse({Errc::bad_argument, "needs a character or --study, and not both", "practise",
                           "nazori-cli practise 休, or nazori-cli practise --study"});
  const auto database = settings.options.database.empty()
                            ? kanji::KanjiDatabase::locate()
                            : base::Result<std::filesystem::path>(settings.options.database);
  if (!database) return console.refuse(database.error());
  if (const auto opened = open_database(database->string()); !opened) return console.refuse(opened.error());
  const auto clock = study_clock(settings.options);
  if (!clock) return console.refuse(clock.error());
  practice::Learner::Place place;
  place.characters = {*database, author::Collection::usual_folder()};
  place.clock = *clock;
  if (settings.study) {
    const auto folder = learners_folder(settings.options);
    if (!folder) return console.refuse(folder.error());
    place.folder = *folder;
  }
  Practice practice(place);
  if (settings.study) {
    const std::string profile =
        settings.options.profile.empty() ? std::string(study::kDefaultProfile) : settings.options.profile;
    if (const auto opened = practice.open_learner(profile); !opened) return console.refuse(opened.error());
    (void)practice.start_study();
  } else {
    const auto character = one_character(settings.character);
    if (!character) return console.refuse(character.error());
    if (const auto shown = practice.show(*character, settings.stage); !shown)
      return console.refuse(shown.error());
  }
  console.print(exchange::to_line(exchange::events_document(practice.take_events())));
  if (!console.flush()) return kDone;
  return answer_lines(console, exchange::events_document(Json::array()),
                      [&](const Json& request) -> base::Result<Json> {
                        const auto done = practice.execute(request);
                        if (!done) return tl::unexpected(done.error());
                        return exchange::events_document(practice.take_events());
                      });
}

}  // namespace

void add_practise(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<PractiseSettings>();
  CLI::App* verb =
      app.add_subcommand("practise", "Practise a character, or study what is due: JSON Lines in and out");
  verb->add_option("character", settings->character, "The character to practise")->type_name("CHARACTER");
  verb->add_option("--stage", settings->stage, "The stage to begin with")
      ->check(CLI::IsMember(names_of_stages()))
      ->capture_default_str()
      ->type_name("STAGE");
  verb->add_flag("--study", settings->study, "Study what is due today, character by character");
  add_learner_options(*verb, settings->options);
  verb->add_option("--database", settings->options.database, "Kanji database to use")->type_name("FILE");
  verb->footer(
      "Reads one request a line and answers each with the events that followed, as docs/command-line.md "
      "describes.\n"
      "Requests: {\"strokes\": [[[x, y], ...], ...]}, {\"stage\": \"memory\"}, {\"do\": \"hint\"}.\n\n"
      "Examples:\n  echo '{\"do\": \"watch\"}' | nazori-cli practise 休\n"
      "  nazori-cli practise --study --profile aiko < requests.jsonl");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
