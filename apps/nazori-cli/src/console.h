// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"

namespace nazori::cli {

/// The exit codes of all commands.
inline constexpr int kDone = 0;   ///< done
inline constexpr int kNo = 1;     ///< the answer is no, or not found
inline constexpr int kWrong = 2;  ///< bad usage or bad input
inline constexpr int kInUse = 3;  ///< another program has it open

/// The output of the program: answers go to standard output, error messages of one line to standard error. A
/// closed pipe is not an error: the work continues without output.
class Console {
 public:
  /// Prints a part of the answer; nothing in quiet mode.
  void print(std::string_view text);
  /// Prints a part of a file for standard output, which is printed even in quiet mode.
  void print_file(std::string_view bytes);
  /// Flushes the output. @return false when it cannot be written, or the reader is gone.
  bool flush();

  /// Prints a remark about the answer in one line on standard error; nothing in quiet mode.
  void inform(std::string_view text) const;
  /// Prints an error of usage or input in one line; nothing where the user stopped the work.
  /// @return kWrong; kInUse for Errc::in_use
  [[nodiscard]] int refuse(const base::Error& error) const;
  /// Prints in one line why the answer is no; the answer in JSON is then null, unless there was one. @return
  /// kNo
  [[nodiscard]] int deny(const base::Error& error);

  /// Flushes the rest of the answer. @return `code`, or kWrong when the answer could not be written.
  [[nodiscard]] int finish(int code);

  /// From now on no answers are printed.
  void set_quiet(bool quiet) { quiet_ = quiet; }
  [[nodiscard]] bool is_quiet() const { return quiet_; }
  /// Answers are in JSON.
  void set_json(bool json) { json_ = json; }

  /// The program's name and command, "nazori-cli carve", with which every error message starts.
  void set_name(std::string name) { name_ = std::move(name); }

 private:
  void send(std::string_view text);

  std::string name_ = "nazori-cli";
  int write_error_ = 0;
  bool quiet_ = false;
  bool json_ = false;
  bool answered_ = false;
};

/// Width of the terminal on standard output, 80 where it is not a terminal; within 40..120, so that lines
/// stay readable.
[[nodiscard]] int text_width();

/// The progress of work, on standard error: a bar on a terminal, else a line at each tenth where `plain` is
/// set, else nothing. Nothing in quiet mode.
class ProgressDisplay {
 public:
  enum class Plain { lines, silent };
  ProgressDisplay(const Console& console, Plain plain);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// @param done 0..1. @return false when the user asked to stop.
  bool show(double done, std::string_view step);
  /// Takes the bar away.
  void clear();
  /// show() as a function. Must not outlive the display.
  [[nodiscard]] base::Progress callback();

 private:
  bool terminal_;
  Plain plain_;
  int last_tenth_ = 0;
  double last_drawn_s_ = -1;
  bool drawn_ = false;
};

}  // namespace nazori::cli
