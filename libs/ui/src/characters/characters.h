// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/practice/character_practice.h"
#include "nazori/practice/key_pen_ground.h"
#include "nazori/widgets/page/page.h"

namespace nazori::ui {

class CharacterActions;
class ConfusableView;
class DrawPanel;
class FileExchange;
class InformationPanel;
class KeyWriting;
class LibraryPanel;
class QuestionView;
class SessionActions;
class SessionAnswers;
class SessionBar;
class SessionPanel;
class SpokenReadings;
class StageView;
class StandingBar;
class WritingPanel;

/// The page for characters: the list on the left, all about the character that is shown on the right.
class Characters final : public Page {
  Q_OBJECT
 public:
  explicit Characters(WindowParts& parts);
  ~Characters() override;

  [[nodiscard]] QString title() const override;
  [[nodiscard]] Panel left() const override;
  [[nodiscard]] Panel right() const override;
  [[nodiscard]] QWidget* above_tablet() const override;
  [[nodiscard]] QWidget* under_tablet() const override;
  [[nodiscard]] practice::FoldedPanels folded() const override;
  [[nodiscard]] ActionSet* actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

  void enter() override;
  void leave() override;
  void refresh_appearance() override;
  void save(QSettings& settings) const override;

  [[nodiscard]] bool opens(const QStringList& paths) const override;
  void open_files(const QStringList& paths) override;
  [[nodiscard]] bool has_files() const override { return true; }
  void ask_and_open() override;
  void ask_and_save() override;

 private:
  /// A stage with its action and its view, in the order of the actions.
  struct StageEntry {
    QAction* action;
    QString tip;  ///< of the action while the stage can be chosen
    StageView* view;
  };

  void make_stage_views();
  void connect_actions();
  void connect_practice();
  void connect_work();
  void connect_session();
  void connect_study_actions();
  void connect_standing();
  void show_standing();
  /// Opens the dialog for a solid of the tablet that is shown.
  void ask_model();
  void show_character();
  void show_own();
  void show_stage();
  void show_hiding();
  void show_session();
  /// The parts of a session beside the tablet, which other pages show, too.
  void hide_session();
  void show_cross();
  void open_search();
  void open_drawing(bool open);
  void close_drawing();
  void show_available();
  [[nodiscard]] const StageEntry& entry_of(const practice::PracticeStage& stage) const;
  [[nodiscard]] const StageEntry& current() const;

  practice::CharacterPractice& practice_;
  CharacterActions* actions_;
  SessionActions* session_actions_;
  LibraryPanel* library_panel_;
  InformationPanel* information_panel_;
  StandingBar* standing_bar_;
  ConfusableView* confusable_view_;
  WritingPanel* writing_panel_;
  DrawPanel* draw_panel_;
  SessionPanel* session_panel_;
  SessionBar* session_bar_;
  QuestionView* question_view_;
  SessionAnswers* session_answers_;
  QWidget* above_tablet_;
  QWidget* left_side_;   ///< the list, or the panel for finding a character by drawing it
  QWidget* right_side_;  ///< the report on the writing above the information
  FileExchange* files_;
  SpokenReadings* spoken_readings_;
  practice::TabletGround key_ground_;
  KeyWriting* key_writing_;
  std::vector<StageEntry> stages_;
};

}  // namespace nazori::ui
