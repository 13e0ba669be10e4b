// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/settings/preferences.h"

#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

/// The value of an enumeration whose name is stored; anything else gives `fallback`.
template <class Enum, std::size_t N>
Enum read_name(const QSettings& ini, const QString& key, const char* const (&names)[N], Enum fallback) {
  const QString text = ini.value(key).toString();
  for (std::size_t i = 0; i < N; ++i)
    if (text == QLatin1String(names[i])) return static_cast<Enum>(i);
  return fallback;
}

constexpr const char* kStyles[] = {"classic", "wood", "slate"};
constexpr const char* kCrosses[] = {"none", "halves", "quarters"};
constexpr const char* kHands[] = {"none", "left", "right"};
constexpr const char* kThemes[] = {"desktop", "light", "dark"};
constexpr const char* kLists[] = {"grade_1",          "grade_2",   "grade_3",   "grade_4",  "grade_5",
                                  "grade_6",          "secondary", "jinmeiyou", "hiragana", "katakana",
                                  "latin_and_digits", "own",       "all"};

}  // namespace

QString Preferences::default_file() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
         QStringLiteral("/nazori/nazori.ini");
}

QString Preferences::start_folder() const {
  return folder.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::HomeLocation) : folder;
}

Preferences Preferences::load(const QString& file) {
  const QSettings ini(file, QSettings::IniFormat);
  Preferences p;
  p.geometry = ini.value(QStringLiteral("window/geometry")).toByteArray();
  for (const auto& width : ini.value(QStringLiteral("window/pane_widths")).toStringList())
    p.pane_widths.append(std::max(width.toInt(), 0));
  if (p.pane_widths.size() != 2) p.pane_widths.clear();
  const auto kanji = ini.value(QStringLiteral("tablet/kanji")).toString().toUcs4();
  if (kanji.size() == 1) p.kanji = static_cast<char32_t>(kanji.front());
  p.list = read_name(ini, QStringLiteral("library/list"), kLists, p.list);
  p.left_open = ini.value(QStringLiteral("library/open"), p.left_open).toBool();
  p.right_open = ini.value(QStringLiteral("information/open"), p.right_open).toBool();
  p.page = ini.value(QStringLiteral("window/workplace")).toString();
  p.strokes_visible = ini.value(QStringLiteral("tablet/strokes"), p.strokes_visible).toBool();
  p.numbers_visible = ini.value(QStringLiteral("tablet/numbers"), p.numbers_visible).toBool();
  p.arrows_visible = ini.value(QStringLiteral("tablet/arrows"), p.arrows_visible).toBool();
  p.snapping = ini.value(QStringLiteral("tablet/snapping"), p.snapping).toBool();
  p.groove_sound = ini.value(QStringLiteral("sound/groove"), p.groove_sound).toBool();
  p.sound_volume = std::clamp(ini.value(QStringLiteral("sound/volume"), p.sound_volume).toDouble(), 0.0, 1.0);
  p.speaks = ini.value(QStringLiteral("speech/on"), p.speaks).toBool();
  p.voice = ini.value(QStringLiteral("speech/voice")).toString();
  p.voice_file = ini.value(QStringLiteral("speech/voice_file")).toString();
  p.slope_help = ini.value(QStringLiteral("tablet/slope_help"), p.slope_help).toBool();
  p.style = read_name(ini, QStringLiteral("tablet/style"), kStyles, p.style);
  p.cross = read_name(ini, QStringLiteral("tablet/cross"), kCrosses, p.cross);
  p.theme = read_name(ini, QStringLiteral("window/theme"), kThemes, p.theme);
  p.text_pt =
      std::clamp(ini.value(QStringLiteral("window/text_pt"), p.text_pt).toInt(), kMinText_pt, kMaxText_pt);
  p.reduced_motion = ini.value(QStringLiteral("window/reduced_motion"), p.reduced_motion).toBool();
  p.language = ini.value(QStringLiteral("window/language")).toString();
  if (p.language != QLatin1String("en") && p.language != QLatin1String("ja")) p.language.clear();
  p.profile = ini.value(QStringLiteral("study/profile"), p.profile).toString();
  p.asks_by_words = ini.value(QStringLiteral("study/asks_by_words"), p.asks_by_words).toBool();
  p.left_handed = ini.value(QStringLiteral("window/left_handed"), p.left_handed).toBool();
  p.one_hand = read_name(ini, QStringLiteral("study/one_hand"), kHands, p.one_hand);
  p.begin_at_home = ini.value(QStringLiteral("study/begin_at_home"), p.begin_at_home).toBool();
  p.skipped_start = ini.value(QStringLiteral("study/skipped_start")).toStringList();
  p.folder = ini.value(QStringLiteral("files/folder")).toString();
  return p;
}

bool Preferences::save(const QString& file) const {
  QSettings ini(file, QSettings::IniFormat);
  QStringList widths;
  for (const int width : pane_widths) widths.append(QString::number(width));
  ini.setValue(QStringLiteral("window/geometry"), geometry);
  ini.setValue(QStringLiteral("window/pane_widths"), widths);
  ini.setValue(QStringLiteral("window/theme"), QLatin1String(kThemes[static_cast<std::size_t>(theme)]));
  ini.setValue(QStringLiteral("window/text_pt"), text_pt);
  ini.setValue(QStringLiteral("window/reduced_motion"), reduced_motion);
  ini.setValue(QStringLiteral("window/language"), language);
  ini.setValue(QStringLiteral("library/list"), QLatin1String(kLists[static_cast<std::size_t>(list)]));
  ini.setValue(QStringLiteral("library/open"), left_open);
  ini.setValue(QStringLiteral("information/open"), right_open);
  ini.setValue(QStringLiteral("window/workplace"), page);
  ini.setValue(QStringLiteral("tablet/kanji"), to_text(kanji));
  ini.setValue(QStringLiteral("tablet/strokes"), strokes_visible);
  ini.setValue(QStringLiteral("tablet/numbers"), numbers_visible);
  ini.setValue(QStringLiteral("tablet/arrows"), arrows_visible);
  ini.setValue(QStringLiteral("tablet/snapping"), snapping);
  ini.setValue(QStringLiteral("sound/groove"), groove_sound);
  ini.setValue(QStringLiteral("sound/volume"), sound_volume);
  ini.setValue(QStringLiteral("speech/on"), speaks);
  ini.setValue(QStringLiteral("speech/voice"), voice);
  ini.setValue(QStringLiteral("speech/voice_file"), voice_file);
  ini.setValue(QStringLiteral("tablet/slope_help"), slope_help);
  ini.setValue(QStringLiteral("tablet/style"), QLatin1String(kStyles[static_cast<std::size_t>(style)]));
  ini.setValue(QStringLiteral("tablet/cross"), QLatin1String(kCrosses[static_cast<std::size_t>(cross)]));
  ini.setValue(QStringLiteral("study/profile"), profile);
  ini.setValue(QStringLiteral("study/asks_by_words"), asks_by_words);
  ini.setValue(QStringLiteral("window/left_handed"), left_handed);
  ini.setValue(QStringLiteral("study/one_hand"), QLatin1String(kHands[static_cast<std::size_t>(one_hand)]));
  ini.setValue(QStringLiteral("study/begin_at_home"), begin_at_home);
  ini.setValue(QStringLiteral("study/skipped_start"), skipped_start);
  ini.setValue(QStringLiteral("files/folder"), folder);
  ini.sync();
  return ini.status() == QSettings::NoError;
}

}  // namespace nazori::ui
