// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QObject>
#include <QTimer>
#include <utility>

#include "nazori/practice/brush_session.h"
#include "nazori/practice/character_library.h"
#include "nazori/practice/character_practice.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/learner_exchange.h"
#include "nazori/practice/placement_run.h"
#include "nazori/practice/settings_change.h"
#include "nazori/practice/study_session.h"
#include "nazori/practice/tablet_recording.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/practice/writing_judge.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "nazori/widgets/settings/preferences.h"
#include "nazori/widgets/tablet/window_tablet.h"
#include "nazori/widgets/words/feedback.h"

namespace nazori::ui {

/// What all pages share: the window, the tablet with its stylus, the database, the workshop, the settings,
/// and the feedback line. Lives as long as the window. Thread: interface.
class WindowParts final : public QObject {
  Q_OBJECT
 public:
  /// Settings are read from `settings_file`. Characters are those of the learner's place.
  WindowParts(QWidget& window, QString settings_file, const practice::Learner::Place& learner);
  ~WindowParts() override;

  [[nodiscard]] QWidget& window() const { return window_; }
  [[nodiscard]] const QString& settings_file() const { return settings_file_; }
  [[nodiscard]] Preferences& preferences() { return preferences_; }
  /// Other threads post tasks for the thread of the window here.
  [[nodiscard]] base::Inbox& inbox() { return inbox_.inbox(); }
  [[nodiscard]] practice::CharacterLibrary& library() { return library_; }
  [[nodiscard]] practice::TabletWorkshop& workshop() { return workshop_; }
  [[nodiscard]] WindowTablet& tablet() { return tablet_; }
  [[nodiscard]] practice::CharacterPractice& practice() { return practice_; }
  [[nodiscard]] practice::WritingJudge& judge() { return judge_; }
  [[nodiscard]] practice::TabletRecording& recording() { return recording_; }
  [[nodiscard]] practice::Learner& learner() { return learner_; }
  [[nodiscard]] practice::LearnerExchange& exchange() { return exchange_; }
  [[nodiscard]] practice::SettingsChange& settings_change() { return settings_change_; }
  [[nodiscard]] practice::StudySession& session() { return session_; }
  /// Reviews with the brush.
  [[nodiscard]] practice::BrushSession& brush_session() { return brush_session_; }
  /// The test of what the learner can write already.
  [[nodiscard]] practice::PlacementRun& placement() { return placement_; }
  /// The back ends for haptic devices. The caller opens and owns them.
  [[nodiscard]] devices::TabletDevice::BackEnds take_back_ends() { return std::move(back_ends_); }
  void set_back_ends(devices::TabletDevice::BackEnds back_ends) { back_ends_ = std::move(back_ends); }

  /// Shows one sentence in the feedback line and sends it to the screen reader.
  void announce(Feedback kind, const QString& sentence);
  /// As announce(), for events that the learner did not cause. While the window is opening, the sentence
  /// waits: the first sentence of the page would replace it.
  void announce_when_open(Feedback kind, const QString& sentence);
  /// The page shows its first content: announces what was waiting.
  void note_opened();

 signals:
  void announced(nazori::ui::Feedback kind, QString sentence);
  /// As announce(), for the answer to a key: it is spoken even if the line already shows this sentence.
  void respond(nazori::ui::Feedback kind, QString sentence);
  /// The settings have changed. They are written within a second.
  void save_later();
  /// Gives the keyboard focus to the tablet or to what replaces it, as after a dialog.
  void focus_tablet();
  /// Closes panels that are open as drawers, after something was chosen in one.
  void close_drawers();
  /// Opens the left panel, even out of full screen.
  void open_left_panel();
  /// Goes to another page, by its id. An id that is not registered changes nothing.
  void go_to(QString page);
  /// From any page: goes to the page for the brush and begins, or goes on with, the reviews there.
  void review_with_brush();
  /// From any page: goes to the page for characters and shows this one.
  void show_character(char32_t code_point);
  /// The study settings that concern the window have changed: keys, layout, questions.
  void study_settings_changed();
  /// A character is shown, with its tablet.
  void character_shown(char32_t code_point);
  /// Own characters were kept, changed or removed.
  void own_characters_changed();
  /// Once: the window shows its first content.
  void opened();

 private:
  QWidget& window_;
  QString settings_file_;
  Preferences preferences_;
  EventLoopInbox inbox_;  // declared before the objects that post to it
  practice::CharacterLibrary library_;
  practice::TabletWorkshop workshop_;
  practice::WritingJudge judge_;
  WindowTablet tablet_;
  practice::TabletRecording recording_;
  practice::Learner learner_;
  practice::LearnerExchange exchange_{inbox(), learner_};
  practice::SettingsChange settings_change_{inbox(), learner_};
  QTimer day_timer_;
  base::SystemClock clock_;
  practice::StudySession session_{learner_, clock_};
  practice::BrushSession brush_session_{learner_, clock_};
  practice::PlacementRun placement_{learner_, tablet_, judge_, clock_};
  practice::CharacterPractice practice_;
  devices::TabletDevice::BackEnds back_ends_;
  bool is_open_ = false;
  QList<std::pair<Feedback, QString>> waiting_;
};

}  // namespace nazori::ui
