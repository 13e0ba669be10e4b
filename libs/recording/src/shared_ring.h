// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "nazori/base/result.h"
#include "nazori/haptics/sample_ring.h"

namespace nazori::recording {

using SessionId = std::array<std::uint8_t, 16>;

/// A sample ring in shared memory (POSIX, in memory only: nothing is ever written to a disk, so a push waits
/// for none). It outlives the process that made it. Whoever has it open holds a lock on it, which the system
/// takes away when the process dies: so a ring without a lock has been left behind.
class SharedRing {
 public:
  /// A new, empty ring, all its pages in memory. @return Errc::io where there is no room.
  [[nodiscard]] static base::Result<SharedRing> create(const SessionId& id);
  /// The ring that a dead process left behind.
  /// @return Errc::not_found where there is none, Errc::device while its process lives, Errc::schema where it
  /// was made by a program with another layout of samples.
  [[nodiscard]] static base::Result<SharedRing> adopt(const SessionId& id);

  SharedRing(SharedRing&& other) noexcept;
  SharedRing& operator=(SharedRing&&) = delete;
  /// Closes it; it goes on to exist unless remove() was called.
  ~SharedRing();

  [[nodiscard]] haptics::SampleRing& ring() const { return *ring_; }
  /// Takes it out of the system.
  void remove() const;

 private:
  SharedRing(std::string name, int fd, void* memory);

  std::string name_;
  int fd_;
  void* memory_;
  haptics::SampleRing* ring_;
};

}  // namespace nazori::recording
