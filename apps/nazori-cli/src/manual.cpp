// SPDX-License-Identifier: Apache-2.0
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>

#include "command_table.h"
#include "manual_page.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

/// The date of SOURCE_DATE_EPOCH in UTC, empty where it is not set.
/// @source https://reproducible-builds.org/specs/source-date-epoch/
base::Result<std::string> date_of_sources() {
  const char* const set = std::getenv("SOURCE_DATE_EPOCH");  // NOLINT(concurrency-mt-unsafe): one thread
  const std::string_view text = set == nullptr ? "" : set;
  if (text.empty()) return std::string();
  constexpr std::time_t kYear10000_s = 253402300800;
  std::time_t seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size() || seconds < 0 || seconds >= kYear10000_s) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("'{}' is not a number of seconds since 1970", text), "SOURCE_DATE_EPOCH",
                      "give a whole number such as 1767225600, or unset it");
  }
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(seconds));
}

int run(Console& console, const CLI::App& app) {
  const auto date = date_of_sources();
  if (!date) return console.refuse(date.error());
  console.print(manual_page(command_table(app), NAZORI_VERSION, *date));
  return kDone;
}

}  // namespace

void add_manual(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("manual", "Print the manual page of this program");
  verb->footer(
      "The page is in roff. Its date is that of SOURCE_DATE_EPOCH, and none where that is not set.\n\n"
      "Example:\n  nazori-cli manual | man -l -");
  verb->callback([&app, &chosen] { chosen = [&app](Console& console) { return run(console, app); }; });
}

}  // namespace nazori::cli
