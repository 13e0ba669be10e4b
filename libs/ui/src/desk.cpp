// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <utility>

namespace nazori::ui {

Desk::Desk(QWidget& window, const std::filesystem::path& database, QString settings_file)
    : window_(window),
      settings_file_(settings_file.isEmpty() ? Preferences::default_file() : std::move(settings_file)),
      preferences_(Preferences::load(settings_file_)),
      library_(database),
      judge_(database) {
  controller_.set_style(preferences_.style);
}

Desk::~Desk() = default;

void Desk::say(Feedback kind, const QString& sentence) {
  if (!sentence.isEmpty()) emit said(kind, sentence);
}

}  // namespace nazori::ui
