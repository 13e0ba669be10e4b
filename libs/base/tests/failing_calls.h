// SPDX-License-Identifier: Apache-2.0
// Calls of the system that fail, are interrupted or do less than they were asked for. failing_calls.cpp
// replaces the functions of the C library in the whole program.
#pragma once

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace nazori::base::test {

/// What happens to the system calls of the program.
struct CallsToFail {
  std::map<std::string, int> refused;                ///< by name: the error number that each call fails with
  std::atomic<int> empty_writes{0};                  ///< that take nothing
  std::atomic<int> interruptions{0};                 ///< of the next reads and writes
  std::atomic<std::size_t> most_bytes{SIZE_MAX};     ///< of one read or write
  std::atomic<std::size_t> bytes_to_read{SIZE_MAX};  ///< before a file seems to end
  std::atomic<int> renames{0}, flushes{0};           ///< number of calls
};
inline std::atomic<CallsToFail*>& calls_to_fail() {
  static std::atomic<CallsToFail*> now{nullptr};
  return now;
}

/// While this lives, the calls of all threads are treated as described.
class FailingCalls : public CallsToFail {
 public:
  explicit FailingCalls(std::map<std::string, int> refuses = {}) {
    refused = std::move(refuses);
    calls_to_fail() = this;
  }
  ~FailingCalls() { calls_to_fail() = nullptr; }
  FailingCalls(const FailingCalls&) = delete;
  FailingCalls& operator=(const FailingCalls&) = delete;
};

/// Whether a call is to fail; sets errno if so.
inline bool is_refused(const char* call) {
  CallsToFail* const now = calls_to_fail();
  if (now == nullptr) return false;
  const auto found = now->refused.find(call);
  if (found == now->refused.end()) return false;
  errno = found->second;
  return true;
}
inline bool is_interrupted() {
  CallsToFail* const now = calls_to_fail();
  if (now == nullptr || now->interruptions <= 0) return false;
  --now->interruptions;
  errno = EINTR;
  return true;
}

/// How many files this process has open.
inline long open_descriptors() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"),
                       std::filesystem::directory_iterator());
}

}  // namespace nazori::base::test
