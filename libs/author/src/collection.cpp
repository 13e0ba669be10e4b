// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/collection.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <set>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "nazori/author/character_file.h"
#include "nazori/base/program_folders.h"
#include "nazori/base/utf8.h"
#include "nazori/carving/groove.h"
#include "nazori/kanji/character_name.h"

namespace nazori::author {
namespace {

namespace fs = std::filesystem;
using base::Errc;

constexpr std::string_view kKeptEnding = ".nazori";
constexpr std::string_view kRemovedEnding = ".removed";
constexpr std::string_view kCodePointMark = "U+";
constexpr std::string_view kLockName = ".lock";  ///< held by what changes the folder

/// "U+F1A2B.nazori" names a character; anything else in the folder is not ours.
std::optional<char32_t> kept_code_point(const std::string& file_name) {
  std::string_view digits = file_name;
  if (!digits.starts_with(kCodePointMark) || !digits.ends_with(kKeptEnding)) return std::nullopt;
  digits.remove_prefix(kCodePointMark.size());
  digits.remove_suffix(kKeptEnding.size());
  std::uint32_t value = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) return std::nullopt;
  const auto code_point = static_cast<char32_t>(value);
  // Another spelling of a number would be a second file of the same character.
  if (!kanji::is_own(code_point) ||
      kanji::code_point_text(code_point) + std::string(kKeptEnding) != file_name)
    return std::nullopt;
  return code_point;
}

/// FNV-1a. @source G. Fowler, L. C. Noll and K.-P. Vo, draft-eastlake-fnv.
std::uint32_t hash_of(std::string_view text) {
  std::uint32_t hash = 2'166'136'261U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 16'777'619U;
  }
  return hash;
}

std::optional<char32_t> free_code_point(const std::string& name, const std::set<char32_t>& taken) {
  constexpr std::uint32_t kCount = kanji::kLastOwn - kanji::kFirstOwn + 1;
  const std::uint32_t first = hash_of(name) % kCount;
  for (std::uint32_t step = 0; step < kCount; ++step) {
    const char32_t code_point = kanji::kFirstOwn + (first + step) % kCount;
    if (!taken.contains(code_point)) return code_point;
  }
  return std::nullopt;
}

bool is_katakana(const std::string& reading) {
  const auto letters = base::decode_utf8(reading);
  return letters && std::ranges::all_of(*letters, [](char32_t c) { return c >= 0x30A0 && c <= 0x30FF; });
}

kanji::Stroke kanji_stroke(const OwnStroke& own) {
  kanji::Stroke stroke;
  for (const carving::SmoothPoint& point : carving::smooth_line(own.points)) {
    stroke.line.points.push_back(point.at);
    stroke.path += fmt::format("{}{},{}", stroke.path.empty() ? 'M' : 'L', point.at.x, point.at.y);
  }
  stroke.line.ending = own.ending;
  stroke.line.number_position = own.number_position;
  return stroke;
}

kanji::Component component_of(const OwnPart& part) {
  kanji::Component component;
  component.element = part.name;
  component.strokes = part.strokes;
  component.first_stroke = part.strokes.empty() ? 0 : part.strokes.front();
  return component;
}

}  // namespace

kanji::Character kanji_character(const OwnCharacter& character, char32_t code_point) {
  const Facts& facts = character.facts;
  kanji::Character out;
  out.code_point = code_point;
  for (const OwnStroke& stroke : character.strokes) out.strokes.push_back(kanji_stroke(stroke));
  std::vector<int> all(character.strokes.size());
  std::iota(all.begin(), all.end(), 0);
  kanji::Component whole;
  whole.strokes = all;
  for (const OwnPart& part : facts.parts)
    if (!part.strokes.empty()) whole.children.push_back(component_of(part));
  const auto letters = base::decode_utf8(facts.name);
  if (letters && letters->size() == 1) {
    whole.element = facts.name;
    out.components.strokes = std::move(all);
    out.components.children.push_back(std::move(whole));
  } else {
    out.components = std::move(whole);
  }
  kanji::DictionaryEntry& entry = out.entry;
  for (const std::string& reading : facts.readings)
    (is_katakana(reading) ? entry.on_readings : entry.kun_readings).push_back(reading);
  for (const std::string& meaning : facts.meanings) entry.meanings.push_back({"en", meaning});
  if (!facts.name.empty() && std::ranges::find(facts.meanings, facts.name) == facts.meanings.end())
    entry.meanings.push_back({"en", facts.name});
  entry.stroke_counts = {static_cast<int>(character.strokes.size())};
  entry.radical = facts.radical;
  return out;
}

