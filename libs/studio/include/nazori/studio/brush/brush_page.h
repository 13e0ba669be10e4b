// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/author/font_models.h"
#include "nazori/calligraphy/brush_writing.h"
#include "nazori/practice/felt_sheet.h"
#include "nazori/practice/key_pen_ground.h"
#include "nazori/studio/brush/paper_view.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "nazori/widgets/page/page.h"

namespace nazori::ui {

class BrushActions;
class BrushReviewBar;
class BrushToolsPanel;
class KeyWriting;

/// The page for writing with a brush: a sheet of paper with ink that spreads, a model, and the tools beside
/// it.
class BrushPage final : public Page {
  Q_OBJECT
 public:
  /// @param cells  of the sheet, a side, as for paint::Sheet::create().
  explicit BrushPage(WindowParts& parts, int cells = paint::Sheet::kLargest);
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
  /// Whether models of a font are being made, or it is not known yet which fonts there are.
  [[nodiscard]] bool awaits_models() const { return !fonts_ || font_models_.is_busy(); }

 private:
  /// What the settings keep.
  struct Choice {
    std::string paper = "hanshi";
    std::string ink = "sumi";
    calligraphy::BrushChoice brush;
    int ruling = 1;
    ModelPlace place = ModelPlace::beneath;
    std::string font;  ///< brush font of the model; empty: printed lines
    QString text;
    bool guess_pressure = true;
    bool left_hand = false;
    bool strengthen = true;  ///< the force of the brush on a device
    bool show_brush = true;
    bool show_tools = true;
  };

  void load(const QSettings& settings);
  void connect_actions();
  void connect_panel();
  void connect_paper();
  void connect_keys();
  void connect_font_models();
  void connect_device();
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
  void choose_font(const std::string& family);
  void show_place();
  void turn_model(int by);
  void set_handling();
  /// Shows the model, and asks for strokes that are not known yet.
  void request_model();
  void show_model();
  void draw_model();
  /// Tells the keys that move the brush which strokes are shown.
  void show_strokes_to_keys(const std::vector<calligraphy::ModelStroke>& strokes);
  void request_font_models();
  void show_fonts(const std::vector<author::BrushFont>& fonts);
  void note_model(const author::MadeModel& made);
  void note_all_models();
  /// The font of the model if it is installed; empty: printed lines.
  [[nodiscard]] std::string font() const;
  /// The models whose strokes are known, each in its square.
  [[nodiscard]] std::vector<calligraphy::SheetModel> sheet_models() const;
  [[nodiscard]] std::vector<calligraphy::ModelStroke> model_strokes() const;  ///< of all of them, in order
  void request_advice();
  void show_advice(const std::vector<calligraphy::CharacterAdvice>& advice);
  void clear_advice();
  /// Where the models stand.
  [[nodiscard]] std::vector<calligraphy::RuledSquare> model_squares() const;
  [[nodiscard]] std::u32string model_text() const;
  [[nodiscard]] std::vector<char32_t> models() const;
  [[nodiscard]] QString model_words() const;
  [[nodiscard]] QString sheet_words() const;
  // The hand of a teacher (brush_teacher.cpp).
  /// Lets the brush write the models on an empty sheet, or stops that.
  void watch_teacher();
  void begin_hand(std::vector<brush::PenSample> hand);
  void move_hand(double seconds);
  void stop_teacher();
  void tell_written();
  /// Dips a brush that would run dry in the next stroke of the teacher.
  void dip_between_strokes();
  [[nodiscard]] bool is_watching() const { return awaits_hand_ || !hand_.empty() || felt_.is_leading(); }
  /// How a force-feedback device feels the brush, as chosen.
  void set_feeling();
  // Reviews with the brush (brush_reviews.cpp).
  void connect_reviews();
  void start_reviews();
  void show_reviews();
  /// Where the paper would be smaller than half of the window, it has the room of the tools for as long as
  /// reviews run, unless the learner opens them.
  void make_room();
  void fold_tools(bool folded);
  /// A new sheet for the character that is to be written.
  void take_character();
  void end_reviews();
  /// The next step of a session: advice, or the suggested rating.
  void go_on();
  /// Strokes were compared while a session waits for that.
  void judge(const calligraphy::CharacterAdvice& advice);
  void note_strokes(int strokes);
  [[nodiscard]] bool reviews() const;
  /// As chosen, in a session for one character.
  [[nodiscard]] int ruling() const { return reviews() ? 1 : choice_.ruling; }
  void ask_and_write(const QString& suffix);
  void show_tablet(const calligraphy::Outcome& outcome);

  int cells_;
  BrushActions* actions_;
  QWidget* widget_;
  PaperView* paper_;
  BrushToolsPanel* panel_;
  BrushReviewBar* bar_;
  practice::SheetGround ground_;  ///< the sheet for the keys that move the brush
  KeyWriting* key_writing_;
  Choice choice_;
  QString file_;
  bool entered_ = false;
  bool tools_folded_ = false;  ///< by reviews
  bool tools_wanted_ = false;  ///< the learner opened them during reviews
  bool closes_when_saved_ = false;
  bool starts_ = false;      ///< the first ink is chosen, which is not announced
  bool warned_dry_ = false;  ///< said once for each time that the brush runs dry
  bool is_quiet_ = false;    ///< the new sheet was not asked for by the learner, which is not announced
  int strokes_ = 0;          ///< on the sheet, in the last frame
  int part_ = 0;             ///< of a model text that needs several sheets
  std::map<char32_t, kanji::Character> characters_;
  std::optional<std::vector<author::BrushFont>> fonts_;       ///< that are installed, once this is known
  std::map<char32_t, std::vector<carving::Groove>> in_font_;  ///< models of font(); empty: it has none
  std::u32string asked_;                                      ///< models of the font that are being made
  std::u32string refused_;                                    ///< those of them that it does not have
  bool advises_later_ = false;                                ///< as soon as the models are made
  bool awaits_hand_ = false;                                  ///< the movement of the teacher is being made
  std::vector<brush::PenSample> hand_;                        ///< that is being shown; empty: none
  std::size_t hand_next_ = 0;
  double hand_begins_s_ = 0;  ///< on the clock of the pen
  double hand_time_s_ = 0;    ///< since then
  QTimer timer_;
  QElapsedTimer since_tick_;
  EventLoopInbox inbox_;
  author::FontModels font_models_{inbox_.inbox()};
  practice::FeltSheet felt_;
  std::unique_ptr<calligraphy::BrushWriting> writing_;  // last: its thread ends first
};

}  // namespace nazori::ui
