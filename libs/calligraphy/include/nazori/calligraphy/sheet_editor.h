// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/brush/held_brush.h"
#include "nazori/calligraphy/brush_stroke.h"
#include "nazori/calligraphy/tools.h"
#include "nazori/paint/history.h"
#include "nazori/paint/sheet.h"
#include "nazori/paint/sheet_picture.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::calligraphy {

/// What can be undone.
enum class Edit : std::uint8_t {
  none,       ///< there is nothing to undo or redo
  stroke,     ///< a stroke of the brush
  drying,     ///< the sheet was dried at once
  new_sheet,  ///< another sheet took the place of this one
};

/// What is on the paper and in the brush, in numbers.
struct SheetState {
  int strokes = 0;  ///< on this sheet, also those that its file had
  Edit undoes = Edit::none;
  Edit redoes = Edit::none;
  bool is_wet = false;
  bool is_writing = false;  ///< the brush is on the paper
  bool is_saved = true;     ///< a file has this sheet, or there is nothing on it
  std::string paper;
  std::string ink;  ///< of kInks
  BrushChoice brush;
  double fullness = 0;  ///< of the brush, 0..1
  double strength = 0;  ///< of the ink in it; 1 is undiluted
  friend bool operator==(const SheetState&, const SheetState&) = default;
};

/// The shape of the hair, for drawing it.
struct BrushShape {
  geometry::PaperPoint pen;                  ///< where the pen was
  std::vector<brush::TuftSection> sections;  ///< from the root to the tip
  double shaft_m = 0;                        ///< diameter of the shaft
  bool touches = false;
};

/// A sheet of paper with a brush in the hand: writes, undoes, opens and saves. Everything happens at once and
/// in the order of the calls, so the same calls give the same bytes. Thread rules: one thread at a time.
class SheetEditor {
 public:
  /// Sheets before this one that undo can bring back; each takes up to 42 MiB.
  static constexpr std::size_t kEarlierSheets = 2;

  /// An empty sheet and a brush full of sumi. @param cells  as for paint::Sheet::create().
  /// @return the errors of paint::find_paper() and paint::Sheet::create().
  [[nodiscard]] static base::Result<SheetEditor> create(std::string_view paper = "hanshi",
                                                        int cells = paint::Sheet::kLargest);
  SheetEditor(SheetEditor&&) noexcept = default;
  SheetEditor& operator=(SheetEditor&&) noexcept = default;

  /// Another brush with the same ink in it, equally full. Lifts the brush.
  void set_brush(const BrushChoice& choice);
  [[nodiscard]] const BrushChoice& brush_choice() const { return choice_; }
  /// A clean brush with this ink. @param ink  of kInks.
  /// @return Errc::not_found for another name; Errc::in_use where no slot of the sheet is dry.
  [[nodiscard]] base::Result<void> set_ink(std::string_view ink);
  void dip_in_ink();
  void dip_in_water();
  void wipe();
  /// How a pen becomes a brush.
  void set_handling(const brush::Handling& handling);

  /// The pen moved. Where it comes down a stroke begins, where it is lifted the stroke ends. Samples with a
  /// number that is not finite are ignored. Times that do not grow are moved on.
  void move_pen(brush::PenSample sample);
  /// Ends a stroke that is under way, where the pen is.
  void lift_pen();
  /// Lets paint::Sheet::kStep_s pass.
  void step();

  /// Undoes the last edit. A stroke that is under way is ended first. @return what was undone.
  Edit undo();
  Edit redo();
  /// @return whether the sheet was wet.
  bool dry_now();
  /// Takes an empty sheet. undo() brings the old one back.
  /// @return the errors of paint::find_paper(); then nothing has changed.
  [[nodiscard]] base::Result<void> take_new_sheet(std::string_view paper);

  /// The bytes of a file, as paint::to_bytes(), with the strokes.
  [[nodiscard]] std::vector<std::uint8_t> bytes() const;
  [[nodiscard]] base::Result<void> save(const std::filesystem::path& path);
  /// Takes the sheet of a file, with its strokes. undo() brings the old one back, and none of them alone.
  /// @return the errors of paint::load_sheet(), Errc::parse for strokes that no brush writes; then nothing
  /// has changed.
  [[nodiscard]] base::Result<void> open(const std::filesystem::path& path);
  /// The picture of the sheet as a PNG, written beside and renamed.
  [[nodiscard]] base::Result<void> save_png(const std::filesystem::path& path);
  /// The sheet as a tablet: ink becomes grooves.
  [[nodiscard]] base::Result<std::shared_ptr<const tablet::CarvedTablet>> carve() const;

  [[nodiscard]] const paint::Sheet& sheet() const { return board_.sheet; }
  [[nodiscard]] const paint::InkLoad& load() const { return load_; }
  /// The strokes on the sheet in their order. Files of older versions have none.
  [[nodiscard]] const std::vector<BrushStroke>& written() const { return board_.written; }
  [[nodiscard]] SheetState state() const;
  [[nodiscard]] BrushShape brush_shape() const;
  /// The picture, up to date. @param changed  gets the numbers of the tiles that changed since the last call.
  const surface::ColourPicture& picture(std::vector<int>& changed);

 private:
  /// A state of a sheet between edits.
  struct Mark {
    Edit edit = Edit::none;      ///< that leads from this state to the next one
    int strokes = 0;             ///< at this state
    std::uint64_t revision = 0;  ///< at this state
    std::string ink;             ///< at this state
  };
  struct Board {
    /// @param number  of its revision, which counts as saved.
    Board(paint::Sheet of, std::uint64_t number) : sheet(std::move(of)), revision(number), saved(number) {}

    paint::Sheet sheet;
    paint::History history;
    std::deque<Mark> past, future;
    int strokes = 0;
    std::vector<BrushStroke> written, undone;  ///< `undone`: the one that redo brings back is the last
    std::uint64_t revision = 0;                ///< equal only for equal sheets
    std::uint64_t saved = 0;                   ///< the revision that a file has
    paint::InkLoad load;                       ///< of the brush when it left this sheet
    std::string ink;                           ///< likewise
  };

  SheetEditor(Board board, const BrushChoice& choice);
  void remember(Edit edit);
  /// Takes another sheet; undo() brings the present one back.
  void put(Board board);
  void swap_board(std::vector<Board>& from, std::vector<Board>& to);
  /// Keeps what is current as the state that `edit` leads to or from, and goes to another state.
  Edit travel(std::deque<Mark>& from, std::deque<Mark>& to);
  void begin_stroke();
  void suit_ink_to_paper(std::string_view before);
  void fit_load();
  void find_ink();

  Board board_;
  std::vector<Board> earlier_, later_;
  std::uint64_t revisions_ = 0;
  paint::SheetPicture picture_;

  BrushChoice choice_;
  brush::TuftForm form_;
  brush::Handling handling_;
  brush::HeldBrush brush_;
  paint::InkLoad load_;
  std::string ink_;
  int slot_ = 0;  ///< of the ink; below 0: clear water
};

}  // namespace nazori::calligraphy
