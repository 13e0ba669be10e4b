// SPDX-License-Identifier: Apache-2.0
#include "json_lines.h"

#include <iostream>
#include <string>

#include "nazori/exchange/requests.h"

namespace nazori::cli {

int answer_lines(Console& console, const Json& refusal,
                 const std::function<base::Result<Json>(const Json& request)>& answer) {
  int code = kDone;
  int number = 0;
  std::string line;
  while (std::getline(std::cin, line)) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const exchange::Reply reply = exchange::reply_to(line, number, refusal, answer);
    if (reply.is_refusal) code = kWrong;
    console.print(reply.line);
    if (!console.flush()) break;
  }
  return code;
}

}  // namespace nazori::cli
