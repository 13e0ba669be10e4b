// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nazori/study/fsrs.h"
#include "nazori/study/lesson.h"
#include "nazori/study/settings.h"
#include "nazori/study/time.h"
#include "nazori/study/writing_result.h"

namespace nazori::study {

/// The kind of an entry of the log.
enum class EntryKind : std::uint8_t {
  writing = 0,    ///< a character was written, or watched: in stage `memory` a review, else practice
  undo = 1,       ///< an earlier action is undone
  settings = 2,   ///< these settings apply from here on
  postpone = 3,   ///< a character is not due before a given day
  pause = 4,      ///< a character is suspended
  resume = 5,     ///< it comes again
  reset = 6,      ///< it is new again
  leech_met = 7,  ///< a difficult character was relearned; it is reviewed again
  choices = 8,    ///< what the learner chose to learn: as `settings`, but it can be undone
  known = 9,      ///< the learner knows a character without having written it here; it is reviewed later
};
/// "writing", "undo", ...
[[nodiscard]] std::string_view name_of(EntryKind kind);
[[nodiscard]] std::optional<EntryKind> entry_kind_named(std::string_view name);

/// One writing of a character.
struct Writing {
  Stage stage = Stage::memory;
  Rating rating = Rating::good;    ///< the learner's rating; only used in the stages `memory` and `brush`
  Rating proposed = Rating::good;  ///< the result of proposed_rating()
  WritingResult result;

  friend bool operator==(const Writing&, const Writing&) = default;
};

/// One entry of the append-only log. `kind` determines which members are used.
struct LogEntry {
  std::int64_t id = 0;      ///< 1, 2, 3, ...
  std::int64_t action = 0;  ///< id of the first entry of the same action; an undo undoes whole actions
  Time at{};
  Day day{};  ///< study day, by the zone the learner was in
  EntryKind kind = EntryKind::writing;
  char32_t character = 0;            ///< all but undo, settings and choices
  Writing writing;                   ///< writing
  std::optional<int> interval_days;  ///< writing: the interval that was set, if it was moved within its range
  int strokes = 1;                   ///< writing: strokes of the character, >= 1
  std::optional<std::int64_t> undoes;  ///< undo: the action
  std::optional<Day> until;            ///< postpone; known: the day of the first review, if it was chosen
  std::string settings;                ///< settings, choices: JSON

  friend bool operator==(const LogEntry&, const LogEntry&) = default;
};

/// The reviews of one character with the brush. They change nothing about the reviews from memory.
struct BrushReviews {
  Memory memory;  ///< fresh before the first one; afterwards always in the phase `review`: there are no steps
                  ///< of minutes
  std::optional<Day> last_day;  ///< of the last one
  std::optional<Day> due_day;   ///< study day on which the next one is due

  friend bool operator==(const BrushReviews&, const BrushReviews&) = default;
};

/// The study state of one character. Computed from the log.
struct Card {
  char32_t character = 0;
  Memory memory;
  std::optional<Day> introduced;       ///< the first day of study since it was last reset, or when it was
                                       ///< marked as known; a review with the brush is none
  std::optional<Day> last_day;         ///< of the last review from memory
  std::optional<Day> due_day;          ///< in the phase `review`: the study day on which it is due
  std::optional<Day> postponed_until;  ///< not before this day
  bool paused = false;
  bool leech = false;               ///< difficult: forgotten too often and taken out of reviews
  int leech_at = 0;                 ///< number of lapses at which it becomes difficult again; 0: as set
  int practices = 0;                ///< writings in other stages than `memory` and `brush`
  Stage next_stage = Stage::watch;  ///< what the lesson proposes
  double help = 1;                  ///< help of the next guided writing
  BrushReviews brush;

  friend bool operator==(const Card&, const Card&) = default;
};

/// How far away a review is, in the unit in which people say it.
struct ReviewDelay {
  enum class Unit : std::uint8_t { minutes, days, months, years };
  Unit unit = Unit::days;
  double amount = 1;  ///< from 1; whole but for years

  friend bool operator==(const ReviewDelay&, const ReviewDelay&) = default;
};
/// When a card comes again: a learning step in minutes, a review in days, from two months on in months and
/// from a year on in years.
[[nodiscard]] ReviewDelay review_delay(const Card& card, Time now, Day today);
/// When a character that was written with the brush comes again with it.
[[nodiscard]] ReviewDelay review_delay(const BrushReviews& brush, Day today);

/// Whether two settings give different numbers for the same reviews.
[[nodiscard]] bool changes_memory(const Settings& before, const Settings& after);

/// Computes the card of one character from the log. Entries must be given in the order of the log, without
/// those that were undone.
class CardHistory {
 public:
  explicit CardHistory(char32_t character) { card_.character = character; }

  /// @param settings  in force when the entry was made.
  void apply(const LogEntry& entry, const Settings& settings);
  /// Other settings apply from here on. If the weights differ, stability and difficulty are computed again
  /// from all reviews; the due day is unchanged.
  void change_settings(const Settings& settings);

  [[nodiscard]] const Card& card() const { return card_; }
  /// Whether the learner would lose anything with this card: false for a character never studied.
  [[nodiscard]] bool met() const { return met_; }

 private:
  struct Answer {
    Rating rating;
    Time at;
    int elapsed_days;
  };
  void write(const LogEntry& entry, const Settings& settings);
  void know(const LogEntry& entry, const Settings& settings);
  void review(const LogEntry& entry, Rating rating, std::optional<int> interval_days,
              const Settings& settings);
  void review_brush(const LogEntry& entry, const Settings& settings);
  void relearned(const Settings& settings);
  Card card_;
  std::vector<Answer> answers_;
  std::vector<Answer> brush_answers_;
  bool met_ = false;
};

}  // namespace nazori::study
