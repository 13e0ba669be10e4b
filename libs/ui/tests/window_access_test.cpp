// SPDX-License-Identifier: Apache-2.0
// What a screen reader finds: every control has a role, a name and, where it holds one, a value; the Tab key
// goes through all of them, forwards and backwards.
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QMenu>
#include <QSet>
#include <QTimer>
#include <functional>

#include "window_under_test.h"

namespace nazori::ui {
namespace {

class Access : public WindowTest {
 protected:
  QList<QAction*> pages() {
    QList<QAction*> all;
    for (auto* action : window_->findChildren<QAction*>())
      if (action->objectName().startsWith(QStringLiteral("go_")) && action->isCheckable()) all.append(action);
    return all;
  }
  void go_to(QAction* page) {
    page->trigger();
    settle();
  }
  static void settle() {
    for (int pass = 0; pass < 5; ++pass) {
      QCoreApplication::sendPostedEvents();
      QCoreApplication::processEvents();
    }
  }
  /// Opens every dialog of every page, and closes it again. @return how many there were.
  int for_each_dialog(const std::function<void(QDialog&, const QString& opened_by)>& look_at) {
    int seen = 0;
    QTimer look;
    QString opened_by;
    QObject::connect(&look, &QTimer::timeout, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      look_at(*dialog, opened_by);
      ++seen;
      dialog->reject();
    });
    look.start(10);
    for (auto* page : pages()) {
      go_to(page);
      for (auto* action : window_->findChildren<QAction*>()) {
        // Three dots say that a dialog follows. Those for files are the desktop's own.
        const bool files = action->objectName().contains(QStringLiteral("open")) ||
                           action->objectName().contains(QStringLiteral("record")) ||
                           action->objectName() == QStringLiteral("voice_file") ||
                           action->objectName().contains(QStringLiteral("export")) ||
                           action->objectName().contains(QStringLiteral("import"));
        if (!action->text().endsWith(QStringLiteral("…")) || !action->isEnabled() || files) continue;
        opened_by = action->objectName();
        action->trigger();
        settle();
      }
    }
    return seen;
  }
};

/// Layouts whose margins or spacing are odd. Those of the window go by steps of two pixels, so that what is
/// in a page stands in line. 9 and 3 are in use, and 11 is the style's.
QString uneven_layouts(const QWidget& whole) {
  QStringList uneven;
  for (const auto* layout : whole.findChildren<QLayout*>()) {
    const auto* box = qobject_cast<const QBoxLayout*>(layout);
    const bool is_ours = box != nullptr || qobject_cast<const QGridLayout*>(layout) != nullptr ||
                         qobject_cast<const QFormLayout*>(layout) != nullptr;
    const auto* holder = layout->parentWidget();
    if (!is_ours || holder == nullptr || holder->inherits("QDialogButtonBox") ||
        holder->inherits("QMessageBox") || holder->inherits("QToolBar"))
      continue;
    const QMargins m = layout->contentsMargins();
    for (const int width : {m.left(), m.top(), m.right(), m.bottom(), layout->spacing()})
      if (width > 0 && width % 2 != 0 && width != 3 && width != 9 && width != 11)
        uneven.append(QStringLiteral("%1 %2: %3 %4 %5 %6, %7")
                          .arg(QString::fromLatin1(holder->metaObject()->className()), holder->objectName())
                          .arg(m.left())
                          .arg(m.top())
                          .arg(m.right())
                          .arg(m.bottom())
                          .arg(layout->spacing()));
  }
  uneven.removeDuplicates();
  return uneven.join(QLatin1Char('\n'));
}

bool holds_a_value(QAccessible::Role role) {
  return role == QAccessible::ComboBox || role == QAccessible::SpinBox || role == QAccessible::Slider ||
         role == QAccessible::ProgressBar;
}

bool is_control(const QAccessibleInterface& part) {
  const auto state = part.state();
  if (state.invisible || part.rect().isEmpty()) return false;
  // The lens and the cross in a search box cannot be reached by key; Qt makes them.
  if (part.object() != nullptr && part.object()->inherits("QLineEditIconButton")) return false;
  switch (part.role()) {
    case QAccessible::PushButton:
    case QAccessible::CheckBox:
    case QAccessible::RadioButton:
    case QAccessible::PageTab:
    case QAccessible::ButtonMenu:
    case QAccessible::ButtonDropDown:
    case QAccessible::EditableText:
      return true;
    case QAccessible::StaticText:
      return false;
    default:
      // What holds other parts is named by them.
      return holds_a_value(part.role()) || (state.focusable && part.childCount() == 0);
  }
}

QString place(QAccessibleInterface* part) {
  QStringList names;
  for (auto* at = part; at != nullptr && names.size() < 6; at = at->parent()) {
    const auto* object = at->object();
    names.prepend(object != nullptr && !object->objectName().isEmpty()
                      ? object->objectName()
                      : QString::fromLatin1(object != nullptr ? object->metaObject()->className() : "item"));
  }
  return names.join(QLatin1Char('/'));
}

/// What is missing in the tree below `part`, a line each.
void find_missing(QAccessibleInterface* part, QStringList& missing) {
  if (part == nullptr) return;
  if (is_control(*part)) {
    if (part->role() == QAccessible::NoRole || part->role() == QAccessible::Client)
      missing.append(place(part) + QStringLiteral(": no role"));
    if (part->text(QAccessible::Name).trimmed().isEmpty())
      missing.append(place(part) + QStringLiteral(": no name"));
    if (holds_a_value(part->role()) && part->valueInterface() == nullptr &&
        part->text(QAccessible::Value).isEmpty())
      missing.append(place(part) + QStringLiteral(": no value"));
  }
  // The rows of long lists are all alike: the first ones stand for them.
  const int children = std::min(part->childCount(), 200);
  for (int i = 0; i < children; ++i) {
    auto* child = part->child(i);
    if (child != nullptr && !child->state().invisible) find_missing(child, missing);
  }
}

QString missing_in(QWidget* widget) {
  QStringList missing;
  find_missing(QAccessible::queryAccessibleInterface(widget), missing);
  missing.removeDuplicates();
  return missing.join(QLatin1Char('\n'));
}

TEST_F(Access, EveryControlOfEveryPageHasARoleANameAndAValue) {
  for (auto* page : pages()) {
    go_to(page);
    EXPECT_EQ(missing_in(window_.get()), QString()) << page->objectName().toStdString();
  }
}

TEST_F(Access, EveryControlOfEveryDialogHasARoleANameAndAValue) {
  const int seen = for_each_dialog([](QDialog& dialog, const QString& opened_by) {
    EXPECT_EQ(missing_in(&dialog), QString()) << opened_by.toStdString();
  });
  EXPECT_GE(seen, 5);
}

TEST_F(Access, EveryLayoutOfEveryPageKeepsToWholeSteps) {
  for (auto* page : pages()) {
    go_to(page);
    EXPECT_EQ(uneven_layouts(*window_), QString()) << page->objectName().toStdString();
  }
}

TEST_F(Access, EveryLayoutOfEveryDialogKeepsToWholeSteps) {
  const int seen = for_each_dialog([](QDialog& dialog, const QString& opened_by) {
    EXPECT_EQ(uneven_layouts(dialog), QString()) << opened_by.toStdString();
  });
  EXPECT_GE(seen, 5);
}

TEST_F(Access, TabAndShiftTabReachTheSameControlsOfEachPage) {
  for (auto* page : pages()) {
    go_to(page);
    // Tab leaves the tablet, which is a window of its own, and comes back to it by its key.
    if (auto* at = QApplication::focusWidget(); at != nullptr && at->objectName() == QStringLiteral("tablet"))
      QTest::keyClick(at, Qt::Key_Tab);
    // In Progress Qt keeps Shift+Tab among the charts.
    if (page->objectName() == QStringLiteral("go_progress")) continue;
    const auto round = [&](Qt::Key key) {
      QSet<QString> reached;
      for (int i = 0; i < 400; ++i) {
        auto* at = QApplication::focusWidget();
        if (at == nullptr) break;
        // What is on the way to the round does not count.
        if (i >= 200) reached.insert(at->objectName());
        QTest::keyClick(at, key, key == Qt::Key_Backtab ? Qt::ShiftModifier : Qt::NoModifier);
      }
      QStringList names(reached.begin(), reached.end());
      names.sort();
      return names.join(QLatin1Char(' '));
    };
    const QString forwards = round(Qt::Key_Tab);
    EXPECT_EQ(forwards, round(Qt::Key_Backtab)) << page->objectName().toStdString();
    EXPECT_TRUE(forwards.contains(QStringLiteral("rail_go_home"))) << forwards.toStdString();
  }
}

}  // namespace
}  // namespace nazori::ui
