// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QImage>
#include <filesystem>

#include "nazori/base/result.h"
#include "nazori/practice/day_record.h"

namespace nazori::ui {

/// A picture of what was written in a week or a month: the learner's own ink, one writing of each character,
/// with figures above it. Always in the light colours.
class PeriodPicture {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::PeriodPicture)
 public:
  static constexpr int kWidth = 1200;  ///< of every picture

  /// @return a null image where nothing was written from memory; the errors of the store.
  [[nodiscard]] static base::Result<QImage> draw(const study::LearnerStore& store,
                                                 const practice::DaySpan& span);
  /// "nazori-2026-11-16.png" for a week, "nazori-2026-11.png" for a month.
  [[nodiscard]] static QString file_name(const practice::DaySpan& span);
  /// Writes a PNG file beside the final one and renames it. @return the errors of base::write_file().
  [[nodiscard]] static base::Result<void> save(const QImage& picture, const std::filesystem::path& file);
};

}  // namespace nazori::ui
