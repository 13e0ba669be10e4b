// SPDX-License-Identifier: Apache-2.0
// The parts that panels and dialogs are made of, made alike everywhere.
#pragma once

#include <QDialogButtonBox>
#include <QStringList>

class QAction;
class QComboBox;
class QLabel;
class QLayout;
class QMimeData;
class QPushButton;
class QScrollArea;
class QTableWidget;
class QWindow;

namespace nazori::ui {

/// Gives a widget its object name and, where it has one, the name that a screen reader says.
/// @param name  never translated: tests and the style sheet find the widget by it. @return the widget.
template <class Widget>
Widget* named(Widget* widget, const char* name, const QString& spoken = {}) {
  widget->setObjectName(QString::fromLatin1(name));
  if (!spoken.isEmpty()) widget->setAccessibleName(spoken);
  return widget;
}

/// Says to the style sheet what a widget is for: "muted", "heading", "card". @return the widget.
template <class Widget>
Widget* with_role(Widget* widget, const char* role) {
  widget->setProperty("role", QString::fromLatin1(role));
  return widget;
}

/// A label of plain text in as many lines as it needs. @param role  as with_role(); nullptr: none.
[[nodiscard]] QLabel* text_label(const char* name, QWidget* parent, const char* role = nullptr);
/// A text_label() for sentences that can be copied.
[[nodiscard]] QLabel* sentence_label(const char* name, QWidget* parent, const char* role = nullptr);
/// The heading of a section, in as many lines as it needs.
[[nodiscard]] QLabel* heading(const QString& text, QWidget* parent);

/// A button for an action: "button_" and the name of the action, and its tool tip. @param text  of the
/// button.
[[nodiscard]] QPushButton* action_button(QAction* action, const QString& text, QWidget* parent);

/// Lets a box be narrower than its longest entry. @param letters  that fit at least.
void make_narrow(QComboBox* box, int letters);
/// Shows rows that are chosen as a whole, and not edited.
void make_row_table(QTableWidget* table);
/// Lets `content` scroll up and down, on the background of the window.
void make_scrolling(QScrollArea* area, QWidget* content);
/// Removes everything that is in a layout.
void clear_layout(QLayout* layout);
/// Buttons that accept and reject a dialog.
[[nodiscard]] QDialogButtonBox* dialog_buttons(QDialogButtonBox::StandardButtons which, QDialog* dialog);

/// Whether the keyboard is in a panel that is shown. Before the panel is hidden the keyboard is given to the
/// tablet, or Qt gives it to whatever comes next.
[[nodiscard]] bool has_keyboard(const QWidget& panel);

/// Gives the keyboard to a widget that shows a window of its own. While `inside`, that window, has the
/// keyboard, Qt takes this for Tab out of it and gives the keyboard to the widget after it: then nothing is
/// to be done.
/// @param inside  null where the widget is an ordinary one
void focus_window_container(QWidget& container, const QWindow* inside);

/// Whether keys that this object receives are meant for the tablet: its widget, or the window inside it.
[[nodiscard]] bool is_tablet(const QObject* object);

/// The files of this computer that are being dropped.
[[nodiscard]] QStringList local_files(const QMimeData* data);

}  // namespace nazori::ui
