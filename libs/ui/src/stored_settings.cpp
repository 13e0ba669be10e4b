// SPDX-License-Identifier: Apache-2.0
#include "stored_settings.h"

#include "kanji_text.h"

namespace nazori::ui {

base::Settings read_settings(const QSettings& settings) {
  base::Settings values;
  for (const QString& key : settings.allKeys())
    values.emplace(key.toStdString(), settings.value(key).toString().toStdString());
  return values;
}

void write_settings(QSettings& settings, const base::Settings& values) {
  const base::Settings before = read_settings(settings);
  for (const auto& [key, value] : before)
    if (!values.contains(key)) settings.remove(to_text(key));
  for (const auto& [key, value] : values)
    if (const auto at = before.find(key); at == before.end() || at->second != value)
      settings.setValue(to_text(key), to_text(value));
}

}  // namespace nazori::ui
