// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/author/character_files.h"
#include "nazori/author/collection.h"
#include "nazori/author/tracer.h"
#include "nazori/author/workbench.h"
#include "nazori/kanji/character.h"
#include "nazori/practice/felt_relief.h"
#include "nazori/widgets/page/page.h"

namespace nazori::ui {

class CharacterCanvas;
class WorkshopActions;
class WorkshopPanel;

/// The page for making characters and signs: draw and correct strokes, work on the relief by hand, find
/// strokes in a picture, check, save, and feel the result.
class WorkshopPage final : public Page {
  Q_OBJECT
 public:
  explicit WorkshopPage(WindowParts& parts);
  ~WorkshopPage() override;

  [[nodiscard]] QString title() const override;
  [[nodiscard]] QWidget* instead_of_tablet() const override;
  [[nodiscard]] ActionSet* actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

  void enter() override;
  void leave() override;
  void refresh_appearance() override;
  void save(QSettings& settings) const override;
  [[nodiscard]] bool may_close(bool quits) override;

  [[nodiscard]] bool opens(const QStringList& paths) const override;
  void open_files(const QStringList& paths) override;
  [[nodiscard]] bool has_files() const override { return true; }
  void ask_and_open() override;
  void ask_and_save() override;

  /// Writes without asking for a name, in the format of its ending, on another thread. Success or failure is
  /// announced.
  void write(const QString& path);
  /// Whether a file is being read or written.
  [[nodiscard]] bool is_busy_with_files() const { return files_.is_busy(); }
  /// Finds the strokes of a picture; they take the place of what is there.
  /// @param character  that it shows; 0: not known.
  void trace_picture(const QString& path, char32_t character);
  /// The same of a character of a font.
  void trace_font(const QString& family, char32_t character);
  /// Whether strokes are being looked for.
  [[nodiscard]] bool is_tracing() const;
  [[nodiscard]] const author::Workbench& bench() const { return *bench_; }

 private:
  void load(const QSettings& settings);
  void connect_actions();
  void connect_edits();
  void connect_canvas();
  void connect_panel();
  void connect_tracing();
  void show_bench();
  void choose_tool(author::Tool tool);
  void change_width(double factor);
  void change_depth(double factor);
  void choose_stamp();
  void choose_ending();
  void say_selection();
  /// Announces that an action found nothing to work on.
  void say_nothing_chosen();
  void show_check();
  void clear_check();
  void describe();
  void feel();
  /// Hands the relief to the tablet that the device feels; later edits follow.
  void begin_feeling();

  /// The file beside which unsaved work is kept.
  [[nodiscard]] std::filesystem::path unnamed_journal() const;
  /// Chooses the one with work to bring back that no other window writes, else an unused one.
  void choose_unnamed_journal();
  void begin(author::OwnCharacter character, const QString& sentence);
  void keep_journal();
  void recover();
  void open(const QString& path);
  bool may_replace();
  void take_opened(const QString& path, author::OpenedCharacter opened);
  /// Waits for what is being read and written. The window goes on being drawn; keys and pointer wait.
  void finish_files();
  /// Says so where the files of the present call take long.
  void say_if_slow(const QString& sentence);
  void say_not_saved(const QString& path, const base::Error& error);
  void ask_and_write(const QString& suffix);
  void trace(author::TraceRequest request, char32_t character);
  void ask_picture();
  void ask_font();
  void ask_plot();
  void ask_copy();
  [[nodiscard]] author::Collection collection() const;
  /// The code point under which the document is kept among the learner's characters.
  [[nodiscard]] std::optional<char32_t> kept_as() const;
  void keep();
  void keep_as(std::optional<char32_t> place, author::SameName same_name);
  void ask_same_name();
  /// Writes the document's own file where only the question of keep() changed it.
  void save_answer(std::size_t edits);
  /// The published character that has the name of this one.
  [[nodiscard]] std::optional<char32_t> published_namesake() const;
  /// Asks whether the form is used instead of the published one, where there is one. @return false: go back.
  [[nodiscard]] bool choose_use();
  void set_instead_of(std::optional<char32_t> published);
  void toggle_instead();
  void remove_kept();
  /// Opens a kept character to change it. @return false where it is not kept.
  bool open_kept(char32_t code_point);
  [[nodiscard]] QString proposed_name() const;
  [[nodiscard]] std::u32string named_character() const;

  WorkshopActions* actions_;
  QWidget* widget_;
  std::unique_ptr<author::Workbench> bench_;
  CharacterCanvas* canvas_;
  WorkshopPanel* panel_;
  QString file_;  ///< path of the document; empty where it has none
  bool entered_ = false;
  bool is_shown_ = false;
  bool is_checked_ = false;
  bool journal_failed_ = false;  ///< said once for each document
  std::map<char32_t, kanji::Character> characters_;
  std::optional<author::TraceRequest> waiting_;  ///< for the strokes of asked_
  char32_t asked_ = 0;       ///< the character whose strokes are waited for; without waiting_ it is copied
  char32_t traced_ = 0;      ///< the character that is looked for
  bool saves_file_ = false;  ///< see save_answer()
  int unnamed_ = 0;          ///< which of the files for work without a name is this window's
  std::size_t edits_ = 0;    ///< made, undone and redone since the window was opened
  QTimer slow_;              ///< runs out while files are being read or written
  QString slow_sentence_;
  std::size_t slow_call_ = 0;  ///< of `files_`, of which the sentence speaks
  author::Tracer tracer_;      // the threads are declared last, so that they end first
  author::CharacterFiles files_;
  practice::FeltRelief felt_;
};

}  // namespace nazori::ui
