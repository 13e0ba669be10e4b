// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/character_editor.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <system_error>
#include <utility>

#include "change.h"
#include "journal.h"

namespace nazori::author {
namespace {

using base::Errc;
using carving::GridBox;

tl::unexpected<base::Error> refuse(std::string what, std::string where, std::string remedy = {}) {
  return base::fail(Errc::bad_argument, std::move(what), std::move(where), std::move(remedy));
}

tl::unexpected<base::Error> no_stroke(std::size_t stroke) {
  return refuse("is not there", "stroke " + std::to_string(stroke + 1));
}

tl::unexpected<base::Error> no_point(std::size_t stroke, std::size_t point) {
  return refuse("is not there",
                "stroke " + std::to_string(stroke + 1) + ", point " + std::to_string(point + 1));
}

/// The facts after strokes got other numbers. @param numbers  for each stroke its new numbers, none where it
/// goes.
Facts renumbered(const Facts& facts, const std::vector<std::vector<int>>& numbers) {
  Facts out = facts;
  for (OwnPart& part : out.parts) {
    std::vector<int> strokes;
    for (const int stroke : part.strokes) {
      const std::vector<int>& now = numbers.at(static_cast<std::size_t>(stroke));
      strokes.insert(strokes.end(), now.begin(), now.end());
    }
    std::ranges::sort(strokes);
    part.strokes = std::move(strokes);
  }
  return out;
}

/// A change of one stroke.
Change change_of(EditKind kind, std::size_t stroke, OwnStroke to, std::size_t point = 0) {
  return {
      .kind = kind, .stroke = stroke, .point = point, .strokes = Change::Strokes{stroke, 1, {std::move(to)}}};
}

/// Whether a character is within its limits after a change of its strokes or facts.
base::Result<void> check_limits(const Change& change, const OwnCharacter& character) {
  std::size_t strokes = character.strokes.size();
  if (change.strokes) {
    const Change::Strokes& now = *change.strokes;
    if (auto fit = validate(now.held); !fit) return fit;
    strokes += now.held.size();
    strokes -= now.count;
    if (strokes > kMostStrokes)
      return refuse("there are too many", "strokes", "give at most " + std::to_string(kMostStrokes));
    std::size_t points = 0;
    for (const OwnStroke& stroke : now.held) points += stroke.points.size();
    for (std::size_t i = 0; i < character.strokes.size(); ++i)
      if (i < now.first || i >= now.first + now.count) points += character.strokes[i].points.size();
    if (points > kMostPointsInAll)
      return refuse("have too many points", "strokes", "give at most " + std::to_string(kMostPointsInAll));
  }
  if (!change.strokes && !change.facts) return {};
  return validate(change.facts ? *change.facts : character.facts, strokes);
}

}  // namespace

/// What is done while a state is being written.
struct CharacterEditor::Saving {
  std::uint64_t number = 0;
  std::optional<std::size_t> at;       // length of past_ in that state, while it can be reached by undoing
  std::vector<PendingRecord> records;  // for the journal that is being begun
  JournalReach reach;                  // of that journal
};

CharacterEditor::CharacterEditor() = default;
CharacterEditor::~CharacterEditor() = default;
CharacterEditor::CharacterEditor(CharacterEditor&&) noexcept = default;
CharacterEditor& CharacterEditor::operator=(CharacterEditor&&) noexcept = default;

base::Result<CharacterEditor> CharacterEditor::create(OwnCharacter character, int size) {
  if (auto fit = validate(character); !fit) return tl::unexpected(std::move(fit).error());
  auto map = carve(character, std::max(size, character.hand.size));
  if (!map) return tl::unexpected(std::move(map).error());
  CharacterEditor editor;
  editor.character_ = std::move(character);
  editor.map_ = *std::move(map);
  return editor;
}

EditorState CharacterEditor::state() const {
  EditorState state;
  if (!past_.empty()) state.undoes = past_.back().kind;
  if (!future_.empty()) state.redoes = future_.back().kind;
  state.is_saved = saved_at_ == past_.size();
  state.is_autosaved = journal_ != nullptr && !journal_->error();
  for (const auto* changes : {&past_, &future_})
    for (const Change& change : *changes) state.history_bytes += bytes_of(change);
  return state;
}

GridBox CharacterEditor::swap(Change& change) {
  const GridBox box = exchange(change, character_, map_.size());
  [[maybe_unused]] const auto carved = carve_box(character_, box, map_);
  assert(carved);
  return box;
}

CharacterEditor::Touched CharacterEditor::apply(Change change, bool goes_on) {
  const std::vector<std::uint8_t> record =
      journal_ || saving_ ? to_record(change) : std::vector<std::uint8_t>();
  if (auto fit = check_limits(change, character_); !fit) return tl::unexpected(std::move(fit).error());
  const bool is_being_saved = saving_ && saving_->at == past_.size();
  const bool merges = goes_on && !past_.empty() && saved_at_ != past_.size() && !is_being_saved &&
                      past_.back().kind == change.kind && past_.back().stroke == change.stroke &&
                      past_.back().point == change.point;
  const GridBox box = swap(change);
  future_.clear();
  for (auto* at : {&saved_at_, saving_ ? &saving_->at : nullptr})
    if (at != nullptr && *at && **at > past_.size()) at->reset();
  if (!merges) past_.push_back(std::move(change));
  note(static_cast<std::uint8_t>(merges ? RecordKind::drag : RecordKind::edit), record, !merges);
  return box;
}

/// To be called before an undo or redo, and after an edit.
/// @param record  of an edit; of an undo or redo, what undoes or redoes it, where needs_change() says so.
void CharacterEditor::note(std::uint8_t kind, const std::vector<std::uint8_t>& record, bool flush) {
  const auto to_write = [&](JournalReach& reach) -> PendingRecord {
    const auto as = static_cast<RecordKind>(kind);
    if (as == RecordKind::undo && past_.size() > reach.floor) {
      ++reach.redoable;
      return {as, {}, flush};
    }
    if (as == RecordKind::redo && reach.redoable > 0) {
      --reach.redoable;
      return {as, {}, flush};
    }
    if (as == RecordKind::undo) reach.floor = past_.size() - 1;
    reach.redoable = 0;
    return {as == RecordKind::drag ? as : RecordKind::edit, record, flush};
  };
  if (journal_) {
    const PendingRecord written = to_write(journal_->reach);
    journal_->append(written.kind, written.content, written.flush);
  }
  if (saving_) saving_->records.push_back(to_write(saving_->reach));
}

SavePoint CharacterEditor::begin_save() {
  static std::atomic<std::uint64_t> calls{0};
  saving_ = std::make_unique<Saving>();
  saving_->number = ++calls;
  saving_->at = past_.size();
  saving_->reach.floor = past_.size();
  SavePoint point;
  point.character = character_;
  point.map_size = map_.size();
  point.number = saving_->number;
  if (journal_) point.journal_file = journal_->path();
  point.is_of_file = saved_at_ == past_.size();
  return point;
}

void CharacterEditor::end_save(SavePoint point) {
  if (!saving_ || saving_->number != point.number) return;
  const std::unique_ptr<Saving> done = std::move(saving_);
  if (point.is_written) saved_at_ = done->at;
  if (!point.journal) return;
  point.journal->reach = done->reach;
  for (const PendingRecord& record : done->records)
    point.journal->append(record.kind, record.content, record.flush);
  std::error_code ignored;
  if (journal_ && journal_->path() != point.journal->path())
    std::filesystem::remove(journal_->path(), ignored);
  journal_ = std::move(point.journal);
}

GridBox CharacterEditor::undo() {
  if (past_.empty()) return {};
  const auto is_below = [this](const JournalReach& reach) { return past_.size() <= reach.floor; };
  const bool needs_change = (journal_ && is_below(journal_->reach)) || (saving_ && is_below(saving_->reach));
  note(static_cast<std::uint8_t>(RecordKind::undo),
       needs_change ? to_record(past_.back()) : std::vector<std::uint8_t>(), true);
  const GridBox box = swap(past_.back());
  future_.push_back(std::move(past_.back()));
  past_.pop_back();
  return box;
}

GridBox CharacterEditor::redo() {
  if (future_.empty()) return {};
  const auto is_below = [](const JournalReach& reach) { return reach.redoable == 0; };
  const bool needs_change = (journal_ && is_below(journal_->reach)) || (saving_ && is_below(saving_->reach));
  note(static_cast<std::uint8_t>(RecordKind::redo),
       needs_change ? to_record(future_.back()) : std::vector<std::uint8_t>(), true);
  const GridBox box = swap(future_.back());
  past_.push_back(std::move(future_.back()));
  future_.pop_back();
  return box;
}

CharacterEditor::Touched CharacterEditor::draw_stroke(
    const geometry::WrittenStroke<geometry::GlyphFrame>& pen, const PenSettings& settings) {
  auto stroke = stroke_of_pen(pen, settings);
  if (!stroke) return refuse("has no points", "pen");
  return apply({.kind = EditKind::draw_stroke,
                .strokes = Change::Strokes{character_.strokes.size(), 0, {*std::move(stroke)}}});
}

CharacterEditor::Touched CharacterEditor::add_strokes(const std::vector<OwnStroke>& strokes) {
  if (strokes.empty()) return GridBox{};
  return apply(
      {.kind = EditKind::add_strokes, .strokes = Change::Strokes{character_.strokes.size(), 0, strokes}});
}

namespace {

/// The numbers of strokes as they are.
std::vector<std::vector<int>> same_numbers(std::size_t strokes) {
  std::vector<std::vector<int>> numbers(strokes);
  for (std::size_t i = 0; i < strokes; ++i) numbers[i] = {static_cast<int>(i)};
  return numbers;
}

/// Adds the new numbers of strokes to a change, where a part has one of them.
void renumber(Change& change, const Facts& facts, const std::vector<std::vector<int>>& numbers) {
  Facts now = renumbered(facts, numbers);
  if (now != facts) change.facts = std::move(now);
}

}  // namespace

CharacterEditor::Touched CharacterEditor::delete_stroke(std::size_t stroke) {
  const std::size_t count = character_.strokes.size();
  if (stroke >= count) return no_stroke(stroke);
  auto numbers = same_numbers(count);
  numbers[stroke].clear();
  for (std::size_t i = stroke + 1; i < count; ++i) --numbers[i][0];
  Change change{.kind = EditKind::delete_stroke, .strokes = Change::Strokes{stroke, 1, {}}};
  renumber(change, character_.facts, numbers);
  return apply(std::move(change));
}

CharacterEditor::Touched CharacterEditor::insert_point(std::size_t stroke, geometry::GlyphPoint at) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  const OwnStroke& old = character_.strokes[stroke];
  auto place = nearest_place(std::span(&old, 1), at);
  if (!place || old.points.size() < 2) return refuse("has no length", "stroke " + std::to_string(stroke + 1));
  place->segment = std::min(place->segment, old.points.size() - 2);
  constexpr double kLeast = 0.05;
  for (const std::size_t i : {place->segment, place->segment + 1})
    if (geometry::distance(old.points[i].at, place->groove.at) < kLeast)
      return refuse("has a point there already", "stroke " + std::to_string(stroke + 1));
  return apply(change_of(EditKind::insert_point, stroke, with_point(old, *place)));
}

