// SPDX-License-Identifier: Apache-2.0
// Menus, keys and tools of the page for functions, which learners know by heart.
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "functions_window.h"

namespace nazori::ui {
namespace {

using PlotMenus = test::FunctionsWindow;

TEST_F(PlotMenus, EveryMenuHasItsEntriesInTheirOrderWithTheirKeys) {
  const QStringList wanted = QString::fromUtf8(R"(
[Plot]
plot_expression Ctrl+L
plot_points Ctrl+T
-
plot_zoom_in Z
plot_zoom_out Shift+Z
plot_pan_left Shift+Left
plot_pan_right Shift+Right
plot_pan_up Shift+Up
plot_pan_down Shift+Down
plot_reset_window W
-
plot_export_raw Ctrl+Alt+R
plot_export_png Ctrl+Alt+P
plot_export_print Ctrl+Alt+T
plot_export_sound Ctrl+Alt+W
-
plot_make_model Ctrl+Shift+F
[Trace]
trace_on Right
trace_back Left
trace_tick_on Ctrl+Right
trace_tick_back Ctrl+Left
trace_start Home
trace_end End
trace_branch_on Up
trace_branch_back Down
trace_point_on N
trace_point_back Shift+N
-
trace_coordinates C
trace_slope D
trace_summary S
trace_speech Shift+S
-
trace_beacon B
trace_next_beacon G
-
curve_on .
curve_back ,
all_curves 0
*curve_alone O
curve_next_alone Shift+O
*plot_snap F
plot_clear_ink Del
[Sound]
sound_hear H
sound_stop Esc
sound_reference Y
-
sound_faster +
sound_slower -
-
sound_louder V
sound_quieter Shift+V
*sound_mute M
[Tablet]
*wood Ctrl+1
*slate Ctrl+2
*classic Ctrl+3
-
reset_view R
zoom_in =
zoom_out
-
turn_left
turn_right
tilt_up Ctrl+Up
tilt_down Ctrl+Down
-
move_left Ctrl+Shift+Left
move_right Ctrl+Shift+Right
move_up Ctrl+Shift+Up
move_down Ctrl+Shift+Down
-
*groove_sound Ctrl+M
sound_louder Ctrl+Shift+M
sound_softer Alt+Shift+M
*slope_help Ctrl+Shift+L
[View]
*left_panel F2
*right_panel F3
menus F10
*full_screen F11
-
text_larger Ctrl++ Ctrl+=
text_smaller Ctrl+-
text_usual Ctrl+0
-
*theme_desktop Ctrl+Alt+1
*theme_light Ctrl+Alt+2
*theme_dark Ctrl+Alt+3
*reduced_motion Ctrl+Alt+M
*left_handed Ctrl+Alt+F
-
*language_desktop Ctrl+Alt+0
*language_english Ctrl+Alt+E
*language_japanese Ctrl+Alt+J
[Go]
*go_characters Alt+1
*go_functions Alt+2
[Help]
keys F1
about Shift+F1)")
                                 .trimmed()
                                 .split(u'\n');
  QStringList all;
  for (const auto* head : find<QMenuBar>("menu_bar")->actions()) {
    const QString title = without_mnemonic(head->text());
    if (title == QStringLiteral("File") || title == QStringLiteral("Learner")) continue;
    all.append(u'[' + title + u']');
    for (const auto* entry : head->menu()->actions()) {
      if (entry->isSeparator()) {
        all.append(QStringLiteral("-"));
        continue;
      }
      QStringList keys;
      for (const auto& key : entry->shortcuts()) keys.append(key.toString(QKeySequence::PortableText));
      const QString name = (entry->isCheckable() ? QStringLiteral("*") : QString()) + entry->objectName();
      all.append(keys.isEmpty() ? name : name + u' ' + keys.join(u' '));
    }
  }
  for (qsizetype i = 0; i < std::min(all.size(), wanted.size()); ++i) EXPECT_EQ(all[i], wanted[i]) << i;
  EXPECT_EQ(all.size(), wanted.size());
}

TEST_F(PlotMenus, TheToolsStandInTheOrderOfTheirUse) {
  QStringList tools;
  for (auto* entry : find<QToolBar>("tool_bar")->actions())
    if (!entry->objectName().isEmpty()) tools.append(entry->objectName());
  EXPECT_EQ(tools.join(u' '),
            QStringLiteral("left_panel sound_hear sound_mute curve_back curve_on plot_snap plot_zoom_in "
                           "plot_zoom_out plot_reset_window plot_clear_ink reset_view right_panel"));
}

}  // namespace
}  // namespace nazori::ui
