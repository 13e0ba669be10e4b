// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/worksheet_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontInfo>
#include <QLabel>
#include <QLocale>
#include <QProgressDialog>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

#include "nazori/studio/print/page_view.h"
#include "nazori/studio/print/worksheet_options.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/dialogs/work_dialog.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kSoon_ms = 80;
constexpr int kWide_ems = 30;  ///< from here on the preview stands beside the options

QString settings_group() { return QStringLiteral("worksheet"); }

/// The id of a list of the page for characters.
std::string id_of(kanji::List list) {
  switch (list) {
    case kanji::List::secondary:
      return "secondary";
    case kanji::List::jinmeiyou:
      return "jinmeiyou";
    case kanji::List::hiragana:
      return "hiragana";
    case kanji::List::katakana:
      return "katakana";
    case kanji::List::own:
      return "own";
    case kanji::List::latin_and_digits:
    case kanji::List::all:
      return "grade-1";
    default:
      return "grade-" + std::to_string(static_cast<int>(list) - static_cast<int>(kanji::List::grade_1) + 1);
  }
}

}  // namespace

WorksheetDialog::WorksheetDialog(WindowParts& parts, char32_t shown, QWidget* parent)
    : QDialog(parent),
      parts_(parts),
      options_(new WorksheetOptions(parts.learner().store(), shown, this)),
      view_(named(new PageView(this), "worksheet_preview", tr("Preview"))),
      area_(new QScrollArea(this)),
      previous_(named(new QPushButton(QStringLiteral("◀"), this), "worksheet_previous", tr("Previous page"))),
      next_(named(new QPushButton(QStringLiteral("▶"), this), "worksheet_next", tr("Next page"))),
      number_(text_label("worksheet_number", this, "muted")),
      words_(sentence_label("worksheet_words", this)),
      spoken_(new SpokenLine(this)),
      maker_(parts.inbox(), parts.learner().source()) {
  setObjectName(QStringLiteral("worksheet_dialog"));
  setWindowTitle(tr("Print a worksheet"));
  area_->setFrameShape(QFrame::NoFrame);
  make_scrolling(area_, options_);

  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(view_, 1);
  auto* turn_row = new QHBoxLayout;
  number_->setAlignment(Qt::AlignCenter);
  number_->setWordWrap(false);
  turn_row->addWidget(previous_);
  turn_row->addWidget(number_, 1);
  turn_row->addWidget(next_);
  column->addLayout(turn_row);
  previous_->setShortcut(QKeySequence(QStringLiteral("Ctrl+PgUp")));
  previous_->setToolTip(tr("Show the previous page (%1)").arg(QStringLiteral("Ctrl+PgUp")));
  next_->setShortcut(QKeySequence(QStringLiteral("Ctrl+PgDown")));
  next_->setToolTip(tr("Show the next page (%1)").arg(QStringLiteral("Ctrl+PgDown")));
  previous_->setAutoDefault(false);
  next_->setAutoDefault(false);

  auto* buttons = dialog_buttons(QDialogButtonBox::Close, this);
  save_ = named(buttons->addButton(tr("&Save as PDF…"), QDialogButtonBox::ActionRole), "worksheet_save");
  save_->setDefault(true);
  sides_ = new QBoxLayout(QBoxLayout::LeftToRight);
  sides_->setSpacing(12);
  sides_->addWidget(area_, 2);
  sides_->addWidget(side, 3);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(16, 16, 16, 12);
  all->addLayout(sides_, 1);
  all->addWidget(words_);
  all->addWidget(buttons);

  soon_.setSingleShot(true);
  soon_.setInterval(kSoon_ms);
  connect(&soon_, &QTimer::timeout, this, &WorksheetDialog::request);
  connect(options_, &WorksheetOptions::changed, this, &WorksheetDialog::choose_later);
  connect(view_, &PageView::turned, this, &WorksheetDialog::turn);
  connect(previous_, &QPushButton::clicked, this, [this] { turn(-1); });
  connect(next_, &QPushButton::clicked, this, [this] { turn(1); });
  connect(save_, &QPushButton::clicked, this, &WorksheetDialog::ask_and_save);
  subscribe(maker_.shown, this, [this](const practice::WorksheetView& view) { show_view(view); });
  subscribe(maker_.refused, this,
            [this](const base::Error& error, std::size_t characters) { show_refusal(error, characters); });
  subscribe(maker_.progressed, this, [this](int percent) {
    if (work_ != nullptr) work_->setValue(percent);
  });
  subscribe(maker_.saved, this, [this](const std::filesystem::path& path, std::size_t pages) {
    end_work();
    parts_.announce(Feedback::good, tr("Saved %n pages as %1.", nullptr, static_cast<int>(pages))
                                        .arg(QDir::toNativeSeparators(to_text(path.string()))));
    accept();
  });
  subscribe(maker_.not_saved, this, [this](const std::filesystem::path& path, const base::Error& error) {
    end_work();
    say(tr("%1: %2. Nothing was saved.").arg(to_text(path.filename().string()), reason(error)), true);
  });
  load();
  show_page_buttons();
  request();
  if (parent != nullptr) {
    const int em = QFontInfo(font()).pixelSize();
    resize(QSize(em * 62, em * 46).boundedTo(parent->size() * 0.95));
  }
}

