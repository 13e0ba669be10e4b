// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/base/signal.h"
#include "nazori/calligraphy/advice.h"
#include "nazori/calligraphy/sheet_editor.h"

namespace nazori::calligraphy {

/// A part of the picture of a sheet.
struct PictureTile {
  static constexpr int kSide = 32;                                 ///< in pixels
  int column = 0, row = 0;                                         ///< of its first pixel
  std::array<std::uint8_t, std::size_t{3} * kSide * kSide> rgb{};  ///< row by row
};

/// What has changed since the last frame.
struct BrushFrame {
  std::vector<PictureTile> tiles;
  SheetState state;
  BrushShape brush;
};

/// What was asked for and is done, or has failed.
enum class Task : std::uint8_t {
  undo,
  redo,
  dry,
  new_sheet,
  ink,
  save,
  open,
  save_png,
  save_svg,
  save_pdf,
  carve,
  advise,
  hand
};
struct Outcome {
  Task task = Task::undo;
  Edit edit = Edit::none;                                   ///< what undo or redo did
  bool changed = true;                                      ///< false: there was nothing to do
  std::filesystem::path file = {};                          ///< that was read or written
  std::shared_ptr<const tablet::CarvedTablet> tablet = {};  ///< of Task::carve
  std::vector<CharacterAdvice> advice = {};                 ///< of Task::advise
  std::vector<brush::PenSample> hand = {};                  ///< of Task::hand
  bool failed = false;
  base::Error error = {};  ///< where it failed; nothing was changed then
};

/// Writes with a brush on a sheet that another thread keeps, so that the caller never waits for water that
/// spreads. Every call returns at once; frames and outcomes come as signals, in the order of the calls.
/// tick() lets the time of the sheet pass. Thread: the owner of the inbox.
class BrushWriting {
 public:
  /// If the other thread is late, at most so many steps of the sheet are made up for at once: ink spreads
  /// more slowly rather than later and later.
  static constexpr int kMostSteps = 4;

  /// @param inbox  outlives this. @param paper  of paint::paper_names(). @param cells  a side, as for
  /// paint::Sheet::create().
  explicit BrushWriting(base::Inbox& inbox, const std::string& paper = "hanshi",
                        int cells = paint::Sheet::kLargest);
  ~BrushWriting();
  BrushWriting(const BrushWriting&) = delete;
  BrushWriting& operator=(const BrushWriting&) = delete;

  /// The pen moved; its time is on a clock of the caller's choice.
  void move_pen(const brush::PenSample& sample);
  /// Ends a stroke, as where the pen left the window.
  void lift_pen();
  /// Time has passed. To be called about 60 times a second while is_busy() or the pen moves. A pen that rests
  /// on the paper goes on pressing.
  void tick(double seconds);

  void set_brush(const BrushChoice& choice);
  void set_handling(const brush::Handling& handling);
  void set_ink(const std::string& ink);
  void dip_in_ink();
  void dip_in_water();
  void wipe();
  void undo();
  void redo();
  void dry_now();
  void take_new_sheet(const std::string& paper);
  void save(const std::filesystem::path& path);
  void open(const std::filesystem::path& path);
  void save_png(const std::filesystem::path& path);
  /// As calligraphy::save_svg() and save_pdf(). @param title  of the document.
  void save_svg(const std::filesystem::path& path);
  void save_pdf(const std::filesystem::path& path, const std::string& title);
  void carve();
  /// Compares the sheet with its models, as calligraphy::advise().
  void advise(std::vector<SheetModel> models, const AdviceOptions& options);

  /// The movement that writes models with the present brush, as teacher_hand(). Nothing is written yet.
  void request_hand(std::vector<ModelStroke> strokes);

  /// The state of the last frame.
  [[nodiscard]] const SheetState& state() const { return state_; }
  /// Pixels a side of the picture.
  [[nodiscard]] int size() const { return cells_; }
  /// Whether something was asked for that is not answered yet.
  [[nodiscard]] bool is_waiting() const { return waiting_ > 0; }
  /// Whether time must go on: the sheet is wet, the pen is down, or something was asked for.
  [[nodiscard]] bool is_busy() const {
    return state_.is_wet || is_down_ || waiting_ > 0 || !samples_.empty();
  }

  base::Signal<const BrushFrame&> drawn;
  base::Signal<const Outcome&> done;

 private:
  struct Work;
  template <class Act>
  void request(Act act);
  template <class Act>
  void ask(Act act);
  void flush(int steps);

  int cells_;
  std::vector<brush::PenSample> samples_;
  brush::PenSample last_;
  bool is_down_ = false;
  bool rests_ = false;  ///< no sample came since the last tick
  double due_s_ = 0;    ///< time that the sheet has not had yet
  int waiting_ = 0;     ///< frames that were asked for and have not come
  SheetState state_;
  std::shared_ptr<Work> work_;   ///< used by the other thread alone
  base::Background background_;  // declared last, so that its thread ends first
};

}  // namespace nazori::calligraphy
