// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/character_source.h"
#include "nazori/scan/sheet_reader.h"
#include "nazori/surface/colour_picture.h"

namespace nazori::practice {

/// A photograph of printed worksheets that was read.
struct WorksheetsRead {
  std::filesystem::path photo;
  std::vector<scan::SheetReading> sheets;  ///< at least one
  surface::ColourPicture picture;          ///< scan::marked_picture() of it
};

/// Reads worksheets back from photographs on a separate thread, one after the other. Requests return at once,
/// answers come as signals. Thread: the owner of the inbox.
class WorksheetReader {
 public:
  /// @param inbox  outlives this. @param database  kanji.db; opened by the other thread with the first
  /// request.
  WorksheetReader(base::Inbox& inbox, const CharacterSource& source);
  ~WorksheetReader();
  WorksheetReader(const WorksheetReader&) = delete;
  WorksheetReader& operator=(const WorksheetReader&) = delete;

  /// `was_read` or `refused` follows.
  void read(const std::filesystem::path& photo);
  /// Writes a picture as PNG; `saved` or `refused` follows.
  void save(std::shared_ptr<const surface::ColourPicture> picture, const std::filesystem::path& path);
  /// Requests that were not answered yet.
  [[nodiscard]] int waiting() const { return waiting_; }

  base::Signal<const std::shared_ptr<const WorksheetsRead>&> was_read;
  base::Signal<const std::filesystem::path&> saved;
  /// The path is that of the photograph or the picture.
  base::Signal<const std::filesystem::path&, const base::Error&> refused;

 private:
  struct Bench;
  int waiting_ = 0;
  std::shared_ptr<Bench> bench_;                  ///< used by the other thread alone
  std::unique_ptr<base::Background> background_;  // declared last, so that its thread ends first
};

}  // namespace nazori::practice
