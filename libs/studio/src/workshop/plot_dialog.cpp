// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/plot_dialog.h"

#include <QDialogButtonBox>
#include <QFontInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/plot_text.h"

namespace nazori::ui {
namespace {

constexpr int kBorderDigits = 10;

}  // namespace

PlotDialog::PlotDialog(base::Inbox& inbox, functions::PlotModel model, const QString& expression, int side,
                       QWidget* parent)
    : QDialog(parent),
      model_(std::move(model)),
      side_(side),
      line_(named(new QLineEdit(expression, this), "plot_expression", tr("Expression"))),
      words_(sentence_label("plot_words", this)),
      progress_(named(new QProgressBar(this), "plot_progress", tr("Drawing"))),
      spoken_(new SpokenLine(this)),
      plotter_(inbox, [](functions::Drawing&& drawing) -> base::Result<Drawn> {
        return Drawn{std::make_shared<const surface::HeightMap>(std::move(drawing.picture.plate.heights)),
                     drawing.final};
      }) {
  setObjectName(QStringLiteral("plot_dialog"));
  setWindowTitle(tr("A function plot"));
  line_->setPlaceholderText(QStringLiteral("y = sin x"));
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Expression"), line_);
  const QString names[] = {tr("x from"), tr("x to"), tr("y from"), tr("y to")};
  const char* ids[] = {"plot_x0", "plot_x1", "plot_y0", "plot_y1"};
  const auto& range = model_.window();
  const double values[] = {range.x0, range.x1, range.y0, range.y1};
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    borders_[i] = named(new QLineEdit(number_text(values[i], kBorderDigits), this), ids[i], names[i]);
    form->addRow(names[i], borders_[i]);
    connect(borders_[i], &QLineEdit::textEdited, this, &PlotDialog::stop);
  }
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  QSizePolicy keeps = progress_->sizePolicy();
  keeps.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(keeps);
  progress_->hide();
  auto* buttons = dialog_buttons(QDialogButtonBox::Cancel, this);
  draw_ = named(buttons->addButton(tr("&Make the relief"), QDialogButtonBox::ActionRole), "plot_draw");
  draw_->setDefault(true);
  auto* all = new QVBoxLayout(this);
  all->addLayout(form);
  all->addWidget(words_);
  all->addWidget(progress_);
  all->addWidget(buttons);

  connect(draw_, &QPushButton::clicked, this, &PlotDialog::draw);
  connect(line_, &QLineEdit::textChanged, this, &PlotDialog::read_expression);
  subscribe(plotter_.progressed, this,
            [this](double done) { progress_->setValue(static_cast<int>(std::lround(done * 100))); });
  subscribe(plotter_.drawn, this, [this](const Drawn& drawn) {
    if (!drawn.is_final) return;
    relief_ = drawn.relief;
    accept();
  });
  subscribe(plotter_.failed, this, [this](const base::Error& error) {
    stop();
    say(tr("This cannot be drawn: %1.").arg(reason(error)), true);
  });
  read_expression();
  line_->selectAll();
  // Room for a longer expression.
  constexpr int kWidth_em = 28;
  resize(QFontInfo(font()).pixelSize() * kWidth_em, sizeHint().height());
}

PlotDialog::~PlotDialog() = default;

QString PlotDialog::expression() const { return QString::fromStdString(model_.expression()); }

void PlotDialog::say(const QString& sentence, bool wrong) {
  words_->setText(wrong ? QStringLiteral("✗ ") + sentence : sentence);
  if (wrong) spoken_->speak(Urgency::at_once, sentence);
}

void PlotDialog::read_expression() {
  stop();
  const auto read = model_.read(line_->text().toStdString(), {uses_decimal_comma()});
  error_ = read ? QString() : syntax_error_words(read.error());
  const QString words =
      read ? localised(functions::in_words(*model_.plot(), plot_language(), plot_speech())) : error_;
  words_->setText(read ? words : QStringLiteral("✗ ") + words);
  line_->setAccessibleDescription(words);
}

bool PlotDialog::read_range() {
  functions::Window typed;
  double* values[] = {&typed.x0, &typed.x1, &typed.y0, &typed.y1};
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    const auto value = functions::read_number(borders_[i]->text().toStdString(), {uses_decimal_comma()});
    if (!value) {
      borders_[i]->setFocus(Qt::OtherFocusReason);
      say(tr("“%1” is not a number.").arg(borders_[i]->text()), true);
      return false;
    }
    *values[i] = *value;
  }
  const auto started = model_.start_with(typed);
  if (!started) say(tr("This range cannot be shown: %1.").arg(reason(started.error())), true);
  return started.has_value();
}

void PlotDialog::draw() {
  if (!error_.isEmpty()) {
    line_->setFocus(Qt::OtherFocusReason);
    return say(error_, true);
  }
  if (!read_range()) return;
  auto request = model_.request(plot_language(), plot_speech());
  request.plate.size = side_;
  draw_->setEnabled(false);
  progress_->setValue(0);
  progress_->show();
  plotter_.draw(std::move(request));
}

void PlotDialog::stop() {
  plotter_.stop();
  progress_->hide();
  draw_->setEnabled(true);
}

}  // namespace nazori::ui
