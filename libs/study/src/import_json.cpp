// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <memory>

#include "base64.h"
#include "counted_text.h"
#include "nazori/base/file.h"
#include "nazori/base/utf8.h"
#include "nazori/json/reader.h"
#include "nazori/study/store_filling.h"
#include "text_pieces.h"

namespace nazori::study {
namespace {

using base::Errc;

constexpr int kDeepest = json::Limits{}.depth;
constexpr std::size_t kLongestInk = 4 << 20;
constexpr double kReading = 0.8;  // of an import; the rest works the cards out

struct ReadEntry {
  LogEntry entry;
  std::vector<std::uint8_t> ink;  ///< packed
};

/// A name that one of ours has; the first of ours and a failure otherwise.
template <class Value, class Find>
Value named(json::Reader::Object& object, const char* member, Value otherwise, Find find) {
  const std::string name = object.text(member, 40);
  const std::optional<Value> value = find(name);
  if (!value) object.refuse(member, "'" + name + "' is none that is known");
  return value.value_or(otherwise);
}

Day read_day(json::Reader::Object& object, const char* member) {
  const std::string text = object.text(member, 40);
  const auto day = parse_day(text);
  if (!day) object.refuse(member, "'" + text + "' " + day.error().what, day.error().remedy);
  return day.value_or(Day{});
}

char32_t read_character(json::Reader::Object& object) {
  const std::string text = object.text("character", 10);
  const auto decoded = base::decode_utf8(text);
  if (decoded && decoded->size() == 1 && decoded->front() != 0) return decoded->front();
  object.refuse("character", "must be one character");
  return 1;
}

void read_writing(json::Reader::Object& object, ReadEntry& one) {
  LogEntry& entry = one.entry;
  Writing& writing = entry.writing;
  WritingResult& result = writing.result;
  writing.stage = named(object, "stage", Stage::memory, stage_named);
  writing.rating = named(object, "rating", Rating::good, rating_named);
  writing.proposed = named(object, "proposed", Rating::good, rating_named);
  result.accepted = object.truth("accepted");
  result.score = static_cast<int>(object.whole("score", 0, 100));
  object.each("faults", [&](json::Reader::Object& mistake) {
    result.mistakes.push_back({named(mistake, "kind", kanji::MistakeKind::wrong, kanji::mistake_named),
                               static_cast<int>(mistake.whole("stroke", 0, 1'000))});
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
    if (!ink) object.refuse("ink", "is not readable handwriting data");
    one.ink = std::move(ink).value_or(std::vector<std::uint8_t>());
  }
}

ReadEntry read_entry(json::Reader::Object& object) {
  ReadEntry one;
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
    case EntryKind::settings:
    case EntryKind::choices: {
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
    case EntryKind::known:
      entry.character = read_character(object);
      if (object.has("until")) entry.until = read_day(object, "until");
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

std::vector<char32_t> read_characters(json::Reader::Object& object, const char* member) {
  const auto decoded = base::decode_utf8(object.text(member, 1 << 20));
  if (!decoded) {
    object.refuse(member, "is not UTF-8");
    return {};
  }
  return {decoded->begin(), decoded->end()};
}

/// Reads an export of a learner as it comes, and holds one entry, list or tag at a time.
class LearnerJson : public nlohmann::json_sax<json::Value> {
 public:
  LearnerJson(CountedText& text, LearnerStore::Filling& filling) : text_(text), filling_(filling) {}

  bool null() override { return value(nullptr); }
  bool boolean(bool truth) override { return value(truth); }
  bool number_integer(number_integer_t number) override { return value(number); }
  bool number_unsigned(number_unsigned_t number) override { return value(number); }
  bool number_float(number_float_t number, const string_t& /*text*/) override { return value(number); }
  bool string(string_t& text) override { return value(std::move(text)); }
  bool binary(binary_t& /*value*/) override { return value(nullptr); }
  bool start_object(std::size_t /*elements*/) override { return open(json::Value::object()); }
  bool end_object() override { return close(); }
  bool key(string_t& name) override {
    begin_token();
    (depth_ == 1 ? member_ : key_) = std::move(name);
    return true;
  }
  bool start_array(std::size_t /*elements*/) override { return open(json::Value::array()); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t /*byte*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    // The byte that does not belong was taken already.
    const bool next_line = text_.last() == '\n' && !text_.at_end();
    if (!error_)
      error_ = base::Error{Errc::parse, "is not JSON: " + json::reason_of(error),
                           fmt::format("line {}", text_.line() - (next_line ? 1 : 0)), ""};
    return false;
  }

  /// After the end, or where it was stopped.
  [[nodiscard]] base::Result<void> result() {
    if (text_.trouble()) return tl::unexpected(*text_.trouble());
    if (!error_) {
      for (std::size_t i = 0; i < kParts.size(); ++i)
        if (!seen_[i]) refuse_member(kParts[i], "is missing");
      for (const char* member : {"format", "version"})
        if (!head_.contains(member)) refuse_member(member, "is missing");
    }
    // Another format is the reason for whatever else does not fit.
    if (auto fine = check_head(); !fine) return fine;
    if (error_) return tl::unexpected(*error_);
    return {};
  }

 private:
  static constexpr std::array<const char*, 3> kParts{"entries", "lists", "tags"};
  static constexpr std::size_t kNoPart = kParts.size();

  bool open(json::Value container) {
    begin_token();
    if (++depth_ > kDeepest) {
      error_ = error_.value_or(base::Error{Errc::parse, "is nested too deeply", "the JSON text", ""});
      return false;
    }
    if (depth_ == 1) return container.is_object() || refuse_root();
    if (depth_ == 2) return open_member(container);
    if (is_ignored()) return true;
    if (depth_ == 3) {
      begin_element(std::move(container));
    } else {
      open_.push_back(put(std::move(container)));
    }
    return true;
  }

  bool open_member(const json::Value& container) {
    part_ = kNoPart;
    index_ = 0;
    for (std::size_t i = 0; i < kParts.size(); ++i)
      if (member_ == kParts[i]) part_ = i;
    if (part_ == kNoPart) return head(container);
    seen_[part_] = true;
    if (!container.is_array()) refuse_member(member_.c_str(), "is not a list", "give [ ... ]");
    return goes_on();
  }

  bool close() {
    begin_token();
    --depth_;
    if (depth_ == 1) part_ = kNoPart;
    if (depth_ < 2 || is_ignored()) return true;
    open_.pop_back();
    return depth_ > 2 || element(text_.part());
  }

  bool value(json::Value value) {
    begin_token();
    if (depth_ == 0) return refuse_root();
    if (depth_ == 1) {
      for (std::size_t i = 0; i < kParts.size(); ++i) {
        if (member_ != kParts[i]) continue;
        seen_[i] = true;
        refuse_member(kParts[i], "is not a list", "give [ ... ]");
      }
      return head(value);
    }
    if (is_ignored()) return true;
    if (depth_ > 2) {
      put(std::move(value));
      return true;
    }
    begin_element(std::move(value));
    return element({});
  }

  /// An element is limited as a whole, all else token by token: it is not held.
  void begin_token() {
    if (open_.empty()) text_.reset_limit();
  }
  [[nodiscard]] bool is_ignored() const { return part_ == kNoPart || error_.has_value(); }
  /// After a failure only the format is still looked for.
  [[nodiscard]] bool goes_on() const {
    return !error_ || !head_.contains("format") || !head_.contains("version");
  }

  void begin_element(json::Value value) {
    text_.begin_part();
    part_line_ = text_.line();
    element_ = std::move(value);
    open_.assign(1, &element_);
  }

  json::Value* put(json::Value value) {
    json::Value& into = *open_.back();
    if (into.is_array()) return &into.emplace_back(std::move(value));
    return &(into[key_] = std::move(value));
  }

  /// One entry, list or tag is whole.
  bool element(std::string_view text) {
    json::Reader reader(text, fmt::format("/{}/{}", kParts[part_], index_++), part_line_);
    json::Reader::Object object = reader.root(element_);
    auto taken = take(reader, object);
    text_.end_part();
    open_.clear();
    begin_token();
    if (reader.ok() && !taken && taken.error().code == Errc::bad_argument)
      reader.refuse("", taken.error().what, taken.error().remedy);
    if (!reader.ok()) {
      error_ = reader.error();
    } else if (!taken) {
      error_ = std::move(taken.error());
    }
    return goes_on();
  }

  base::Result<void> take(const json::Reader& reader, json::Reader::Object& object) {
    if (part_ == 0) {
      const ReadEntry one = read_entry(object);
      return reader.ok() ? filling_.add(one.entry, one.ink) : base::Result<void>();
    }
    const std::string name = object.text("name", 100);
    const std::vector<char32_t> characters = read_characters(object, "characters");
    if (!reader.ok()) return {};
    return part_ == 1 ? filling_.add_list({name, characters}) : filling_.add_tag(name, characters);
  }

  /// A member of the whole that is no list.
  bool head(const json::Value& value) {
    if (member_ != "format" && member_ != "version") return goes_on();
    head_[member_] = value;
    return check_head().has_value() && goes_on();
  }

  [[nodiscard]] base::Result<void> check_head() const {
    json::Reader reader({}, "", text_.line());
    json::Reader::Object root = reader.root(head_);
    const std::string format = head_.contains("format") ? root.text("format", 100) : kLearnerFormat;
    const std::int64_t version = head_.contains("version") ? root.whole("version", 1, 1'000'000) : 1;
    if (!reader.ok()) return tl::unexpected(reader.error());
    if (format == kLearnerFormat && version <= kLearnerFormatVersion) return {};
    return base::fail(Errc::schema,
                      format != kLearnerFormat
                          ? "is not an export of study data"
                          : fmt::format("is of version {}, written by a newer Nazori", version),
                      "line 1", "give a file that study export wrote");
  }

  bool refuse_root() {
    json::Reader reader({}, "", text_.line());
    reader.refuse("", "is not an object", "give { ... }");
    error_ = error_.value_or(reader.error());
    return false;
  }
  void refuse_member(const char* member, const char* what, const char* remedy = "") {
    if (error_) return;
    json::Reader reader({}, "", text_.line());
    reader.refuse(std::string("/") + member, what, remedy);
    error_ = reader.error();
  }

  CountedText& text_;
  LearnerStore::Filling& filling_;
  json::Value head_ = json::Value::object();  ///< format and version
  std::array<bool, kParts.size()> seen_{};
  int depth_ = 0;
  std::string member_;  ///< of the whole
  std::size_t part_ = kNoPart;
  std::size_t index_ = 0;
  json::Value element_;
  int part_line_ = 1;
  std::vector<json::Value*> open_;  ///< containers within the element, the innermost last
  std::string key_;
  std::optional<base::Error> error_;
};

base::Result<void> read_learner(const TextSource& json, LearnerStore::Filling& filling,
                                const base::Progress& progress) {
  CountedText text(json, progress);
  LearnerJson reader(text, filling);
  (void)json::Value::sax_parse(CountedTextIterator(text), CountedTextIterator(), &reader);
  return reader.result();
}

}  // namespace

TextSource text_source(std::string_view text) {
  const auto read = [rest = text](std::span<char> room) mutable -> base::Result<std::size_t> {
    const std::size_t count = rest.copy(room.data(), room.size());
    rest.remove_prefix(count);
    return count;
  };
  return {read, text.size()};
}

base::Result<TextSource> file_source(const std::filesystem::path& path) {
  auto opened = base::InputFile::open(path);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  const auto file = std::make_shared<base::InputFile>(*std::move(opened));
  const auto read = [file](std::span<char> room) {
    return file->read({reinterpret_cast<std::uint8_t*>(room.data()), room.size()});
  };
  return TextSource{read, file->size()};
}

base::Result<void> check_json(const TextSource& json, const base::Progress& progress) {
  return LearnerStore::check_contents(
      [&](LearnerStore::Filling& filling) { return read_learner(json, filling, progress); });
}

base::Result<void> import_json(LearnerStore& learner, const TextSource& json,
                               const base::Progress& progress) {
  return learner.fill(
      [&](LearnerStore::Filling& filling) {
        return read_learner(json, filling, base::part_of(progress, 0, kReading));
      },
      base::part_of(progress, kReading, 1));
}

}  // namespace nazori::study
