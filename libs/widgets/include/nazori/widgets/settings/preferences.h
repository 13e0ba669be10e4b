// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QList>
#include <QString>
#include <cstdint>

#include "nazori/kanji/kanji_database.h"
#include "nazori/view/tablet_view.h"
#include "nazori/widgets/look/theme.h"

namespace nazori::ui {

/// The hand whose keys a session uses; none: keys for both hands.
enum class OneHand : std::uint8_t { none, left, right };

/// The settings of the window that are stored between runs.
struct Preferences {
  static constexpr int kMinText_pt = ui::kMinText_pt;
  static constexpr int kMaxText_pt = ui::kMaxText_pt;

  QByteArray geometry;     ///< QWidget::saveGeometry
  QList<int> pane_widths;  ///< of the left and the right panel as last dragged; empty: as wide as may be
  char32_t kanji = U'休';
  kanji::List list = kanji::List::grade_1;
  bool left_open = true;
  bool right_open = true;
  QString page;  ///< Page::id of the last page; empty: the first
  bool strokes_visible = true;
  bool numbers_visible = true;
  bool arrows_visible = true;
  bool snapping = false;
  bool groove_sound = false;
  double sound_volume = 0.5;  ///< 0..1
  bool speaks = true;         ///< readings are spoken by themselves
  QString voice;              ///< name of a speech::VoiceKind; empty: automatic
  QString voice_file;         ///< of Open JTalk; empty: the first that is installed
  bool slope_help = false;    ///< the mouse slows down on slopes
  view::Style style = view::Style::wood;
  view::WritingCross cross = view::WritingCross::none;
  ThemeChoice theme = ThemeChoice::desktop;
  int text_pt = kMinText_pt;
  bool reduced_motion = false;
  QString language;                             ///< "en", "ja"; empty: the desktop's
  QString profile = QStringLiteral("learner");  ///< the learner
  bool asks_by_words = true;                    ///< some reviews ask by a word with the character left out
  bool left_handed = false;                     ///< the panels beside the tablet change sides
  OneHand one_hand = OneHand::none;             ///< keys of a session within reach of one hand
  bool begin_at_home = true;                    ///< the window opens with Home, not with the last page
  QStringList skipped_start;                    ///< learners who skipped the questions of the first start
  QString folder;                               ///< where the last file was opened or saved

  /// The folder in which a file dialog begins.
  [[nodiscard]] QString start_folder() const;
  /// Reads an INI file. A missing or invalid value keeps its default.
  [[nodiscard]] static Preferences load(const QString& file);
  /// @return false where the file cannot be written.
  bool save(const QString& file) const;
  /// nazori/nazori.ini in the XDG config home.
  [[nodiscard]] static QString default_file();
};

}  // namespace nazori::ui
