// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "nazori/practice/character_library.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/study/lesson.h"
#include "workplace.h"

namespace nazori::ui {

class CharacterActions;
class CharacterStage;
class DrawPanel;
class FileExchange;
class GuidedStage;
class InformationPanel;
class LibraryPanel;
class MemoryStage;
class SessionActions;
class SessionBar;
class SessionPanel;
class WritingPanel;

/// The workplace for characters: those to choose from on the left, all about the one on the desk on the
/// right.
class Characters final : public Workplace {
  Q_OBJECT
 public:
  explicit Characters(Desk& desk);
  ~Characters() override;

  [[nodiscard]] QString id() const override;
  [[nodiscard]] QString name() const override;
  [[nodiscard]] QString purpose() const override;
  [[nodiscard]] Icon drawing() const override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] Panel left() const override;
  [[nodiscard]] Panel right() const override;
  [[nodiscard]] QWidget* under_tablet() const override;
  [[nodiscard]] ActionSet* actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  [[nodiscard]] QString tablet_description() const override;

  void enter() override;
  void leave() override;
  void take_appearance() override;
  void save(QSettings& settings) const override;

  [[nodiscard]] bool opens(const QStringList& paths) const override;
  void open_files(const QStringList& paths) override;
  [[nodiscard]] bool has_files() const override { return true; }
  void ask_and_open() override;
  void ask_and_save() override;

 private:
  void connect_actions();
  void connect_work();
  void choose(char32_t code_point, bool remember);
  void travel(int step);
  void take_sheet(const std::shared_ptr<const practice::CharacterSheet>& sheet);
  void take_tablet(char32_t code_point, const practice::Tablet& tablet);
  void take_own(const practice::OwnTablet& loaded);
  void enter_stage(CharacterStage* stage);
  void begin_lesson();
  void show_hiding();
  void open_drawing(bool open);
  void close_drawing();
  void connect_session();
  void connect_study_actions();
  void show_session();
  [[nodiscard]] CharacterStage* stage_for(study::Stage stage) const;
  [[nodiscard]] char32_t studied_character() const;

  CharacterActions* actions_;
  SessionActions* session_actions_;
  LibraryPanel* library_panel_;
  InformationPanel* information_panel_;
  WritingPanel* writing_panel_;
  DrawPanel* draw_panel_;
  SessionPanel* session_panel_;
  SessionBar* session_bar_;
  QWidget* left_side_;   ///< the list, or what is drawn to find
  QWidget* right_side_;  ///< what is said of the writing over the information
  FileExchange* files_;
  /// In the order of their actions.
  struct StageEntry {
    QString id;
    QAction* action;
    CharacterStage* stage;
    study::Stage name;
  };
  std::vector<StageEntry> stages_;
  MemoryStage* memory_;
  GuidedStage* guided_;
  CharacterStage* stage_ = nullptr;

  bool entered_ = false;
  bool returns_ = false;  ///< while the page is entered again
  std::shared_ptr<const practice::CharacterSheet>
      sheet_;             ///< of the character on the desk; null: a tablet of one's own
  char32_t awaited_ = 0;  ///< whose sheet was asked for last, 0 for none
  std::shared_ptr<const practice::CharacterSheet> coming_;  ///< of the one being carved
  practice::Tablet tablet_;     ///< what is on the desk here, kept while another workplace has the tablet
  practice::OwnTablet own_;     ///< loaded from files; empty while a character is on the desk
  std::vector<char32_t> path_;  ///< characters visited
  std::size_t step_ = 0;        ///< where in `path_` we are
  bool searching_ = false;      ///< the list stands in the session's place
};

}  // namespace nazori::ui