CharacterEditor::Touched CharacterEditor::move_point(std::size_t stroke, std::size_t point,
                                                     geometry::GlyphPoint to, bool goes_on) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  OwnStroke changed = character_.strokes[stroke];
  if (point >= changed.points.size()) return no_point(stroke, point);
  changed.points[point].at = to;
  return apply(change_of(EditKind::move_point, stroke, std::move(changed), point), goes_on);
}

CharacterEditor::Touched CharacterEditor::delete_point(std::size_t stroke, std::size_t point) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  const OwnStroke& old = character_.strokes[stroke];
  if (point >= old.points.size()) return no_point(stroke, point);
  if (old.points.size() == 1)
    return refuse("has no other point", "stroke " + std::to_string(stroke + 1), "delete the stroke");
  return apply(change_of(EditKind::delete_point, stroke, without_point(old, point)));
}

CharacterEditor::Touched CharacterEditor::move_stroke(std::size_t stroke, geometry::GlyphPoint by,
                                                      bool goes_on) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  OwnStroke changed = character_.strokes[stroke];
  for (GroovePoint& point : changed.points) point.at = point.at + by;
  if (changed.number_position) changed.number_position = *changed.number_position + by;
  return apply(change_of(EditKind::move_stroke, stroke, std::move(changed)), goes_on);
}

