// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <optional>

#include "nazori/widgets/look/icons.h"

namespace nazori::ui {

/// Actions with their words and keys, in the groups that become menus. Menus, toolbar and the list of keys
/// are all made from the same sets, so none can be missing in one of them.
class ActionSet : public QObject {
  Q_OBJECT
 public:
  /// A named group of actions, as in the menu bar.
  struct Group {
    QString title;
    QList<QAction*> actions;  ///< nullptr: a separator
  };
  [[nodiscard]] const QList<Group>& groups() const { return groups_; }

  /// Whether the actions of a set, or of one of its groups, exist for the learner: their menu entries,
  /// buttons and keys. Sets of different pages may use the same keys, because only one page is in force at a
  /// time.
  void set_in_force(bool in_force);
  static void set_in_force(const Group& group, bool in_force);
  /// Adds the groups of another set to its own. The other set keeps owning the actions.
  void adopt(const ActionSet& other) { groups_.append(other.groups_); }
  /// Draws the icons again in the colours of the window's palette.
  void draw_icons();

 protected:
  explicit ActionSet(QWidget* window);

  /// @param name  object name. @param key_list  with spaces between them; the first is shown in the tool tip.
  QAction* make(const char* name, const QString& text, const QString& tip, const char* key_list,
                bool checkable = false, std::optional<Icon> drawing = {});
  QAction* make(const char* name, const QString& text, const QString& tip, const char* key_list,
                Icon drawing) {
    return make(name, text, tip, key_list, false, drawing);
  }
  /// Makes these actions exclusive: one at a time is checked.
  void make_exclusive(const QList<QAction*>& actions);
  void add_group(const QString& title, const QList<QAction*>& actions) { groups_.append({title, actions}); }
  /// @param group  its place among groups().
  void add_to_group(qsizetype group, QAction* action) { groups_[group].actions.append(action); }

 private:
  QWidget* window_;
  QList<Group> groups_;
  QHash<QAction*, Icon> drawings_;
};

/// The text of a menu entry without its mnemonic: "&Open…", "開く(&O)…".
[[nodiscard]] QString without_mnemonic(QString text);

}  // namespace nazori::ui
