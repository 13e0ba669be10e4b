// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verbs.h"

namespace nazori::cli {

/// Each function adds one command to `author`.
void add_author_trace(CLI::App& author, Action& chosen);

}  // namespace nazori::cli
