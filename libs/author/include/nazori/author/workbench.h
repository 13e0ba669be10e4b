// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "nazori/author/character_editor.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"

namespace nazori::author {

/// What the pen does.
enum class Tool : std::uint8_t {
  draw,    ///< draws a stroke
  place,   ///< places the points of a stroke, one click each
  edit,    ///< chooses and moves points and strokes
  groove,  ///< the relief tools
  raise,
  smooth,
  erase,
  stamp,
};
/// Names for settings, in the order of the enumeration.
inline constexpr std::array<std::string_view, 8> kToolNames{"draw",  "place",  "edit",  "groove",
                                                            "raise", "smooth", "erase", "stamp"};
inline constexpr std::array<std::string_view, 6> kStampNames{"dot",   "ring",   "bar",
                                                             "cross", "square", "triangle"};
inline constexpr std::array<std::string_view, 3> kEndingNames{"stop", "hook", "taper"};

/// How the tools are held.
struct BenchSettings {
  Tool tool = Tool::draw;
  double width = 7;  ///< of strokes and of relief tools [glyph units], kThinnestTool..kWidestTool
  double depth = 1;  ///< fraction of the tablet's depth, kShallowestTool..1
  kanji::StrokeEnding ending = kanji::StrokeEnding::stop;  ///< of a stroke whose points are placed
  StampShape stamp = StampShape::dot;
  bool straight = false;  ///< a stroke or a movement of a relief tool is one straight line
  bool mirrored = false;  ///< relief tools work at the other side of the vertical middle line, too
  friend bool operator==(const BenchSettings&, const BenchSettings&) = default;
};
inline constexpr double kThinnestTool = 0.5;
inline constexpr double kWidestTool = 40;
inline constexpr double kShallowestTool = 0.05;

/// What is chosen. A point or a number is chosen only together with its stroke.
struct Selection {
  std::optional<std::size_t> stroke;  ///< 0-based
  std::optional<std::size_t> point;   ///< 0-based, of that stroke
  bool number = false;                ///< the number of that stroke; then none of its points
  friend bool operator==(const Selection&, const Selection&) = default;
};

/// How an edit came about.
enum class EditWay : std::uint8_t { made, undone, redone };

/// A character under the pen: turns movements of a pen and keys into edits, and knows what is chosen. Where
/// an edit is refused nothing changes and refused() is emitted. Positions are in the glyph frame. Thread
/// rules: one thread at a time.
class Workbench {
 public:
  /// How near a click must be to choose a point or a line, and how near a placed point snaps [glyph units].
  static constexpr double kReach = 3;

  explicit Workbench(CharacterEditor editor) : editor_(std::move(editor)) {}

  [[nodiscard]] const CharacterEditor& editor() const { return editor_; }
  [[nodiscard]] const OwnCharacter& character() const { return editor_.character(); }
  /// Another document takes the place of this one. Nothing is chosen then.
  void take(CharacterEditor editor);

  [[nodiscard]] const BenchSettings& settings() const { return settings_; }
  /// Ends what is under way if the tool is another one. Numbers out of range are moved into it.
  void set_settings(BenchSettings settings);

  /// The pen moved. Where it comes down a movement begins, where it is lifted the movement ends. Positions
  /// that are not finite are ignored.
  void move_pen(const geometry::WrittenPoint<geometry::GlyphFrame>& pen, bool down);
  /// Gives up a movement that is under way; what it dragged stays where it is.
  void lose_pen();
  /// The movement of the pen that is under way, to be drawn; empty where it drags something.
  [[nodiscard]] const geometry::WrittenStroke<geometry::GlyphFrame>& movement() const { return movement_; }
  [[nodiscard]] bool is_down() const { return down_; }

  /// The points that were placed for the next stroke.
  [[nodiscard]] const geometry::Polyline<geometry::GlyphFrame>& placed() const { return placed_; }
  /// Makes a stroke of the placed points. @return whether there were at least two.
  bool finish_placing();
  /// Takes the last placed point back, or else undoes the last edit.
  void step_back();

  /// Adds a point to the line at a double click. @return whether a line was in reach.
  bool insert_point_at(geometry::GlyphPoint at);

  [[nodiscard]] const Selection& selection() const { return selection_; }
  /// What is not there is not chosen.
  void select(Selection selection);
  /// The next or previous stroke, after the last one the first. @param by  1 or -1.
  void select_next_stroke(int by);
  /// The next or previous point of the chosen stroke, of none the first point of the first stroke.
  void select_next_point(int by);

  /// Chooses the number of the chosen stroke, of none that of the first one. @return whether there are
  /// strokes.
  bool select_number();

