// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "entry_progress.h"
#include "nazori/base/utf8.h"
#include "text_pieces.h"

namespace nazori::study {
namespace {

constexpr double kFindingUndone = 0.3;  // of the work

}  // namespace

base::Result<void> export_csv(const LearnerStore& learner, const TextSink& sink,
                              const base::Progress& progress) {
  bool stopped = false;
  const auto all = static_cast<double>(std::max<std::int64_t>(1, learner.last_entry()));
  const auto goes_on = [&](std::int64_t entry, double from, double to) {
    if (progress && entry % kEntriesBetweenProgress == 0)
      stopped = !progress(from + (to - from) * std::min(1.0, static_cast<double>(entry) / all), "export");
    return !stopped;
  };
  std::unordered_set<std::int64_t> undone;
  auto read = learner.for_each_entry(false, [&](const LearnerStore::LoggedEntry& logged) {
    if (logged.entry.undoes) undone.insert(*logged.entry.undoes);
    return goes_on(logged.entry.id, 0, kFindingUndone);
  });
  if (!read) return read;
  if (stopped) return base::fail(base::Errc::cancelled, "stopped");
  TextPieces text(sink);
  text.add(
      "entry,at,day,character,stage,rating,proposed,accepted,score,faults,hints,misses,shown_strokes,help,"
      "duration_ms,strokes,interval_days,speed,smoothness,undone\r\n");
  read = learner.for_each_entry(false, [&](const LearnerStore::LoggedEntry& logged) {
    const LogEntry& entry = logged.entry;
    if (!goes_on(entry.id, kFindingUndone, 1)) return false;
    if (entry.kind != EntryKind::writing) return true;
    const Writing& writing = entry.writing;
    const WritingResult& result = writing.result;
    std::string mistakes;
    for (const StrokeMistake& mistake : result.mistakes) {
      mistakes +=
          fmt::format("{}{}:{}", mistakes.empty() ? "" : " ", name_of(mistake.kind), mistake.stroke + 1);
    }
    // Commas and quotation marks can be studied, too.
    std::string character = base::encode_utf8(entry.character);
    if (character == "\"") character = "\"\"";
    text.add(fmt::format("{},{},{},\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", entry.id,
                         to_text(entry.at), to_text(entry.day), character, name_of(writing.stage),
                         name_of(writing.rating), name_of(writing.proposed), result.accepted ? 1 : 0,
                         result.score, mistakes, result.hints, result.misses, result.shown_strokes,
                         result.help, result.duration.count(), entry.strokes,
                         entry.interval_days ? std::to_string(*entry.interval_days) : "",
                         logged.motion ? fmt::format("{:.3f}", logged.motion->speed) : "",
                         logged.motion ? fmt::format("{:.4f}", logged.motion->smoothness) : "",
                         undone.contains(entry.action) ? 1 : 0));
    return text.ok();
  });
  if (!read) return read;
  if (stopped) return base::fail(base::Errc::cancelled, "stopped");
  return text.finish();
}

base::Result<std::string> export_csv(const LearnerStore& learner) {
  return as_one_text([&](const TextSink& sink) { return export_csv(learner, sink); });
}

}  // namespace nazori::study
