// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace nazori::print {

/// Appends `parity` symbols to at most 255 - parity bytes; half as many wrong bytes can then be corrected.
/// @source I. S. Reed, G. Solomon, "Polynomial codes over certain finite fields", 1960; the field of 256 with
/// the polynomial x^8 + x^4 + x^3 + x^2 + 1.
void append_parity(std::vector<std::uint8_t>& bytes, std::size_t parity);

/// Corrects bytes to which append_parity() appended `parity`. @return false where too many are wrong.
/// @source J. L. Massey, "Shift-register synthesis and BCH decoding", 1969; G. D. Forney, "On decoding BCH
/// codes", 1965.
[[nodiscard]] bool correct(std::span<std::uint8_t> bytes, std::size_t parity);

}  // namespace nazori::print
