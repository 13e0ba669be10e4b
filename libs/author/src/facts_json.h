// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "nazori/author/own_character.h"
#include "nazori/base/result.h"

namespace nazori::author {

/// What is said about a character, as `meta.json` of a document.
[[nodiscard]] std::string to_json(const Facts& facts);
/// @return Errc::parse naming the place; Errc::schema for a newer version. What is read still has to be
/// validated.
[[nodiscard]] base::Result<Facts> parse_facts(std::string_view text);

}  // namespace nazori::author
