// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/number_slider.h"

#include <QLabel>
#include <QLocale>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "nazori/widgets/controls/flow_layout.h"

namespace nazori::ui {
namespace {

constexpr int kGap = 8;

}  // namespace

NumberSlider::NumberSlider(const QString& name, const QString& object, double low, double high, double step,
                           const QString& unit, int decimals, QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal, this)),
      words_(new QLabel(this)),
      low_(low),
      step_(step),
      unit_(unit),
      decimals_(decimals) {
  auto* label = new QLabel(name, this);
  label->setBuddy(slider_);
  label->setWordWrap(true);
  slider_->setObjectName(object);
  slider_->setAccessibleName(name);
  words_->setObjectName(object + QStringLiteral("_value"));
  // Side by side if there is space, one below the other with large text.
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* line = new FlowLayout(kGap, 0);
  line->addWidget(label);
  line->addWidget(words_);
  column->addLayout(line);
  column->addWidget(slider_);
  set_range(low, high);
  connect(slider_, &QSlider::valueChanged, this, [this] {
    show_value();
    if (!silent_) emit moved(value());
  });
}

void NumberSlider::set_range(double low, double high) {
  silent_ = true;
  low_ = low;
  const int steps = static_cast<int>(std::lround((high - low) / step_));
  slider_->setRange(0, steps);
  slider_->setPageStep(std::max(1, steps / 10));
  silent_ = false;
  show_value();
}

void NumberSlider::set_value(double value) {
  silent_ = true;
  slider_->setValue(static_cast<int>(std::lround((value - low_) / step_)));
  silent_ = false;
  show_value();
}

double NumberSlider::value() const { return low_ + slider_->value() * step_; }

void NumberSlider::show_value() {
  const QString text = unit_.arg(QLocale().toString(value(), 'f', decimals_));
  words_->setText(text);
  slider_->setAccessibleDescription(text);
}

}  // namespace nazori::ui
