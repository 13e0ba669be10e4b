// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "nazori/base/result.h"
#include "nazori/study/time.h"

namespace nazori::study {

/// Converts moments to study days. A study day begins at a fixed hour of local time, so that writing after
/// midnight still counts for the evening. Where the clocks change, a day is an hour shorter or longer. If the
/// starting hour is skipped, the day begins when the clocks are put forward. Immutable; thread-safe.
/// @source rules of time zones: the system's tz database, read by Howard Hinnant's date library.
class Calendar {
 public:
  /// @param zone  "Asia/Tokyo"; empty: the environment variable TZ, else the computer's zone, else UTC.
  /// @param day_starts_at  hour of local time, 0..12.
  /// @return Errc::bad_argument for a zone that the tz database does not have or an hour outside 0..12.
  [[nodiscard]] static base::Result<Calendar> create(std::string_view zone, int day_starts_at = 4);

  /// The study day that `time` belongs to.
  [[nodiscard]] Day day_of(Time time) const;
  /// The moment at which a study day begins.
  [[nodiscard]] Time begin_of(Day day) const;
  /// The name of the zone, as in the tz database.
  [[nodiscard]] const std::string& zone() const { return zone_name_; }

 private:
  Calendar(const void* zone, std::string name, int day_starts_at);
  const void* zone_;  ///< owned by the tz library until the program ends
  std::string zone_name_;
  int day_starts_at_;
};

}  // namespace nazori::study
