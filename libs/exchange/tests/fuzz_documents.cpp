// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/exchange/cards.h"
#include "nazori/exchange/grades.h"
#include "nazori/exchange/practice_events.h"

namespace {

using namespace nazori;

/// What is read is written so that it is read as the same.
template <class Read, class Write>
void look_at(const exchange::Value& document, const Read& read, const Write& write) {
  const auto first = read(document);
  if (!first) {
    if (first.error().where.empty() || first.error().what.empty()) std::abort();
    return;
  }
  const exchange::Value written = write(*first);
  const auto second = read(written);
  if (!second || write(*second) != written) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto document = json::parse({reinterpret_cast<const char*>(data), size});
  if (!document) return 0;
  static const study::LearnerStore learner = *study::LearnerStore::in_memory();
  look_at(*document, exchange::read_practice_event,
          [](const exchange::PracticeEvent& event) { return exchange::to_json(event); });
  look_at(*document, exchange::read_grade,
          [](const exchange::GradeAnswer& answer) { return exchange::to_json(answer); });
  look_at(*document, exchange::read_card,
          [](const exchange::ReadCard& read) { return exchange::to_json(read.card, learner); });
  return 0;
}