CharacterEditor::Touched CharacterEditor::split_stroke(std::size_t stroke, std::size_t point) {
  const std::size_t count = character_.strokes.size();
  if (stroke >= count) return no_stroke(stroke);
  const OwnStroke& old = character_.strokes[stroke];
  if (point >= old.points.size()) return no_point(stroke, point);
  if (point == 0 || point + 1 == old.points.size())
    return refuse("cannot be split at its end", "stroke " + std::to_string(stroke + 1),
                  "give a point in between");
  auto numbers = same_numbers(count);
  numbers[stroke].push_back(static_cast<int>(stroke) + 1);
  for (std::size_t i = stroke + 1; i < count; ++i) ++numbers[i][0];
  auto [first, second] = split_at(old, point);
  Change change{.kind = EditKind::split_stroke,
                .strokes = Change::Strokes{stroke, 1, {std::move(first), std::move(second)}}};
  renumber(change, character_.facts, numbers);
  return apply(std::move(change));
}

CharacterEditor::Touched CharacterEditor::join_strokes(std::size_t first, std::size_t second) {
  const std::size_t count = character_.strokes.size();
  for (const std::size_t stroke : {first, second})
    if (stroke >= count) return no_stroke(stroke);
  if (first == second) return refuse("cannot be joined to itself", "stroke " + std::to_string(first + 1));
  // All strokes between the two move, so they are part of the change.
  const std::size_t begin = std::min(first, second);
  const std::size_t end = std::max(first, second) + 1;
  std::vector<OwnStroke> held(character_.strokes.begin() + static_cast<std::ptrdiff_t>(begin),
                              character_.strokes.begin() + static_cast<std::ptrdiff_t>(end));
  held[first - begin] = joined(character_.strokes[first], character_.strokes[second]);
  held.erase(held.begin() + static_cast<std::ptrdiff_t>(second - begin));
  auto numbers = same_numbers(count);
  numbers[second].clear();
  for (std::size_t i = second + 1; i < count; ++i) --numbers[i][0];
  Change change{.kind = EditKind::join_strokes,
                .strokes = Change::Strokes{begin, end - begin, std::move(held)}};
  renumber(change, character_.facts, numbers);
  return apply(std::move(change));
}

