// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace nazori::audio {

/// The driver that SDL opens sound cards with, while this lives.
class WithDriver {
 public:
  explicit WithDriver(const char* name) {
    if (const char* before = std::getenv(kVariable)) before_ = before;
    setenv(kVariable, name, 1);
  }
  ~WithDriver() {
    if (before_)
      setenv(kVariable, before_->c_str(), 1);
    else
      unsetenv(kVariable);
  }
  WithDriver(const WithDriver&) = delete;
  WithDriver& operator=(const WithDriver&) = delete;

 private:
  static constexpr const char* kVariable = "SDL_AUDIODRIVER";
  std::optional<std::string> before_;
};

}  // namespace nazori::audio
