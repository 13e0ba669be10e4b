// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <atomic>
#include <functional>
#include <memory>

#include "nazori/base/progress.h"
#include "study/learner.h"
#include "worker.h"

class QProgressDialog;
class QTemporaryDir;

namespace nazori::ui {

/// What goes into an Anki package.
struct AnkiChoice {
  QString list;  ///< as ListChoice::list(); empty: what was met
  QString deck = QStringLiteral("Nazori");
  int words = 4;
};

/// Everything of a learner to a file and back, backups too, on a thread of its own, with how far it is and a
/// way to stop. Files are written whole or not at all, also where the window is closed meanwhile; what is
/// imported is tried apart first. Says in one sentence how it went. Thread: interface.
class LearnerExchange final : public QObject {
  Q_OBJECT
 public:
  enum class Kind : std::uint8_t { json, csv, anki };

  LearnerExchange(Learner& learner, QWidget* window);
  ~LearnerExchange() override;

  /// Writes the present learner. One work at a time: another is refused with a sentence.
  void write(Kind kind, const QString& path, const AnkiChoice& choice = {});
  /// Reads an export: into the present learner where nothing is studied yet, else into a new one named after
  /// the file, who studies then.
  void read(const QString& path);
  /// Makes a backup of the present learner besides the daily ones.
  void back_up();
  /// Puts a backup in the place of the present learner's file; what stood there is kept. Until that is done
  /// the learner has no store.
  void restore(const std::filesystem::path& backup);
  [[nodiscard]] bool is_busy() const { return busy_; }
  void stop() { wanted_ = false; }

 signals:
  void said(nazori::ui::Feedback kind, QString sentence);
  void finished();

 private:
  /// What an import has made so far: a sound learner.db in a folder that goes with this.
  struct Read {
    std::shared_ptr<QTemporaryDir> folder;
    std::filesystem::path file;
    int characters = 0;
  };
  bool begin(const QString& words);
  void end();
  [[nodiscard]] base::Progress progress();
  void put_in_place(const QString& path, const Read& read);
  /// Puts a store in the place of a profile's file, then opens that profile. @param done  told of what became
  /// of it, when it is open.
  void replace(const std::filesystem::path& store, const QString& profile,
               std::function<void(const base::Result<std::filesystem::path>&)> done);
  /// Says the sentence, or that it was stopped where the learner did that.
  void tell_failure(const base::Error& error, const QString& sentence);
  void tell_failure(const QString& path, const base::Error& error);

  Learner& learner_;
  QWidget* window_;
  QPointer<QProgressDialog> dialog_;
  bool busy_ = false;
  std::atomic<bool> wanted_{false};
  Worker worker_{QStringLiteral("exchange")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
