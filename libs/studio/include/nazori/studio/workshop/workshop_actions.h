// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nazori/widgets/controls/action_set.h"

namespace nazori::ui {

/// What one can do on the page for making characters, with its keys.
class WorkshopActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit WorkshopActions(QWidget* window);

  std::array<QAction*, 8> tools;  ///< in the order of author::Tool
  QAction *straight, *mirrored, *wider, *thinner, *deeper, *shallower, *next_stamp;
  QAction *undo, *redo, *step_back, *finish;
  QAction *next_stroke, *previous_stroke, *next_point, *previous_point;
  QAction *number, *place_number, *curve;
  QAction *earlier, *later, *reverse, *ending, *insert, *split, *join, *remove;
  QAction *start_empty, *copy, *from_picture, *from_font, *from_plot, *clear_relief;
  QAction *keep, *instead, *remove_kept;
  QAction *add_part, *remove_part;
  QAction *details, *check, *describe, *carve, *save_copy;
  QAction *zoom_in, *zoom_out, *zoom_whole, *strokes, *panel;
};

}  // namespace nazori::ui
