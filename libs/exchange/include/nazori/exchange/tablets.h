// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "nazori/devices/simulated_hand.h"
#include "nazori/exchange/document.h"
#include "nazori/kanji/character.h"
#include "nazori/recording/sample_statistics.h"

namespace nazori::exchange {

/// The files that a character was carved into.
struct CarvedFiles {
  std::string map;                     ///< height map
  std::optional<std::string> strokes;  ///< .str
  int size = 0;                        ///< samples a side of the map
};
/// docs/schemas/tablets.json, carve: one of its items.
[[nodiscard]] Value to_json(const kanji::Character& character, const CarvedFiles& files);

/// A picture that was painted (docs/schemas/tablets.json, render: one of its items).
struct PaintedPicture {
  std::string subject;  ///< a character, or the name of a file
  std::string file;
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
};
[[nodiscard]] Value to_json(const PaintedPicture& picture);

/// A solid model that was written (docs/schemas/tablets.json, model).
struct SolidModel {
  std::string subject;  ///< a character, a word, an expression or the name of a file
  std::string file;
  double width_mm = 0;      ///< left to right
  double height_mm = 0;     ///< bottom to top
  double thickness_mm = 0;  ///< from the table to the highest point
  double volume_mm3 = 0;
  std::size_t triangles = 0;
  double error_mm = 0;              ///< greatest distance from the relief
  std::vector<int> without_number;  ///< strokes (from 1) for whose number there was no room
};
[[nodiscard]] Value to_json(const SolidModel& model);

/// A file for a mill, a laser, swell paper or an embosser (docs/schemas/tablets.json, model).
struct MadeTouchFile {
  std::string subject;  ///< a character, a word or the name of a file
  std::string file;
  std::string kind;     ///< mill, laser, swell-paper or embosser
  double width_mm = 0;  ///< of the plate or the paper
  double height_mm = 0;
  int pages = 1;                    ///< of paper
  std::vector<int> without_number;  ///< strokes (from 1) for whose number there was no room
  double closest_mm = 0;            ///< swell paper: between lines side by side; 0: none or not known
  /// What a mill does; of other kinds not written.
  struct Milling {
    int passes = 0;
    double deepest_mm = 0;
    double cut_length_mm = 0;
    double minutes = 0;
  };
  std::optional<Milling> milling;
};
[[nodiscard]] Value to_json(const MadeTouchFile& made);

/// A worksheet that was written (docs/schemas/tablets.json, worksheet).
struct PrintedSheet {
  std::string file;
  std::string layout;               ///< practice, quiz, cards or manuscript
  std::size_t character_count = 0;  ///< 0: manuscript paper
  std::size_t bytes = 0;
};
[[nodiscard]] Value to_json(const PrintedSheet& sheet);

/// A sheet that a brush wrote on (docs/schemas/tablets.json, paint).
struct PaintedSheet {
  std::string script;  ///< file
  std::string file;
  std::string paper;
  std::string brush;
  int size = 0;             ///< pixels a side
  std::size_t samples = 0;  ///< moments of the script
  double seconds = 0;       ///< from the first to the last of them
  double painted_mm2 = 0;   ///< area with pigment, that of the model too
  double ink_left = 0;      ///< in the brush, 0..1
  int frames = 0;           ///< pictures in the folder
  std::string model_font;   ///< family of the font that the model is from; empty: printed lines, or no model
};
[[nodiscard]] Value to_json(const PaintedSheet& sheet);

/// The distance of the tip from the lines, over all strokes that a hand followed.
struct HandTracking {
  double rms_m = 0;
  double max_m = 0;
};
[[nodiscard]] HandTracking tracking_of(const devices::HandReport& hand);
/// The scheduling of the hand's clock: "SCHED_FIFO" or "SCHED_OTHER".
[[nodiscard]] std::string_view scheduling_of(const devices::HandReport& hand);

/// How a simulated hand followed a tablet.
struct FollowedBy {
  std::string device;
  double rate_hz = 0;
  bool snapping = false;
  std::string picture;        ///< file
  bool in_real_time = false;  ///< the clock ran in real time: how punctual it was is part of the document
};
/// docs/schemas/tablets.json, demo: one of its items.
[[nodiscard]] Value to_json(const kanji::Character& character, const FollowedBy& by,
                            const devices::HandReport& hand, const recording::SampleStatistics& samples);

/// How a recorded motion felt (docs/schemas/tablets.json, feel).
struct FeltMotion {
  std::string subject;
  std::string mode;
  std::string device;
  double rate_hz = 0;
  std::string input;   ///< file
  std::string output;  ///< file
  recording::SampleStatistics samples;
  haptics::ServoTiming timing;
  double took_s = 0;        ///< for computing
  double tip_radius_m = 0;  ///< of the ball at the tip; 0: a point
  /// Ratio of the hand's time to the computing time.
  [[nodiscard]] double real_time_factor() const;
};
[[nodiscard]] Value to_json(const FeltMotion& felt);

}  // namespace nazori::exchange
