// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "console.h"

namespace nazori::cli {

/// The chosen command. @return the exit code.
using Action = std::function<int(Console&)>;

/// Each function adds one command to the command line. Parsing arguments that name the command sets `chosen`;
/// `chosen` must outlive `app`.
void add_info(CLI::App& app, Action& chosen);
void add_search(CLI::App& app, Action& chosen);
void add_carve(CLI::App& app, Action& chosen);
void add_render(CLI::App& app, Action& chosen);
void add_model(CLI::App& app, Action& chosen);
void add_plot(CLI::App& app, Action& chosen);
void add_demo(CLI::App& app, Action& chosen);
void add_feel(CLI::App& app, Action& chosen);
void add_paint(CLI::App& app, Action& chosen);
void add_record(CLI::App& app, Action& chosen);
void add_grade(CLI::App& app, Action& chosen);
void add_recognise(CLI::App& app, Action& chosen);
void add_practise(CLI::App& app, Action& chosen);
void add_speak(CLI::App& app, Action& chosen);
void add_devices(CLI::App& app, Action& chosen);
void add_study(CLI::App& app, Action& chosen);
void add_database(CLI::App& app, Action& chosen);
void add_worksheet(CLI::App& app, Action& chosen);
void add_grade_sheet(CLI::App& app, Action& chosen);
void add_author(CLI::App& app, Action& chosen);
void add_completion(CLI::App& app, Action& chosen);
void add_manual(CLI::App& app, Action& chosen);
void add_help(CLI::App& app, Action& chosen);

}  // namespace nazori::cli
