// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/worksheet_reader.h"

#include <optional>
#include <utility>

#include "nazori/kanji/kanji_database.h"
#include "nazori/scan/marked_picture.h"
#include "nazori/scan/picture.h"

namespace nazori::practice {

namespace fs = std::filesystem;

/// What the other thread keeps: the database, and what it knows of the shapes of characters.
struct WorksheetReader::Bench {
  explicit Bench(CharacterSource source) : book(std::move(source)) {}

  base::Result<std::shared_ptr<const WorksheetsRead>> read(const fs::path& path) {
    auto photo = scan::load_photo(path);
    if (!photo) return tl::unexpected(std::move(photo.error()));
    const auto anew = book.look();
    if (!anew) return tl::unexpected(anew.error());
    if (*anew || !reader) {
      reader.reset();
      auto made = scan::SheetReader::make(*book.database());
      if (!made) return tl::unexpected(std::move(made.error()));
      reader.emplace(*std::move(made));
    }
    auto sheets = reader->read(*photo);
    if (!sheets) return tl::unexpected(std::move(sheets.error()));
    auto answer = std::make_shared<WorksheetsRead>();
    answer->photo = path;
    answer->picture = scan::marked_picture(*photo, *sheets);
    answer->sheets = *std::move(sheets);
    return answer;
  }

  CharacterBook book;
  std::optional<scan::SheetReader> reader;
};

WorksheetReader::WorksheetReader(base::Inbox& inbox, const CharacterSource& source)
    : bench_(std::make_shared<Bench>(source)),
      background_(std::make_unique<base::Background>("sheets", inbox)) {}

WorksheetReader::~WorksheetReader() = default;

void WorksheetReader::read(const fs::path& photo) {
  ++waiting_;
  background_->post([this, &to = *background_, bench = bench_, photo] {
    auto answer = bench->read(photo);
    to.answer([this, photo, answer = std::move(answer)] {
      --waiting_;
      if (answer)
        was_read(*answer);
      else
        refused(photo, answer.error());
    });
  });
}

void WorksheetReader::save(std::shared_ptr<const surface::ColourPicture> picture, const fs::path& path) {
  ++waiting_;
  background_->post([this, &to = *background_, picture = std::move(picture), path] {
    const auto written = surface::save_png(*picture, path);
    to.answer([this, path, written] {
      --waiting_;
      if (written)
        saved(path);
      else
        refused(path, written.error());
    });
  });
}

}  // namespace nazori::practice
