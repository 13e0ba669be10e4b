// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/requests.h"

#include <fmt/format.h>

#include <utility>

namespace nazori::exchange {
namespace {

using base::Errc;

base::Result<Value> read_request(std::string_view line, int number) {
  const auto where = fmt::format("line {}", number);
  auto request = json::parse(line);
  if (!request) {
    base::Error error = std::move(request.error());
    // The line is the only one of its text: its number there says nothing.
    const std::size_t comma = error.where.find(", ");
    error.where = comma == std::string::npos ? where : where + error.where.substr(comma);
    error.remedy = "give one object a line, with numbers that are finite";
    return tl::unexpected(std::move(error));
  }
  if (!request->is_object())
    return base::fail(Errc::parse, "is not a JSON object", where,
                      "give one object a line, with numbers that are finite");
  return request;
}

base::Result<void> check_version(const Value& request) {
  const auto version = request.find("version");
  if (version == request.end() || *version == kVersion) return {};
  return base::fail(Errc::schema,
                    fmt::format("is {}, not {}", json::to_line(*version).substr(0, 40), kVersion), "version",
                    fmt::format("give {}, or leave it out", kVersion));
}

}  // namespace

Reply reply_to(std::string_view line, int number, const Value& refusal,
               const std::function<base::Result<Value>(const Value& request)>& answer) {
  const auto request = read_request(line, number);
  Value object = Value::object();
  base::Result<Value> result;
  if (!request) {
    result = tl::unexpected(request.error());
  } else {
    if (const auto id = request->find("id"); id != request->end()) object["id"] = *id;
    const auto known = check_version(*request);
    result = known ? answer(*request) : base::Result<Value>(tl::unexpected(known.error()));
  }
  if (result) {
    object.update(*result);
  } else {
    object["line"] = number;
    object["error"] = base::to_line(result.error());
    object.update(refusal);
  }
  return {to_line(std::move(object)), !result};
}

}  // namespace nazori::exchange
