// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/learner_exchange.h"

#include <stdlib.h>

#include <utility>

#include "nazori/base/file.h"
#include "nazori/practice/list_members.h"
#include "nazori/study/backups.h"
#include "nazori/study/exchange.h"
#include "nazori/study/profiles.h"

namespace nazori::practice {
namespace {

namespace fs = std::filesystem;
using study::Access;
using study::LearnerStore;
using Kind = ExchangeEvent::Kind;

/// A folder that is removed with this object, with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code unknown;
    std::string name = (fs::temp_directory_path(unknown) / "nazori-XXXXXX").string();
    if (!unknown && mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// Empty where none could be made.
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

base::Result<void> write_learner(LearnerExchange::Format format, const fs::path& learner,
                                 const study::Clock& clock, const CharacterSource& characters,
                                 const AnkiChoice& choice, const fs::path& path,
                                 const base::Progress& progress) {
  const auto store = LearnerStore::open(learner, Access::read, clock);
  if (!store) return tl::unexpected(store.error());
  if (format == LearnerExchange::Format::anki) {
    CharacterBook book(characters);
    if (const auto opened = book.look(); !opened) return tl::unexpected(opened.error());
    study::CharacterLists lists(*book.database());
    const auto members = list_members(choice.list, &lists, *store);
    if (!members) return tl::unexpected(members.error());
    const auto bytes =
        study::anki_package(*book.database(), *members, {choice.deck, choice.words}, store->now(), progress);
    if (!bytes) return tl::unexpected(bytes.error());
    return base::write_file(path, *bytes);
  }
  auto file = base::OutputFile::create(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  const auto append = [&file](std::string_view piece) { return file->append(piece); };
  auto written = format == LearnerExchange::Format::csv ? study::export_csv(*store, append, progress)
                                                        : study::export_json(*store, append, progress);
  if (!written) return written;
  if (!progress(1, "write")) return base::fail(base::Errc::cancelled, "stopped");
  return file->commit();
}

/// Without the last character.
void shorten(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
  if (!text.empty()) text.pop_back();
}

/// Without white space at its ends, the ideographic space included.
std::string trimmed(std::string text) {
  constexpr std::string_view kSpaces = " \t\n\v\f\r";
  constexpr std::string_view kWideSpace = "\xE3\x80\x80";
  for (bool more = true; more && !text.empty();) {
    more = true;
    if (text.starts_with(kWideSpace))
      text.erase(0, kWideSpace.size());
    else if (text.ends_with(kWideSpace))
      text.resize(text.size() - kWideSpace.size());
    else if (kSpaces.find(text.front()) != std::string_view::npos)
      text.erase(0, 1);
    else if (kSpaces.find(text.back()) != std::string_view::npos)
      text.pop_back();
    else
      more = false;
  }
  return text;
}

/// An unused name for a learner.
std::string free_name(const fs::path& folder, const fs::path& file) {
  std::string base = trimmed(file.stem().string());
  while (!base.empty() && !study::can_be_profile(base)) shorten(base);
  if (base.empty()) base = study::kDefaultProfile;
  std::string name = base;
  std::error_code ignored;
  for (int copy = 2; fs::exists(folder / name, ignored); ++copy) name = base + ' ' + std::to_string(copy);
  return name;
}

}  // namespace

/// The result of an import so far: a valid learner.db in a folder that is removed with this object.
struct LearnerExchange::Import {
  std::shared_ptr<TemporaryFolder> folder;
  fs::path file;
  int characters = 0;
};

LearnerExchange::LearnerExchange(base::Inbox& inbox, Learner& learner)
    : learner_(learner), work_("exchange", inbox) {}

bool LearnerExchange::begin(Work work, const fs::path& file) {
  if (!work_.begin()) {
    announce(Kind::busy);
    return false;
  }
  started(work, file);
  return true;
}

void LearnerExchange::end() {
  work_.end();
  finished();
}

void LearnerExchange::announce(ExchangeEvent::Kind kind, const fs::path& file) {
  ExchangeEvent event;
  event.kind = kind;
  event.file = file;
  announced(event);
}

void LearnerExchange::announce_failure(ExchangeEvent::Kind kind, const base::Error& error,
                                       const fs::path& file) {
  ExchangeEvent event;
  event.kind = error.code == base::Errc::cancelled ? Kind::stopped : kind;
  event.file = file;
  event.error = error;
  announced(event);
}

void LearnerExchange::write(Format format, const fs::path& file, const AnkiChoice& choice) {
  if (!begin(Work::write, file)) return;
  const study::Time now = learner_.store().now();
  work_.run(
      [format, file, choice, now, learner = learner_.file(),
       characters = learner_.source()](const base::Progress& progress) {
        return write_learner(
            format, learner, [now] { return now; }, characters, choice, file, progress);
      },
      [this, file](const base::Result<void>& done) {
        end();
        if (done)
          announce(Kind::saved, file);
        else
          announce_failure(Kind::exchange_failed, done.error(), file);
      });
}

void LearnerExchange::read(const fs::path& file) {
  if (!begin(Work::read, file)) return;
  const study::Time now = learner_.store().now();
  work_.run(
      [file, now, this](const base::Progress& progress) -> base::Result<Import> {
        const auto source = study::file_source(file);
        if (!source) return tl::unexpected(source.error());
        Import made{std::make_shared<TemporaryFolder>(), {}, 0};
        if (made.folder->path().empty())
          return base::fail(base::Errc::io, "no folder for the import can be made", "temporary folder");
        made.file = made.folder->path() / "learner.db";
        auto store = LearnerStore::open(made.file, Access::write, [now] { return now; });
        if (!store) return tl::unexpected(store.error());
        if (auto done = study::import_json(*store, *source, progress); !done)
          return tl::unexpected(done.error());
        if (!work_.is_wanted()) return base::fail(base::Errc::cancelled, "stopped");
        made.characters = static_cast<int>(store->cards().size());
        return made;
      },
      [this, file](const base::Result<Import>& import) {
        if (import) return place(file, *import);
        end();
        announce_failure(Kind::exchange_failed, import.error(), file);
      });
}

void LearnerExchange::place(const fs::path& file, const Import& import) {
  const auto lists = learner_.store().lists();
  const auto tags = learner_.store().tags();
  const bool is_empty = learner_.can_write() && learner_.store().last_entry() == 0 && lists &&
                        lists->empty() && tags && tags->empty();
  const std::string name = is_empty ? learner_.profile() : free_name(learner_.folder(), file);
  replace(import.file, name, [this, file, name, import](const Placed& placed) {
    if (!placed) return announce_failure(Kind::exchange_failed, placed.error(), file);
    ExchangeEvent event;
    event.kind = Kind::imported;
    event.file = file;
    event.profile = name;
    event.characters = import.characters;
    announced(event);
  });
}

void LearnerExchange::replace(const fs::path& store, const std::string& profile,
                              std::function<void(const Placed&)> done) {
  const study::Time now = learner_.store().now();
  learner_.let_go(LearnerEvent::Kind::replacing);
  work_.run(
      [store, profile, now, folder = learner_.folder()](const base::Progress& progress) -> Placed {
        const auto file = study::learner_file(folder, profile);
        if (!file) return tl::unexpected(file.error());
        return study::restore_backup(
            store, *file, [now] { return now; }, progress);
      },
      [this, profile, done = std::move(done)](const Placed& placed) {
        if (placed && profile != learner_.profile())
          (void)learner_.switch_profile(profile);
        else
          (void)learner_.open_again();
        end();
        done(placed);
      });
}

void LearnerExchange::back_up() {
  if (learner_.store().last_entry() == 0) {
    // A store that cannot be read must not be treated as an empty one.
    ExchangeEvent event;
    event.kind = learner_.trouble() ? Kind::no_store : Kind::nothing_to_back_up;
    event.trouble = learner_.trouble();
    announced(event);
    return;
  }
  if (!begin(Work::back_up)) return;
  const study::Time now = learner_.store().now();
  work_.run(
      [now, file = learner_.file()](const base::Progress& progress) -> Placed {
        const auto store = LearnerStore::open(file, Access::read, [now] { return now; });
        if (!store) return tl::unexpected(store.error());
        return study::make_backup(*store, file, progress);
      },
      [this](const Placed& made) {
        end();
        if (made)
          announce(Kind::backed_up, *made);
        else
          announce_failure(Kind::backup_failed, made.error());
      });
}

void LearnerExchange::restore(const fs::path& backup) {
  if (!begin(Work::restore)) return;
  replace(backup, learner_.profile(), [this](const Placed& placed) {
    if (placed)
      announce(Kind::restored);
    else
      announce_failure(Kind::restore_failed, placed.error());
  });
}

}  // namespace nazori::practice
