// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/time.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <optional>

namespace nazori::study {
namespace {

using std::chrono::floor;
using std::chrono::hours;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

/// Reads a text piece by piece.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  /// Exactly `digits` digits.
  std::optional<int> number(std::size_t digits) {
    if (rest_.size() < digits) return std::nullopt;
    int value = 0;
    for (const char c : rest_.substr(0, digits)) {
      if (c < '0' || c > '9') return std::nullopt;
      value = value * 10 + (c - '0');
    }
    rest_.remove_prefix(digits);
    return value;
  }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// Milliseconds of ".5", ".250"; digits beyond the third are dropped.
  std::optional<int> fraction() {
    int value = 0;
    int digits = 0;
    for (; !rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9'; rest_.remove_prefix(1), ++digits) {
      if (digits < 3) value = value * 10 + (rest_.front() - '0');
    }
    if (digits == 0 || digits > 9) return std::nullopt;
    for (; digits < 3; ++digits) value *= 10;
    return value;
  }
  [[nodiscard]] bool empty() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

std::optional<Day> read_day(Reader& reader) {
  const auto year = reader.number(4);
  if (!year || !reader.take('-')) return std::nullopt;
  const auto month = reader.number(2);
  if (!month || !reader.take('-')) return std::nullopt;
  const auto day = reader.number(2);
  if (!day || *year < 1970) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date);
}

/// The difference from UTC of an offset such as "+09:00".
std::optional<minutes> read_offset(Reader& reader) {
  if (reader.take('Z')) return minutes(0);
  const int sign = reader.take('-') ? -1 : 1;
  if (sign == 1 && !reader.take('+')) return std::nullopt;
  const auto hour = reader.number(2);
  (void)reader.take(':');
  const auto minute = reader.number(2);
  if (!hour || !minute || *hour > 14 || *minute > 59) return std::nullopt;
  return sign * (hours(*hour) + minutes(*minute));
}

std::optional<Time> read_time(Reader& reader) {
  const auto day = read_day(reader);
  if (!day || !reader.take('T')) return std::nullopt;
  const auto hour = reader.number(2);
  if (!hour || !reader.take(':')) return std::nullopt;
  const auto minute = reader.number(2);
  if (!minute || *hour > 23 || *minute > 59) return std::nullopt;
  Time time = *day + hours(*hour) + minutes(*minute);
  if (reader.take(':')) {
    const auto second = reader.number(2);
    if (!second || *second > 59) return std::nullopt;
    time += seconds(*second);
    if (reader.take('.')) {
      const auto fraction = reader.fraction();
      if (!fraction) return std::nullopt;
      time += milliseconds(*fraction);
    }
  }
  const auto offset = read_offset(reader);
  if (!offset) return std::nullopt;
  return time - *offset;
}

}  // namespace

Clock clock_from(Time start) {
  return [start, begun = std::chrono::steady_clock::now()] {
    return start + std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - begun);
  };
}

base::Result<Clock> environment_clock() {
  const char* text = std::getenv("NAZORI_NOW");
  if (text == nullptr || *text == '\0') return Clock(system_now);
  const auto start = parse_time(text);
  if (!start) return tl::unexpected(start.error());
  return clock_from(*start);
}

Time system_now() { return floor<milliseconds>(std::chrono::system_clock::now()); }

Day utc_day(Time time) { return floor<std::chrono::days>(time); }

std::string to_text(Day day) {
  const std::chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

std::string to_text(Time time) {
  const Day day = utc_day(time);
  const auto part = (time - day).count();
  constexpr int kSecond = 1000;
  constexpr int kMinute = 60 * kSecond;
  constexpr int kHour = 60 * kMinute;
  return fmt::format("{}T{:02}:{:02}:{:02}.{:03}Z", to_text(day), part / kHour, part % kHour / kMinute,
                     part % kMinute / kSecond, part % kSecond);
}

base::Result<Time> parse_time(std::string_view text) {
  Reader reader(text);
  const auto time = read_time(reader);
  if (!time || !reader.empty() || *time < Time{}) {
    return base::fail(base::Errc::parse, "is not a valid time", std::string(text),
                      "write it as 2026-01-01T09:00:00Z or 2026-01-01T18:00:00+09:00");
  }
  return *time;
}

base::Result<Day> parse_day(std::string_view text) {
  Reader reader(text);
  const auto day = read_day(reader);
  if (!day || !reader.empty()) {
    return base::fail(base::Errc::parse, "is not a valid date", std::string(text), "write it as 2026-01-01");
  }
  return *day;
}

}  // namespace nazori::study
