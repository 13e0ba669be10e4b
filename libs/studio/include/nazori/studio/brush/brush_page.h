// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "nazori/calligraphy/brush_writing.h"
#include "nazori/studio/brush/paper_view.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "nazori/widgets/page/page.h"

namespace nazori::ui {

class BrushActions;
class BrushToolsPanel;

/// The page for writing with a brush: a sheet of paper with ink that spreads, a model, and the tools beside
/// it.
class BrushPage final : public Page {
  Q_OBJECT
 public:
  explicit BrushPage(WindowParts& parts);
  ~BrushPage() override;

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

  /// Writes without asking for a name.
  void write(const QString& path);
  /// What is on the sheet; null before the page was first entered.
  [[nodiscard]] const calligraphy::BrushWriting* writing() const { return writing_.get(); }

 private:
  /// What the settings keep.
  struct Choice {
    std::string paper = "hanshi";
    std::string ink = "sumi";
    calligraphy::BrushChoice brush;
    int ruling = 1;
    ModelPlace place = ModelPlace::beneath;
    QString text;
    bool guess_pressure = true;
    bool left_hand = false;
    bool show_brush = true;
    bool show_tools = true;
  };

  void load(const QSettings& settings);
  void connect_actions();
  void connect_panel();
  void connect_paper();
  void start_writing();
  void show_frame(const calligraphy::BrushFrame& frame);
  void show_outcome(const calligraphy::Outcome& outcome);
  void wake();
  void tick();

  void choose_brush(const calligraphy::BrushChoice& brush);
  void choose_ink(const std::string& ink);
  void choose_paper(const std::string& paper);
  void choose_ruling(int characters);
  void choose_place(ModelPlace place);
  void show_place();
  void turn_model(int by);
  void set_handling();
  /// Shows the model, and asks for strokes that are not known yet.
  void request_model();
  void show_model();
  void request_advice();
  void show_advice(const std::vector<calligraphy::CharacterAdvice>& advice);
  void clear_advice();
  /// Where the models stand.
  [[nodiscard]] std::vector<calligraphy::RuledSquare> model_squares() const;
  [[nodiscard]] std::u32string model_text() const;
  [[nodiscard]] std::vector<char32_t> models() const;
  [[nodiscard]] QString model_words() const;
  [[nodiscard]] QString sheet_words() const;
  void ask_and_write(const QString& suffix);
  void show_tablet(const calligraphy::Outcome& outcome);

  BrushActions* actions_;
  QWidget* widget_;
  PaperView* paper_;
  BrushToolsPanel* panel_;
  Choice choice_;
  QString file_;
  bool entered_ = false;
  bool closes_when_saved_ = false;
  bool starts_ = false;      ///< the first ink is chosen, which is not announced
  bool warned_dry_ = false;  ///< said once for each time that the brush runs dry
  int part_ = 0;             ///< of a model text that needs several sheets
  std::map<char32_t, kanji::Character> characters_;
  QTimer timer_;
  QElapsedTimer since_tick_;
  EventLoopInbox inbox_;
  std::unique_ptr<calligraphy::BrushWriting> writing_;  // last: its thread ends first
};

}  // namespace nazori::ui
