// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdlib.h>

#include <optional>
#include <string>

namespace nazori::test {

/// Sets or removes an environment variable until it is destroyed; then it is as it was.
class EnvironmentVariable {
 public:
  /// @param value  nullptr: removes it
  EnvironmentVariable(const char* name, const char* value) : name_(name) {
    const char* const before = ::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    if (before != nullptr) before_ = before;
    set(value);
  }
  ~EnvironmentVariable() { set(before_ ? before_->c_str() : nullptr); }
  EnvironmentVariable(const EnvironmentVariable&) = delete;
  EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

 private:
  void set(const char* value) const {
    if (value == nullptr)
      ::unsetenv(name_);  // NOLINT(concurrency-mt-unsafe)
    else
      ::setenv(name_, value, 1);  // NOLINT(concurrency-mt-unsafe)
  }
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace nazori::test
