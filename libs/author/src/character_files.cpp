// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/character_files.h"

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "nazori/base/file.h"

namespace nazori::author {

base::Result<OpenedCharacter> open_character(const std::filesystem::path& path) {
  const auto format = format_of(path);
  std::optional<Recovery> recovery;
  if (format == CharacterFormat::document) {
    auto editor = CharacterEditor::open(path, recovery);
    if (!editor) return tl::unexpected(std::move(editor).error());
    return OpenedCharacter{*std::move(editor), true, recovery};
  }
  if (!format)
    return base::fail(base::Errc::bad_argument, "is not a file of a character", path.filename().string(),
                      ".nazori, .svg, .str, .raw and .png are");
  const auto bytes = base::read_file(path, kLargestFile);
  if (!bytes) return tl::unexpected(bytes.error());
  auto character = import_character(*bytes, *format);
  if (!character) return tl::unexpected(std::move(character).error());
  if (character->facts.name.empty()) character->facts.name = path.stem().string();
  auto editor = CharacterEditor::create(*std::move(character));
  if (!editor) return tl::unexpected(std::move(editor).error());
  return OpenedCharacter{*std::move(editor), false, recovery};
}

/// Runs `work` on the other thread and gives what it returns to `done` on the owner's.
template <class Work, class Done>
void CharacterFiles::run(Work work, Done done) {
  if (!background_) background_.emplace("character files", inbox_);
  ++asked_;
  // Tasks are copied; what is moved between the threads is therefore shared.
  const auto shared_work = std::make_shared<Work>(std::move(work));
  const auto shared_done = std::make_shared<Done>(std::move(done));
  // An optional that is being destroyed says that it is empty while its thread still finishes.
  background_->post([this, background = &*background_, shared_work, shared_done] {
    using Made = std::invoke_result_t<Work&>;
    const auto made = std::make_shared<Made>((*shared_work)());
    background->answer([this, made, shared_done] {
      ++answered_;
      (*shared_done)(std::move(*made));
    });
  });
}

void CharacterFiles::open(const std::filesystem::path& path,
                          Answered<base::Result<OpenedCharacter>> answered) {
  run([path] { return open_character(path); }, std::move(answered));
}

void CharacterFiles::save(SavePoint point, const std::filesystem::path& path,
                          Answered<SavePoint, base::Result<void>> answered) {
  run(
      [point = std::move(point), path]() mutable {
        auto saved = CharacterEditor::write_document(point, path);
        return std::pair(std::move(point), std::move(saved));
      },
      [answered = std::move(answered)](auto made) {
        answered(std::move(made.first), std::move(made.second));
      });
}

void CharacterFiles::begin_journal(SavePoint point, const std::filesystem::path& journal,
                                   Answered<SavePoint, base::Result<void>> answered) {
  run(
      [point = std::move(point), journal]() mutable {
        auto begun = CharacterEditor::write_journal(point, journal);
        return std::pair(std::move(point), std::move(begun));
      },
      [answered = std::move(answered)](auto made) {
        answered(std::move(made.first), std::move(made.second));
      });
}

void CharacterFiles::keep(SavePoint point, const Collection& collection, std::optional<char32_t> as,
                          SameName same_name, bool becomes_document,
                          Answered<SavePoint, base::Result<char32_t>> answered) {
  run(
      [point = std::move(point), collection, as, same_name, becomes_document]() mutable {
        auto kept = collection.keep(point.character, as, same_name);
        if (kept && becomes_document) {
          point.is_written = true;
          point.is_of_file = true;
          // Without a new journal the one there was goes on.
          if (!point.journal_file.empty())
            (void)CharacterEditor::write_journal(point, journal_path(collection.file_of(*kept)));
        }
        return std::pair(std::move(point), std::move(kept));
      },
      [answered = std::move(answered)](auto made) {
        answered(std::move(made.first), std::move(made.second));
      });
}

void CharacterFiles::remove(const Collection& collection, char32_t code_point,
                            Answered<base::Result<void>> answered) {
  run([collection, code_point] { return collection.remove(code_point); }, std::move(answered));
}

void CharacterFiles::write_copy(OwnCharacter character, const std::filesystem::path& path,
                                CharacterFormat format, int size, Answered<base::Result<void>> answered) {
  run(
      [character = std::move(character), path, format, size]() -> base::Result<void> {
        const auto bytes = export_character(character, format, size);
        if (!bytes) return tl::unexpected(bytes.error());
        return base::write_file(path, *bytes);
      },
      std::move(answered));
}

}  // namespace nazori::author
