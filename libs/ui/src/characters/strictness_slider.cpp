// SPDX-License-Identifier: Apache-2.0
#include "characters/strictness_slider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {

StrictnessSlider::StrictnessSlider(QWidget* parent)
    : QWidget(parent),
      slider_(named(new QSlider(Qt::Horizontal, this), "strictness", tr("Strictness"))),
      words_(text_label("strictness_words", this)) {
  auto* name = new QLabel(tr("Str&ictness"), this);
  name->setBuddy(slider_);
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 4);
  slider_->setTickInterval(kSteps / 2);
  slider_->setTickPosition(QSlider::TicksBelow);
  slider_->setToolTip(tr("How strictly your writing is checked (Ctrl+[ and Ctrl+])"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new FlowLayout(12, 0);
  row->addWidget(name);
  row->addWidget(words_);
  column->addLayout(row);
  column->addWidget(slider_);
  auto* scale = new QHBoxLayout;
  scale->setSpacing(4);
  const auto mark = [&](const QString& text, Qt::Alignment side) {
    auto* label = with_role(new QLabel(text, this), "muted");
    label->setAlignment(side | Qt::AlignTop);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    scale->addWidget(label, 1);
    marks_.append(label);
  };
  mark(tr("lenient"), Qt::AlignLeft);
  mark(tr("normal"), Qt::AlignHCenter);
  mark(tr("strict"), Qt::AlignRight);
  column->addLayout(scale);
  connect(slider_, &QSlider::valueChanged, this, [this] {
    show_words();
    if (!silent_) emit moved(strictness());
  });
  set_strictness(0.5);
}

void StrictnessSlider::set_strictness(double strictness) {
  silent_ = true;
  slider_->setValue(static_cast<int>(std::lround(strictness * kSteps)));
  silent_ = false;
  show_words();
}

double StrictnessSlider::strictness() const { return static_cast<double>(slider_->value()) / kSteps; }

void StrictnessSlider::step(int by) { slider_->setValue(slider_->value() + by); }

QString StrictnessSlider::words() const {
  const int value = slider_->value();
  if (value == 0) return tr("lenient");
  if (value == kSteps) return tr("strict");
  if (value == kSteps / 2) return tr("normal");
  return value < kSteps / 2 ? tr("fairly lenient") : tr("fairly strict");
}

void StrictnessSlider::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  // With large text there is no space for these labels. The words above say the same.
  const bool fit = std::all_of(marks_.begin(), marks_.end(), [this](const QLabel* mark) {
    return mark->sizeHint().width() <= width() / static_cast<int>(marks_.size());
  });
  for (auto* mark : marks_) mark->setVisible(fit);
}

void StrictnessSlider::show_words() {
  words_->setText(words());
  slider_->setAccessibleDescription(words());
}

}  // namespace nazori::ui
