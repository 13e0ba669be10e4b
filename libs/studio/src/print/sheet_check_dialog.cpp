// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/sheet_check_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "nazori/studio/print/photo_view.h"
#include "nazori/studio/print/sheet_words.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

QString name_of(const std::filesystem::path& path) { return to_text(path.filename().string()); }

}  // namespace

SheetCheckDialog::SheetCheckDialog(WindowParts& parts, QWidget* parent)
    : QDialog(parent),
      parts_(parts),
      photos_(named(new QComboBox(this), "sheet_photos", tr("Photograph"))),
      cells_(named(new QListWidget(this), "sheet_cells", tr("Cells that need care"))),
      view_(named(new PhotoView(this), "sheet_picture", tr("The photograph with its cells"))),
      words_(sentence_label("sheet_check_words", this)),
      spoken_(new SpokenLine(this)),
      reader_(parts.inbox(), parts.learner().source()) {
  setObjectName(QStringLiteral("sheet_check_dialog"));
  setWindowTitle(tr("Check worksheets"));
  constexpr int kLetters = 16;
  make_narrow(photos_, kLetters);
  cells_->setWordWrap(true);
  auto* side = new QVBoxLayout;
  side->addWidget(photos_);
  side->addWidget(heading(tr("Cells that need care"), this));
  side->addWidget(cells_, 1);
  side->addWidget(text_label("sheet_order_words", this, "muted"));
  findChild<QLabel*>(QStringLiteral("sheet_order_words"))
      ->setText(tr("Stroke order and direction cannot be seen in a photograph."));
  auto* sides = new QHBoxLayout;
  sides->setSpacing(12);
  sides->addLayout(side, 2);
  sides->addWidget(view_, 3);
  auto* buttons = dialog_buttons(QDialogButtonBox::Close, this);
  open_ = named(buttons->addButton(tr("&Open photographs…"), QDialogButtonBox::ActionRole), "sheet_open");
  save_ = named(buttons->addButton(tr("&Save the picture…"), QDialogButtonBox::ActionRole), "sheet_save");
  save_->setEnabled(false);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(16, 16, 16, 12);
  all->addLayout(sides, 1);
  all->addWidget(words_);
  all->addWidget(buttons);

  connect(photos_, &QComboBox::currentIndexChanged, this, &SheetCheckDialog::show_photo);
  connect(cells_, &QListWidget::currentRowChanged, this, &SheetCheckDialog::mark_cell);
  connect(open_, &QPushButton::clicked, this, &SheetCheckDialog::ask_photos);
  connect(save_, &QPushButton::clicked, this, &SheetCheckDialog::ask_and_save);
  subscribe(reader_.was_read, this,
            [this](const std::shared_ptr<const practice::WorksheetsRead>& photo) { show_read(photo); });
  subscribe(reader_.saved, this,
            [this](const std::filesystem::path& path) { say(tr("Saved %1.").arg(name_of(path)), false); });
  subscribe(reader_.refused, this, [this](const std::filesystem::path& path, const base::Error& error) {
    say(QStringLiteral("%1: %2.").arg(name_of(path), reason(error)), true);
  });
  if (parent != nullptr) {
    const int em = QFontInfo(font()).pixelSize();
    resize(QSize(em * 62, em * 46).boundedTo(parent->size() * 0.95));
  }
}

SheetCheckDialog::~SheetCheckDialog() = default;

void SheetCheckDialog::read(const QStringList& photos) {
  for (const QString& photo : photos) reader_.read(photo.toStdString());
  say(tr("Reading %n photographs…", nullptr, static_cast<int>(photos.size())), false);
}

void SheetCheckDialog::show_read(const std::shared_ptr<const practice::WorksheetsRead>& photo) {
  read_.push_back(photo);
  {
    const QSignalBlocker quiet(photos_);
    photos_->addItem(name_of(photo->photo));
  }
  photos_->setCurrentIndex(photos_->count() - 1);
  // The first entry of an empty box becomes the current one while signals are blocked.
  show_photo(photos_->count() - 1);
}

