// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <vector>

#include "nazori/kanji/kanji_database.h"

namespace nazori::ui {

/// Version, licences, and the published sources that the kanji database was built from.
class AboutDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit AboutDialog(const std::vector<kanji::Source>& sources, QWidget* parent);
};

}  // namespace nazori::ui
