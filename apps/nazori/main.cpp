// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "nazori/author/collection.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/ui/program.h"

namespace {

constexpr int kExitBadUsage = 2;
constexpr int kExitFailed = 1;

/// One line on standard error. @return kExitBadUsage
int refuse(const QString& what) {
  std::fprintf(stderr, "nazori: %s\n", what.toUtf8().constData());
  return kExitBadUsage;
}

/// Qt aborts after some messages if the display does not answer; print one line instead and use the exit code
/// of other environment errors.
void print_no_display(QtMsgType type, const QMessageLogContext& /*context*/, const QString& /*text*/) {
  if (type != QtFatalMsg) return;
  std::_Exit(refuse(QStringLiteral("the display does not respond (DISPLAY=%1, WAYLAND_DISPLAY=%2); use "
                                   "nazori-cli instead")
                        .arg(qEnvironmentVariable("DISPLAY"), qEnvironmentVariable("WAYLAND_DISPLAY"))));
}

bool has_display() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

}  // namespace

int main(int argc, char** argv) {
  nazori::ui::Program::prepare();
  // Help must also work without a display, where Qt would abort.
  const QString unseen = has_display() ? QString() : QStringLiteral("offscreen");
  if (!unseen.isEmpty()) qputenv("QT_QPA_PLATFORM", unseen.toUtf8());
  const QtMessageHandler before = qInstallMessageHandler(print_no_display);
  QApplication application(argc, argv);
  qInstallMessageHandler(before);
  QApplication::setApplicationName(QStringLiteral("Nazori"));
  QApplication::setDesktopFileName(QStringLiteral("nazori"));
  QApplication::setApplicationVersion(QStringLiteral(NAZORI_VERSION));

  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Carved kanji you can see, feel and trace."));
  const auto help = parser.addHelpOption();
  const auto version = parser.addVersionOption();
  const QCommandLineOption exit_after_startup(
      QStringLiteral("exit-after-startup"),
      QStringLiteral("Open the window, wait for the first page, then exit."));
  parser.addOption(exit_after_startup);
  const QCommandLineOption now(
      QStringLiteral("now"),
      QStringLiteral(
          "Use this as the current time and continue from there: 2026-01-01T09:00Z or with +09:00. For "
          "trying out other study days; the environment variable NAZORI_NOW does the same."),
      QStringLiteral("time"));
  parser.addOption(now);
  parser.addPositionalArgument(
      QStringLiteral("character or files"),
      QStringLiteral("Character to open, or files: a plot, a height map, a stroke order file."),
      QStringLiteral("[character | file...]"));
  // The error is reported here in one line, because QCommandLineParser::process() would exit with 1.
  if (!parser.parse(QApplication::arguments())) {
    const QString given = parser.unknownOptionNames().value(0);
    return refuse(given.isEmpty() ? parser.errorText()
                                  : QStringLiteral("there is no option '%1' (see nazori --help)")
                                        .arg((given.size() > 1 ? QStringLiteral("--") : QStringLiteral("-")) +
                                             given.left(60)));
  }
  if (parser.isSet(version)) parser.showVersion();
  if (parser.isSet(help) || parser.isSet(QStringLiteral("help-all"))) parser.process(application);
  if (!unseen.isEmpty() && QApplication::platformName() == unseen) {
    return refuse(
        QStringLiteral("no display found (DISPLAY and WAYLAND_DISPLAY are not set); use "
                       "nazori-cli instead"));
  }

  nazori::ui::MainWindow::Setup setup;
  const auto arguments = parser.positionalArguments();
  const bool files = !arguments.isEmpty() && std::all_of(arguments.begin(), arguments.end(),
                                                         [](const auto& a) { return QFileInfo(a).isFile(); });
  if (!arguments.isEmpty() && !files) {
    const auto code_points = arguments.front().toUcs4();
    if (arguments.size() > 1 || code_points.size() != 1) {
      return refuse(QStringLiteral("give one character or existing files, for example: nazori 休"));
    }
    setup.character = static_cast<char32_t>(code_points.front());
  }
  if (parser.isSet(now)) qputenv("NAZORI_NOW", parser.value(now).toUtf8());
  const auto clock = nazori::study::environment_clock();
  if (!clock) {
    return refuse(QString::fromStdString(nazori::base::to_line(clock.error())));
  }
  setup.clock = *clock;
  const auto database = nazori::kanji::KanjiDatabase::locate();
  if (!database) {
    std::fprintf(stderr, "nazori: %s\n", nazori::base::to_line(database.error()).c_str());
    if (!parser.isSet(exit_after_startup)) nazori::ui::Program::show_failure(database.error());
    return kExitFailed;
  }
  setup.database = *database;
  setup.own_characters = nazori::author::Collection::usual_folder();

  nazori::ui::Program program(setup);
  program.show();
  if (files) program.window()->open_files(arguments);
  if (parser.isSet(exit_after_startup)) {
    QObject::connect(program.window(), &nazori::ui::MainWindow::opened, &application,
                     [&program] { QTimer::singleShot(0, program.window(), &QWidget::close); });
    constexpr int kPatience_ms = 30000;
    QTimer::singleShot(kPatience_ms, &application, [] { QApplication::exit(kExitFailed); });
  }
  return QApplication::exec();
}
