// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "nazori/exchange/tablets.h"
#include "nazori/model/embosser.h"
#include "nazori/model/mill.h"
#include "nazori/practice/touch_file.h"

namespace nazori::cli {

/// The paper of swell paper and embossers.
struct PaperOptions {
  std::string swell = "a4";
  model::EmbosserPaper embosser;

  [[nodiscard]] print::Paper paper() const;
};

/// The options of `model` for machines that print no solid.
struct TouchOptions {
  model::MillSettings mill;
  int layers = 10;
  PaperOptions paper;
  std::string braille = "uncontracted";
  bool no_label = false;

  [[nodiscard]] model::EnglishBraille english() const;
};

/// Adds them. `options` must outlive `verb`.
void add_touch_options(CLI::App& verb, TouchOptions& options);
/// Adds --paper, --columns-braille and --lines-braille to a group. `options` must outlive `verb`.
void add_paper_options(CLI::App& verb, PaperOptions& options, const std::string& group);

/// What was made, for JSON. @param file  its name.
[[nodiscard]] exchange::MadeTouchFile answer_of(const practice::TouchFile& made, const std::string& subject,
                                                const std::string& file);
/// The same in one line for people, and in another what does not suit a finger.
[[nodiscard]] std::string touch_text(const practice::TouchFile& made, const std::string& subject,
                                     const std::string& file);
/// A line for people if lines on swell paper are too close for fingers; else empty.
[[nodiscard]] std::string close_lines_text(const practice::TouchFile& made);

}  // namespace nazori::cli
