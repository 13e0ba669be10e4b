// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/choice_access.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QAction>
#include <QActionGroup>
#include <QToolButton>

namespace nazori::ui {
namespace {

bool is_choice(const QToolButton& button) {
  const auto* action = button.defaultAction();
  return action != nullptr && action->isCheckable() && action->actionGroup() != nullptr &&
         action->actionGroup()->exclusionPolicy() != QActionGroup::ExclusionPolicy::None;
}

class ChoiceAccess final : public QAccessibleWidget {
 public:
  explicit ChoiceAccess(QToolButton* button) : QAccessibleWidget(button, QAccessible::RadioButton) {}

  [[nodiscard]] QString text(QAccessible::Text which) const override {
    const QString own = QAccessibleWidget::text(which);
    if (!own.isEmpty()) return own;
    if (which == QAccessible::Name) return button().defaultAction()->iconText();
    if (which == QAccessible::Accelerator)
      return button().defaultAction()->shortcut().toString(QKeySequence::NativeText);
    return {};
  }
  [[nodiscard]] QAccessible::State state() const override {
    auto now = QAccessibleWidget::state();
    now.checkable = true;
    now.checked = button().isChecked();
    return now;
  }
  [[nodiscard]] QStringList actionNames() const override { return {pressAction(), setFocusAction()}; }
  void doAction(const QString& name) override {
    if (name == pressAction())
      button().click();
    else
      QAccessibleWidget::doAction(name);
  }

 private:
  [[nodiscard]] QToolButton& button() const { return *static_cast<QToolButton*>(widget()); }
};

QAccessibleInterface* make(const QString&, QObject* object) {
  auto* button = qobject_cast<QToolButton*>(object);
  return button != nullptr && is_choice(*button) ? new ChoiceAccess(button) : nullptr;
}

}  // namespace

void describe_choices() { QAccessible::installFactory(make); }

}  // namespace nazori::ui
