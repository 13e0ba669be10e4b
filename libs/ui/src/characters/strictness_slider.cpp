// SPDX-License-Identifier: Apache-2.0
#include "characters/strictness_slider.h"

#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <cmath>

namespace nazori::ui {

StrictnessSlider::StrictnessSlider(QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal, this)), words_(new QLabel(this)) {
  auto* name = new QLabel(tr("&Judged"), this);
  name->setBuddy(slider_);
  slider_->setObjectName(QStringLiteral("strictness"));
  slider_->setAccessibleName(tr("Strictness"));
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 4);
  slider_->setTickInterval(kSteps / 2);
  slider_->setTickPosition(QSlider::TicksBelow);
  slider_->setToolTip(tr("How strictly writing is judged (Ctrl+[ and Ctrl+])"));
  words_->setObjectName(QStringLiteral("strictness_words"));
  words_->setWordWrap(true);
  words_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(0);
  grid->addWidget(name, 0, 0);
  grid->addWidget(words_, 0, 1, 1, 2);
  grid->addWidget(slider_, 1, 0, 1, 3);
  const auto mark = [&](const QString& text, int column, Qt::Alignment side) {
    auto* label = new QLabel(text, this);
    label->setProperty("role", QStringLiteral("muted"));
    label->setAlignment(side | Qt::AlignTop);
    grid->addWidget(label, 2, column);
    grid->setColumnStretch(column, 1);
  };
  mark(tr("lenient"), 0, Qt::AlignLeft);
  mark(tr("normal"), 1, Qt::AlignHCenter);
  mark(tr("strict"), 2, Qt::AlignRight);
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
  if (value == 0) return tr("leniently");
  if (value == kSteps) return tr("strictly");
  if (value == kSteps / 2) return tr("as a teacher does");
  return value < kSteps / 2 ? tr("rather leniently") : tr("rather strictly");
}

void StrictnessSlider::show_words() {
  words_->setText(words());
  slider_->setAccessibleDescription(words());
}

}  // namespace nazori::ui
