// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::haptics::test {

/// Counts operator new and delete on this thread while it lives.
class AllocGuard {
 public:
  AllocGuard();
  AllocGuard(const AllocGuard&) = delete;
  AllocGuard& operator=(const AllocGuard&) = delete;
  [[nodiscard]] long calls() const;

 private:
  long at_start_;
};

}  // namespace nazori::haptics::test
