// SPDX-License-Identifier: Apache-2.0
#include "style_sheet.h"

namespace nazori::ui {

QString style_sheet(const Colours& c) {
  QString sheet = QStringLiteral(R"(
QMainWindow, QDialog, QMessageBox { background: @paper; }
QWidget#toolbar_frame, QStatusBar { background: @paper; }
QToolTip { background: @surface; color: @ink; border: 1px solid @line; padding: 4px 6px; }

QMenuBar { background: @paper; color: @ink; border: none; padding: 2px 6px; }
QMenuBar::item { padding: 4px 10px; border-radius: 5px; background: transparent; }
QMenuBar::item:selected { background: @hover; }
QMenu { background: @surface; color: @ink; border: 1px solid @line; padding: 6px 0; }
QMenu::item { padding: 5px 28px 5px 30px; }
QMenu::item:selected { background: @tint; color: @ink; }
QMenu::item:disabled { color: @faint; }
QMenu::separator { height: 1px; background: @line; margin: 6px 12px; }
QMenu::indicator { width: 14px; height: 14px; left: 9px; }

QToolBar { background: @paper; border: none; border-bottom: 1px solid @line; spacing: 2px; padding: 3px 8px; }
QToolBar::separator { background: @line; width: 1px; margin: 7px 8px; }
QToolBar QToolButton { color: @ink; background: transparent; border: 2px solid transparent; border-radius: 7px;
  padding: 3px 7px; }
QToolBar QToolButton:hover { background: @hover; }
QToolBar QToolButton:pressed { background: @press; }
QToolBar QToolButton:checked { background: @tint; color: @indigo; }
QToolBar QToolButton:disabled { color: @faint; }
QToolBar QToolButton:focus { border-color: @indigo; }
QToolBar QToolButton::menu-indicator { image: none; width: 0; }
QToolButton#qt_toolbar_ext_button { qproperty-icon: url(:/nazori/down-@mode.png); background: @hover; border: 1px solid @line; border-radius: 5px; }
QLabel#stroke_label { padding: 0 4px; }

QStatusBar { border-top: 1px solid @line; color: @muted; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: @muted; padding: 1px 8px; }

QLineEdit { background: @surface; color: @ink; border: 2px solid @line; border-radius: 8px; padding: 5px 7px;
  selection-background-color: @indigo; selection-color: @surface; }
QLineEdit:focus { border-color: @indigo; }
QLineEdit > QToolButton { border: none; background: transparent; padding: 0; margin: 0; }

QComboBox, QSpinBox, QDoubleSpinBox { background: @surface; color: @ink; border: 2px solid @line; border-radius: 8px;
  padding: 4px 8px; }
QComboBox:hover { background: @hover; }
QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus { border-color: @indigo; }
QCheckBox { border: 2px solid transparent; border-radius: 6px; padding: 2px 4px; }
QCheckBox:focus { border-color: @indigo; }
QSlider { border: 2px solid transparent; border-radius: 6px; padding: 2px; }
QSlider:focus { border-color: @indigo; }
QWidget#plot_panel, QWidget#points_panel { background: @paper; }
QWidget#plot_content { background: transparent; }
QComboBox::drop-down { border: none; width: 22px; }
QComboBox::down-arrow { image: url(:/nazori/down-@mode.png); width: 10px; height: 6px; }
QComboBox QAbstractItemView { background: @surface; color: @ink; border: 1px solid @line; outline: none;
  selection-background-color: @tint; selection-color: @ink; }

QPushButton { background: @surface; color: @ink; border: 2px solid @line; border-radius: 8px; padding: 5px 14px; }
QPushButton:hover { background: @hover; }
QPushButton:pressed { background: @press; }
QPushButton:focus { border-color: @indigo; }
QPushButton:disabled { color: @faint; }
QPushButton:default { border-color: @indigo; }

QPushButton[role="primary"] { background: @vermilion; color: @surface; border-color: @vermilion; padding: 7px 16px; }
QPushButton[role="rating"] { padding: 3px 6px; }
QPushButton[role="primary"]:hover { background: @vermilion_hover; }
QPushButton[role="primary"]:focus { border-color: @ink; }
QPushButton[role="primary"]:disabled { background: @hover; color: @faint; border-color: @line; }
QFrame[role="card"], QLabel[role="card"] { background: @surface; border: 1px solid @line; border-radius: 10px; }
QFrame[role="card"] QLabel { border: none; background: transparent; }
QLabel[role="card"] { padding: 12px 16px; }
QLabel[role="trouble"] { background: @surface; border: 2px solid @vermilion; border-radius: 10px; padding: 12px 16px; }
QFrame#session_bar { background: @paper; border: none; border-top: 1px solid @line; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { subcontrol-origin: padding; width: 24px; border: none;
  background: transparent; }
QAbstractSpinBox::up-button { subcontrol-position: top right; }
QAbstractSpinBox::down-button { subcontrol-position: bottom right; }
QAbstractSpinBox::up-button:hover, QAbstractSpinBox::down-button:hover { background: @hover; }
QAbstractSpinBox::up-arrow { image: url(:/nazori/up-@mode.png); width: 10px; height: 6px; }
QAbstractSpinBox::down-arrow { image: url(:/nazori/down-@mode.png); width: 10px; height: 6px; }
QTabWidget::pane { border: none; border-top: 1px solid @line; background: @paper; }
QTabBar::tab { background: transparent; color: @muted; border: 2px solid transparent; border-radius: 7px;
  padding: 5px 12px; margin: 0 2px 5px 0; }
QTabBar::tab:hover { background: @hover; }
QTabBar::tab:selected { background: @tint; color: @indigo; }
QTabBar::tab:focus { border-color: @indigo; }
QListWidget#study_lists, QListWidget#learners_list { background: @surface; border: 2px solid @line; border-radius: 8px; outline: none; padding: 4px; }
QListWidget#study_lists:focus, QListWidget#learners_list:focus { border-color: @indigo; }
QListWidget#study_lists::item, QListWidget#learners_list::item { color: @ink; padding: 3px; border-radius: 6px; }
QListWidget#study_lists::item:selected, QListWidget#learners_list::item:selected { background: @tint; color: @ink; }
QTableView::item { padding: 2px 8px; }
QTableView::item:selected { background: @tint; color: @ink; }
QProgressBar { background: @line; border: none; border-radius: 3px; }
QProgressBar::chunk { background: @indigo; border-radius: 3px; }

QListView#character_grid { background: transparent; border: 2px solid transparent; border-radius: 8px;
  outline: none; }
QListView#character_grid:focus { border-color: @indigo; }

QListWidget#candidates { background: @surface; border: 2px solid @line; border-radius: 8px; outline: none; padding: 4px; }
QListWidget#candidates:focus { border-color: @indigo; }
QListWidget#candidates::item { color: @ink; border: 2px solid transparent; border-radius: 7px; }
QListWidget#candidates::item:hover { background: @hover; }
QListWidget#candidates::item:selected { background: @tint; color: @ink; border-color: @indigo; }
QWidget#draw_panel { background: @paper; }

QScrollArea { background: transparent; border: none; }
QScrollArea:focus { border: 2px solid @indigo; }
QScrollArea#home_page:focus { border: none; }
QWidget#information_content { background: transparent; }
QFrame[separator="true"] { background: @line; border: none; max-height: 1px; min-height: 1px; }
QWidget#library_panel, QWidget#information_panel, QWidget#seat_panel, QWidget#feel_panel,
QWidget#session_panel, QWidget#home_page { background: @paper; }
QWidget#progress_page, QWidget#progress_content { background: @paper; }
QLabel[role="card_title"] { color: @ink; font-weight: bold; }
QFrame[role="card"] QToolButton { color: @ink; background: @surface; border: 2px solid @line; border-radius: 7px; padding: 2px 8px; }
QFrame[role="card"] QToolButton:hover { background: @hover; }
QFrame[role="card"] QToolButton:checked { background: @tint; color: @indigo; }
QFrame[role="card"] QToolButton:focus { border-color: @indigo; }
QFrame[role="card"] QGraphicsView { background: transparent; border: 2px solid transparent; border-radius: 8px; }
QFrame[role="card"] QGraphicsView:focus { border-color: @indigo; }
QFrame[role="card"] QListView { background: transparent; border: 2px solid @line; border-radius: 8px; outline: none; }
QFrame[role="card"] QListView:focus { border-color: @indigo; }
QProgressBar#progress_work { max-height: 8px; }
QLabel[role="muted"] { color: @muted; }
QLabel[role="heading"] { color: @muted; }

QPushButton[role="part"] { background: @surface; color: @ink; border: 2px solid @line; border-radius: 9px;
  padding: 3px 9px; text-align: left; }
QPushButton[role="part"]:hover { border-color: @indigo; }
QPushButton[role="part"]:focus { border-color: @indigo; }
QPushButton[role="part"]:disabled { border-color: transparent; background: transparent; color: @ink; }

QSplitter::handle { background: @line; }
QSplitter::handle:horizontal { width: 1px; }
QSplitter::handle:hover { background: @indigo; }

QScrollBar:vertical { background: transparent; width: 12px; margin: 0; }
QScrollBar::handle:vertical { background: @line; border-radius: 4px; min-height: 36px; margin: 2px; }
QScrollBar::handle:vertical:hover { background: @muted; }
QScrollBar:horizontal { background: transparent; height: 12px; margin: 0; }
QScrollBar::handle:horizontal { background: @line; border-radius: 4px; min-width: 36px; margin: 2px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QTextBrowser, QPlainTextEdit, QTreeView, QTableView { background: @surface; color: @ink; border: 1px solid @line; border-radius: 8px; }
QTextBrowser:focus, QPlainTextEdit:focus, QTreeView:focus, QTableView:focus { border: 2px solid @indigo; }
QHeaderView::section { background: @paper; color: @muted; border: none; padding: 4px 8px; }
)");
  const std::pair<const char*, QColor> names[] = {
      {"@paper", c.paper},
      {"@surface", c.surface},
      {"@line", c.line},
      {"@ink", c.ink},
      {"@muted", c.muted},
      {"@indigo", c.indigo},
      {"@hover", blend(c.paper, c.line, 0.45)},
      {"@press", blend(c.paper, c.line, 0.9)},
      {"@vermilion_hover", blend(c.vermilion, c.ink, 0.15)},
      {"@vermilion", c.vermilion},
      {"@tint", blend(c.surface, c.indigo, 0.13)},
      {"@faint", blend(c.muted, c.paper, 0.35)},
  };
  for (const auto& [name, colour] : names) sheet.replace(QLatin1String(name), colour.name());
  sheet.replace(QLatin1String("@mode"),
                c.ink.lightnessF() > 0.5 ? QStringLiteral("dark") : QStringLiteral("light"));
  return sheet;
}

}  // namespace nazori::ui
