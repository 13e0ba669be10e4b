// SPDX-License-Identifier: Apache-2.0
#include "study/period_picture.h"

#include <QBuffer>
#include <QDate>
#include <QGuiApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>

#include "nazori/base/file.h"
#include "nazori/widgets/look/ink_painting.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 70;
constexpr int kTitle_px = 46;
constexpr int kText_px = 24;
constexpr int kLargestTile = 150;
constexpr int kSmallestTile = 70;
constexpr std::size_t kMostInk = 300;
constexpr double kPen = 0.045;
constexpr int kDaysOfWeek = 7;

bool is_week(const practice::DaySpan& span) { return (span.last - span.first).count() == kDaysOfWeek - 1; }

QDate date_of(study::Day day) { return QDate(1970, 1, 1).addDays(day.time_since_epoch().count()); }

/// The larger the fewer: so that a short week is no stamp, and a long month no wall.
int tile_for(std::size_t count) {
  constexpr int kRoom = PeriodPicture::kWidth - 2 * kMargin;
  constexpr int kRoomDown = 900;
  for (int tile = kLargestTile; tile > kSmallestTile; tile -= 10) {
    const auto rows =
        (count + static_cast<std::size_t>(kRoom / tile) - 1) / static_cast<std::size_t>(kRoom / tile);
    if (rows * static_cast<std::size_t>(tile) <= kRoomDown) return tile;
  }
  return kSmallestTile;
}

}  // namespace

QString PeriodPicture::file_name(const practice::DaySpan& span) {
  const std::string day = study::to_text(span.first);
  return QStringLiteral("nazori-%1.png").arg(to_text(is_week(span) ? day : day.substr(0, day.rfind('-'))));
}

base::Result<QImage> PeriodPicture::draw(const study::LearnerStore& store, const practice::DaySpan& span) {
  const auto record = practice::writing_record(store, span.first, span.last);
  if (!record) return tl::unexpected(record.error());
  const auto inks = practice::inks_of(store, record->best_of_each(), kMostInk);
  if (!inks) return tl::unexpected(inks.error());
  if (inks->empty()) return QImage();
  const int tile = tile_for(inks->size());
  const int across = (kWidth - 2 * kMargin) / tile;
  const int rows = (static_cast<int>(inks->size()) + across - 1) / across;
  const int top = kMargin + kTitle_px * 2 + kText_px * 2;
  QImage picture(kWidth, top + rows * tile + 2 * kText_px + kMargin, QImage::Format_RGB32);
  const Colours& c = light_colours();
  picture.fill(c.paper);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = QGuiApplication::font();
  const auto write = [&](int y, int size, const QColor& colour, Qt::Alignment side, const QString& text) {
    font.setPixelSize(size);
    painter.setFont(font);
    painter.setPen(colour);
    painter.drawText(QRect(kMargin, y, kWidth - 2 * kMargin, size * 2), side | Qt::AlignTop, text);
  };
  const bool japanese = QLocale().language() == QLocale::Japanese;
  write(kMargin, kTitle_px, c.ink, Qt::AlignLeft,
        is_week(span) ? tr("Week of %1").arg(StudyWords::short_day(span.first))
                      : QLocale().toString(date_of(span.first), japanese ? QStringLiteral("yyyy年M月")
                                                                         : QStringLiteral("MMMM yyyy")));
  QStringList figures{
      tr("%n characters in my own hand", nullptr, static_cast<int>(record->best_of_each().size()))};
  if (!record->fresh.empty()) figures.append(tr("%n new", nullptr, static_cast<int>(record->fresh.size())));
  figures.append(tr("%n study days", nullptr, record->study_days));
  write(kMargin + kTitle_px * 3 / 2 + kText_px / 2, kText_px, c.muted, Qt::AlignLeft,
        figures.join(QStringLiteral(" · ")));
  const int left = (kWidth - across * tile) / 2;
  for (int i = 0; i < static_cast<int>(inks->size()); ++i) {
    const QRectF box(left + i % across * tile, top + i / across * tile, tile, tile);
    painter.setPen(QPen(c.line, 1));
    painter.setBrush(c.surface);
    painter.drawRoundedRect(box.adjusted(4, 4, -4, -4), 10, 10);
    paint_handwriting(painter, (*inks)[static_cast<std::size_t>(i)].ink, box.adjusted(12, 12, -12, -12),
                      c.ink, kPen);
  }
  write(top + rows * tile + kText_px, kText_px, c.muted, Qt::AlignRight, QStringLiteral("Nazori"));
  return picture;
}

base::Result<void> PeriodPicture::save(const QImage& picture, const std::filesystem::path& file) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG"))
    return base::fail(base::Errc::io, "cannot be written as PNG", file.string());
  return base::write_file(file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

}  // namespace nazori::ui
