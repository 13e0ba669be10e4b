// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::study {

/// Number of log entries between two progress reports: some milliseconds.
constexpr int kEntriesBetweenProgress = 256;

}  // namespace nazori::study
