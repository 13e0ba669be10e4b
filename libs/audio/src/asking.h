// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::audio {

/// What SDL calls on its audio thread: silence, then what the source adds, held to -1..1. Neither allocates,
/// locks, throws nor waits.
/// @param source  a Source.  @param bytes  floats, aligned as SDL gives them.
void ask(void* source, std::uint8_t* bytes, int length) noexcept;

}  // namespace nazori::audio
