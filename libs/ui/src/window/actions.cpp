// SPDX-License-Identifier: Apache-2.0
#include "window/actions.h"

#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>

#include "nazori/widgets/controls/menu_letters.h"

namespace nazori::ui {
namespace {

/// How high a menu may be below the bar; 0: no limit, because the space is too small to help.
int room_below(const QMenuBar& bar, const QMenu& menu) {
  constexpr int kFew = 6;
  const auto* screen = bar.screen();
  if (screen == nullptr) return 0;
  const int room = screen->availableGeometry().bottom() - bar.mapToGlobal(QPoint(0, bar.height())).y();
  return room >= kFew * 2 * menu.fontMetrics().lineSpacing() ? room : 0;
}

/// Entries that do not fit go into a submenu at the end.
void fill(QMenu& menu, const QList<QAction*>& actions, int room, const QString& rest) {
  QList<QAction*> entries = actions;
  entries.removeAll(nullptr);
  give_own_letters(entries);
  menu.clear();
  for (auto* old : menu.findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly)) delete old;
  for (auto* action : actions)
    if (action != nullptr)
      menu.addAction(action);
    else
      menu.addSeparator();
  if (room == 0 || menu.sizeHint().height() <= room) return;
  auto* more = menu.addMenu(rest);
  while (menu.sizeHint().height() > room && menu.actions().size() > 2) {
    auto* last = menu.actions().at(menu.actions().size() - 2);
    if (!last->isSeparator()) {
      menu.removeAction(last);
      more->insertAction(more->actions().value(0), last);
      continue;
    }
    delete last;  // the menu owns its separators
    if (!more->actions().isEmpty()) more->insertSeparator(more->actions().constFirst());
  }
  if (more->actions().constFirst()->isSeparator()) delete more->actions().constFirst();
}

}  // namespace

Actions::Actions(QWidget* window) : ActionSet(window), one_page_(new QActionGroup(this)) {
  open =
      make("open", tr("&Open…"), tr("Open a height map (RAW, PNG) or a stroke order file (.str)"), "Ctrl+O");
  save = make("save", tr("&Save as…"), tr("Save the tablet as RAW, PNG or .str"), "Ctrl+S");
  print = make("print", tr("&Print a worksheet…"),
               tr("Practice sheets, quizzes, flash cards and manuscript paper as PDF"), "Ctrl+P");
  check_sheets =
      make("check_sheets", tr("&Check worksheets…"),
           tr("Read printed worksheets back from photographs: what is legible, and what needs care"),
           "Ctrl+Alt+K");
  record = make("record", tr("&Record pen motion"), tr("Save every position and force of the pen to a file"),
                "Ctrl+Shift+R", true);
  quit = make("quit", tr("&Quit"), tr("Close Nazori"), "Q Ctrl+Q");

  groove_sound = make("groove_sound", tr("Groove s&ound"), tr("Play the sound of the stylus in the groove"),
                      "Ctrl+M", true);
  sound_louder = make("sound_louder", tr("Lo&uder"), tr("Make the groove sound louder"), "Ctrl+Shift+M");
  sound_softer = make("sound_softer", tr("Quie&ter"), tr("Make the groove sound quieter"), "Alt+Shift+M");
  slope_help = make("slope_help", tr("Feel s&lopes with the mouse"),
                    tr("The pointer moves more slowly uphill and faster downhill, as if held in the groove"),
                    "Ctrl+Shift+L", true);
  wood = make("wood", tr("&Wood"), tr("Pale wood"), "Ctrl+1", true);
  slate = make("slate", tr("S&late"), tr("Dark stone"), "Ctrl+2", true);
  classic = make("classic", tr("&Classic"), tr("The look of the 2005 program"), "Ctrl+3", true);
  theme_desktop = make("theme_desktop", tr("&Desktop colours"), tr("Light or dark, following the desktop"),
                       "Ctrl+Alt+1", true);
  theme_light = make("theme_light", tr("&Light colours"), tr("Always light"), "Ctrl+Alt+2", true);
  theme_dark = make("theme_dark", tr("Dar&k colours"), tr("Always dark"), "Ctrl+Alt+3", true);
  language_desktop = make("language_desktop", tr("Des&ktop language"), tr("Use the language of the desktop"),
                          "Ctrl+Alt+0", true);
  language_english =
      make("language_english", QStringLiteral("&English"), QStringLiteral("English"), "Ctrl+Alt+E", true);
  language_japanese =
      make("language_japanese", QStringLiteral("日本語 (&J)"), QStringLiteral("日本語"), "Ctrl+Alt+J", true);
  text_larger = make("text_larger", tr("&Larger text"), tr("Make the text larger"), "Ctrl++ Ctrl+=");
  text_smaller = make("text_smaller", tr("S&maller text"), tr("Make the text smaller"), "Ctrl+-");
  text_usual = make("text_usual", tr("Defa&ult text size"), tr("Reset the text size"), "Ctrl+0");
  reduced_motion = make("reduced_motion", tr("&Reduce motion"), tr("No animations: changes appear at once"),
                        "Ctrl+Alt+M", true);
  left_handed = make("left_handed", tr("Le&ft-handed"),
                     tr("Panels, the next button, brush and light change sides"), "Ctrl+Alt+F", true);
  // The page sets the text of these two.
  left_panel = make("left_panel", {}, {}, "F2", true, Icon::library);
  right_panel = make("right_panel", {}, {}, "F3", true, Icon::information);
  menus = make("menus", tr("Me&nus"), tr("Open the first menu; the arrow keys go on"), "F10");
  full_screen = make("full_screen", tr("&Full screen"), tr("Show only the tablet"), "F11", true);

  turn_left = make("turn_left", tr("Turn left"), tr("Turn the tablet to the left"), "Ctrl+Left");
  turn_right = make("turn_right", tr("Turn right"), tr("Turn the tablet to the right"), "Ctrl+Right");
  tilt_up = make("tilt_up", tr("Tilt away"), tr("Look at the tablet at an angle"), "Ctrl+Up");
  tilt_down = make("tilt_down", tr("Tilt back"), tr("Look more from above"), "Ctrl+Down");
  move_left = make("move_left", tr("Move left"), tr("Move the tablet to the left"), "Ctrl+Shift+Left");
  move_right = make("move_right", tr("Move right"), tr("Move the tablet to the right"), "Ctrl+Shift+Right");
  move_up = make("move_up", tr("Move up"), tr("Move the tablet up"), "Ctrl+Shift+Up");
  move_down = make("move_down", tr("Move down"), tr("Move the tablet down"), "Ctrl+Shift+Down");
  zoom_in = make("zoom_in", tr("Zoom in"), tr("Zoom in"), "+ =");
  zoom_out = make("zoom_out", tr("Zoom out"), tr("Zoom out"), "-");
  reset_view = make("reset_view", tr("Re&set view"), tr("Show the whole tablet from straight above"), "R",
                    Icon::reset_view);

  keys = make("keys", tr("&Keyboard shortcuts"), tr("All keyboard shortcuts and mouse actions"), "F1");
  about = make("about", tr("&About Nazori"), tr("Version, licences and sources"), "Shift+F1");

  make_exclusive({wood, slate, classic});
  make_exclusive({theme_desktop, theme_light, theme_dark});
  make_exclusive({language_desktop, language_english, language_japanese});

  file_ = {tr("&File"), {open, save, nullptr, print, check_sheets, nullptr, record, nullptr, quit}};
  tablet_ = {tr("&Tablet"),
             {wood,      slate,      classic,      nullptr,      reset_view,   zoom_in,   zoom_out,   nullptr,
              turn_left, turn_right, tilt_up,      tilt_down,    nullptr,      move_left, move_right, move_up,
              move_down, nullptr,    groove_sound, sound_louder, sound_softer, slope_help}};
  view_ = {tr("&View"),
           {left_panel, right_panel, menus, full_screen, nullptr, text_larger, text_smaller, text_usual,
            nullptr, theme_desktop, theme_light, theme_dark, reduced_motion, left_handed, nullptr,
            language_desktop, language_english, language_japanese}};
  go_ = {tr("&Go"), {}};
  help_ = {tr("&Help"), {keys, about}};
}

