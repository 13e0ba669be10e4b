// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/settings/stored_settings.h"

#include "nazori/widgets/words/kanji_text.h"

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

practice::TabletRecording::UnfinishedFiles unfinished_recordings(const QString& settings_file) {
  static const QString key = QStringLiteral("recording/unfinished");
  const auto read = [settings_file] {
    const QStringList list = QSettings(settings_file, QSettings::IniFormat).value(key).toStringList();
    std::vector<std::string> files;
    files.reserve(static_cast<std::size_t>(list.size()));
    for (const QString& file : list) files.push_back(file.toStdString());
    return files;
  };
  const auto write = [settings_file](const std::vector<std::string>& files) {
    QSettings settings(settings_file, QSettings::IniFormat);
    QStringList list;
    for (const auto& file : files) list.append(to_text(file));
    if (list.isEmpty())
      settings.remove(key);
    else
      settings.setValue(key, list);
  };
  return {read, write};
}

}  // namespace nazori::ui
