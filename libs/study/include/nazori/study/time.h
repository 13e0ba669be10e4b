// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::study {

/// A moment, in whole milliseconds since 1970-01-01 00:00 UTC.
using Time = std::chrono::time_point<std::chrono::system_clock, std::chrono::milliseconds>;

/// A study day: the calendar date on which it begins. Counted in days since 1970-01-01.
using Day = std::chrono::sys_days;
/// The days that an entry of the log may have.
inline constexpr Day kFirstDay{std::chrono::days(-4'000'000)};
inline constexpr Day kLastDay{std::chrono::days(4'000'000)};

/// Returns the present time. Everything in this module that needs it calls a function of this type.
using Clock = std::function<Time()>;

/// The computer's clock.
[[nodiscard]] Time system_now();

/// A clock that shows `start` now and runs on from there, to simulate other days.
[[nodiscard]] Clock clock_from(Time start);
/// The clock of the environment variable NAZORI_NOW ("2026-01-01T09:00Z"), which runs on from there; the
/// computer's clock if it is not set. @return Errc::parse for an invalid time.
[[nodiscard]] base::Result<Clock> environment_clock();

/// "2026-01-01T09:00:00.000Z".
[[nodiscard]] std::string to_text(Time time);
/// "2026-01-01".
[[nodiscard]] std::string to_text(Day day);

/// Reads ISO 8601: "2026-01-01T09:00:00.000Z", with or without seconds and fractions, and with Z or an offset
/// such as +09:00. Years 1970..9999.
/// @return Errc::parse, the text in Error::where.
[[nodiscard]] base::Result<Time> parse_time(std::string_view text);
/// Reads "2026-01-01". @return Errc::parse, the text in Error::where.
[[nodiscard]] base::Result<Day> parse_day(std::string_view text);

/// The date of `time` in UTC.
[[nodiscard]] Day utc_day(Time time);

}  // namespace nazori::study
