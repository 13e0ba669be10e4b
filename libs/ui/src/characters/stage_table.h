// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "nazori/practice/practice_stage.h"
#include "nazori/widgets/look/icons.h"

namespace nazori::ui {

class CharacterActions;
class WindowParts;
class StageView;
class WritingPanel;

/// What the view of a stage is made with. All of it outlives the view.
struct StageViewParts {
  WindowParts& window_parts;
  CharacterActions& actions;
  WritingPanel* writing_panel;
};

/// What the window has of a stage. Words are in the context "nazori::ui::CharacterActions".
struct StageRow {
  std::string_view id;  ///< practice::StageKind::id, and the object name of the action
  const char* name;     ///< with the letter of its menu entry: "&Memory"
  const char* purpose;
  const char* key;
  Icon drawing;
  /// @param stage  of this id.
  StageView* (*make_view)(practice::PracticeStage& stage, const StageViewParts& parts);
};

/// One row for each of practice::stage_kinds(), in its order, which is that of menu and toolbar.
[[nodiscard]] std::span<const StageRow> stage_rows();

}  // namespace nazori::ui
