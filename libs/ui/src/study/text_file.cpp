// SPDX-License-Identifier: Apache-2.0
#include "study/text_file.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QLabel>

#include "nazori/base/file.h"
#include "nazori/widgets/words/error_text.h"

namespace nazori::ui {
namespace {

constexpr std::size_t kLargestFile = 1'000'000;

}  // namespace

std::optional<TextFile> ask_text_file(QWidget* parent, const QString& title, QLabel& trouble) {
  const QString path = QFileDialog::getOpenFileName(
      parent, title, {},
      QCoreApplication::translate("nazori::ui::NewListDialog",
                                  "Text files (*.txt *.csv *.tsv);;All files (*)"));
  if (path.isEmpty()) return std::nullopt;
  const auto bytes = base::read_file(path.toStdString(), kLargestFile);
  if (!bytes) {
    trouble.setText(reason(bytes.error()));
    return std::nullopt;
  }
  return TextFile{path, QString::fromUtf8(reinterpret_cast<const char*>(bytes->data()),
                                          static_cast<qsizetype>(bytes->size()))};
}

}  // namespace nazori::ui
