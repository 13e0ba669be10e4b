// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "nazori/base/result.h"
#include "nazori/haptics/sample_ring.h"

namespace nazori::recording {

using SessionId = std::array<std::uint8_t, 16>;

/// A sample ring in shared memory (POSIX, in memory only: nothing is written to a disk, so a push never waits
/// for one). It outlives the process that made it. A process that has it open has a lock on it, which the
/// system releases when the process ends: so a ring without a lock is abandoned.
class SharedRing {
 public:
  /// A new, empty ring, all its pages in memory. @return Errc::io where there is no room.
  [[nodiscard]] static base::Result<SharedRing> create(const SessionId& id);
  /// The ring of a process that has ended.
  /// @return Errc::not_found where there is none, Errc::device while its process lives, Errc::schema where it
  /// was made by a program with another layout of samples.
  [[nodiscard]] static base::Result<SharedRing> adopt(const SessionId& id);

  SharedRing(SharedRing&& other) noexcept;
  SharedRing& operator=(SharedRing&&) = delete;
  /// Closes the ring, which continues to exist unless remove() was called.
  ~SharedRing();

  [[nodiscard]] haptics::SampleRing& ring() const { return *ring_; }
  /// Removes the ring from the system.
  void remove() const;

 private:
  SharedRing(std::string name, int fd, void* memory);

  std::string name_;
  int fd_;
  void* memory_;
  haptics::SampleRing* ring_;
};

}  // namespace nazori::recording
