// SPDX-License-Identifier: Apache-2.0
#include "console.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <system_error>

#include "stop.h"
#include "text_layout.h"

namespace nazori::cli {
namespace {

// The error may quote an argument of 50 kB.
constexpr int kWidestPart = 200;
constexpr int kWidestRemedy = 400;

/// The error as one line that any terminal can show.
std::string shown(const base::Error& error) {
  base::Error part = error;
  part.what = shortened(printable(base::to_line({error.code, error.what, "", ""})), kWidestPart);
  part.where = shortened(printable(base::to_line({error.code, error.where, "", ""})), kWidestPart);
  part.remedy = shortened(printable(base::to_line({error.code, error.remedy, "", ""})), kWidestRemedy);
  return base::to_line(part);
}

int columns_of(int descriptor) {
  winsize size{};
  if (::isatty(descriptor) != 1 || ::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void to_stderr(std::string_view text) {
  // A failure of standard error cannot be reported.
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
  (void)std::fflush(stderr);
}

}  // namespace

void Console::send(std::string_view text) {
  if (write_error_ != 0) return;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) write_error_ = errno;
}

void Console::print(std::string_view text) {
  answered_ = true;
  if (!quiet_) send(text);
}

void Console::print_file(std::string_view bytes) { send(bytes); }

bool Console::flush() {
  if (std::fflush(stdout) != 0 && write_error_ == 0) write_error_ = errno;
  return write_error_ == 0;
}

void Console::inform(std::string_view text) const {
  if (!quiet_) to_stderr(fmt::format("{}: {}\n", name_, printable(text)));
}

int Console::refuse(const base::Error& error) const {
  // The user who stopped the work needs no message; the program ends by that signal.
  if (error.code == base::Errc::cancelled && stop_requested()) return kWrong;
  to_stderr(fmt::format("{}: {}\n", name_, shown(error)));
  return error.code == base::Errc::in_use ? kInUse : kWrong;
}

int Console::deny(const base::Error& error) {
  if (json_ && !answered_) print("null\n");
  (void)refuse(error);
  return kNo;
}

int Console::finish(int code) {
  (void)flush();
  if (write_error_ == 0 || write_error_ == EPIPE) return code;
  return refuse({base::Errc::io, "cannot be written: " + std::generic_category().message(write_error_),
                 "standard output", ""});
}

int text_width() { return std::clamp(columns_of(STDOUT_FILENO), 40, 120); }

ProgressDisplay::ProgressDisplay(const Console& console, Plain plain)
    : terminal_(!console.is_quiet() && ::isatty(STDERR_FILENO) == 1),
      plain_(console.is_quiet() ? Plain::silent : plain) {}

ProgressDisplay::~ProgressDisplay() { clear(); }

bool ProgressDisplay::show(double done, std::string_view step) {
  done = std::clamp(done, 0.0, 1.0);
  const int percent = static_cast<int>(std::floor(done * 100));
  if (terminal_) {
    const double now = now_s();
    if (last_drawn_s_ < 0) last_drawn_s_ = now;
    // Very short work needs no bar, and a bar needs at most ten updates a second.
    if (now - last_drawn_s_ >= 0.1) {
      last_drawn_s_ = now;
      drawn_ = true;
      note_unfinished_line(true);
      constexpr int kCells = 24;
      const int full = percent * kCells / 100;
      std::string bar;
      for (int i = 0; i < kCells; ++i) bar += i < full ? "█" : "░";
      const int room = columns_of(STDERR_FILENO) - kCells - 10;
      to_stderr(fmt::format("\r\x1b[K{} {:3} %  {}", bar, percent, cut(step, std::max(room, 0))));
    }
  } else if (plain_ == Plain::lines && percent / 10 > last_tenth_) {
    last_tenth_ = percent / 10;
    to_stderr(fmt::format("{:3} %  {}\n", last_tenth_ * 10, step));
  }
  return !stop_requested();
}

void ProgressDisplay::clear() {
  if (drawn_) to_stderr("\r\x1b[K");
  drawn_ = false;
  note_unfinished_line(false);
}

base::Progress ProgressDisplay::callback() {
  return [this](double done, std::string_view step) { return show(done, step); };
}

}  // namespace nazori::cli
