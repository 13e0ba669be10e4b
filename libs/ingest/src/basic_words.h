// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/ingest/edict.h"

namespace nazori::ingest {

/// Whether the table of basic words names a word with its reading.
[[nodiscard]] bool is_basic(const EdictEntry& word);

}  // namespace nazori::ingest
