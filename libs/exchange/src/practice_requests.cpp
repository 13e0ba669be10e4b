// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/practice_requests.h"

#include <utility>

#include "nazori/exchange/handwriting.h"

namespace nazori::exchange {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace

base::Result<PracticeRequest> read_practice_request(const Value& request) {
  if (request.contains("strokes")) {
    auto ink = read_handwriting(request);
    if (!ink) return tl::unexpected(std::move(ink.error()));
    return PracticeRequest(*std::move(ink));
  }
  if (const auto what = request.find("do"); what != request.end() && what->is_string()) {
    auto name = what->get<std::string>();
    if (const auto rating = study::rating_named(name)) return PracticeRequest(*rating);
    return PracticeRequest(PracticeCommand{std::move(name)});
  }
  if (const auto stage = request.find("stage"); stage != request.end() && stage->is_string())
    return PracticeRequest(StageChoice{stage->get<std::string>()});
  return base::fail(base::Errc::parse, "asks for nothing", "request", "give strokes, stage or do");
}

Value to_json(const PracticeRequest& request) {
  return std::visit(Overloaded{[](const writing::WrittenCharacter& ink) { return to_json(ink); },
                               [](const StageChoice& choice) {
                                 return Value{{"stage", choice.stage}};
                               },
                               [](study::Rating rating) {
                                 return Value{{"do", study::name_of(rating)}};
                               },
                               [](const PracticeCommand& command) {
                                 return Value{{"do", command.name}};
                               }},
                    request);
}

}  // namespace nazori::exchange
