// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::cli {

/// Ends every verb in one way on SIGINT and SIGTERM. From the signal on stop_requested() is true, so that
/// work can put away what it has begun and end by itself. What has not ended a tenth of a second later, or at
/// a second signal, is ended: unfinished files (base::UnfinishedFile) are removed and the program dies by the
/// signal. Call once, first in main(), before any other thread is started.
void watch_for_stop();

/// Whether the user asked to stop. Thread-safe: yes.
[[nodiscard]] bool stop_requested();

/// Ends the program by the signal that asked for the stop. @pre stop_requested()
[[noreturn]] void end_by_stop_signal();

/// Whether a line on the terminal has to be wiped away before the program ends. Thread-safe: yes.
void note_unfinished_line(bool there);

}  // namespace nazori::cli
