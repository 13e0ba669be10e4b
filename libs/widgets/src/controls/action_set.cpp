// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/action_set.h"

#include <QActionGroup>
#include <QRegularExpression>
#include <QWidget>

#include "nazori/widgets/look/palette.h"

namespace nazori::ui {

ActionSet::ActionSet(QWidget* window) : QObject(window), window_(window) {}

QAction* ActionSet::make(const char* name, const QString& text, const QString& tip, const char* key_list,
                         bool checkable, std::optional<Icon> drawing) {
  QList<QKeySequence> keys;
  for (const QString& key : QString::fromLatin1(key_list).split(QLatin1Char(' ')))
    keys.append(QKeySequence(key, QKeySequence::PortableText));
  auto* action = new QAction(text, this);
  action->setObjectName(QString::fromLatin1(name));
  action->setShortcuts(keys);
  action->setCheckable(checkable);
  action->setIconText(without_mnemonic(text).remove(QChar(0x2026)).trimmed());
  action->setStatusTip(tip);
  action->setToolTip(QStringLiteral("%1 (%2)").arg(tip, keys.front().toString(QKeySequence::NativeText)));
  action->setIconVisibleInMenu(false);
  // A key must also work while the menu bar is hidden (full screen).
  window_->addAction(action);
  if (drawing) drawings_.insert(action, *drawing);
  return action;
}

void ActionSet::make_exclusive(const QList<QAction*>& actions) {
  auto* group = new QActionGroup(this);
  for (auto* action : actions) group->addAction(action);
}

void ActionSet::set_in_force(bool in_force) {
  for (const auto& group : groups_) set_in_force(group, in_force);
}

void ActionSet::set_in_force(const Group& group, bool in_force) {
  // An action that is not visible has no key either.
  for (auto* action : group.actions)
    if (action != nullptr) action->setVisible(in_force);
}

void ActionSet::draw_icons() {
  const Colours& c = current_colours();
  for (auto at = drawings_.cbegin(); at != drawings_.cend(); ++at)
    at.key()->setIcon(icon(at.value(), c.ink, c.indigo));
}

QString without_mnemonic(QString text) {
  static const QRegularExpression mnemonic(QStringLiteral(" ?\\(&.\\)|&"));
  return text.remove(mnemonic);
}

}  // namespace nazori::ui
