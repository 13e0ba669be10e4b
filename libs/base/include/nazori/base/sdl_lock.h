// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>

namespace nazori::base {

/// Locked while SDL's subsystems are started or ended and while its hints are set: SDL protects neither, and
/// different threads start sound and controllers. A thread must not wait for another one while it has this
/// lock.
inline std::mutex& sdl_lock() {
  static std::mutex lock;
  return lock;
}

}  // namespace nazori::base
