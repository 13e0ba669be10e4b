// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "console.h"
#include "nazori/base/file.h"
#include "nazori/base/result.h"
#include "nazori/haptics/servo.h"

namespace nazori::cli {

/// Samples as CSV, to a file that appears complete with commit(), or to standard output. Memory does not grow
/// with their number.
class SampleOutput {
 public:
  [[nodiscard]] static base::Result<SampleOutput> to_file(const std::string& path);
  /// `console` must outlive this object.
  [[nodiscard]] static base::Result<SampleOutput> to_console(Console& console);

  [[nodiscard]] base::Result<void> add(const haptics::ServoSample& sample);
  /// Call it once, as the last call.
  [[nodiscard]] base::Result<void> commit();

 private:
  SampleOutput(std::optional<base::OutputFile> file, Console* console);
  [[nodiscard]] base::Result<void> send();

  std::optional<base::OutputFile> file_;
  Console* console_;
  std::string text_;
};

}  // namespace nazori::cli
