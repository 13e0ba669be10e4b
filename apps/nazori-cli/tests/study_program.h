// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program.h"

namespace nazori::cli::test {

/// When a test of study begins unless it says so.
inline const std::string kFirst = "2026-01-01T09:00:00Z";

/// A temporary learner with a clock that the test sets.
class StudyProgram : public testing::Test {
 protected:
  Outcome study(std::vector<std::string> arguments, const std::string& now = kFirst) {
    arguments.insert(arguments.begin(), "study");
    for (const std::string& part :
         {std::string("--learners"), folder_ / "learners", std::string("--now"), now})
      arguments.push_back(part);
    return nazori_cli(arguments, {"TZ=UTC"});
  }
  TemporaryFolder folder_;
};

}  // namespace nazori::cli::test