  /// The pen of the keyboard.
  [[nodiscard]] geometry::GlyphPoint cursor() const { return cursor_; }
  /// With the tool edit moves what is chosen; else, or with nothing chosen, the cursor, and with the cursor
  /// the pen that is down. It stays in the box.
  void move_by_key(geometry::GlyphPoint by);
  /// Lowers or lifts the pen at the cursor; the tools place, edit and stamp click there.
  void press_at_cursor(double time_s);

  // Edits of the chosen stroke. @return false where nothing is chosen that they could change.
  /// Adds a point halfway between the chosen point and the next one; at the end, before the last one.
  bool insert_point();
  /// Deletes the chosen point or stroke. A chosen number is placed by the program again.
  bool remove();
  bool reverse();
  /// Splits at the chosen point.
  bool split();
  /// Joins the next stroke to its end.
  bool join();
  /// Moves it in the writing order. @param by  1 or -1.
  bool reorder(int by);
  bool set_ending(kanji::StrokeEnding ending);
  /// Of the chosen point, else of the whole stroke.
  bool scale_width(double factor);
  bool scale_depth(double factor);
  /// Changes the groove at a point of the chosen stroke. Values out of range are moved into it.
  /// @param half_width  [glyph units], 0..carving::kWidestHalf. @param goes_on  the same drag as the edit
  /// before: both are undone at once, and edited() is emitted only for the beginning.
  bool set_half_width(std::size_t point, double half_width, bool goes_on = false);
  /// @param depth  fraction of the tablet's depth, 0..1.
  bool set_depth(std::size_t point, double depth, bool goes_on = false);
  /// The program places the number of the chosen stroke. @return false also where it does so already.
  bool place_number();

  void set_facts(const Facts& facts);
  void add_strokes(const std::vector<OwnStroke>& strokes);
  void load_relief(const surface::HeightMap& map);
  void clear_relief();
  void undo();
  void redo();

  [[nodiscard]] base::Result<void> autosave_to(const std::filesystem::path& path);
  [[nodiscard]] base::Result<void> save(const std::filesystem::path& path);
  /// As CharacterEditor::begin_save() and end_save(): another thread writes the document.
  [[nodiscard]] SavePoint begin_save() { return editor_.begin_save(); }
  void end_save(SavePoint point);
  void close_journal() { editor_.close_journal(); }

  /// Samples of the editor's map have changed.
  base::Signal<const carving::GridBox&> relief_changed;
  /// Strokes, what is chosen, what is placed or the state have changed.
  base::Signal<> changed;
  /// Only the movement under way or the cursor has changed.
  base::Signal<> pen_moved;
  /// An edit was made, undone or redone. EditKind::none: there was nothing to undo or redo.
  base::Signal<EditKind, EditWay> edited;
  base::Signal<const base::Error&> refused;

 private:
  bool apply(CharacterEditor::Touched touched);
  void begin(const geometry::WrittenPoint<geometry::GlyphFrame>& pen);
  void drag(geometry::GlyphPoint to);
  void end();
  void click(geometry::GlyphPoint at);
  void choose_at(geometry::GlyphPoint at);
  /// The point of a stroke within reach, else `at`.
  [[nodiscard]] geometry::GlyphPoint snapped(geometry::GlyphPoint at) const;
  void keep_selection_valid();
  [[nodiscard]] bool uses_movement() const;
  /// The stroke whose number is written at a place.
  [[nodiscard]] std::optional<std::size_t> number_at(geometry::GlyphPoint at) const;
  /// Where the number of a stroke is written, whoever placed it.
  [[nodiscard]] geometry::GlyphPoint number_place(std::size_t stroke) const;
  /// Moves the number of the chosen stroke. @return whether it is elsewhere now.
  bool move_number(geometry::GlyphPoint to, bool goes_on);
  /// What a drag of the chosen thing changes.
  [[nodiscard]] EditKind kind_of_move() const;

  CharacterEditor editor_;
  BenchSettings settings_;
  Selection selection_;
  geometry::WrittenStroke<geometry::GlyphFrame> movement_;
  geometry::Polyline<geometry::GlyphFrame> placed_;
  geometry::GlyphPoint cursor_{geometry::kGlyphSide / 2, geometry::kGlyphSide / 2};
  geometry::GlyphPoint dragged_to_;
  geometry::GlyphPoint number_grip_;  ///< from the pen to the number that it drags
  bool down_ = false;
  bool drags_ = false;  ///< a point, a number or a stroke
  bool has_dragged_ = false;
};

}  // namespace nazori::author
