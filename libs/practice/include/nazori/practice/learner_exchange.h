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

/// What goes into an Anki package.
struct AnkiChoice {
  std::string list;             ///< as list_members() reads it; empty: what was studied
  std::string deck = "Nazori";  ///< its name
  int words = 4;                ///< at most so many per character
};

/// How an exchange went.
struct ExchangeEvent {
  enum class Kind : std::uint8_t {
    busy,                ///< something is being written or read already
    nothing_to_back_up,  ///< nothing is studied yet
    no_store,            ///< the study data cannot be read: `trouble`
    saved,               ///< an export is in `file`
    imported,            ///< `characters` for `profile`, which is now open
    backed_up,           ///< the backup is `file`
    restored,            ///< the backup is the learner's file now; what was there is a backup
    stopped,             ///< by stop(): everything is as it was
    exchange_failed,     ///< of `file`, by `error`: everything is as it was
    backup_failed,       ///< by `error`
    restore_failed,      ///< by `error`: everything is as it was
  };
  Kind kind = Kind::busy;
  std::filesystem::path file;
  std::string profile;
  int characters = 0;
  base::Error error;
  std::optional<LearnerEvent> trouble;
};

/// Everything of a learner to a file and back, backups too, on a thread of its own, with how far it is and a
/// way to stop. Files are written whole or not at all, also where this is destroyed meanwhile; an import is
/// read apart first. Thread: the owner of the inbox.
class LearnerExchange {
 public:
  enum class Format : std::uint8_t { json, csv, anki };
  enum class Work : std::uint8_t { write, read, back_up, restore };

  /// @param learner  outlives this.
  LearnerExchange(base::Inbox& inbox, Learner& learner);

  /// Writes the present learner. One work at a time: another is refused (`busy`).
  void write(Format format, const std::filesystem::path& file, const AnkiChoice& choice = {});
  /// Imports an export into the current learner where nothing is studied yet, else into a new learner named
  /// after the file, whose profile is then opened.
  void read(const std::filesystem::path& file);
  /// Makes a backup of the present learner besides the daily ones.
  void back_up();
  /// Restores a backup of the current learner; the replaced file is backed up first. Until that is done the
  /// learner has no store.
  void restore(const std::filesystem::path& backup);
  [[nodiscard]] bool is_busy() const { return work_.is_busy(); }
  /// Asks what is running to stop; everything stays as it was, unless it is too late.
  void stop() { work_.stop(); }

  /// Work has begun; the file is that of write() and read().
  base::Signal<Work, const std::filesystem::path&> started;
  /// Whole percents of the present step.
  [[nodiscard]] base::Signal<int>& progressed() { return work_.progressed; }
  /// The work is done, one way or another; before what is announced of it.
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
  LongWork work_;  // declared last, so that it ends before what it uses
};

}  // namespace nazori::practice
