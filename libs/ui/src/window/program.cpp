// SPDX-License-Identifier: Apache-2.0
#include "nazori/ui/program.h"

#include <QApplication>
#include <QMessageBox>
#include <QSurfaceFormat>
#include <utility>

#include "nazori/widgets/look/appearance.h"
#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/settings/preferences.h"
#include "nazori/widgets/tablet/tablet_window.h"
#include "nazori/widgets/words/error_text.h"
#include "window/language.h"

namespace nazori::ui {

Program::Program(MainWindow::Setup setup) : setup_(std::move(setup)) {
  if (setup_.settings_file.isEmpty()) setup_.settings_file = Preferences::default_file();
  install_language(Preferences::load(setup_.settings_file).language);
  appearance_ = std::make_unique<Appearance>();
  QApplication::setWindowIcon(program_icon());
}

Program::~Program() = default;

void Program::prepare() {
  QSurfaceFormat::setDefaultFormat(TabletWindow::surface_format());
  // Every event of mouse and pen is needed: a fast stroke has only few.
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
  QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
}

void Program::show() { open_window(); }

void Program::open_window() {
  // The old window holds the learner's store open, and the new one needs it.
  const bool quits = QApplication::quitOnLastWindowClosed();
  QApplication::setQuitOnLastWindowClosed(false);
  window_.reset();
  window_ = std::make_unique<MainWindow>(setup_, *appearance_);
  setup_.character = 0;
  setup_.page.clear();
  connect(
      window_.get(), &MainWindow::language_chosen, this,
      [this] {
        // The new window opens on the page of the old one.
        const auto preferences = Preferences::load(setup_.settings_file);
        install_language(preferences.language);
        setup_.page = preferences.page;
        open_window();
      },
      Qt::QueuedConnection);
  window_->show();
  QApplication::setQuitOnLastWindowClosed(quits);
}

void Program::show_failure(const base::Error& error) {
  install_language({});
  QMessageBox box(QMessageBox::Critical, QStringLiteral("Nazori"),
                  tr("Nazori cannot start: %1.").arg(reason(error)), QMessageBox::Close);
  box.exec();
}

}  // namespace nazori::ui
