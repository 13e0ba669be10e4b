// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "nazori/base/result.h"
#include "nazori/exchange/document.h"

namespace nazori::exchange {

/// The answer to one line of JSON Lines.
struct Reply {
  std::string line;         ///< an object in one line, with a line feed at the end
  bool is_refusal = false;  ///< the object has "error"
};

/// Answers one request of JSON Lines. An "id" is handed back, whatever it is. A line that is no JSON object,
/// that asks for a version that is not known, or that `answer` refuses gets `refusal` with "line" and
/// "error".
/// @param number  of the line, from 1.
/// @param answer  @return an object, without version and id.
[[nodiscard]] Reply reply_to(std::string_view line, int number, const Value& refusal,
                             const std::function<base::Result<Value>(const Value& request)>& answer);

}  // namespace nazori::exchange
