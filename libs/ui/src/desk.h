// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QObject>
#include <QTimer>
#include <utility>

#include "event_loop_inbox.h"
#include "feedback_line.h"
#include "nazori/practice/character_library.h"
#include "nazori/practice/character_practice.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/learner_exchange.h"
#include "nazori/practice/settings_change.h"
#include "nazori/practice/study_session.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/practice/writing_judge.h"
#include "preferences.h"
#include "session_recording.h"
#include "window_tablet.h"

namespace nazori::ui {

/// What all workplaces share: the window they stand in, the tablet with its stylus, the database, the
/// workshop, the settings, and the one line of words. Lives as long as the window. Thread: interface.
class Desk final : public QObject {
  Q_OBJECT
 public:
  /// Settings are read from `settings_file`.
  Desk(QWidget& window, const std::filesystem::path& database, QString settings_file,
       const practice::Learner::Place& learner);
  ~Desk() override;

  [[nodiscard]] QWidget& window() const { return window_; }
  [[nodiscard]] const QString& settings_file() const { return settings_file_; }
  [[nodiscard]] Preferences& preferences() { return preferences_; }
  /// Where tasks of other threads for that of the window arrive.
  [[nodiscard]] base::Inbox& inbox() { return inbox_.inbox(); }
  [[nodiscard]] practice::CharacterLibrary& library() { return library_; }
  [[nodiscard]] practice::TabletWorkshop& workshop() { return workshop_; }
  [[nodiscard]] WindowTablet& tablet() { return tablet_; }
  [[nodiscard]] practice::CharacterPractice& practice() { return practice_; }
  [[nodiscard]] practice::WritingJudge& judge() { return judge_; }
  [[nodiscard]] SessionRecording& recording() { return recording_; }
  [[nodiscard]] practice::Learner& learner() { return learner_; }
  [[nodiscard]] practice::LearnerExchange& exchange() { return exchange_; }
  [[nodiscard]] practice::SettingsChange& settings_change() { return settings_change_; }
  [[nodiscard]] practice::StudySession& session() { return session_; }
  /// The ways to haptic devices, for who opens them.
  [[nodiscard]] devices::TabletDevice::BackEnds take_back_ends() { return std::move(back_ends_); }
  void set_back_ends(devices::TabletDevice::BackEnds back_ends) { back_ends_ = std::move(back_ends); }

  /// One sentence in the feedback line, also to the screen reader.
  void say(Feedback kind, const QString& sentence);
  /// As say(), for an answer to a key: it is spoken also where the line says so already.
  void answer(Feedback kind, const QString& sentence) { emit answered(kind, sentence); }
  /// As say(), for what happened by itself: while the window is just opening it waits for the first words of
  /// the workplace, which would hide it.
  void tell(Feedback kind, const QString& sentence);
  /// The workplace shows what it begins with: what waited to be told is said now.
  void note_opened();
  /// The settings have changed: they are written within a second.
  void save_later() { emit save_wanted(); }
  /// The keyboard goes to the tablet (or the page), as after a dialog.
  void focus_tablet() { emit focus_wanted(); }
  /// Closes panels that lie open as drawers, after something was chosen in one.
  void close_drawers() { emit drawers_done(); }
  /// Opens the left panel, even out of full screen.
  void open_left_panel() { emit left_panel_wanted(); }

  /// To another workplace, by its id; one that is not registered changes nothing.
  void go_to(const QString& workplace) { emit workplace_wanted(workplace); }
  /// The settings of study have changed that are the window's: keys, layout, words.
  void note_study_settings() { emit study_settings_changed(); }
  /// From any workplace: puts a character on the desk of the workplace for characters.
  void show_character(char32_t code_point) { emit character_wanted(code_point); }

 signals:
  void said(nazori::ui::Feedback kind, QString sentence);
  void answered(nazori::ui::Feedback kind, QString sentence);
  void save_wanted();
  void focus_wanted();
  void drawers_done();
  void left_panel_wanted();
  void character_wanted(char32_t code_point);
  void workplace_wanted(QString workplace);
  void study_settings_changed();
  /// A character and its tablet are on the desk.
  void character_shown(char32_t code_point);
  /// Once: the window shows what it begins with.
  void opened();

 private:
  QWidget& window_;
  QString settings_file_;
  Preferences preferences_;
  EventLoopInbox inbox_;  // before all that answer through it
  practice::CharacterLibrary library_;
  practice::TabletWorkshop workshop_{inbox_.inbox()};
  practice::WritingJudge judge_;
  WindowTablet tablet_;
  SessionRecording recording_;
  practice::Learner learner_;
  practice::LearnerExchange exchange_{inbox(), learner_};
  practice::SettingsChange settings_change_{inbox(), learner_};
  QTimer day_timer_;
  base::SystemClock clock_;
  practice::StudySession session_{learner_, clock_};
  practice::CharacterPractice practice_;
  devices::TabletDevice::BackEnds back_ends_;
  bool settled_ = false;
  QList<std::pair<Feedback, QString>> news_;
};

}  // namespace nazori::ui
