// SPDX-License-Identifier: Apache-2.0
#include "learners/learner_exchange.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QProgressDialog>
#include <QTemporaryDir>
#include <algorithm>
#include <utility>

#include "error_text.h"
#include "kanji_text.h"
#include "nazori/base/file.h"
#include "nazori/study/backups.h"
#include "nazori/study/exchange.h"
#include "nazori/study/profiles.h"
#include "study/list_choice.h"

namespace nazori::ui {
namespace {

namespace fs = std::filesystem;
using study::Access;
using study::LearnerStore;

constexpr int kPatience_ms = 500;

base::Result<void> write_learner(LearnerExchange::Kind kind, const fs::path& learner,
                                 const study::Clock& clock, const fs::path& database,
                                 const AnkiChoice& choice, const fs::path& path,
                                 const base::Progress& progress) {
  const auto store = LearnerStore::open(learner, Access::read, clock);
  if (!store) return tl::unexpected(store.error());
  if (kind == LearnerExchange::Kind::anki) {
    const auto kanji = kanji::KanjiDatabase::open(database);
    if (!kanji) return tl::unexpected(kanji.error());
    study::CharacterLists lists(*kanji);
    const auto members = ListChoice::members(choice.list, &lists, *store);
    if (!members) return tl::unexpected(members.error());
    const auto bytes = study::anki_package(*kanji, *members, {choice.deck.toStdString(), choice.words},
                                           store->now(), progress);
    if (!bytes) return tl::unexpected(bytes.error());
    return base::write_file(path, *bytes);
  }
  auto file = base::OutputFile::create(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  const auto append = [&file](std::string_view piece) { return file->append(piece); };
  auto written = kind == LearnerExchange::Kind::csv ? study::export_csv(*store, append, progress)
                                                    : study::export_json(*store, append, progress);
  if (!written) return written;
  if (!progress(1, "write")) return base::fail(base::Errc::cancelled, "stopped");
  return file->commit();
}

/// A name that no learner has yet.
QString free_name(const fs::path& folder, const QString& wished) {
  QString base = wished.trimmed();
  while (!base.isEmpty() && !study::can_be_profile(base.toStdString())) base.chop(1);
  if (base.isEmpty()) base = to_text(study::kDefaultProfile);
  QString name = base;
  std::error_code ignored;
  for (int copy = 2; fs::exists(folder / name.toStdString(), ignored); ++copy)
    name = QStringLiteral("%1 %2").arg(base).arg(copy);
  return name;
}

}  // namespace

LearnerExchange::LearnerExchange(Learner& learner, QWidget* window)
    : QObject(window), learner_(learner), window_(window) {}

LearnerExchange::~LearnerExchange() { wanted_ = false; }

bool LearnerExchange::begin(const QString& words) {
  if (busy_) {
    emit said(Feedback::advice, tr("Something is being written or read already. Wait for it, or stop it."));
    return false;
  }
  busy_ = true;
  wanted_ = true;
  // Above a dialog that is open, which would hold its input up otherwise.
  QWidget* above = QApplication::activeModalWidget();
  dialog_ = new QProgressDialog(words, tr("Stop"), 0, 100, above != nullptr ? above : window_);
  dialog_->setObjectName(QStringLiteral("exchange_progress"));
  dialog_->setWindowModality(Qt::WindowModal);
  dialog_->setMinimumDuration(kPatience_ms);
  dialog_->setAutoClose(false);
  dialog_->setAutoReset(false);
  dialog_->setValue(0);
  connect(dialog_, &QProgressDialog::canceled, this, &LearnerExchange::stop);
  return true;
}

void LearnerExchange::end() {
  busy_ = false;
  if (dialog_ != nullptr) dialog_->deleteLater();
  dialog_ = nullptr;
  emit finished();
}

base::Progress LearnerExchange::progress() {
  // The dialog paints itself whenever it is told, so it is told of whole percents.
  return [this, told = 0](double done, std::string_view) mutable {
    const int percent = std::clamp(static_cast<int>(100 * done), 0, 99);
    if (percent > std::exchange(told, percent)) {
      worker_.answer([this, percent] {
        if (dialog_ != nullptr && wanted_) dialog_->setValue(percent);
      });
    }
    return wanted_.load();
  };
}

void LearnerExchange::tell_failure(const base::Error& error, const QString& sentence) {
  if (error.code == base::Errc::cancelled)
    emit said(Feedback::hint, tr("Stopped. Everything is as it was."));
  else
    emit said(Feedback::wrong, sentence);
}

void LearnerExchange::tell_failure(const QString& path, const base::Error& error) {
  tell_failure(error, tr("%1: %2. Everything is as it was.").arg(QFileInfo(path).fileName(), reason(error)));
}

void LearnerExchange::write(Kind kind, const QString& path, const AnkiChoice& choice) {
  if (!begin(tr("Writing %1…").arg(QFileInfo(path).fileName()))) return;
  const study::Time now = learner_.store().now();
  worker_.post([this, kind, path, choice, now, file = learner_.file(), database = learner_.database_file()] {
    auto done = write_learner(
        kind, file, [now] { return now; }, database, choice, path.toStdString(), progress());
    worker_.answer([this, path, done = std::move(done)] {
      end();
      if (done)
        emit said(Feedback::good, tr("Saved as %1.").arg(QDir::toNativeSeparators(path)));
      else
        tell_failure(path, done.error());
    });
  });
}

void LearnerExchange::read(const QString& path) {
  if (!begin(tr("Reading %1…").arg(QFileInfo(path).fileName()))) return;
  const study::Time now = learner_.store().now();
  worker_.post([this, path, now] {
    auto read = [&]() -> base::Result<Read> {
      const auto source = study::file_source(path.toStdString());
      if (!source) return tl::unexpected(source.error());
      Read made{std::make_shared<QTemporaryDir>(), {}, 0};
      if (!made.folder->isValid())
        return base::fail(base::Errc::io, "no folder for the import can be made", "temporary folder");
      made.file = fs::path(made.folder->path().toStdString()) / "learner.db";
      auto store = LearnerStore::open(made.file, Access::write, [now] { return now; });
      if (!store) return tl::unexpected(store.error());
      if (auto done = study::import_json(*store, *source, progress()); !done)
        return tl::unexpected(done.error());
      if (!wanted_) return base::fail(base::Errc::cancelled, "stopped");
      made.characters = static_cast<int>(store->cards().size());
      return made;
    }();
    worker_.answer([this, path, read = std::move(read)] {
      if (read) return put_in_place(path, *read);
      end();
      tell_failure(path, read.error());
    });
  });
}

void LearnerExchange::put_in_place(const QString& path, const Read& read) {
  const auto lists = learner_.store().lists();
  const auto tags = learner_.store().tags();
  const bool is_empty = learner_.can_write() && learner_.store().last_entry() == 0 && lists &&
                        lists->empty() && tags && tags->empty();
  const QString name =
      is_empty ? learner_.profile() : free_name(learner_.folder(), QFileInfo(path).completeBaseName());
  replace(read.file, name, [this, path, name, read](const base::Result<fs::path>& done) {
    if (done)
      emit said(Feedback::good, tr("Imported for %1: characters %2. %1 studies now.")
                                    .arg(name, QLocale().toString(read.characters)));
    else
      tell_failure(path, done.error());
  });
}

void LearnerExchange::replace(const fs::path& store, const QString& profile,
                              std::function<void(const base::Result<fs::path>&)> done) {
  const study::Time now = learner_.store().now();
  learner_.let_go(
      tr("Something is being put in the place of what %1 has done. Nothing is kept until it is there.")
          .arg(learner_.profile()));
  worker_.post([this, store, profile, now, folder = learner_.folder(), done = std::move(done)] {
    auto put = [&]() -> base::Result<fs::path> {
      const auto file = study::learner_file(folder, profile.toStdString());
      if (!file) return tl::unexpected(file.error());
      return study::restore_backup(
          store, *file, [now] { return now; }, progress());
    }();
    worker_.answer([this, profile, done, put = std::move(put)] {
      if (put && profile != learner_.profile())
        (void)learner_.switch_profile(profile);
      else
        (void)learner_.open_again();
      end();
      done(put);
    });
  });
}

void LearnerExchange::back_up() {
  if (learner_.store().last_entry() == 0) {
    // A store that cannot be read is not an empty one.
    if (learner_.trouble().isEmpty())
      emit said(Feedback::advice, tr("Nothing is studied yet: there is nothing to back up."));
    else
      emit said(Feedback::wrong, learner_.trouble());
    return;
  }
  if (!begin(tr("Making a backup…"))) return;
  const study::Time now = learner_.store().now();
  worker_.post([this, now, file = learner_.file()] {
    auto made = [&]() -> base::Result<fs::path> {
      const auto store = LearnerStore::open(file, Access::read, [now] { return now; });
      if (!store) return tl::unexpected(store.error());
      return study::make_backup(*store, file, progress());
    }();
    worker_.answer([this, made = std::move(made)] {
      end();
      if (made)
        emit said(Feedback::good, tr("Backed up as %1.").arg(to_text(made->filename().string())));
      else
        tell_failure(made.error(), tr("No backup was made: %1.").arg(reason(made.error())));
    });
  });
}

void LearnerExchange::restore(const fs::path& backup) {
  if (!begin(tr("Putting the backup in place…"))) return;
  replace(backup, learner_.profile(), [this](const base::Result<fs::path>& done) {
    if (done)
      emit said(Feedback::good, tr("The backup is in place. What stood there is kept."));
    else
      tell_failure(
          done.error(),
          tr("The backup was not put in place: %1. Everything is as it was.").arg(reason(done.error())));
  });
}

}  // namespace nazori::ui
