// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/dialogs/save_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {

SaveDialog::SaveDialog(int fixed_size, bool has_strokes, QWidget* parent)
    : QDialog(parent),
      format_(named(new QComboBox(this), "save_format")),
      size_(named(new QComboBox(this), "save_size")) {
  setObjectName(QStringLiteral("save_dialog"));
  setWindowTitle(tr("Save the tablet"));
  format_->addItem(tr("Height map, 8-bit RAW (2005 format)"), static_cast<int>(practice::FileFormat::raw));
  format_->addItem(tr("Height map, 16-bit PNG"), static_cast<int>(practice::FileFormat::png));
  if (has_strokes)
    format_->addItem(tr("Stroke order, .str (2005 format)"), static_cast<int>(practice::FileFormat::strokes));
  if (fixed_size > 0) {
    size_->addItem(tr("%1 × %1").arg(fixed_size), fixed_size);
    size_->setEnabled(false);
  } else {
    for (const int side : {128, 256, 512, 1024, 2048})
      size_->addItem(side == practice::TabletWorkshop::kClassicSize ? tr("%1 × %1 (2005 format)").arg(side)
                                                                    : tr("%1 × %1").arg(side),
                     side);
  }
  auto* buttons = dialog_buttons(QDialogButtonBox::Cancel, this);
  auto* choose = buttons->addButton(tr("Choose file…"), QDialogButtonBox::AcceptRole);
  choose->setDefault(true);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 20, 20, 16);
  form->setSpacing(12);
  form->addRow(tr("&Format"), format_);
  form->addRow(tr("&Size"), size_);
  form->addRow(buttons);
}

practice::FileFormat SaveDialog::format() const {
  return static_cast<practice::FileFormat>(format_->currentData().toInt());
}

int SaveDialog::size() const { return size_->currentData().toInt(); }

QString SaveDialog::filter(practice::FileFormat format) {
  switch (format) {
    case practice::FileFormat::raw:
      return tr("Height maps (*.raw)");
    case practice::FileFormat::png:
      return tr("Pictures (*.png)");
    case practice::FileFormat::strokes:
      return tr("Stroke order files (*.str)");
  }
  return {};
}

QString SaveDialog::suffix(practice::FileFormat format) {
  switch (format) {
    case practice::FileFormat::raw:
      return QStringLiteral("raw");
    case practice::FileFormat::png:
      return QStringLiteral("png");
    case practice::FileFormat::strokes:
      return QStringLiteral("str");
  }
  return {};
}

}  // namespace nazori::ui
