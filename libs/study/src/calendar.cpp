// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/calendar.h"

#include <date/tz.h>

#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace nazori::study {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;

const date::time_zone& as_zone(const void* zone) { return *static_cast<const date::time_zone*>(zone); }

const date::time_zone* zone_named(std::string_view name) {
  try {
    return date::locate_zone(std::string(name));
  } catch (const std::runtime_error&) {
    return nullptr;
  }
}

const date::time_zone* zone_of_computer() {
  if (const char* name = std::getenv("TZ"); name != nullptr && *name != 0) {
    const std::string_view text(name);
    if (const auto* zone = zone_named(text.substr(text.front() == ':' ? 1 : 0))) return zone;
  }
  try {
    return date::current_zone();
  } catch (const std::runtime_error&) {
    return zone_named("UTC");
  }
}

}  // namespace

Calendar::Calendar(const void* zone, std::string name, int day_starts_at)
    : zone_(zone), zone_name_(std::move(name)), day_starts_at_(day_starts_at) {}

base::Result<Calendar> Calendar::create(std::string_view zone, int day_starts_at) {
  if (day_starts_at < 0 || day_starts_at > 12) {
    return base::fail(base::Errc::bad_argument,
                      std::to_string(day_starts_at) + " is not a valid hour for the start of the day",
                      "start of the day", "give 0 to 12");
  }
  const date::time_zone* found = zone.empty() ? zone_of_computer() : zone_named(zone);
  if (found == nullptr) {
    return base::fail(base::Errc::bad_argument,
                      "'" + std::string(zone) + "' is not a time zone known on this computer", "time zone",
                      "give a name such as Asia/Tokyo, and install tzdata");
  }
  return Calendar(found, found->name(), day_starts_at);
}

Day Calendar::day_of(Time time) const {
  const auto local = as_zone(zone_).to_local(time);
  return Day(std::chrono::floor<std::chrono::days>(local.time_since_epoch() - hours(day_starts_at_)));
}

Time Calendar::begin_of(Day day) const {
  const date::local_time<milliseconds> local(milliseconds(day.time_since_epoch()) + hours(day_starts_at_));
  return std::chrono::time_point_cast<milliseconds>(as_zone(zone_).to_sys(local, date::choose::earliest));
}

}  // namespace nazori::study
