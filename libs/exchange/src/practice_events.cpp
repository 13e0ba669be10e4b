// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/practice_events.h"

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "nazori/base/utf8.h"
#include "nazori/exchange/characters.h"
#include "nazori/kanji/mistake_kind.h"
#include "nazori/practice/event_names.h"

namespace nazori::exchange {
namespace {

std::string_view name_of(practice::Leading leading) {
  return leading == practice::Leading::leading ? "leading" : "missing";
}

void add(const practice::StageDetails& details, Value& to);

Value detail_json(bool value) { return value; }
Value detail_json(int value) { return value; }
Value detail_json(const std::string& value) { return value; }
Value detail_json(const std::vector<std::string>& values) { return values; }
Value detail_json(const std::vector<practice::StageDetails>& all) {
  Value list = Value::array();
  for (const auto& details : all) add(details, list.emplace_back(Value::object()));
  return list;
}

void add(const practice::StageDetails& details, Value& to) {
  for (const auto& detail : details)
    to[std::string(detail.name)] =
        std::visit([](const auto& value) { return detail_json(value); }, detail.value);
}

}  // namespace

Value to_json(const CharacterShown& event) {
  return {{"event", "character"},
          {"char", base::encode_utf8(event.character)},
          {"strokes", event.strokes},
          {"stage", event.stage}};
}

Value to_json(const StageReport& event) {
  const practice::StageFeedback& what = event.feedback;
  Value json{{"event", "feedback"},
             {"stage", event.stage},
             {"what", practice::name_of(what)},
             {"tone", practice::name_of(what.tone)}};
  if (what.stroke > 0) json["stroke"] = what.stroke;
  if (what.other > 0) json["other"] = what.other;
  if (what.count > 0) json["count"] = what.count;
  if (what.event == practice::StageEvent::speed_changed) json["speed"] = what.value;
  if (what.event == practice::StageEvent::stroke_watched) {
    json["type"] = what.type;
    json["ending"] = name_of(what.ending);
  }
  if (what.leading != practice::Leading::none) json["leading"] = name_of(what.leading);
  if (what.written != 0) json["written"] = base::encode_utf8(what.written);
  if (what.asked != 0) json["asked"] = base::encode_utf8(what.asked);
  if (what.more == practice::MistakeHelp::hint) json["help"] = "hint";
  if (what.mistake) json["mistake"] = kanji::name_of(what.mistake->kind);
  if (what.error) json["error"] = base::to_line(*what.error);
  add(event.details, json);
  return json;
}

Value to_json(const StageFinished& event) { return {{"event", "finished"}, {"stage", event.stage}}; }

Value to_json(const SessionProgress& event) {
  Value json{{"event", "session"}, {"state", practice::name_of(event.state)}};
  if (event.task) {
    json["char"] = base::encode_utf8(event.task->character);
    json["stage"] = study::name_of(event.task->stage);
    json["done"] = event.task->done;
    json["total"] = event.task->total;
  }
  if (event.proposed) json["proposed"] = study::name_of(*event.proposed);
  return json;
}

Value to_json(const practice::SessionFeedback& event) {
  Value json{{"event", "announced"}, {"what", practice::name_of(event.kind)}};
  if (!event.characters.empty()) json["char"] = base::encode_utf8(event.characters.front());
  if (event.kind == practice::SessionFeedback::Kind::rated) json["rating"] = study::name_of(event.rating);
  if (!event.error.what.empty()) json["error"] = base::to_line(event.error);
  return json;
}

Value error_event(const base::Error& error) { return {{"event", "error"}, {"error", base::to_line(error)}}; }

Value events_document(Value events) { return {{"events", std::move(events)}}; }

}  // namespace nazori::exchange
