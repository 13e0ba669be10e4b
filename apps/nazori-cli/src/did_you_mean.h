// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace nazori::cli {

/// The word that was probably meant by one that is misspelt: the nearest one by letters left out, added,
/// changed or swapped, or the only one that begins with it. If several have the same distance, the first.
/// @return nothing where none is near enough.
[[nodiscard]] std::optional<std::string> meant_word(std::string_view given,
                                                    std::span<const std::string> words);

}  // namespace nazori::cli