WorksheetDialog::~WorksheetDialog() = default;

void WorksheetDialog::load() {
  practice::WorksheetChoice choice;
  choice.source = practice::WorksheetSource::shown;
  choice.list = id_of(parts_.preferences().list);
  const bool japanese = QLocale().language() == QLocale::Japanese;
  choice.sheet.language = japanese ? print::Language::japanese : print::Language::english;
  QSettings settings(parts_.settings_file(), QSettings::IniFormat);
  settings.beginGroup(settings_group());
  choice = practice::load_choice(read_settings(settings), choice);
  options_->set_choice(choice);
}

void WorksheetDialog::store_choice() const {
  QSettings settings(parts_.settings_file(), QSettings::IniFormat);
  settings.beginGroup(settings_group());
  base::Settings values;
  practice::save_choice(values, options_->choice());
  write_settings(settings, values);
}

void WorksheetDialog::choose_later() {
  page_ = 0;
  fit_options();
  save_->setEnabled(false);  // until it is known that there is something to save
  soon_.start();
}

void WorksheetDialog::request() {
  soon_.stop();
  practice::WorksheetRequest made{options_->choice(), {}};
  auto characters = practice::chosen_characters(made.choice, parts_.learner());
  if (characters) made.characters = *characters;
  request_ = made;
  if (!characters) return show_refusal(characters.error(), 0);
  maker_.show(std::move(made), page_);
}

void WorksheetDialog::turn(int pages) {
  if (pages_ == 0) return;
  const auto last = static_cast<long long>(pages_) - 1;
  const auto wanted = std::clamp(static_cast<long long>(page_) + pages, 0LL, last);
  if (wanted == static_cast<long long>(page_)) return;
  page_ = static_cast<std::size_t>(wanted);
  request();
}

void WorksheetDialog::show_view(const practice::WorksheetView& view) {
  // An older page may arrive while the newest choice still waits to be asked for.
  if (soon_.isActive()) return;
  pages_ = view.pages;
  page_ = view.page;
  const QString number = tr("Page %1 of %2").arg(page_ + 1).arg(pages_);
  number_->setText(number);
  view_->show_page(view.drawing, number + QStringLiteral(". ") + to_text(view.drawing->text).simplified());
  QString sentence = view.characters == 0
                         ? tr("%n pages", nullptr, static_cast<int>(pages_))
                         : tr("%n characters", nullptr, static_cast<int>(view.characters)) +
                               QStringLiteral(" · ") + tr("%n pages", nullptr, static_cast<int>(pages_));
  if (!view.missing.empty()) {
    QString missing;
    for (const char32_t c : view.missing) missing += to_text(c);
    sentence += QStringLiteral(" · ") + tr("Not in the database: %1").arg(missing);
  }
  save_->setEnabled(true);
  show_page_buttons();
  say(sentence, false);
  spoken_->speak(Urgency::queued, number);
}

