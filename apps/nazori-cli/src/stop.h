// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::cli {

/// Ends all commands in the same way on SIGINT and SIGTERM. After the signal stop_requested() is true, so
/// that work can clean up and end by itself. If it has not ended a tenth of a second later, or at a second
/// signal, unfinished files (base::UnfinishedFile) are removed and the program ends by the signal. Call once,
/// first in main(), before any other thread is started.
void watch_for_stop();

/// Whether the user asked to stop. Thread-safe: yes.
[[nodiscard]] bool stop_requested();

/// Ends the program by the signal that requested the stop. @pre stop_requested()
[[noreturn]] void end_by_stop_signal();

/// Whether a line on the terminal has to be cleared before the program ends. Thread-safe: yes.
void note_unfinished_line(bool there);

}  // namespace nazori::cli
