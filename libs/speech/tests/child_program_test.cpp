// SPDX-License-Identifier: Apache-2.0
#include "child_program.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

#include "stand_in_voices.h"

namespace nazori::speech {
namespace {

ChildProgram shell(const std::string& script) {
  ChildProgram child;
  child.program = "/bin/sh";
  child.arguments = {"-c", script};
  child.most_output = 1000;
  return child;
}

std::string text_of(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

TEST(ChildProgram, GetsItsArgumentsAndInputUnchangedAndGivesItsOutput) {
  auto child = shell(R"(printf '%s;' "$@"; cat)");
  child.arguments.insert(child.arguments.end(), {"sh", "a b", "$HOME", "か"});
  child.input = "line\n";
  const auto output = run(child);
  ASSERT_TRUE(output) << base::to_line(output.error());
  EXPECT_EQ(text_of(*output), "a b;$HOME;か;line\n");
}

TEST(ChildProgram, MayOpenItsOutputByName) {
  const auto output = run(shell("printf later > /dev/stdout"));
  ASSERT_TRUE(output);
  EXPECT_EQ(text_of(*output), "later");
}

TEST(ChildProgram, ThatDoesNotExistIsNotFound) {
  ChildProgram child;
  child.program = "/no such program";
  const auto output = run(child);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, base::Errc::not_found);
  EXPECT_EQ(output.error().where, "/no such program");
}

TEST(ChildProgram, ThatFailsIsQuotedWithItsFirstLine) {
  const auto output = run(shell("echo first >&2; echo second >&2; exit 1"));
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, base::Errc::io);
  EXPECT_EQ(output.error().what, "first");
  EXPECT_EQ(run(shell("exit 1")).error().what, "failed");
  EXPECT_EQ(run(shell("kill -9 $$")).error().what, "failed");
}

TEST(ChildProgram, IsEndedWithAllThatItStartedWhenItTakesTooLong) {
  const StandInVoices folder;
  auto child = shell("sleep 1000 & echo $! > '" + folder.path("process").string() + "'; wait");
  child.most_time = std::chrono::milliseconds(300);
  const auto output = run(child);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().what, "takes too long");
  std::ifstream in(folder.path("process"));
  pid_t started = 0;
  ASSERT_TRUE(in >> started);
  // It dies a moment after the signal, and the process that adopts it may take a moment to remove it; a
  // removed or a dead one is not running.
  const auto is_over = [started] {
    std::ifstream state("/proc/" + std::to_string(started) + "/stat");
    std::string all;
    std::getline(state, all);
    return all.empty() || all.find(") Z") != std::string::npos || all.find(") X") != std::string::npos;
  };
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!is_over() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  EXPECT_TRUE(is_over());
}

TEST(ChildProgram, IsEndedWhenItWritesTooMuchOrIsNoLongerWanted) {
  auto child = shell("yes");
  EXPECT_EQ(run(child).error().what, "writes too much");
  child = shell("head -c 1001 /dev/zero");
  EXPECT_EQ(run(child).error().what, "writes too much");
  child = shell("head -c 1000 /dev/zero");
  EXPECT_EQ(run(child)->size(), 1000U);
  int asked = 0;
  const auto unwanted = run(shell("sleep 1000"), [&] { return ++asked < 3; });
  ASSERT_FALSE(unwanted);
  EXPECT_EQ(unwanted.error().code, base::Errc::cancelled);
  EXPECT_EQ(asked, 3);
}

TEST(ChildProgram, DoesNotInheritBlockedSignals) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const auto output = run(shell("grep SigBlk /proc/self/status"));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ASSERT_TRUE(output);
  EXPECT_EQ(text_of(*output), "SigBlk:\t0000000000000000\n");
}

}  // namespace
}  // namespace nazori::speech
