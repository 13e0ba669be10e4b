// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>

namespace nazori::base {

/// Held while SDL's subsystems and hints are begun, set or ended: SDL keeps both without a lock of its own,
/// and sound and controllers are begun by different threads. Nobody waits for another thread under it.
inline std::mutex& sdl_lock() {
  static std::mutex lock;
  return lock;
}

}  // namespace nazori::base
