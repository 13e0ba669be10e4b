// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/result.h"

namespace nazori::base {

std::string to_line(const Error& error) {
  std::string line;
  if (!error.where.empty()) line += error.where + ": ";
  line += error.what;
  if (!error.remedy.empty()) line += " (" + error.remedy + ")";
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  return line;
}

}  // namespace nazori::base
