// SPDX-License-Identifier: Apache-2.0
#include "actions.h"

#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QWidget>
#include <utility>

#include "icons.h"
#include "palette.h"

namespace nazori::ui {

Actions::Actions(QWidget* window) : QObject(window), window_(window) {
  const auto key = [](const char* text) { return QKeySequence(QString::fromLatin1(text)); };

  open = make("open", tr("&Open…"), tr("Open a height map (RAW, PNG) or a stroke order (.str)"),
              {key("Ctrl+O")});
  save = make("save", tr("&Save as…"), tr("Save the tablet as RAW, PNG or .str"), {key("Ctrl+S")});
  quit = make("quit", tr("&Quit"), tr("Close Nazori"), {key("Q"), key("Ctrl+Q")});

  find = make("find", tr("&Find a character"), tr("Go to the search box"), {key("Ctrl+F")});
  next_character = make("next_character", tr("&Next in the list"), tr("The next character of the list"),
                        {key("Ctrl+PgDown"), key("PgDown")});
  previous_character = make("previous_character", tr("&Previous in the list"),
                            tr("The character before in the list"), {key("Ctrl+PgUp"), key("PgUp")});
  back = make("back", tr("&Back"), tr("Back to the character before"), {key("Alt+Left")});
  forward = make("forward", tr("For&ward"), tr("Forward again"), {key("Alt+Right")});

  next_stroke = make("next_stroke", tr("&Next stroke"), tr("Show the next stroke alone; after the last, all"),
                     {key(".")});
  previous_stroke = make("previous_stroke", tr("&Previous stroke"),
                         tr("Show the stroke before alone; before the first, all"), {key(",")});
  all_strokes = make("all_strokes", tr("&All strokes"), tr("Show all strokes at once"), {key("0")});
  strokes = make("strokes", tr("&Strokes"), tr("Show or hide the strokes"), {key("S")}, true);
  numbers =
      make("numbers", tr("N&umbers"), tr("Show or hide the number at each stroke's start"), {key("N")}, true);
  arrows = make("arrows", tr("A&rrows"), tr("Show or hide the arrowheads"), {key("A")}, true);
  snap = make("snap", tr("S&nap"), tr("Strokes hold the stylus, while they are shown"), {key("F")}, true);
  clear_ink =
      make("clear_ink", tr("&Clear the ink"), tr("Wipe the tablet clean to write again"), {key("Del")});

  wood = make("wood", tr("&Wood"), tr("Pale wood"), {key("Ctrl+1")}, true);
  slate = make("slate", tr("S&late"), tr("Dark stone"), {key("Ctrl+2")}, true);
  classic = make("classic", tr("&Classic"), tr("The look of 2005"), {key("Ctrl+3")}, true);
  theme_desktop = make("theme_desktop", tr("Colours of the &desktop"), tr("Light or dark, as the desktop is"),
                       {key("Alt+1")}, true);
  theme_light = make("theme_light", tr("&Light colours"), tr("Always light"), {key("Alt+2")}, true);
  theme_dark = make("theme_dark", tr("Dar&k colours"), tr("Always dark"), {key("Alt+3")}, true);
  language_desktop = make("language_desktop", tr("Language of the des&ktop"),
                          tr("The language of the desktop"), {key("Ctrl+Alt+0")}, true);
  language_english = make("language_english", QStringLiteral("&English"), QStringLiteral("English"),
                          {key("Ctrl+Alt+E")}, true);
  language_japanese = make("language_japanese", QStringLiteral("日本語 (&J)"), QStringLiteral("日本語"),
                           {key("Ctrl+Alt+J")}, true);
  text_larger = make("text_larger", tr("&Larger text"), tr("Larger text"), {key("Ctrl++"), key("Ctrl+=")});
  text_smaller = make("text_smaller", tr("S&maller text"), tr("Smaller text"), {key("Ctrl+-")});
  text_usual = make("text_usual", tr("&Usual text size"), tr("Text as at first"), {key("Ctrl+0")});
  reduced_motion = make("reduced_motion", tr("&Reduced motion"),
                        tr("Nothing glides, everything is there at once"), {key("Ctrl+Alt+M")}, true);
  library = make("library", tr("&List of characters"), tr("Show or fold away the list"), {key("F2")}, true);
  information =
      make("information", tr("&Information"), tr("Show or fold away the information"), {key("F3")}, true);
  full_screen = make("full_screen", tr("&Full screen"), tr("Only the tablet"), {key("F11")}, true);

  turn_left = make("turn_left", tr("Turn left"), tr("Turn the tablet to the left"), {key("Ctrl+Left")});
  turn_right = make("turn_right", tr("Turn right"), tr("Turn the tablet to the right"), {key("Ctrl+Right")});
  tilt_up = make("tilt_up", tr("Tilt away"), tr("Look along the tablet"), {key("Ctrl+Up")});
  tilt_down = make("tilt_down", tr("Tilt back"), tr("Look from above"), {key("Ctrl+Down")});
  move_left = make("move_left", tr("Move left"), tr("Move the tablet to the left"), {key("Ctrl+Shift+Left")});
  move_right =
      make("move_right", tr("Move right"), tr("Move the tablet to the right"), {key("Ctrl+Shift+Right")});
  move_up = make("move_up", tr("Move up"), tr("Move the tablet up"), {key("Ctrl+Shift+Up")});
  move_down = make("move_down", tr("Move down"), tr("Move the tablet down"), {key("Ctrl+Shift+Down")});
  zoom_in = make("zoom_in", tr("Nearer"), tr("Nearer"), {key("+"), key("=")});
  zoom_out = make("zoom_out", tr("Farther"), tr("Farther"), {key("-")});
  reset_view =
      make("reset_view", tr("&Straight view"), tr("The whole tablet, straight from above"), {key("R")});

  keys = make("keys", tr("&Keys"), tr("All keys and what the mouse does"), {key("F1")});
  about = make("about", tr("&About Nazori"), tr("Version, licences and sources"), {key("Shift+F1")});

  for (const auto& one_of : {QList<QAction*>{wood, slate, classic},
                             {theme_desktop, theme_light, theme_dark},
                             {language_desktop, language_english, language_japanese}}) {
    auto* group = new QActionGroup(this);
    for (auto* action : one_of) group->addAction(action);
  }

  groups_ = {
      {tr("&File"), {open, save, nullptr, quit}},
      {tr("&Character"), {find, nullptr, next_character, previous_character, nullptr, back, forward}},
      {tr("&Strokes"),
       {next_stroke, previous_stroke, all_strokes, nullptr, strokes, numbers, arrows, snap, nullptr,
        clear_ink}},
      {tr("&Tablet"),
       {wood, slate, classic, nullptr, reset_view, zoom_in, zoom_out, nullptr, turn_left, turn_right, tilt_up,
        tilt_down, nullptr, move_left, move_right, move_up, move_down}},
      {tr("&View"),
       {library, information, full_screen, nullptr, text_larger, text_smaller, text_usual, nullptr,
        theme_desktop, theme_light, theme_dark, reduced_motion, nullptr, language_desktop, language_english,
        language_japanese}},
      {tr("&Help"), {keys, about}},
  };
}

QAction* Actions::make(const char* name, const QString& text, const QString& tip,
                       const QList<QKeySequence>& key_list, bool checkable) {
  auto* action = new QAction(text, this);
  action->setObjectName(QString::fromLatin1(name));
  action->setShortcuts(key_list);
  action->setCheckable(checkable);
  // On buttons without the letter for the menu: "&Strokes", "筆画(&S)".
  static const QRegularExpression mnemonic(QStringLiteral("\\(&.\\)|&"));
  action->setIconText(QString(text).remove(mnemonic).remove(QChar(0x2026)).trimmed());
  action->setStatusTip(tip);
  action->setToolTip(QStringLiteral("%1 (%2)").arg(tip, key_list.front().toString(QKeySequence::NativeText)));
  // A key must work with the menu bar hidden (full screen) too.
  window_->addAction(action);
  return action;
}

void Actions::add_menus(QMenuBar* bar) const {
  for (const auto& group : groups_) {
    auto* menu = bar->addMenu(group.title);
    menu->setToolTipsVisible(false);
    for (auto* action : group.actions)
      if (action != nullptr)
        menu->addAction(action);
      else
        menu->addSeparator();
  }
}

void Actions::draw_icons() {
  const Colours& c = current_colours();
  const std::pair<QAction*, Icon> drawings[] = {
      {previous_stroke, Icon::previous}, {next_stroke, Icon::next}, {strokes, Icon::strokes},
      {numbers, Icon::numbers},          {arrows, Icon::arrows},    {snap, Icon::snap},
      {clear_ink, Icon::erase},          {library, Icon::library},  {information, Icon::information},
      {reset_view, Icon::reset_view},    {back, Icon::back}};
  for (const auto& [action, drawing] : drawings) {
    action->setIcon(icon(drawing, c.ink, c.indigo));
    action->setIconVisibleInMenu(false);
  }
}

}  // namespace nazori::ui
