// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <utility>
#include <vector>

#include "nazori/practice/session_steps.h"
#include "nazori/widgets/controls/action_set.h"
#include "nazori/widgets/look/icons.h"

class QSettings;
class QWidget;

namespace nazori::ui {

class WindowParts;

/// A button of the toolbar.
struct Tool {
  QAction* action = nullptr;  ///< nullptr: a separator. A QWidgetAction brings its own widget
  bool words = false;         ///< shows its text beside the icon if there is space
};

/// One page of the window, for one subject: characters, functions, statistics, a device. It has either panels
/// beside the shared tablet, or a widget instead of the tablet. Its menus, keys and tools exist only while it
/// is entered. Made once, with the window, and never moved. Thread: interface.
class Page : public QObject {
  Q_OBJECT
 public:
  /// What never changes about a page.
  struct Description {
    QString id;  ///< never translated: its group in the settings, and part of object names ("go_characters")
    QString name;     ///< as shown to the learner, with its mnemonic: "&Characters"
    QString purpose;  ///< in one short line
    Icon drawing;
    QString tablet;  ///< the tablet's description for a screen reader
  };

  Page(WindowParts& parts, Description description);
  ~Page() override;

  /// A panel beside the tablet.
  struct Panel {
    QWidget* widget = nullptr;  ///< nullptr: there is none
    QString name;               ///< of the menu entry that hides it, "&List of characters"
    QString tip;                ///< the tool tip of that entry
  };

  [[nodiscard]] const QString& id() const { return description_.id; }
  [[nodiscard]] const QString& name() const { return description_.name; }
  [[nodiscard]] const QString& purpose() const { return description_.purpose; }
  [[nodiscard]] Icon drawing() const { return description_.drawing; }
  [[nodiscard]] const QString& tablet_description() const { return description_.tablet; }
  /// What the page shows now, for the title of the window.
  [[nodiscard]] virtual QString title() const { return {}; }

  [[nodiscard]] virtual Panel left() const { return {}; }
  [[nodiscard]] virtual Panel right() const { return {}; }
  /// A widget above the tablet. The page shows and hides what is in it. nullptr: none.
  [[nodiscard]] virtual QWidget* above_tablet() const { return nullptr; }
  /// A widget under the tablet and the feedback line. The page shows and hides it. nullptr: none.
  [[nodiscard]] virtual QWidget* under_tablet() const { return nullptr; }
  /// Whether the page needs the room of panels and toolbar for the tablet.
  [[nodiscard]] virtual practice::FoldedPanels folded() const { return {}; }
  /// A widget that replaces the tablet and its panels. nullptr: the tablet is shown.
  [[nodiscard]] virtual QWidget* instead_of_tablet() const { return nullptr; }
  [[nodiscard]] virtual ActionSet* actions() const { return nullptr; }
  /// Whether the page is in the rail and in the menu "Go" and opens again at the next start.
  [[nodiscard]] virtual bool is_listed() const { return true; }
  /// Whether the window must open with this page, whatever was shown last.
  [[nodiscard]] virtual bool comes_first() const { return false; }
  /// The middle of the toolbar.
  [[nodiscard]] virtual QList<Tool> tools() const { return {}; }

  /// The page is shown: it sets its tablet and announces what can be done.
  virtual void enter() = 0;
  /// Another page is shown instead.
  virtual void leave() {}
  /// The colours or the text size have changed.
  virtual void refresh_appearance() {}
  /// Saves the settings of the page in its own group. Called before the window closes, and shortly after
  /// parts().save_later().
  virtual void save(QSettings& settings) const;

  /// Whether the window may close. A page with work that is not saved asks the learner first.
  /// @param quits  false: the window closes to open again, as in another language.
  [[nodiscard]] virtual bool may_close(bool /*quits*/) { return true; }

  /// Whether the page opens files of this kind (dropped on the window, named on the command line).
  [[nodiscard]] virtual bool opens(const QStringList& paths) const;
  virtual void open_files(const QStringList& paths);
  /// Whether the menu entries "Open" and "Save as" do something on this page.
  [[nodiscard]] virtual bool has_files() const { return false; }
  virtual void ask_and_open() {}
  virtual void ask_and_save() {}

 signals:
  void title_changed();
  /// tools() has changed.
  void tools_changed();
  /// folded() may have changed.
  void room_changed();
  /// The page must be shown: something was requested that only this page can show.
  void wants_to_be_entered();

 protected:
  [[nodiscard]] WindowParts& parts() const { return parts_; }
  /// Calls `what` whenever an action is triggered.
  template <class What>
  void on(QAction* action, What what) {
    connect(action, &QAction::triggered, this, std::move(what));
  }

 private:
  WindowParts& parts_;
  Description description_;
};

using MakePage = std::unique_ptr<Page> (*)(WindowParts&);

/// The pages of the program, in the order of their keys (Alt+1, Alt+2 ...).
[[nodiscard]] std::vector<MakePage> registered_pages();

}  // namespace nazori::ui