QAction* Actions::add_page(const Page& page) {
  const auto number = static_cast<int>(pages_.size()) + 1;
  const QByteArray name = "go_" + page.id().toLatin1();
  const QByteArray key = "Alt+" + QByteArray::number(number);
  auto* entry = make(name, page.name(), page.purpose(), key, true, page.drawing());
  pages_.append(entry);
  go_.actions.append(entry);
  one_page_->addAction(entry);
  return entry;
}

QList<ActionSet::Group> Actions::groups_with(const Page& page) const {
  QList<Group> groups{file_};
  groups.append(added_);
  if (const auto* own = page.actions()) groups.append(own->groups());
  if (page.instead_of_tablet() == nullptr) groups.append(tablet_);
  groups.append(view_);
  // With one page there is nothing to choose.
  if (pages_.size() > 1) groups.append(go_);
  groups.append(help_);
  return groups;
}

void Actions::give_keys(const Page& page) {
  QList<QKeySequence> taken;
  if (const auto* own = page.actions())
    for (const auto& group : own->groups())
      for (const auto* action : group.actions)
        if (action != nullptr) taken.append(action->shortcuts());
  for (auto* action : tablet_.actions) {
    if (action == nullptr) continue;
    if (!tablet_keys_.contains(action)) tablet_keys_.insert(action, action->shortcuts());
    QList<QKeySequence> left = tablet_keys_.value(action);
    left.removeIf([&taken](const QKeySequence& key) { return taken.contains(key); });
    action->setShortcuts(left);
  }
}

void Actions::enter(const Page& page, QMenuBar* bar) {
  const auto name_panel = [](QAction* action, const Page::Panel& panel) {
    action->setVisible(panel.widget != nullptr);
    action->setText(panel.name);
    action->setIconText(without_mnemonic(panel.name));
    action->setStatusTip(panel.tip);
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(panel.tip, action->shortcut().toString(QKeySequence::NativeText)));
  };
  name_panel(left_panel, page.left());
  name_panel(right_panel, page.right());
  set_in_force(tablet_, page.instead_of_tablet() == nullptr);
  give_keys(page);
  open->setVisible(page.has_files());
  save->setVisible(page.has_files());
  bar->clear();
  for (auto* old : bar->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly)) delete old;
  for (const auto& group : groups_with(page)) {
    auto* menu = bar->addMenu(group.title);
    fill(*menu, group.actions, 0, {});
    // A long menu would cover the menu bar, and the other menus could not be reached.
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, bar, entries = group.actions] {
      fill(*menu, entries, room_below(*bar, *menu), tr("More"));
    });
  }
  give_own_letters(bar->actions());
}

}  // namespace nazori::ui
