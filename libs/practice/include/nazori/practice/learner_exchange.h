// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/long_work.h"

namespace nazori::practice {

/// The content of an Anki package.
struct AnkiChoice {
  std::string list;             ///< as list_members() reads it; empty: all studied characters
  std::string deck = "Nazori";  ///< its name
  int words = 4;                ///< maximum number per character
};

/// How an exchange went.
struct ExchangeEvent {
  enum class Kind : std::uint8_t {
    busy,                ///< another operation is already running
    nothing_to_back_up,  ///< nothing is studied yet
    no_store,            ///< the study data cannot be read: `trouble`
    saved,               ///< an export is in `file`
    imported,            ///< `characters` for `profile`, which is now open
    backed_up,           ///< the backup is `file`
    restored,            ///< the backup is now the learner's file; the replaced file was backed up
    stopped,             ///< by stop(): nothing has changed
    exchange_failed,     ///< of `file`, by `error`: nothing has changed
    backup_failed,       ///< by `error`
    restore_failed,      ///< by `error`: nothing has changed
  };
  Kind kind = Kind::busy;
  std::filesystem::path file;
  std::string profile;
  int characters = 0;
  base::Error error;
  std::optional<LearnerEvent> trouble;
};

/// Exports and imports all data of a learner, and makes and restores backups, on a separate thread, with
/// progress and a way to stop. Files are written completely or not at all, even if this object is destroyed
/// meanwhile. An import is first read into a temporary file. Thread: the owner of the inbox.
class LearnerExchange {
 public:
  enum class Format : std::uint8_t { json, csv, anki };
  enum class Work : std::uint8_t { write, read, back_up, restore };

  /// @param learner  outlives this.
  LearnerExchange(base::Inbox& inbox, Learner& learner);

  /// Exports the current learner. Only one operation runs at a time: another one is refused (`busy`).
  void write(Format format, const std::filesystem::path& file, const AnkiChoice& choice = {});
  /// Imports an export into the current learner where nothing is studied yet, else into a new learner named
  /// after the file, whose profile is then opened.
  void read(const std::filesystem::path& file);
  /// Makes a backup of the current learner besides the daily ones.
  void back_up();
  /// Restores a backup of the current learner; the replaced file is backed up first. Until it is finished the
  /// learner has no store.
  void restore(const std::filesystem::path& backup);
  [[nodiscard]] bool is_busy() const { return work_.is_busy(); }
  /// Asks the running operation to stop. Nothing changes then, unless it is too late.
  void stop() { work_.stop(); }

  /// An operation has begun; the file is that of write() or read().
  base::Signal<Work, const std::filesystem::path&> started;
  /// Progress of the present step in whole percent.
  [[nodiscard]] base::Signal<int>& progressed() { return work_.progressed; }
  /// The operation has ended, with or without success; emitted before its result is announced.
  base::Signal<> finished;
  base::Signal<const ExchangeEvent&> announced;

 private:
  struct Import;
  using Placed = base::Result<std::filesystem::path>;

  bool begin(Work work, const std::filesystem::path& file = {});
  void end();
  void announce(ExchangeEvent::Kind kind, const std::filesystem::path& file = {});
  void announce_failure(ExchangeEvent::Kind kind, const base::Error& error,
                        const std::filesystem::path& file = {});
  void place(const std::filesystem::path& file, const Import& import);
  /// Replaces a profile's file with a store, then opens that profile. @param done  called once it is open.
  void replace(const std::filesystem::path& store, const std::string& profile,
               std::function<void(const Placed&)> done);

  Learner& learner_;
  LongWork work_;  // declared last, so that it is destroyed before the members it uses
};

}  // namespace nazori::practice
