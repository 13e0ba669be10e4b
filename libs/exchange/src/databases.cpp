// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/databases.h"

namespace nazori::exchange {
namespace {

void add(Value& json, DatabaseCounts counts) {
  for (const auto& [name, count] : counts) json[std::string(name)] = count;
}

}  // namespace

Value database_path(const std::string& path) { return {{"path", path}}; }

Value to_json(const std::string& path, const std::optional<BuiltDatabase>& built) {
  Value json{{"path", path}, {"built", built.has_value()}};
  if (!built) return json;
  json["bytes"] = built->bytes;
  json["took_s"] = built->took_s;
  add(json, built->counts);
  json["left_out"] = built->left_out;
  return json;
}

Value checked_database(const std::string& path, std::uintmax_t bytes, DatabaseCounts counts,
                       std::span<const kanji::Source> sources) {
  Value json{{"path", path}, {"bytes", bytes}};
  add(json, counts);
  Value list = Value::array();
  for (const kanji::Source& source : sources)
    list.push_back({{"name", source.name},
                    {"version", source.version},
                    {"sha256", source.sha256},
                    {"licence", source.licence}});
  json["sources"] = std::move(list);
  return json;
}

}  // namespace nazori::exchange
