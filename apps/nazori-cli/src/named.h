// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace nazori::cli {

/// The value of an enumeration with this name. The command line has checked that there is one.
template <class Enum, std::size_t N>
Enum named(const std::array<std::string_view, N>& names, const std::string& name, Enum otherwise) {
  const auto at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? otherwise : static_cast<Enum>(at - names.begin());
}

}  // namespace nazori::cli