void SheetCheckDialog::show_photo(int number) {
  if (number < 0 || number >= static_cast<int>(read_.size())) return;
  const auto& photo = *read_[static_cast<std::size_t>(number)];
  const QSignalBlocker quiet(cells_);
  cells_->clear();
  listed_.clear();
  QStringList sentences;
  for (const auto& sheet : photo.sheets) {
    sentences.append(sheet_words(sheet));
    for (std::size_t i = 0; i < sheet.cells.size(); ++i) {
      if (!needs_care(sheet.cells[i])) continue;
      const bool legible = sheet.cells[i].state == scan::CellState::legible;
      cells_->addItem((legible ? QStringLiteral("⚠ ") : QStringLiteral("✗ ")) +
                      cell_words(i + 1, sheet.cells[i]));
      listed_.push_back(&sheet.cells[i]);
    }
  }
  const QString sentence = sentences.join(QLatin1Char(' '));
  view_->show_picture(photo.picture, sentence);
  save_->setEnabled(true);
  say(sentence, false);
}

void SheetCheckDialog::mark_cell(int row) {
  if (row < 0 || row >= static_cast<int>(listed_.size())) return view_->mark({});
  QPolygonF corners;
  for (const auto& corner : listed_[static_cast<std::size_t>(row)]->corners)
    corners.append({corner.x, corner.y});
  view_->mark(corners);
}

void SheetCheckDialog::say(const QString& sentence, bool wrong) {
  words_->setText(wrong ? QStringLiteral("✗ ") + sentence : sentence);
  spoken_->speak(wrong ? Urgency::at_once : Urgency::queued, sentence);
}

void SheetCheckDialog::ask_photos() {
  const QStringList photos = QFileDialog::getOpenFileNames(this, tr("Open photographs of worksheets"),
                                                           parts_.preferences().start_folder(),
                                                           tr("Photographs and scans (*.jpg *.jpeg *.png)"));
  if (photos.isEmpty()) return;
  parts_.preferences().folder = QFileInfo(photos.front()).absolutePath();
  emit parts_.save_later();
  read(photos);
}

void SheetCheckDialog::ask_and_save() {
  QFileDialog dialog(this, tr("Save the picture"));
  dialog.setObjectName(QStringLiteral("sheet_file_dialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilter(tr("Picture (*.png)"));
  dialog.setDefaultSuffix(QStringLiteral("png"));
  dialog.setDirectory(parts_.preferences().start_folder());
  // With its ending: what follows another full stop would be taken for one.
  dialog.selectFile(tr("%1 checked").arg(QFileInfo(photos_->currentText()).completeBaseName()) +
                    QStringLiteral(".png"));
  if (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty())
    save(dialog.selectedFiles().front());
}

void SheetCheckDialog::save(const QString& path) {
  const int shown = photos_->currentIndex();
  if (shown < 0) return;
  const auto& photo = read_[static_cast<std::size_t>(shown)];
  reader_.save({photo, &photo->picture}, path.toStdString());
}

void SheetCheckDialog::done(int result) {
  QDialog::done(result);
  parts_.focus_tablet();
}

void ask_sheet_check(WindowParts& parts) {
  const QStringList photos = QFileDialog::getOpenFileNames(
      &parts.window(), SheetCheckDialog::tr("Open photographs of worksheets"),
      parts.preferences().start_folder(), SheetCheckDialog::tr("Photographs and scans (*.jpg *.jpeg *.png)"));
  if (photos.isEmpty()) return parts.focus_tablet();
  parts.preferences().folder = QFileInfo(photos.front()).absolutePath();
  auto* dialog = new SheetCheckDialog(parts, &parts.window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
  dialog->read(photos);
}

}  // namespace nazori::ui
