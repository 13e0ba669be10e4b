// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/character_source.h"
#include "nazori/practice/learner_event.h"
#include "nazori/practice/store_upkeep.h"
#include "nazori/study/character_lists.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/learner_store.h"

namespace nazori::practice {

/// The current learner: the store of a profile, open for writing where that is possible. Where it is not
/// (another program has it open, the folder is read-only, the file is damaged or of a newer version) nothing
/// is written: can_write() is false, trouble() says why, and store() contains what can be read, or is empty.
/// Thread: the owner of the inbox.
class Learner {
 public:
  /// The paths of the study data and the dictionary, and the learner's clock.
  struct Place {
    std::filesystem::path folder;  ///< of all profiles; empty: study::profiles_folder()
    CharacterSource characters;    ///< for lists and their order
    study::Clock clock;            ///< empty: the computer's
  };

  /// Opens no profile: the store is an empty one in memory.
  Learner(base::Inbox& inbox, Place place);
  ~Learner();
  Learner(const Learner&) = delete;
  Learner& operator=(const Learner&) = delete;

  /// Opens a profile; a profile that does not exist becomes a new learner. Always emits profile_changed.
  /// @return whether it can be written. An invalid name changes nothing.
  bool switch_profile(const std::string& name);
  /// Opens the same profile again, after another program has closed it.
  bool open_again();
  /// Closes the file while `work` runs (renames a profile, for example), then opens the profile that it
  /// returns; empty: the same profile.
  void while_closed(const std::function<std::string()>& work);
  /// Closes the file, so that another thread can work on it; trouble() is of this kind until this or another
  /// profile is opened.
  void let_go(LearnerEvent::Kind why);

  /// Every learner, the current one among them, whether or not it has a file yet.
  [[nodiscard]] std::vector<std::string> profiles() const;
  /// Whether there is a folder of this name already.
  [[nodiscard]] bool has_profile(const std::string& name) const;
  /// Renames a learner, who may be the current one. @return the errors of study::rename_profile().
  base::Result<void> rename_profile(const std::string& from, const std::string& to);
  /// Removes a learner from the list, as study::remove_profile(). After the current one the first of the
  /// others is opened, or a new one. @return its folder; the errors of study::remove_profile().
  base::Result<std::filesystem::path> remove_profile(const std::string& name);

  [[nodiscard]] const std::string& profile() const { return profile_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// The learner.db of the profile.
  [[nodiscard]] std::filesystem::path file() const;

  /// Valid until a profile is opened or closed.
  [[nodiscard]] study::LearnerStore& store() { return *store_; }
  [[nodiscard]] const study::LearnerStore& store() const { return *store_; }
  /// Whether actions can be saved. Check it before every action.
  [[nodiscard]] bool can_write() const { return can_write_; }
  /// Why it cannot; nothing while it can, and before a profile is opened.
  [[nodiscard]] const std::optional<LearnerEvent>& trouble() const { return trouble_; }

  /// Handles the result of an action of the store: emits `changed`, or announces that the action was not
  /// saved.
  /// @return whether the action succeeded.
  template <class T>
  bool report(const base::Result<T>& result) {
    if (!result) {
      announce_unsaved(result.error());
      return false;
    }
    changed();
    return true;
  }

  /// Why today's backup could not be made; nothing if it was made.
  [[nodiscard]] const std::optional<LearnerEvent>& backup_trouble() const { return backup_trouble_; }
  /// Announces that something in the store could not be read.
  void announce_unread(const base::Error& error);

  /// Characters and lists of the kanji database; nullptr where that cannot be read.
  [[nodiscard]] study::CharacterLists* lists() { return lists_.get(); }
  /// For another thread to open.
  [[nodiscard]] const CharacterSource& source() const { return book_.source(); }
  [[nodiscard]] const kanji::KanjiDatabase* database() const { return book_.database(); }
  /// Own characters were kept, changed or removed: reads them again; `changed` follows.
  void renew_characters();
  /// Every character of the chosen lists, in learning order. Valid until something is done, set or renewed.
  /// @return the errors of study::CharacterLists::in_learning_order().
  [[nodiscard]] base::Result<std::span<const char32_t>> learning_order();
  /// The plan of today. Takes a few milliseconds, however long the history is.
  [[nodiscard]] base::Result<study::DayPlan> plan();
  /// Notices a new study day. To be called every minute.
  void tick();
  /// Whether another thread is still checking the file and backing it up.
  [[nodiscard]] bool keeps_up() const { return upkeep_.is_busy(); }
  /// Lists or tags have changed: computes the learning order again; `changed` follows.
  void renew_order();

  /// Something was done, undone or set; a new study day has begun.
  base::Signal<> changed;
  /// Another learner was opened, or the same one again. `changed` follows.
  base::Signal<> profile_changed;
  base::Signal<const LearnerEvent&> announced;

 private:
  bool open();
  void close();
  void close_for(LearnerEvent trouble);
  void announce_unsaved(const base::Error& error);
  [[nodiscard]] LearnerEvent event(LearnerEvent::Kind kind, base::Error error = {}) const;
  [[nodiscard]] LearnerEvent trouble_with(const base::Error& error) const;
  void handle_upkeep(const study::UpkeepReport& report);
  void handle_damage(const base::Error& error);

  std::filesystem::path folder_;
  study::Clock clock_;
  std::string profile_;
  CharacterBook book_;
  std::unique_ptr<study::CharacterLists> lists_;
  std::optional<study::LearnerStore> store_;
  bool can_write_ = false;
  std::optional<LearnerEvent> trouble_;
  std::optional<LearnerEvent> backup_trouble_;
  std::optional<std::vector<char32_t>> order_;  ///< learning order, while its settings are unchanged
  study::Settings ordered_by_;
  study::Day day_{};
  StoreUpkeep upkeep_;
};

}  // namespace nazori::practice
