// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <openssl/evp.h>

#include "json_text.h"
#include "nazori/base/utf8.h"
#include "nazori/study/exchange.h"

namespace nazori::study {
namespace {

using base::Errc;

constexpr const char* kFormat = "nazori-learner";
constexpr int kVersion = 1;
constexpr std::size_t kLongestInk = 4 << 20;

std::string to_base64(std::span<const std::uint8_t> bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int size = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes.data(),
                                   static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(size));
  return text;
}

std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text) {
  std::vector<std::uint8_t> bytes(3 * (text.size() / 4) + 3);
  const int size = EVP_DecodeBlock(bytes.data(), reinterpret_cast<const unsigned char*>(text.data()),
                                   static_cast<int>(text.size()));
  if (size < 0 || text.size() % 4 != 0) return std::nullopt;
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
  bytes.resize(static_cast<std::size_t>(size) - padding);
  // One text for the same bytes, so that what was read is written alike.
  if (to_base64(bytes) != text) return std::nullopt;
  return bytes;
}

Json entry_json(const LearnerStore::Contents::Entry& one) {
  const LogEntry& entry = one.entry;
  Json json{{"id", entry.id},
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
      json["faults"] = Json::array();
      for (const StrokeFault& fault : result.faults) {
        json["faults"].push_back({{"kind", name_of(fault.kind)}, {"stroke", fault.stroke}});
      }
      json["hints"] = result.hints;
      json["misses"] = result.misses;
      json["shown_strokes"] = result.shown_strokes;
      json["help"] = result.help;
      json["duration_ms"] = static_cast<std::int64_t>(result.duration.count());
      json["strokes"] = entry.strokes;
      if (entry.interval_days) json["interval_days"] = *entry.interval_days;
      if (!one.ink.empty()) json["ink"] = to_base64(one.ink);
      break;
    }
    case EntryKind::undo:
      json["undoes"] = *entry.undoes;
      break;
    case EntryKind::settings:
      json["settings"] = Json::parse(entry.settings, nullptr, false);
      break;
    case EntryKind::postpone:
      json["until"] = to_text(*entry.until);
      break;
    case EntryKind::pause:
    case EntryKind::resume:
    case EntryKind::reset:
    case EntryKind::leech_met:
      break;
  }
  return json;
}

/// A name that one of ours has; the first of ours and a failure otherwise.
template <class Value, class Find>
Value named(JsonReader::Object& object, const char* member, Value otherwise, Find find) {
  const std::string name = object.text(member, 40);
  const std::optional<Value> value = find(name);
  if (!value) object.refuse(member, "'" + name + "' is none that is known");
  return value.value_or(otherwise);
}

Day read_day(JsonReader::Object& object, const char* member) {
  const std::string text = object.text(member, 40);
  const auto day = parse_day(text);
  if (!day) object.refuse(member, "'" + text + "' " + day.error().what, day.error().remedy);
  return day.value_or(Day{});
}

char32_t read_character(JsonReader::Object& object) {
  const std::string text = object.text("character", 10);
  const auto decoded = base::decode_utf8(text);
  if (decoded && decoded->size() == 1 && decoded->front() != 0) return decoded->front();
  object.refuse("character", "is not one character");
  return 1;
}

