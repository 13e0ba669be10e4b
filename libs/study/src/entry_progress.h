// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::study {

/// Entries of the log from one report of progress to the next: some milliseconds.
constexpr int kEntriesBetweenProgress = 256;

}  // namespace nazori::study
