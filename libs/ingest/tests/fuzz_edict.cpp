// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/ingest/edict.h"

/// Any line is either refused or gives a word with a gloss in every sense. A space is put behind each mark
/// that is kept, so a gloss is at most twice as long as the line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto entry =
      nazori::ingest::parse_edict_line(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!entry) {
    if (entry.error().what.empty()) std::abort();
    return 0;
  }
  if (entry->text.empty() || entry->senses.empty()) std::abort();
  for (const auto& sense : entry->senses) {
    const bool odd = std::any_of(sense.begin(), sense.end(), [&](const auto& gloss) {
      return gloss.empty() || gloss.size() > 2 * size || gloss.find('/') != std::string_view::npos;
    });
    if (sense.empty() || odd) std::abort();
  }
  return 0;
}
