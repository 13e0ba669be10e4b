// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/study/fsrs.h"
#include "nazori/study/lesson.h"

namespace nazori::study {

/// The order in which new characters of the chosen lists are introduced.
enum class NewOrder : std::uint8_t {
  grade = 0,       ///< school grade, commoner first within a grade (default)
  frequency = 1,   ///< commonest in newspapers first
  strokes = 2,     ///< fewest strokes first
  components = 3,  ///< parts before the characters made of them, else as by grade
  own = 4,         ///< the order of the chosen lists
};
/// "grade", "frequency", "strokes", "components", "own".
[[nodiscard]] std::string_view name_of(NewOrder order);
[[nodiscard]] std::optional<NewOrder> new_order_named(std::string_view name);

/// The settings of a learner. They are kept in the log, so that every state can be computed from the log
/// alone.
struct Settings {
  FsrsSettings fsrs;
  bool fuzz = false;          ///< intervals vary a little, so that characters learned together are not always
                              ///< reviewed together
  bool load_balance = false;  ///< within the same range, the day with the fewest reviews is chosen
  int new_per_day = 5;        ///< 0..1000
  int reviews_per_day = 100;  ///< 1..10000
  int day_starts_at = 4;      ///< hour of local time, 0..12
  std::string time_zone;      ///< "Asia/Tokyo"; empty: the computer's
  NewOrder new_order = NewOrder::grade;
  std::vector<std::string> new_lists{"grade-1", "grade-2", "grade-3",  "grade-4",
                                     "grade-5", "grade-6", "secondary"};  ///< ids of lists, at most 100
  int brush_per_day = 0;  ///< well known characters that are reviewed with the brush, too; 0..100, 0: none
  int leech_lapses = 8;   ///< number of lapses that make a character difficult; 2..100
  LessonRules lesson;

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// @return Errc::bad_argument that names the setting that is out of range.
[[nodiscard]] base::Result<void> check(const Settings& settings);

/// JSON of all settings (docs/file-formats.md), in one line.
[[nodiscard]] std::string to_json(const Settings& settings);
/// @return Errc::parse with line and reason. Settings that are missing keep their defaults.
[[nodiscard]] base::Result<Settings> parse_settings(std::string_view json);

}  // namespace nazori::study
