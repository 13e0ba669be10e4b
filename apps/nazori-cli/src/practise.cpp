// SPDX-License-Identifier: Apache-2.0
// practise: a character, or a day's study, stage by stage: JSON Lines in and out.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "json_lines.h"
#include "nazori/base/utf8.h"
#include "nazori/practice/character_practice.h"
#include "nazori/practice/event_names.h"
#include "nazori/practice/learner.h"
#include "nazori/study/profiles.h"
#include "options.h"
#include "practised_hand.h"
#include "study_session.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

using base::Errc;
using base::fail;
using study::Stage;

struct PractiseSettings {
  StudyOptions options;
  std::string character;
  std::string stage = "watch";
  bool study = false;
};

/// The program without a window, and what it has to report since it was last asked.
class Practice {
 public:
  Practice(const std::filesystem::path& database, practice::Learner::Place place)
      : learner_(inbox_, std::move(place)), library_(inbox_, database), judge_(inbox_, database) {
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
  /// Begins what is due today. @return false where nothing is due.
  bool start_study() {
    if (!session_.start()) return false;
    wait();
    return true;
  }
  /// Does what a request asks for. @return the errors of a request that cannot be read.
  [[nodiscard]] base::Result<void> answer(const Json& request);
  /// What happened since the last call, in order.
  [[nodiscard]] Json take_events() { return std::exchange(events_, Json::array()); }

 private:
  void connect();
  void report(const practice::PracticeStage& stage, const practice::StageFeedback& what);
  void report_session();
  [[nodiscard]] base::Result<void> obey(const std::string& what);
  [[nodiscard]] base::Result<void> write(const Json& request);
  [[nodiscard]] base::Result<void> enter_stage(const std::string& name);
  /// Until nothing is being looked up, carved or judged any more.
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
  char32_t coming_ = 0;  ///< the character that was asked for and is not there yet
  bool is_missing_ = false;
  bool has_failed_ = false;
};

void Practice::connect() {
  practice_.feedback.connect([this](const practice::PracticeStage& stage,
                                    const practice::StageFeedback& what) { report(stage, what); });
  practice_.character_shown.connect([this](char32_t character) {
    coming_ = 0;
    events_.push_back({{"event", "character"},
                       {"char", base::encode_utf8(character)},
                       {"strokes", tablet_.stroke_count()},
                       {"stage", study::name_of(practice_.current_stage().stage())}});
  });
  practice_.character_missing.connect([this](char32_t) {
    coming_ = 0;
    is_missing_ = true;
  });
  practice_.wanted.connect([this] {
    if (!practice_.is_entered()) practice_.enter();
  });
  for (auto* const stage : practice_.stages())
    stage->finished.connect([this, stage](const study::WritingResult&) {
      events_.push_back({{"event", "finished"}, {"stage", study::name_of(stage->stage())}});
    });
  library_.failed.connect([this](const base::Error& error) {
    has_failed_ = true;
    events_.push_back({{"event", "error"}, {"error", base::to_line(error)}});
  });
  session_.character_wanted.connect([this](char32_t character) { coming_ = character; });
  session_.changed.connect([this] { report_session(); });
  session_.announced.connect([this](const practice::SessionFeedback& what) {
    Json event{{"event", "announced"}, {"what", practice::name_of(what.kind)}};
    if (!what.characters.empty()) event["char"] = base::encode_utf8(what.characters.front());
    if (what.kind == practice::SessionFeedback::Kind::rated) event["rating"] = study::name_of(what.rating);
    if (!what.error.what.empty()) event["error"] = base::to_line(what.error);
    events_.push_back(std::move(event));
  });
}

void Practice::report(const practice::PracticeStage& stage, const practice::StageFeedback& what) {
  Json event{{"event", "feedback"},
             {"stage", study::name_of(stage.stage())},
             {"what", practice::name_of(what.event)},
             {"tone", practice::name_of(what.tone)}};
  if (what.stroke > 0) event["stroke"] = what.stroke;
  if (what.other > 0) event["other"] = what.other;
  if (what.count > 0) event["count"] = what.count;
  if (what.mistake) event["mistake"] = kanji::name_of(what.mistake->kind);
  if (what.error) event["error"] = base::to_line(*what.error);
  if (what.event == practice::StageEvent::judged) {
    event["accepted"] = practice_.memory().grade().accepted;
    event["score"] = practice_.memory().grade().score;
  }
  events_.push_back(std::move(event));
}

void Practice::report_session() {
  Json event{{"event", "session"}, {"state", practice::name_of(session_.state())}};
  if (session_.is_running()) {
    event["char"] = base::encode_utf8(session_.character());
    event["stage"] = study::name_of(session_.stage());
    event["done"] = session_.done();
    event["total"] = session_.total();
    if (session_.state() == practice::StudySession::State::judged)
      event["proposed"] = study::name_of(session_.proposed());
  }
  // Several things may change at once, and each says so.
  if (events_.empty() || events_.back() != event) events_.push_back(std::move(event));
}

void Practice::wait() {
  inbox_.run_until([this] { return has_failed_ || (coming_ == 0 && !practice_.memory().is_judging()); });
}

base::Result<void> Practice::show(char32_t character, std::string_view stage) {
  practice_.set_first_character(character);
  practice_.enter_stage(practice_.stage_for(study::stage_named(stage).value_or(Stage::watch)));
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

base::Result<void> Practice::answer(const Json& request) {
  base::Result<void> done;
  if (request.contains("strokes"))
    done = write(request);
  else if (const auto what = request.find("do"); what != request.end() && what->is_string())
    done = obey(what->get<std::string>());
  else if (const auto stage = request.find("stage"); stage != request.end() && stage->is_string())
    done = enter_stage(stage->get<std::string>());
  else
    return fail(Errc::parse, "asks for nothing", "request", "give strokes, stage or do");
  wait();
  return done;
}

base::Result<void> Practice::write(const Json& request) {
  const auto ink = read_ink(request);
  if (!ink) return tl::unexpected(ink.error());
  const writing::WritingBox box = ink->box.value_or(writing::WritingBox{{0, 0}, geometry::kGlyphSide});
  for (const auto& stroke : ink->strokes) {
    hand_.write(stroke, box);
    wait();
  }
  return {};
}

base::Result<void> Practice::enter_stage(const std::string& name) {
  const auto stage = study::stage_named(name);
  if (!stage) return fail(Errc::bad_argument, "is no stage", name, "give watch, trace, guided or memory");
  practice_.enter_stage(practice_.stage_for(*stage));
  return {};
}

base::Result<void> Practice::obey(const std::string& what) {
  auto& memory = practice_.memory();
  if (const auto rating = study::rating_named(what)) {
    session_.rate(*rating);
    return {};
  }
  const bool is_memory = memory.is_entered();
  if (what == "watch" && practice_.watch().is_entered()) {
    const int stops = practice_.watch().player().stroke_count() + 1;
    for (int i = 0; i < stops; ++i) practice_.watch().step(+1);
  } else if (what == "go_on") {
    session_.go_on();
  } else if (what == "undo") {
    is_memory ? memory.undo() : tablet_.undo_ink();
  } else if (what == "clear") {
    is_memory ? memory.start_over() : tablet_.clear_ink();
  } else if (what == "hint" && is_memory) {
    memory.give_hint();
  } else if (what == "answer" && is_memory) {
    memory.show_answer();
  } else if (what == "finish" && is_memory) {
    memory.finish_writing();
  } else if (what == "end") {
    session_.end();
  } else {
    return fail(
        Errc::bad_argument, "cannot be done now", what,
        "give watch, undo, clear, hint, answer, finish, go_on, end or a rating, where they make sense");
  }
  return {};
}

base::Result<char32_t> one_character(const std::string& text) {
  const auto decoded = base::decode_utf8(text);
  if (!decoded || decoded->size() != 1)
    return fail(Errc::bad_argument, "is not one character", text, "give one, or --study");
  return decoded->front();
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
  place.database = *database;
  place.clock = *clock;
  if (settings.study) {
    const auto folder = learners_folder(settings.options);
    if (!folder) return console.refuse(folder.error());
    place.folder = *folder;
  }
  Practice practice(*database, std::move(place));
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
  console.print(Json{{"events", practice.take_events()}}.dump() + "\n");
  if (!console.flush()) return kDone;
  return answer_lines(console, Json{{"events", Json::array()}},
                      [&](const Json& request) -> base::Result<Json> {
                        const auto done = practice.answer(request);
                        if (!done) return tl::unexpected(done.error());
                        return Json{{"events", practice.take_events()}};
                      });
}

}  // namespace

void add_practise(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<PractiseSettings>();
  CLI::App* verb =
      app.add_subcommand("practise", "Practise a character, or study what is due: JSON Lines in and out");
  verb->add_option("character", settings->character, "The character to practise")->type_name("CHARACTER");
  verb->add_option("--stage", settings->stage, "The stage to begin with")
      ->check(CLI::IsMember({"watch", "trace", "guided", "memory"}))
      ->capture_default_str()
      ->type_name("STAGE");
  verb->add_flag("--study", settings->study, "Study what is due today, character by character");
  add_learner_options(*verb, settings->options);
  verb->add_option("--database", settings->options.database, "The kanji database to read")->type_name("FILE");
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
