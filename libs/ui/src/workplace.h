// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <vector>

#include "action_set.h"
#include "icons.h"

class QSettings;
class QWidget;

namespace nazori::ui {

class Desk;

/// A button of the toolbar.
struct Tool {
  QAction* action = nullptr;  ///< nullptr: a separator. A QWidgetAction brings its own widget
  bool words = false;         ///< shows its words beside the drawing where there is room
};

/// One of the things the window is for: characters, functions, statistics, a device. A workplace has either
/// panels beside the one shared tablet, or a page in its place; its own menus, keys and tools are there only
/// while it is entered. Made once, with the window, and never moved. Thread: interface.
class Workplace : public QObject {
  Q_OBJECT
 public:
  explicit Workplace(Desk& desk);
  ~Workplace() override;

  /// A panel beside the tablet.
  struct Panel {
    QWidget* widget = nullptr;  ///< nullptr: there is none
    QString name;               ///< of the entry that folds it away, "&List of characters"
    QString tip;                ///< what that entry does
  };

  /// Never translated: its group in the settings and the object name of its entry ("go_characters").
  [[nodiscard]] virtual QString id() const = 0;
  /// For people, with the letter of its menu entry: "&Characters".
  [[nodiscard]] virtual QString name() const = 0;
  /// One short line: what it is for.
  [[nodiscard]] virtual QString purpose() const = 0;
  [[nodiscard]] virtual Icon drawing() const = 0;
  /// What is on the desk, for the window's title.
  [[nodiscard]] virtual QString title() const { return {}; }

  [[nodiscard]] virtual Panel left() const { return {}; }
  [[nodiscard]] virtual Panel right() const { return {}; }
  /// Stands between the tablet and the words below it; the workplace shows and hides it. nullptr: nothing.
  [[nodiscard]] virtual QWidget* under_tablet() const { return nullptr; }
  /// Stands in place of the tablet and its panels; nullptr: the tablet stays.
  [[nodiscard]] virtual QWidget* page() const { return nullptr; }
  [[nodiscard]] virtual ActionSet* actions() const { return nullptr; }
  /// The middle of the toolbar.
  [[nodiscard]] virtual QList<Tool> tools() const { return {}; }
  /// The tablet's description for a screen reader.
  [[nodiscard]] virtual QString tablet_description() const { return {}; }

  /// It comes to stand in the window: put your tablet on the desk, say what can be done.
  virtual void enter() = 0;
  /// Another takes its place.
  virtual void leave() {}
  /// The colours or the text size are others now.
  virtual void take_appearance() {}
  /// Before the window goes, and a little after desk().save_later(): its own settings, in a group of its own.
  virtual void save(QSettings& settings) const;

  /// Whether it is the place for files of this kind (dropped on the window, named on the command line).
  [[nodiscard]] virtual bool opens(const QStringList& paths) const;
  virtual void open_files(const QStringList& paths);
  /// Whether the entries "Open" and "Save as" do something here.
  [[nodiscard]] virtual bool has_files() const { return false; }
  virtual void ask_and_open() {}
  virtual void ask_and_save() {}

 signals:
  void title_changed();
  /// tools() are others now.
  void tools_changed();
  /// It must stand in the window: something was asked for that only it can show.
  void wants_to_be_entered();

 protected:
  [[nodiscard]] Desk& desk() const { return desk_; }

 private:
  Desk& desk_;
};

using MakeWorkplace = std::unique_ptr<Workplace> (*)(Desk&);

/// The workplaces of the program, in the order of their keys (Alt+1, Alt+2 ...).
[[nodiscard]] std::vector<MakeWorkplace> registered_workplaces();

}  // namespace nazori::ui
