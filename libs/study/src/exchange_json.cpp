// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base64.h"
#include "entry_progress.h"
#include "nazori/base/utf8.h"
#include "nazori/json/json.h"
#include "text_pieces.h"

namespace nazori::study {
namespace {

using base::Errc;

json::Value entry_json(const LogEntry& entry, std::span<const std::uint8_t> ink) {
  json::Value json{{"id", entry.id},
                   {"action", entry.action},
                   {"at", to_text(entry.at)},
                   {"day", to_text(entry.day)},
                   {"kind", name_of(entry.kind)}};
  if (entry.character != 0) json["character"] = base::encode_utf8(entry.character);
  switch (entry.kind) {
    case EntryKind::writing: {
      const Writing& writing = entry.writing;
      const WritingResult& result = writing.result;
      json["stage"] = name_of(writing.stage);
      json["rating"] = name_of(writing.rating);
      json["proposed"] = name_of(writing.proposed);
      json["accepted"] = result.accepted;
      json["score"] = result.score;
      json["faults"] = json::Value::array();
      for (const StrokeMistake& mistake : result.mistakes) {
        json["faults"].push_back({{"kind", name_of(mistake.kind)}, {"stroke", mistake.stroke}});
      }
      json["hints"] = result.hints;
      json["misses"] = result.misses;
      json["shown_strokes"] = result.shown_strokes;
      json["help"] = result.help;
      json["duration_ms"] = static_cast<std::int64_t>(result.duration.count());
      json["strokes"] = entry.strokes;
      if (entry.interval_days) json["interval_days"] = *entry.interval_days;
      if (!ink.empty()) json["ink"] = to_base64(ink);
      break;
    }
    case EntryKind::undo:
      json["undoes"] = *entry.undoes;
      break;
    case EntryKind::settings:
    case EntryKind::choices:
      json["settings"] = json::parse(entry.settings).value_or(json::Value());
      break;
    case EntryKind::postpone:
      json["until"] = to_text(*entry.until);
      break;
    case EntryKind::known:
      if (entry.until) json["until"] = to_text(*entry.until);
      break;
    case EntryKind::pause:
    case EntryKind::resume:
    case EntryKind::reset:
    case EntryKind::leech_met:
      break;
  }
  return json;
}

}  // namespace

base::Result<void> export_json(const LearnerStore& learner, const TextSink& sink,
                               const base::Progress& progress) {
  TextPieces text(sink);
  const auto between = [](bool& first) { return std::exchange(first, false) ? "\n" : ",\n"; };
  // A line for each entry, so that the file can be read, compared and named by line.
  text.add(fmt::format("{{\"format\": \"{}\", \"version\": {},\n\"entries\": [", kLearnerFormat,
                       kLearnerFormatVersion));
  bool first = true;
  bool stopped = false;
  const auto all = static_cast<double>(std::max<std::int64_t>(1, learner.last_entry()));
  auto read = learner.for_each_with_ink(
      [&](const LearnerStore::LoggedEntry& logged, std::span<const std::uint8_t> ink) {
        if (progress && logged.entry.id % kEntriesBetweenProgress == 0)
          stopped = !progress(std::min(1.0, static_cast<double>(logged.entry.id) / all), "export");
        text.add(between(first));
        text.add(entry_json(logged.entry, ink).dump());
        return !stopped && text.ok();
      });
  if (!read) return read;
  if (stopped) return base::fail(Errc::cancelled, "stopped");
  const auto add_list = [&](const std::string& name, const std::vector<char32_t>& members) {
    const std::u32string characters(members.begin(), members.end());
    text.add(between(first));
    text.add(json::Value{{"name", name}, {"characters", base::encode_utf8(characters)}}.dump());
  };
  const auto lists = learner.lists();
  if (!lists) return tl::unexpected(lists.error());
  text.add("\n],\n\"lists\": [");
  first = true;
  for (const CustomList& list : *lists) add_list(list.name, list.characters);
  const auto tags = learner.tags();
  if (!tags) return tl::unexpected(tags.error());
  text.add("\n],\n\"tags\": [");
  first = true;
  for (const auto& [tag, members] : *tags) add_list(tag, members);
  text.add("\n]}\n");
  return text.finish();
}

base::Result<std::string> export_json(const LearnerStore& learner) {
  return as_one_text([&](const TextSink& sink) { return export_json(learner, sink); });
}

}  // namespace nazori::study
