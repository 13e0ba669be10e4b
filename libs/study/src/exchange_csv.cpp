// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <unordered_set>

#include "nazori/base/utf8.h"
#include "nazori/study/exchange.h"

namespace nazori::study {

base::Result<std::string> export_csv(const LearnerStore& learner) {
  std::unordered_set<std::int64_t> undone;
  auto read = learner.for_each_entry(false, [&](const LearnerStore::LoggedEntry& logged) {
    if (logged.entry.undoes) undone.insert(*logged.entry.undoes);
    return true;
  });
  if (!read) return tl::unexpected(std::move(read.error()));
  std::string text =
      "entry,at,day,character,stage,rating,proposed,accepted,score,faults,hints,misses,shown_strokes,help,"
      "duration_ms,strokes,interval_days,speed,smoothness,undone\r\n";
  read = learner.for_each_entry(false, [&](const LearnerStore::LoggedEntry& logged) {
    const LogEntry& entry = logged.entry;
    if (entry.kind != EntryKind::writing) return true;
    const Writing& writing = entry.writing;
    const WritingResult& result = writing.result;
    std::string faults;
    for (const StrokeFault& fault : result.faults) {
      faults += fmt::format("{}{}:{}", faults.empty() ? "" : " ", name_of(fault.kind), fault.stroke + 1);
    }
    // A comma or a quotation mark can be studied too.
    std::string character = base::encode_utf8(entry.character);
    if (character == "\"") character = "\"\"";
    text += fmt::format("{},{},{},\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", entry.id,
                        to_text(entry.at), to_text(entry.day), character, name_of(writing.stage),
                        name_of(writing.rating), name_of(writing.proposed), result.accepted ? 1 : 0,
                        result.score, faults, result.hints, result.misses, result.shown_strokes, result.help,
                        result.duration.count(), entry.strokes,
                        entry.interval_days ? std::to_string(*entry.interval_days) : "",
                        logged.motion ? fmt::format("{:.3f}", logged.motion->speed) : "",
                        logged.motion ? fmt::format("{:.4f}", logged.motion->smoothness) : "",
                        undone.contains(entry.action) ? 1 : 0);
    return true;
  });
  if (!read) return tl::unexpected(std::move(read.error()));
  return text;
}

}  // namespace nazori::study
