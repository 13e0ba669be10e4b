// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::speech {

/// A program to run, without a shell.
struct ChildProgram {
  std::filesystem::path program;
  std::vector<std::string> arguments;  ///< without the name of the program
  std::string input;                   ///< its standard input
  std::size_t most_output = 0;         ///< bytes of standard output; with more it is ended
  std::chrono::milliseconds most_time{5000};
};

/// Runs a program to its end and returns what it wrote on standard output. Its output goes to memory, so a
/// program that ends early cannot block or signal this one. It is ended when it takes too long, writes too
/// much, or is no longer wanted. Waits; any thread.
/// @param is_wanted  asked about every 20 ms; empty: always.
/// @return Errc::not_found where it cannot be started, Errc::io where it fails, with the first line that it
/// wrote on standard error, Errc::cancelled.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> run(const ChildProgram& child,
                                                          const std::function<bool()>& is_wanted = {});

}  // namespace nazori::speech
