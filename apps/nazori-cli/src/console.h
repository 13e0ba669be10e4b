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
inline constexpr int kInUse = 3;  ///< another program has it open

/// Where the program speaks: answers go to standard output, one line of trouble to standard error. A reader
/// that goes away (a closed pipe) is no trouble: the work goes on, in silence.
class Console {
 public:
  /// Part of the answer; nothing where it is to be quiet.
  void print(std::string_view text);
  /// Part of a file that was asked for on standard output, which comes even where the answer is not wanted.
  void print_file(std::string_view bytes);
  /// Sends what was printed so far. @return false when it cannot be written, or nobody reads it any more.
  bool flush();

  /// Says something about the answer in one line on standard error; nothing where it is to be quiet.
  void note(std::string_view text) const;
  /// Says in one line what was wrong with the usage or the input; nothing where the user stopped the work.
  /// @return kWrong; kInUse for Errc::in_use
  [[nodiscard]] int refuse(const base::Error& error) const;
  /// Says in one line why the answer is no; the answer in JSON is null then, unless there was one. @return
  /// kNo
  [[nodiscard]] int deny(const base::Error& error);

  /// Sends what is left of the answer. @return `code`, or kWrong when the answer could not be written.
  [[nodiscard]] int finish(int code);

  /// From now on no answers are printed.
  void set_quiet(bool quiet) { quiet_ = quiet; }
  [[nodiscard]] bool is_quiet() const { return quiet_; }
  /// Answers are in JSON.
  void set_json(bool json) { json_ = json; }

  /// The program's name and verb, "nazori-cli carve", that every line of trouble starts with.
  void set_name(std::string name) { name_ = std::move(name); }

 private:
  void send(std::string_view text);

  std::string name_ = "nazori-cli";
  int write_error_ = 0;
  bool quiet_ = false;
  bool json_ = false;
  bool answered_ = false;
};

/// Width of the terminal on standard output, 80 where it is none; within 40..120, so that lines stay
/// readable.
[[nodiscard]] int text_width();

/// How far work has come, on standard error: a bar on a terminal, else a line at each tenth where `plain` is
/// set, else nothing. Nothing at all where the console is quiet.
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