CharacterEditor::Touched CharacterEditor::reverse_stroke(std::size_t stroke) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  return apply(change_of(EditKind::reverse_stroke, stroke, reversed(character_.strokes[stroke])));
}

CharacterEditor::Touched CharacterEditor::reorder(std::size_t from, std::size_t to) {
  const std::size_t count = character_.strokes.size();
  for (const std::size_t stroke : {from, to})
    if (stroke >= count) return no_stroke(stroke);
  if (from == to) return GridBox{};
  const std::size_t begin = std::min(from, to);
  const std::size_t end = std::max(from, to) + 1;
  std::vector<OwnStroke> held(character_.strokes.begin() + static_cast<std::ptrdiff_t>(begin),
                              character_.strokes.begin() + static_cast<std::ptrdiff_t>(end));
  auto numbers = same_numbers(count);
  if (from < to) {
    std::rotate(held.begin(), held.begin() + 1, held.end());
    for (std::size_t i = from + 1; i <= to; ++i) --numbers[i][0];
  } else {
    std::rotate(held.begin(), held.end() - 1, held.end());
    for (std::size_t i = to; i < from; ++i) ++numbers[i][0];
  }
  numbers[from] = {static_cast<int>(to)};
  Change change{.kind = EditKind::reorder_strokes,
                .strokes = Change::Strokes{begin, end - begin, std::move(held)}};
  renumber(change, character_.facts, numbers);
  return apply(std::move(change));
}

