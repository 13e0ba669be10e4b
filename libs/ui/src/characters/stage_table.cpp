// SPDX-License-Identifier: Apache-2.0
#include "characters/stage_table.h"

#include <QCoreApplication>
#include <array>

#include "characters/stages/guided_view.h"
#include "characters/stages/memory_view.h"
#include "characters/stages/trace_view.h"
#include "characters/stages/watch_view.h"

namespace nazori::ui {

StageView* make_dictation_view(practice::PracticeStage& stage,
                               const StageViewParts& parts);  // dictation_view.cpp

namespace {

template <class Page, class Stage>
StageView* make(practice::PracticeStage& stage, const StageViewParts& parts) {
  return new Page(static_cast<Stage&>(stage), parts.window_parts, parts.actions);
}

StageView* make_memory(practice::PracticeStage& stage, const StageViewParts& parts) {
  return new MemoryView(static_cast<practice::MemoryStage&>(stage), parts.window_parts, parts.actions,
                        parts.writing_panel);
}

constexpr std::array kRows{
    StageRow{
        "watch", QT_TRANSLATE_NOOP("nazori::ui::CharacterActions", "&Watch"),
        QT_TRANSLATE_NOOP("nazori::ui::CharacterActions", "A brush writes the character stroke by stroke"),
        "F5", Icon::watch, make<WatchView, practice::WatchStage>},
    StageRow{"trace", QT_TRANSLATE_NOOP("nazori::ui::CharacterActions", "&Trace"),
             QT_TRANSLATE_NOOP("nazori::ui::CharacterActions", "Trace the grooves, with lines and numbers"),
             "F6", Icon::trace, make<TraceView, practice::TraceStage>},
    StageRow{"guided", QT_TRANSLATE_NOOP("nazori::ui::CharacterActions", "&Guided"),
             QT_TRANSLATE_NOOP(
                 "nazori::ui::CharacterActions",
                 "Write with only the groove or the starting points as a guide; strokes attract the stylus"),
             "F7", Icon::guided, make<GuidedView, practice::GuidedStage>},
    StageRow{"memory", QT_TRANSLATE_NOOP("nazori::ui::CharacterActions", "&Memory"),
             QT_TRANSLATE_NOOP("nazori::ui::CharacterActions",
                               "Write on a blank tablet and have your writing checked"),
             "F8", Icon::memory, make_memory},
    StageRow{"dictation", QT_TRANSLATE_NOOP("nazori::ui::CharacterActions", "Di&ctation"),
             QT_TRANSLATE_NOOP("nazori::ui::CharacterActions",
                               "Write a whole word that has the character, from its reading and meaning"),
             "F9", Icon::dictation, make_dictation_view},
};

}  // namespace

std::span<const StageRow> stage_rows() { return kRows; }

}  // namespace nazori::ui