std::optional<char32_t> kept_form_of(const kanji::Character& character) {
  return kanji::is_own(character.code_point) ? character.code_point : character.own_form;
}

fs::path Collection::usual_folder() {
  // Nothing here sets variables.
  if (const char* const own = std::getenv("NAZORI_CHARACTERS")) return own;  // NOLINT(concurrency-mt-unsafe)
  const fs::path data = base::user_data_folder();
  return data.empty() ? fs::path() : data / "characters";
}

base::Result<Facts> Collection::facts(char32_t code_point) const {
  auto character = load_character(file_of(code_point), FileParts::without_relief);
  if (!character) return tl::unexpected(std::move(character).error());
  return std::move(character->facts);
}

fs::path Collection::file_of(char32_t code_point) const {
  return folder_ / (kanji::code_point_text(code_point) + std::string(kKeptEnding));
}

std::optional<char32_t> Collection::code_point_of(const fs::path& file) const {
  if (folder_.empty() || file.parent_path() != folder_) return std::nullopt;
  return kept_code_point(file.filename().string());
}

base::Result<CollectionContent> Collection::read() const {
  CollectionContent content;
  std::error_code refused;
  if (folder_.empty() || !fs::exists(folder_, refused)) return content;
  for (fs::directory_iterator at(folder_, refused), end; !refused && at != end; at.increment(refused)) {
    const auto code_point = kept_code_point(at->path().filename().string());
    if (!code_point) continue;
    auto character = load_character(at->path(), FileParts::without_relief);
    // A file that another program has just taken away is not damaged.
    if (!character && character.error().code == Errc::not_found) continue;
    if (character && character->strokes.empty())
      character = base::fail(Errc::parse, "has no strokes", at->path().string());
    if (character)
      content.characters.push_back({*code_point, at->path(), *std::move(character), {}});
    else
      content.unread.push_back(std::move(character.error()));
  }
  if (refused)
    return base::fail(Errc::io, "cannot be read: " + refused.message(), folder_.string(),
                      "check who may read this folder");
  std::ranges::sort(content.characters, [](const KeptCharacter& a, const KeptCharacter& b) {
    return std::tie(a.character.facts.name, a.code_point) < std::tie(b.character.facts.name, b.code_point);
  });
  std::ranges::sort(content.unread, {}, &base::Error::where);
  std::set<char32_t> replaced;
  for (KeptCharacter& kept : content.characters)
    if (const auto published = kept.character.facts.instead_of;
        published && replaced.insert(*published).second)
      kept.instead_of = published;
  return content;
}

base::Result<OwnCharacter> Collection::find(char32_t code_point) const {
  if (folder_.empty() || !kanji::is_own(code_point))
    return base::fail(Errc::not_found, "is not kept", kanji::code_point_text(code_point));
  return load_character(file_of(code_point));
}

base::Result<base::FileLock> Collection::lock() const {
  constexpr std::chrono::seconds kPatience{2};
  std::error_code refused;
  fs::create_directories(folder_, refused);
  if (refused)
    return base::fail(Errc::io, "cannot be made: " + refused.message(), folder_.string(),
                      "check who may write there");
  return base::FileLock::wait(folder_ / kLockName, kPatience);
}

/// The clock of files moves in steps of a few milliseconds: two changes in one step must differ, too.
void Collection::note_change(fs::file_time_type before) const {
  std::error_code ignored;
  if (changed_at() == before) fs::last_write_time(folder_, before + std::chrono::microseconds(1), ignored);
}

base::Result<char32_t> Collection::free_place(const OwnCharacter& character) const {
  std::set<char32_t> taken;
  std::error_code ignored;
  for (fs::directory_iterator at(folder_, ignored), end; !ignored && at != end; at.increment(ignored)) {
    // What is removed keeps its code point: learners may have studied it.
    std::string name = at->path().filename().string();
    if (name.ends_with(kRemovedEnding)) name.resize(name.size() - kRemovedEnding.size());
    if (const auto known = kept_code_point(name)) taken.insert(*known);
  }
  if (const auto place = free_code_point(character.facts.name, taken)) return *place;
  return base::fail(Errc::io, "has no room for another character", folder_.string());
}