CharacterEditor::Touched CharacterEditor::set_ending(std::size_t stroke, kanji::StrokeEnding ending) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  OwnStroke changed = character_.strokes[stroke];
  changed.ending = ending;
  return apply(change_of(EditKind::set_ending, stroke, std::move(changed)));
}

CharacterEditor::Touched CharacterEditor::set_half_width(std::size_t stroke, std::size_t point,
                                                         double half_width, bool goes_on) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  OwnStroke changed = character_.strokes[stroke];
  if (point >= changed.points.size()) return no_point(stroke, point);
  changed.points[point].half_width = half_width;
  return apply(change_of(EditKind::set_width, stroke, std::move(changed), point), goes_on);
}

CharacterEditor::Touched CharacterEditor::set_depth(std::size_t stroke, std::size_t point, double depth,
                                                    bool goes_on) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  OwnStroke changed = character_.strokes[stroke];
  if (point >= changed.points.size()) return no_point(stroke, point);
  changed.points[point].depth = depth;
  return apply(change_of(EditKind::set_depth, stroke, std::move(changed), point), goes_on);
}

namespace {

/// In place of a point: the whole stroke is changed.
constexpr std::size_t kWholeStroke = 0xFFFFFFFF;

base::Result<void> check_factor(double factor) {
  if (factor > 0 && factor <= 100) return {};
  return refuse("is out of range", "factor", "give more than 0, at most 100");
}

}  // namespace

CharacterEditor::Touched CharacterEditor::scale_width(std::size_t stroke, double factor, bool goes_on) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  if (auto fit = check_factor(factor); !fit) return tl::unexpected(std::move(fit).error());
  return apply(
      change_of(EditKind::set_width, stroke, scaled(character_.strokes[stroke], factor, 1), kWholeStroke),
      goes_on);
}

CharacterEditor::Touched CharacterEditor::scale_depth(std::size_t stroke, double factor, bool goes_on) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  if (auto fit = check_factor(factor); !fit) return tl::unexpected(std::move(fit).error());
  return apply(
      change_of(EditKind::set_depth, stroke, scaled(character_.strokes[stroke], 1, factor), kWholeStroke),
      goes_on);
}

CharacterEditor::Touched CharacterEditor::set_number(std::size_t stroke,
                                                     std::optional<geometry::GlyphPoint> at, bool goes_on) {
  if (stroke >= character_.strokes.size()) return no_stroke(stroke);
  OwnStroke changed = character_.strokes[stroke];
  changed.number_position = at;
  return apply(change_of(EditKind::move_number, stroke, std::move(changed)), goes_on);
}

CharacterEditor::Touched CharacterEditor::set_facts(Facts facts) {
  const Rights& rights = character_.facts.rights;
  if (rights.source == kKanjiVgSource && !character_.strokes.empty() && facts.rights != rights)
    return refuse("the strokes come from KanjiVG, whose licence stays with them", "licence",
                  "keep licence, author and source");
  if (facts == character_.facts) return GridBox{};
  return apply({.kind = EditKind::set_facts, .facts = std::move(facts)});
}

}  // namespace nazori::author
