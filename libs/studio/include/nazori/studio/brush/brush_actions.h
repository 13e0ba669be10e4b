// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nazori/widgets/controls/action_set.h"

namespace nazori::ui {

/// The actions of the page for the brush.
class BrushActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit BrushActions(QWidget* window);

  QAction *dip_in_ink, *dip_in_water, *wipe, *thicker, *thinner, *next_hair, *next_ink;
  QAction *guess_pressure, *left_hand, *strengthen, *show_brush;
  QAction *undo, *redo, *dry, *new_sheet, *next_paper, *describe, *advice, *save_png, *carve, *tools;
  QAction *model_none, *model_beneath, *model_beside, *next_ruling, *next_font, *model_text, *next_model,
      *previous_model, *watch;
  QAction *by_key, *press, *next_start, *where, *harder, *softer;
  // Reviews with the brush.
  QAction *review, *go_on, *skip, *undo_rating, *end;
  std::array<QAction*, 4> rate;  ///< in the order of study::kRatings

  /// Gives keys and menu entries to what can be done in a session. @param advised  a rating is due.
  void show_session(bool is_running, bool advised);
};

}  // namespace nazori::ui
