// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::audio {

/// Called by SDL on its audio thread: fills the buffer with silence, then with what the source adds, limited
/// to -1..1. Does not allocate, lock, throw or wait.
/// @param source  a Source.  @param bytes  floats, aligned as SDL gives them.
void ask(void* source, std::uint8_t* bytes, int length) noexcept;

}  // namespace nazori::audio
