// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "command_table.h"

namespace nazori::cli {

/// The manual page nazori-cli(1), in roff with the macros of man(7). The same table gives the same bytes.
/// @param version  of Nazori: "0.1.0"
/// @param date     of the page, 2026-01-01; may be empty
[[nodiscard]] std::string manual_page(const Command& program, std::string_view version,
                                      std::string_view date);

/// `text` escaped so that roff shows it literally: nothing in it is a request or an escape.
[[nodiscard]] std::string roff_escaped(std::string_view text);

}  // namespace nazori::cli
