// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"

namespace nazori::cli {

/// Exit codes of every verb.
inline constexpr int kDone = 0;   ///< done
inline constexpr int kNo = 1;     ///< the answer is no, or not found
inline constexpr int kWrong = 2;  ///< bad usage or bad input

/// Where the program speaks: answers go to standard output, one line of trouble to standard error. A reader
/// that goes away (a closed pipe) is no trouble: the work goes on, in silence.
class Console {
 public:
  /// Part of the answer.
  void print(std::string_view text);

  /// Says in one line what was wrong with the usage or the input. @return kWrong
  [[nodiscard]] int refuse(const base::Error& error) const;
  /// Says in one line why the answer is no. @return kNo
  [[nodiscard]] int deny(const base::Error& error) const;
  /// refuse(), or death by the signal when the user stopped the work.
  [[nodiscard]] int fail(const base::Error& error) const;

  /// Sends what is left of the answer. @return `code`, or kWrong when the answer could not be written.
  [[nodiscard]] int finish(int code);

  /// The program's name and verb, "nazori-cli carve", that every line of trouble starts with.
  void set_name(std::string name) { name_ = std::move(name); }

 private:
  std::string name_ = "nazori-cli";
  int write_error_ = 0;
};

/// Width of the terminal on standard output, 80 where it is none; within 40..120, so that lines stay
/// readable.
[[nodiscard]] int text_width();

/// Makes interruption (Ctrl+C, SIGTERM) stop the work at the next step, so that nothing half-written is left.
void stop_on_signals();
/// The user asked to stop.
[[nodiscard]] bool stop_requested();

/// How long work stands, on standard error: a bar on a terminal, else a line at each tenth where `plain` is
/// set, else nothing.
class ProgressDisplay {
 public:
  enum class Plain { lines, silent };
  explicit ProgressDisplay(Plain plain);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// @param done 0..1. @return false when the user asked to stop.
  bool show(double done, std::string_view step);
  /// Takes the bar away.
  void clear();
  /// show() for those who take a function. Must not outlive the display.
  [[nodiscard]] base::Progress callback();

 private:
  bool terminal_;
  Plain plain_;
  int last_tenth_ = 0;
  double last_drawn_s_ = -1;
  bool drawn_ = false;
};

}  // namespace nazori::cli
