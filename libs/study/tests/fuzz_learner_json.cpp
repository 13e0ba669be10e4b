// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/study/exchange.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::study;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto clock = [] { return Time{}; };
  auto learner = LearnerStore::in_memory(clock);
  if (!learner || !import_json(*learner, text_source(text))) return 0;
  // Valid input is exported in canonical form, and reading that gives the same again.
  const auto written = export_json(*learner);
  auto again = LearnerStore::in_memory(clock);
  if (!written || !again || !import_json(*again, text_source(*written)) || export_json(*again) != written)
    std::abort();
  const auto report = again->rebuild();
  if (!report || report->differences != 0) std::abort();
  return 0;
}
