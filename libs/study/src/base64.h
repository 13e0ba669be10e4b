// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::study {

[[nodiscard]] std::string to_base64(std::span<const std::uint8_t> bytes);
/// nullopt for text that to_base64() would not write, so that a decoded text is encoded identically.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);

}  // namespace nazori::study