void read_writing(JsonReader::Object& object, LearnerStore::Contents::Entry& one) {
  LogEntry& entry = one.entry;
  Writing& writing = entry.writing;
  WritingResult& result = writing.result;
  writing.stage = named(object, "stage", Stage::memory, stage_named);
  writing.rating = named(object, "rating", Rating::good, rating_named);
  writing.proposed = named(object, "proposed", Rating::good, rating_named);
  result.accepted = object.truth("accepted");
  result.score = static_cast<int>(object.whole("score", 0, 100));
  object.each("faults", [&](JsonReader::Object& fault) {
    result.faults.push_back({named(fault, "kind", FaultKind::wrong, fault_named),
                             static_cast<int>(fault.whole("stroke", 0, 1'000))});
  });
  result.hints = static_cast<int>(object.whole("hints", 0, 1'000'000));
  result.misses = static_cast<int>(object.whole("misses", 0, 1'000'000));
  result.shown_strokes = static_cast<int>(object.whole("shown_strokes", 0, 1'000'000));
  result.help = object.number("help", 0, 1);
  result.duration = std::chrono::milliseconds(object.whole("duration_ms", 0, 86'400'000));
  entry.strokes = static_cast<int>(object.whole("strokes", 1, 1'000));
  if (object.has("interval_days"))
    entry.interval_days = static_cast<int>(object.whole("interval_days", 1, 36'600));
  if (object.has("ink")) {
    auto ink = from_base64(object.text("ink", kLongestInk));
    if (!ink) object.refuse("ink", "is no ink that can be read");
    one.ink = std::move(ink).value_or(std::vector<std::uint8_t>());
  }
}

LearnerStore::Contents::Entry read_entry(JsonReader::Object& object) {
  LearnerStore::Contents::Entry one;
  LogEntry& entry = one.entry;
  entry.id = object.whole("id", 1, 1'000'000'000);
  entry.action = object.whole("action", 1, 1'000'000'000);
  const std::string at = object.text("at", 40);
  if (const auto time = parse_time(at)) {
    entry.at = *time;
  } else {
    object.refuse("at", "'" + at + "' " + time.error().what, time.error().remedy);
  }
  entry.day = read_day(object, "day");
  entry.kind = named(object, "kind", EntryKind::pause, entry_kind_named);
  switch (entry.kind) {
    case EntryKind::undo:
      entry.undoes = object.whole("undoes", 1, 1'000'000'000);
      break;
    case EntryKind::settings: {
      // Settings without what a newer version would add are whole, so they are kept as they were written.
      entry.settings = object.raw("settings");
      if (const auto settings = parse_settings(entry.settings); !settings) {
        object.refuse("settings", settings.error().what, settings.error().remedy);
      }
      break;
    }
    case EntryKind::writing:
      entry.character = read_character(object);
      read_writing(object, one);
      break;
    case EntryKind::postpone:
      entry.character = read_character(object);
      entry.until = read_day(object, "until");
      break;
    case EntryKind::pause:
    case EntryKind::resume:
    case EntryKind::reset:
    case EntryKind::leech_met:
      entry.character = read_character(object);
      break;
  }
  return one;
}

std::vector<char32_t> read_characters(JsonReader::Object& object, const char* member) {
  const auto decoded = base::decode_utf8(object.text(member, 1 << 20));
  if (!decoded) {
    object.refuse(member, "is not UTF-8");
    return {};
  }
  return {decoded->begin(), decoded->end()};
}

}  // namespace

base::Result<std::string> export_json(const LearnerStore& learner, const base::Progress& progress) {
  auto contents = learner.contents();
  if (!contents) return tl::unexpected(std::move(contents.error()));
  // A line for each entry, so that the file can be read, compared and named by line.
  std::string text = fmt::format("{{\"format\": \"{}\", \"version\": {},\n\"entries\": [", kFormat, kVersion);
  const char* between = "\n";
  for (const auto& one : contents->entries) {
    text += between + entry_json(one).dump();
    between = ",\n";
    if (progress && one.entry.id % 256 == 0 &&
        !progress(static_cast<double>(one.entry.id) / static_cast<double>(contents->entries.size()),
                  "export")) {
      return base::fail(Errc::cancelled, "stopped");
    }
  }
  text += "\n],\n\"lists\": [";
  between = "\n";
  for (const CustomList& list : contents->lists) {
    const std::u32string characters(list.characters.begin(), list.characters.end());
    text += between + Json{{"name", list.name}, {"characters", base::encode_utf8(characters)}}.dump();
    between = ",\n";
  }
  text += "\n],\n\"tags\": [";
  between = "\n";
  for (const auto& [tag, members] : contents->tags) {
    const std::u32string characters(members.begin(), members.end());
    text += between + Json{{"name", tag}, {"characters", base::encode_utf8(characters)}}.dump();
    between = ",\n";
  }
  text += "\n]}\n";
  return text;
}

base::Result<LearnerStore::Contents> read_json(std::string_view json) {
  const auto document = parse_json(json);
  if (!document) return tl::unexpected(document.error());
  JsonReader reader(json);
  JsonReader::Object root = reader.root(*document);
  const std::string format = root.text("format", 100);
  const std::int64_t version = root.whole("version", 1, 1'000'000);
  if (!reader.ok()) return tl::unexpected(reader.error());
  if (format != kFormat || version > kVersion) {
    return base::fail(Errc::schema,
                      format != kFormat ? "is no export of a learner"
                                        : fmt::format("is of version {}, written by a newer Nazori", version),
                      "line 1", "give a file that study export wrote");
  }
  LearnerStore::Contents contents;
  root.each("entries", [&](JsonReader::Object& object) { contents.entries.push_back(read_entry(object)); });
  root.each("lists", [&](JsonReader::Object& object) {
    std::string name = object.text("name", 100);
    contents.lists.push_back({std::move(name), read_characters(object, "characters")});
  });
  root.each("tags", [&](JsonReader::Object& object) {
    std::string name = object.text("name", 100);
    contents.tags[std::move(name)] = read_characters(object, "characters");
  });
  if (!reader.ok()) return tl::unexpected(reader.error());
  const auto fine = LearnerStore::check_contents(contents);
  if (fine) return contents;
  for (std::size_t i = 0; i < contents.entries.size(); ++i) {
    if (fine.error().where != fmt::format("entry {}", contents.entries[i].entry.id)) continue;
    reader.refuse("/entries/" + std::to_string(i), fine.error().what, fine.error().remedy);
    return tl::unexpected(reader.error());
  }
  return tl::unexpected(fine.error());
}

base::Result<void> import_json(LearnerStore& learner, std::string_view json, const base::Progress& progress) {
  const auto contents = read_json(json);
  if (!contents) return tl::unexpected(contents.error());
  return learner.fill(*contents, progress);
}

}  // namespace nazori::study
