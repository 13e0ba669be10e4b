// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "in_english.h"
#include "nazori/widgets/page/page.h"
#include "nazori/widgets/page/window_parts.h"
#include "print_qt.h"

namespace nazori::ui::test {

inline QString sentence(const char* text) { return QString::fromUtf8(text); }

/// A window for one page that has nothing else, with what the page says.
class PageTest : public testing::Test {
 protected:
  PageTest() {
    speak_english();
    const auto note = [this](Feedback kind, const QString& words) {
      kind_ = kind;
      said_.append(words);
    };
    QObject::connect(&parts_, &WindowParts::announced, &window_, note);
    QObject::connect(&parts_, &WindowParts::respond, &window_, note);
    QObject::connect(&parts_, &WindowParts::save_later, &window_, [this] { ++saves_; });
    QObject::connect(&parts_, &WindowParts::focus_tablet, &window_, [this] { ++focused_; });
  }
  /// Dialogs that a page left open end before what they use.
  ~PageTest() override { qDeleteAll(window_.findChildren<QDialog*>(Qt::FindDirectChildrenOnly)); }
  [[nodiscard]] QString file(const char* name) const { return folder_.filePath(QString::fromUtf8(name)); }
  [[nodiscard]] QString all_said() const { return said_.join(QLatin1Char('|')); }
  /// Writes the settings of a page as they are when the window closes.
  void keep_settings(const Page& page) {
    QSettings stored(parts_.settings_file(), QSettings::IniFormat);
    stored.beginGroup(page.id());
    page.save(stored);
  }
  /// Does this with the next dialog of this kind, as soon as it is there.
  template <class Dialog>
  void with_dialog(const std::function<void(Dialog&)>& what) {
    auto* again = new QTimer(&window_);
    QObject::connect(again, &QTimer::timeout, again, [what, again] {
      auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      again->stop();
      again->deleteLater();
      what(*dialog);
    });
    again->start(0);
  }
  /// Answers the next question.
  void answer(const char* name, const char* button) {
    with_dialog<QMessageBox>([name, button](QMessageBox& box) {
      EXPECT_EQ(box.objectName(), sentence(name));
      for (auto* one : box.buttons())
        if (one->text() == sentence(button)) return one->click();
      ADD_FAILURE() << button;
      box.reject();
    });
  }
  /// Chooses a file in the next dialog for files, or none.
  void choose_file(const QString& path, const std::function<void(QFileDialog&)>& look = {}) {
    with_dialog<QFileDialog>([path, look](QFileDialog& dialog) {
      if (look) look(dialog);
      if (path.isEmpty()) return static_cast<QDialog&>(dialog).reject();
      dialog.selectFile(path);
      static_cast<QDialog&>(dialog).accept();
    });
  }

  QTemporaryDir folder_;
  study::Time now_ = *study::parse_time("2026-03-02T10:00Z");
  QWidget window_;
  WindowParts parts_{
      window_,
      file("nazori.ini"),
      {file("learners").toStdString(),
       {std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db", file("own").toStdString()},
       [this] { return now_; }}};
  Feedback kind_ = Feedback::hint;
  QStringList said_;
  int saves_ = 0;
  int focused_ = 0;
};

/// The tools of a page in the order of the toolbar, with a star where the text is shown, too.
inline QString tools_of(const Page& page) {
  QStringList names;
  for (const auto& tool : page.tools())
    names.append(tool.action == nullptr ? QStringLiteral("-")
                                        : tool.action->objectName() + QLatin1String(tool.words ? "*" : ""));
  return names.join(QLatin1Char(' '));
}

}  // namespace nazori::ui::test
