// SPDX-License-Identifier: Apache-2.0
#include "characters/writing_panel.h"

#include <QEvent>
#include <QFontInfo>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "characters/compare_view.h"
#include "characters/strictness_slider.h"
#include "characters/writing_report.h"
#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {
namespace {

constexpr int kLeastLines = 7;
constexpr int kMostPerCent = 62;  // of the height of the side
constexpr int kUsualWidth = 280;

}  // namespace

WritingPanel::WritingPanel(QWidget* parent)
    : QScrollArea(parent),
      content_(named(new QWidget(this), "writing_content")),
      strictness_(new StrictnessSlider(content_)),
      compare_(new CompareView(content_)),
      report_(new WritingReport(content_)) {
  setObjectName(QStringLiteral("writing_panel"));
  setAccessibleName(tr("Your writing"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  setFocusPolicy(Qt::TabFocus);
  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(12, 12, 12, 12);
  column->setSpacing(10);
  column->addWidget(strictness_);
  column->addWidget(compare_);
  column->addWidget(report_);
  setWidget(content_);
  compare_->hide();
  report_->hide();
  content_->installEventFilter(this);
}

void WritingPanel::set_compare_shown(bool shown) { compare_->setVisible(shown); }

void WritingPanel::set_report_shown(bool shown) { report_->setVisible(shown); }

QSize WritingPanel::sizeHint() const {
  const int width = viewport()->width() > 0 ? viewport()->width() : kUsualWidth;
  const int wanted = content_->layout()->totalHeightForWidth(width) + 2 * frameWidth();
  const int most = parentWidget() != nullptr ? parentWidget()->height() * kMostPerCent / 100 : wanted;
  return {kUsualWidth, std::min(wanted, std::max(most, QFontInfo(font()).pixelSize() * kLeastLines))};
}

QSize WritingPanel::minimumSizeHint() const {
  const int least = QFontInfo(font()).pixelSize() * kLeastLines;
  return {content_->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
          std::min(least, sizeHint().height())};
}

bool WritingPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == content_ && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

void WritingPanel::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  // At another width the text wraps differently and needs another height.
  updateGeometry();
}

}  // namespace nazori::ui
