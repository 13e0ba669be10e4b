// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/character_source.h"
#include "nazori/practice/worksheet_choice.h"
#include "nazori/print/page_drawing.h"

namespace nazori::practice {

/// A worksheet to make: a choice, and the characters that it means.
struct WorksheetRequest {
  WorksheetChoice choice;
  /// As chosen_characters() gives them; for WorksheetSource::text they are read from the text.
  std::vector<char32_t> characters;

  friend bool operator==(const WorksheetRequest&, const WorksheetRequest&) = default;
};

/// One side of a worksheet to look at.
struct WorksheetView {
  std::size_t pages = 0;          ///< sides of the whole document
  std::size_t page = 0;           ///< which one this is, from 0
  std::size_t characters = 0;     ///< printed ones
  std::vector<char32_t> missing;  ///< asked for, but not in the database
  std::shared_ptr<const print::PageDrawing> drawing;
};

/// Lays worksheets out, shows their pages and writes them as PDF, on a separate thread. Requests return at
/// once, answers come as signals. Thread: the owner of the inbox.
class WorksheetMaker {
 public:
  /// @param inbox  outlives this. @param database  kanji.db; opened by the other thread.
  WorksheetMaker(base::Inbox& inbox, const CharacterSource& source);
  ~WorksheetMaker();
  WorksheetMaker(const WorksheetMaker&) = delete;
  WorksheetMaker& operator=(const WorksheetMaker&) = delete;

  /// Asks for one page; `shown` or `refused` follows. Of several requests only the newest is answered.
  /// @param page  from 0; after the last page, the last one.
  void show(WorksheetRequest request, std::size_t page);
  /// Writes the document, completely or not at all; `saved` or `not_saved` follows.
  void save(WorksheetRequest request, const std::filesystem::path& path);
  /// Stops saving; nothing is written, and no signal follows.
  void stop();
  [[nodiscard]] bool is_saving() const;

  base::Signal<const WorksheetView&> shown;
  /// There is no such worksheet: Errc::bad_argument for nothing to print or settings that do not fit
  /// together.
  base::Signal<const base::Error&, std::size_t /*characters*/> refused;
  /// Whole percent of saving.
  base::Signal<int> progressed;
  base::Signal<const std::filesystem::path&, std::size_t /*pages*/> saved;
  base::Signal<const std::filesystem::path&, const base::Error&> not_saved;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::practice
