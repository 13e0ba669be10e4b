// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "feedback_line.h"
#include "nazori/study/character_lists.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/learner_store.h"
#include "study/store_upkeep.h"

namespace nazori::ui {

/// Who studies in this window: the profile's store, open for writing where that is possible. Where it is not
/// (another window holds it, the folder is read-only, the file is damaged or of a newer version) nothing is
/// written: can_write() is false, trouble() says why, and store() shows what can be read, or an empty one.
/// Thread: interface.
class Learner final : public QObject {
  Q_OBJECT
 public:
  struct Place {
    std::filesystem::path folder;    ///< of all profiles; empty: study::profiles_folder()
    std::filesystem::path database;  ///< kanji.db, for lists and their order
    study::Clock clock;              ///< empty: the computer's
  };

  explicit Learner(Place place, QObject* parent = nullptr);
  ~Learner() override;

  /// Opens a profile; one that is not there yet is a new learner. Emits profile_changed() in any case.
  /// @return whether it can be written. A name that can be none changes nothing.
  bool switch_profile(const QString& name);
  /// Opens the same profile once more, after another window was closed.
  bool open_again();
  /// Lets go of the file while `work` is done (a profile renamed), then opens the profile that it returns;
  /// empty: the same again.
  void while_closed(const std::function<QString()>& work);
  /// Lets go of the file, for another thread to put one in its place; `sentence` becomes trouble() until the
  /// profile, or another one, is opened again.
  void let_go(const QString& sentence);

  [[nodiscard]] const QString& profile() const { return profile_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// The learner.db of the profile.
  [[nodiscard]] std::filesystem::path file() const;

  /// Never hold on to it: opening anew replaces it.
  [[nodiscard]] study::LearnerStore& store() { return *store_; }
  [[nodiscard]] const study::LearnerStore& store() const { return *store_; }
  /// Whether what is done can be kept. Ask before every action.
  [[nodiscard]] bool can_write() const { return can_write_; }
  /// Why it cannot, in one sentence for the learner; empty while it can.
  [[nodiscard]] const QString& trouble() const { return trouble_; }

  /// Whether an action of the store was done: emits changed(), or says what went wrong.
  template <class T>
  bool take(const base::Result<T>& result) {
    if (!result) {
      tell_failure(result.error());
      return false;
    }
    emit changed();
    return true;
  }

  /// Why today's backup could not be made, in one sentence; empty where it was.
  [[nodiscard]] const QString& backup_trouble() const { return backup_trouble_; }
  /// Says that something of the store could not be read.
  void announce_unread(const base::Error& error);

  /// Characters and lists of the kanji database; nullptr where that cannot be read.
  [[nodiscard]] study::CharacterLists* lists() { return lists_.get(); }
  /// kanji.db, for another thread to open.
  [[nodiscard]] const std::filesystem::path& database_file() const { return database_file_; }
  [[nodiscard]] const kanji::KanjiDatabase* database() const { return database_ ? &*database_ : nullptr; }
  /// What today holds. A few milliseconds, however long the history is.
  [[nodiscard]] base::Result<study::DayPlan> plan();
  /// Notices a new study day; asked every minute.
  void look_at_the_day();
  /// Whether the file is still being checked and backed up behind the window.
  [[nodiscard]] bool keeps_up() const { return upkeep_.is_busy(); }
  /// Lists or tags have changed: what is learnt next is worked out anew, and changed() follows.
  void note_lists();

 signals:
  /// Something was done, undone or set; a new study day has begun.
  void changed();
  /// Another learner, or the same one opened anew. changed() follows.
  void profile_changed();
  /// For desk().tell().
  void said(nazori::ui::Feedback kind, QString sentence);

 private:
  bool open();
  void close();
  void tell_failure(const base::Error& error);
  [[nodiscard]] QString sentence_about(const base::Error& error) const;
  void take_upkeep(const study::UpkeepReport& report);
  void take_damage(const base::Error& error);

  std::filesystem::path folder_;
  std::filesystem::path database_file_;
  study::Clock clock_;
  QString profile_;
  std::optional<kanji::KanjiDatabase> database_;
  std::unique_ptr<study::CharacterLists> lists_;
  std::optional<study::LearnerStore> store_;
  bool can_write_ = false;
  QString trouble_;
  QString backup_trouble_;
  std::optional<std::vector<char32_t>> order_;  ///< of learning, while its settings hold
  study::Settings ordered_by_;
  study::Day day_{};
  QTimer day_timer_;
  StoreUpkeep upkeep_;
};

}  // namespace nazori::ui
