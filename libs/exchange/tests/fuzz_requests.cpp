// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/exchange/candidates.h"
#include "nazori/exchange/grades.h"
#include "nazori/exchange/handwriting.h"
#include "nazori/exchange/practice_requests.h"
#include "nazori/exchange/requests.h"
#include "nazori/writing/grade.h"

namespace {

using namespace nazori;

void look_at(const exchange::Value& request) {
  const auto ink = exchange::read_handwriting(request);
  if (!ink) {
    if (ink.error().where.empty()) std::abort();
  } else {
    if (ink->strokes.size() != request["strokes"].size()) std::abort();
    (void)writing::check(*ink);
    const auto again = exchange::read_handwriting(exchange::to_json(*ink));
    if (!again || again->strokes.size() != ink->strokes.size()) std::abort();
  }
  if (const auto asked = exchange::read_grade_request(request); !asked && asked.error().where.empty())
    std::abort();
  if (const auto asked = exchange::read_practice_request(request)) {
    const auto again = exchange::read_practice_request(exchange::to_json(*asked));
    if (!again || again->index() != asked->index()) std::abort();
  }
}

}  // namespace

/// Any line is answered by one line with an object, which has an error or is what was answered.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  const auto reply =
      exchange::reply_to(line, 1, exchange::refused_candidates(), [](const exchange::Value& request) {
        look_at(request);
        return base::Result<exchange::Value>(exchange::refused_grade());
      });
  const auto answer = json::parse(reply.line);
  if (!answer || !answer->is_object() || answer->contains("error") != reply.is_refusal) std::abort();
  if ((*answer)["version"] != exchange::kVersion) std::abort();
  return 0;
}