base::Result<void> Collection::free_published(char32_t instead_of, char32_t but) const {
  const auto content = read();
  if (!content) return tl::unexpected(content.error());
  for (const KeptCharacter& kept : content->characters) {
    if (kept.code_point == but || kept.character.facts.instead_of != instead_of) continue;
    auto whole = load_character(kept.file);
    if (!whole) return tl::unexpected(std::move(whole.error()));
    whole->facts.instead_of.reset();
    if (auto saved = save_character(*whole, kept.file); !saved) return saved;
  }
  return {};
}

base::Result<char32_t> Collection::keep(const OwnCharacter& character, std::optional<char32_t> as,
                                        SameName same_name) const {
  if (folder_.empty())
    return base::fail(Errc::io, "there is no folder for own characters", "HOME", "set NAZORI_CHARACTERS");
  if (character.facts.name.empty())
    return base::fail(Errc::bad_argument, "has no name", "the character", "give it a name");
  if (character.strokes.empty())
    return base::fail(Errc::bad_argument, "has no strokes", "the character",
                      "draw its strokes: without them nobody can be led along it");
  if (as && !kanji::is_own(*as))
    return base::fail(Errc::bad_argument, "is no code point of an own character",
                      kanji::code_point_text(*as));
  const auto locked = lock();
  if (!locked) return tl::unexpected(locked.error());
  const auto before = changed_at();
  if (!as && same_name == SameName::refuse) {
    const auto same = named(character.facts.name);
    if (!same) return tl::unexpected(same.error());
    if (!same->empty())
      return base::fail(Errc::in_use, "is the name of a character that is kept already", character.facts.name,
                        "replace it, or keep both");
  }
  auto place = as ? base::Result<char32_t>(*as) : free_place(character);
  if (!place) return place;
  if (auto saved = save_character(character, file_of(*place)); !saved)
    return tl::unexpected(std::move(saved.error()));
  if (character.facts.instead_of)
    if (auto freed = free_published(*character.facts.instead_of, *place); !freed)
      return tl::unexpected(std::move(freed.error()));
  note_change(before);
  return place;
}

base::Result<void> Collection::remove(char32_t code_point) const {
  const fs::path file = file_of(code_point);
  const auto not_kept = [&] {
    return base::fail(Errc::not_found, "is not kept", kanji::code_point_text(code_point));
  };
  std::error_code refused;
  if (folder_.empty() || !kanji::is_own(code_point) || !fs::exists(file, refused)) return not_kept();
  const auto locked = lock();
  if (!locked) return tl::unexpected(locked.error());
  const auto before = changed_at();
  fs::path removed = file;
  removed += kRemovedEnding;
  fs::rename(file, removed, refused);
  // Another program may have removed it while this one waited.
  if (refused == std::errc::no_such_file_or_directory) return not_kept();
  if (refused) return base::fail(Errc::io, "cannot be removed: " + refused.message(), file.string());
  note_change(before);
  return {};
}

base::Result<std::vector<char32_t>> Collection::named(const std::string& name) const {
  auto content = read();
  if (!content) return tl::unexpected(std::move(content.error()));
  std::vector<char32_t> found;
  for (const KeptCharacter& kept : content->characters)
    if (kept.character.facts.name == name) found.push_back(kept.code_point);
  return found;
}

fs::file_time_type Collection::changed_at() const {
  // Files are renamed into the folder and out of it, which changes the folder's own time.
  std::error_code ignored;
  const auto time = fs::last_write_time(folder_, ignored);
  return ignored ? fs::file_time_type() : time;
}

base::Result<kanji::KanjiDatabase> open_with_own(const fs::path& database, const Collection& collection,
                                                 std::vector<base::Error>* unread) {
  std::vector<kanji::Character> own;
  auto content = collection.read();
  if (content) {
    for (const KeptCharacter& kept : content->characters) {
      own.push_back(kanji_character(kept.character, kept.instead_of.value_or(kept.code_point)));
      if (kept.instead_of) own.back().own_form = kept.code_point;
    }
  }
  if (unread != nullptr)
    *unread = content ? std::move(content->unread) : std::vector<base::Error>{std::move(content.error())};
  return kanji::KanjiDatabase::open(database, std::move(own));
}

}  // namespace nazori::author
