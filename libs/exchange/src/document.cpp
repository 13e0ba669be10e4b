// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/document.h"

#include <utility>

namespace nazori::exchange {

Value versioned(Value document) {
  if (document.is_array()) {
    for (Value& one : document)
      if (one.is_object()) one = versioned(std::move(one));
    return document;
  }
  if (!document.is_object() || document.contains("version")) return document;
  Value with_version{{"version", kVersion}};
  for (auto& [name, value] : document.items()) with_version[name] = std::move(value);
  return with_version;
}

std::string to_text(Value document) { return json::to_text(versioned(std::move(document))); }

std::string to_line(Value document) { return json::to_line(versioned(std::move(document))) + "\n"; }

}  // namespace nazori::exchange