void WorksheetDialog::show_refusal(const base::Error& error, std::size_t characters) {
  if (soon_.isActive()) return;
  pages_ = 0;
  view_->clear();
  number_->clear();
  save_->setEnabled(false);
  show_page_buttons();
  using Source = practice::WorksheetSource;
  const auto source = request_.choice.source;
  const auto layout = request_.choice.sheet.layout;
  if (error.code != base::Errc::bad_argument)
    say(tr("There is no preview: %1.").arg(reason(error)), true);
  else if (characters > 0 && layout == print::Layout::practice)
    say(tr("The rows do not fit on a page. Choose fewer rows or smaller cells."), true);
  else if (characters > 0)
    say(tr("None of these characters has a word to ask. Choose other characters."), true);
  else if (source == Source::due)
    say(tr("No reviews are due now. Choose other characters."), false);
  else if (source == Source::difficult)
    say(tr("There are no difficult characters. Choose other characters."), false);
  else if (source == Source::text)
    say(tr("Type or paste a text with characters to write."), false);
  else
    say(tr("This list is empty. Choose other characters."), false);
}

void WorksheetDialog::show_page_buttons() {
  previous_->setEnabled(pages_ > 0 && page_ > 0);
  next_->setEnabled(page_ + 1 < pages_);
}

void WorksheetDialog::say(const QString& sentence, bool wrong) {
  words_->setText(wrong ? QStringLiteral("✗ ") + sentence : sentence);
  spoken_->speak(wrong ? Urgency::at_once : Urgency::queued, sentence);
}

void WorksheetDialog::ask_and_save() {
  QFileDialog dialog(this, tr("Save as PDF"));
  dialog.setObjectName(QStringLiteral("worksheet_file_dialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilter(tr("PDF (*.pdf)"));
  dialog.setDefaultSuffix(QStringLiteral("pdf"));
  dialog.setDirectory(parts_.preferences().start_folder());
  const QString title = to_text(options_->choice().sheet.title);
  dialog.selectFile(
      (title.isEmpty() ? tr("worksheet") : QString(title).replace(QLatin1Char('/'), QLatin1Char('-'))) +
      QStringLiteral(".pdf"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString path = dialog.selectedFiles().front();
  parts_.preferences().folder = QFileInfo(path).absolutePath();
  parts_.save_later();
  save(path);
}

void WorksheetDialog::save(const QString& path) {
  work_ = make_work_dialog(QStringLiteral("worksheet_progress"),
                           tr("Writing %1…").arg(QFileInfo(path).fileName()), tr("Stop"), this);
  connect(work_, &QProgressDialog::canceled, this, [this] {
    maker_.stop();
    end_work();
    say(tr("Stopped. Nothing was saved."), false);
  });
  maker_.save(request_, path.toStdString());
}

void WorksheetDialog::end_work() {
  if (work_ != nullptr) work_->deleteLater();
  work_ = nullptr;
}

void WorksheetDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  const bool wide = event->size().width() >= QFontInfo(font()).pixelSize() * kWide_ems;
  // In a narrow window the preview stands above the options.
  sides_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::BottomToTop);
  sides_->setStretch(0, wide ? 2 : 3);
  sides_->setStretch(1, wide ? 3 : 2);
  fit_options();
}

void WorksheetDialog::fit_options() {
  // The options scroll up and down only, so they must not be wider than what shows them.
  area_->setMinimumWidth(area_->widget()->minimumSizeHint().width() +
                         area_->verticalScrollBar()->sizeHint().width());
}

void WorksheetDialog::done(int result) {
  store_choice();
  QDialog::done(result);
  parts_.focus_tablet();
}

void ask_worksheet(WindowParts& parts) {
  const auto& practice = parts.practice();
  const auto& sheet = practice.sheet();
  // What the learner is asked to write from memory must not be shown.
  const bool hidden = practice.current_stage().hides_character();
  const char32_t shown = sheet && !hidden ? sheet->character.code_point : 0;
  auto* dialog = new WorksheetDialog(parts, shown, &parts.window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

}  // namespace nazori::ui
