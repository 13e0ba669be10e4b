// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDBusVariant>
#include <QObject>
#include <optional>
#include <utility>

#include "nazori/widgets/look/theme.h"

namespace nazori::ui {

/// Gives the application its palette, style sheet and text size, and follows the desktop between light and
/// dark while the program runs. Made once, before anything else changes the palette.
class Appearance final : public QObject {
  Q_OBJECT
 public:
  explicit Appearance(QObject* parent = nullptr);

  void apply(ThemeChoice theme, int text_pt);
  [[nodiscard]] bool is_dark() const;

 signals:
  void changed();

 private slots:
  void desktop_setting_changed(const QString& group, const QString& key, const QDBusVariant& value);

 private:
  void ask_desktop();
  void use_desktop_scheme(const QVariant& value);

  bool palette_dark_;                ///< the desktop's palette, as Qt found it at start
  std::optional<bool> portal_dark_;  ///< the answer of the desktop's settings portal, if there is one
  ThemeChoice theme_ = ThemeChoice::desktop;
  int text_pt_ = kMinText_pt;
  std::optional<std::pair<bool, int>> applied_;  ///< dark, size of text: what all widgets have
};

}  // namespace nazori::ui
