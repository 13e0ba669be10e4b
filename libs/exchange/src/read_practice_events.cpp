// SPDX-License-Identifier: Apache-2.0
// Events of practice, read back.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "nazori/exchange/characters.h"
#include "nazori/exchange/practice_events.h"
#include "nazori/kanji/mistake_kind.h"
#include "nazori/practice/event_names.h"
#include "reading.h"

namespace nazori::exchange {
namespace {

using practice::SessionFeedback;
using practice::StageDetails;
using practice::StageEvent;

constexpr int kMost = 1'000'000;

/// The members of a stage's report that every stage may have; all others are details.
constexpr std::array<std::string_view, 14> kShared{"event",   "stage", "what",    "tone", "stroke",
                                                   "other",   "count", "speed",   "type", "ending",
                                                   "leading", "help",  "mistake", "error"};

/// @param is_shared  of names that are no details. @return whether all of them can be details.
template <class IsShared>
bool read_details(const Value& object, const IsShared& is_shared, StageDetails& details);

bool read_detail(const Value& value, practice::StageDetail& detail) {
  if (value.is_boolean()) {
    detail.value = value.get<bool>();
  } else if (value.is_number_integer()) {
    if (value < -kMost || value > kMost) return false;
    detail.value = value.get<int>();
  } else if (value.is_string()) {
    detail.value = value.get<std::string>();
  } else if (value.is_array() && !value.empty() && value.front().is_object()) {
    auto& all = detail.value.emplace<std::vector<StageDetails>>();
    for (const auto& one : value)
      if (!read_details(
              one, [](std::string_view) { return false; }, all.emplace_back()))
        return false;
  } else if (value.is_array()) {
    auto& texts = detail.value.emplace<std::vector<std::string>>();
    for (const auto& one : value) {
      if (!one.is_string()) return false;
      texts.push_back(one.get<std::string>());
    }
  } else {
    return false;
  }
  return true;
}

template <class IsShared>
bool read_details(const Value& object, const IsShared& is_shared, StageDetails& details) {
  if (!object.is_object()) return false;
  for (const auto& [name, value] : object.items()) {
    if (is_shared(name)) continue;
    practice::StageDetail detail{name, false};
    if (!read_detail(value, detail)) return false;
    details.push_back(std::move(detail));
  }
  return true;
}

base::Error error_of_line(std::string line) { return {base::Errc::io, std::move(line), "", ""}; }

/// The text itself, which lives as long as the document.
std::string_view text_in(const Value& object, const char* member) {
  return object.find(member)->get_ref<const std::string&>();
}

int read_number(JsonObject& from, const char* member) {
  return from.is_there(member) ? static_cast<int>(from.whole(member, 1, kMost)) : 0;
}

StageReport read_report(JsonObject& from, const Value& event) {
  StageReport report;
  practice::StageFeedback& what = report.feedback;
  report.stage = from.text("stage");
  const std::string name = from.text("what");
  const auto known = enumerator_named(name, StageEvent::judges_at_end,
                                      [](StageEvent one) { return practice::name_of(one); });
  what.event = known.value_or(StageEvent::own);
  what.tone = read_name(from, "tone", [](std::string_view text) {
    return enumerator_named(text, practice::Tone::wrong,
                            [](practice::Tone one) { return practice::name_of(one); });
  });
  what.stroke = read_number(from, "stroke");
  what.other = read_number(from, "other");
  what.count = read_number(from, "count");
  if (what.event == StageEvent::speed_changed) what.value = from.number("speed", 0, kMost);
  if (what.event == StageEvent::stroke_watched) {
    what.type = from.text("type");
    what.ending = read_name(from, "ending", [](std::string_view text) {
      return enumerator_named(text, kanji::StrokeEnding::either,
                              [](kanji::StrokeEnding one) { return name_of(one); });
    });
  }
  if (from.is_there("leading")) {
    const std::string leading = from.text("leading");
    what.leading = leading == "leading" ? practice::Leading::leading : practice::Leading::missing;
    if (leading != "leading" && leading != "missing") from.refuse("leading", "is a name that is not known");
  }
  if (from.is_there("help")) {
    what.more = practice::MistakeHelp::hint;
    if (from.text("help") != "hint") from.refuse("help", "is a name that is not known");
  }
  if (from.is_there("mistake"))
    what.mistake.emplace().kind = read_name(from, "mistake", kanji::mistake_named);
  if (from.is_there("error")) what.error = error_of_line(from.text("error"));
  if (event.is_object() && event.contains("what") && event["what"].is_string() && !known)
    what.own = text_in(event, "what");
  const auto is_shared = [](std::string_view member) {
    return std::find(kShared.begin(), kShared.end(), member) != kShared.end();
  };
  if (!read_details(event, is_shared, report.details)) from.refuse("what", "has details that cannot be read");
  return report;
}

SessionProgress read_progress(JsonObject& from) {
  SessionProgress progress;
  progress.state = read_name(from, "state", [](std::string_view text) {
    return enumerator_named(text, practice::SessionState::judged,
                            [](practice::SessionState one) { return practice::name_of(one); });
  });
  if (from.is_there("char"))
    progress.task = {read_character(from, "char"), read_name(from, "stage", study::stage_named),
                     static_cast<int>(from.whole("done", 0, kMost)),
                     static_cast<int>(from.whole("total", 0, kMost))};
  if (from.is_there("proposed")) progress.proposed = read_name(from, "proposed", study::rating_named);
  return progress;
}

SessionFeedback read_feedback(JsonObject& from) {
  SessionFeedback feedback;
  feedback.kind = read_name(from, "what", [](std::string_view text) {
    return enumerator_named(text, SessionFeedback::Kind::reset,
                            [](SessionFeedback::Kind one) { return practice::name_of(one); });
  });
  if (from.is_there("char")) feedback.characters = {read_character(from, "char")};
  if (feedback.kind == SessionFeedback::Kind::rated)
    feedback.rating = read_name(from, "rating", study::rating_named);
  if (from.is_there("error")) feedback.error = error_of_line(from.text("error"));
  return feedback;
}

}  // namespace

base::Result<PracticeEvent> read_practice_event(const Value& event) {
  json::Reader reader("");
  auto from = reader.root(event);
  const std::string kind = from.text("event");
  PracticeEvent read;
  if (kind == "character") {
    const char32_t character = read_character(from, "char");
    const auto strokes = static_cast<int>(from.whole("strokes", 0, kMost));
    read = CharacterShown{character, strokes, from.text("stage")};
  } else if (kind == "feedback") {
    read = read_report(from, event);
  } else if (kind == "finished") {
    read = StageFinished{from.text("stage")};
  } else if (kind == "session") {
    read = read_progress(from);
  } else if (kind == "announced") {
    read = read_feedback(from);
  } else if (kind == "error") {
    read = FailureEvent{from.text("error")};
  } else {
    from.refuse("event", "is a name that is not known");
  }
  if (!reader.ok()) return tl::unexpected(reader.error());
  return read;
}

Value to_json(const PracticeEvent& event) {
  return std::visit(
      [](const auto& one) -> Value {
        if constexpr (std::is_same_v<std::decay_t<decltype(one)>, FailureEvent>)
          return {{"event", "error"}, {"error", one.line}};
        else
          return to_json(one);
      },
      event);
}

}  // namespace nazori::exchange
