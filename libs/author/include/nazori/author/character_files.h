// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

#include "nazori/author/character_editor.h"
#include "nazori/author/character_file.h"
#include "nazori/author/collection.h"
#include "nazori/base/executor.h"
#include "nazori/base/result.h"

namespace nazori::author {

/// A character that was opened, to be edited.
struct OpenedCharacter {
  CharacterEditor editor;
  bool is_document = false;  ///< a .nazori, which can be saved under its name
  std::optional<Recovery> recovery;
};

/// Opens a file of any format that can be read. A character without a name of its own is called as its file.
/// Thread: any. @return the errors of CharacterEditor::open() and import_character().
[[nodiscard]] base::Result<OpenedCharacter> open_character(const std::filesystem::path& path);

/// Files of characters, read and written on another thread, one after another. Each call returns at once and
/// its answer follows. Thread: the owner of the inbox.
class CharacterFiles {
 public:
  template <class... Results>
  using Answered = std::function<void(Results...)>;

  /// @param inbox  outlives this. The thread starts with the first call.
  explicit CharacterFiles(base::Inbox& inbox) : inbox_(inbox) {}

  /// As open_character().
  void open(const std::filesystem::path& path, Answered<base::Result<OpenedCharacter>> answered);
  /// As CharacterEditor::write_document(). The point comes back for CharacterEditor::end_save(), also where
  /// there is an error.
  void save(SavePoint point, const std::filesystem::path& path,
            Answered<SavePoint, base::Result<void>> answered);
  /// As CharacterEditor::write_journal().
  void begin_journal(SavePoint point, const std::filesystem::path& journal,
                     Answered<SavePoint, base::Result<void>> answered);
  /// As Collection::keep(). @param becomes_document  the document has no other file: it is then saved, and
  /// its journal begins beside the kept file.
  void keep(SavePoint point, const Collection& collection, std::optional<char32_t> as, SameName same_name,
            bool becomes_document, Answered<SavePoint, base::Result<char32_t>> answered);
  /// As Collection::remove().
  void remove(const Collection& collection, char32_t code_point, Answered<base::Result<void>> answered);
  /// As export_character(). @param size  as there.
  void write_copy(OwnCharacter character, const std::filesystem::path& path, CharacterFormat format, int size,
                  Answered<base::Result<void>> answered);

  /// Whether an answer is to come.
  [[nodiscard]] bool is_busy() const { return is_waiting_for(asked_); }
  /// Number of the last call, from 1 on; 0 before the first.
  [[nodiscard]] std::size_t last_call() const { return asked_; }
  /// Whether the answer to this call is to come, or the call itself.
  [[nodiscard]] bool is_waiting_for(std::size_t call) const { return answered_ < call; }

 private:
  template <class Work, class Done>
  void run(Work work, Done done);

  base::Inbox& inbox_;
  std::size_t asked_ = 0, answered_ = 0;
  std::optional<base::Background> background_;  // declared last, so that its thread ends first
};

}  // namespace nazori::author
