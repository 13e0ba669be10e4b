// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "nazori/base/result.h"
#include "nazori/ingest/ingest.h"

namespace nazori::cli {

/// Whether the file at `path` is a kanji.db of this version that was built from exactly these sources, so
/// that building it again would give the same rows.
/// @return the errors of reading the sources.
[[nodiscard]] base::Result<bool> is_current(const ingest::Sources& sources,
                                            const std::filesystem::path& path);

}  // namespace nazori::cli
