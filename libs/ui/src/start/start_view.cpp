// SPDX-License-Identifier: Apache-2.0
#include "start/start_view.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QFontInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "start/choice_button.h"
#include "start/start_words.h"

namespace nazori::ui {
namespace {

using practice::LearningGoal;

constexpr int kMargin = 28;
constexpr int kWidest_em = 60;
constexpr int kGap = 12;
constexpr int kTextLines = 3;
constexpr std::size_t kMostShown = 30;

/// As many as one line holds.
QString in_a_row(const std::vector<char32_t>& characters) {
  QString row;
  for (std::size_t i = 0; i < characters.size() && i < kMostShown; ++i) row += to_text(characters[i]);
  if (characters.size() > kMostShown) row += QStringLiteral("…");
  return row;
}

}  // namespace

StartView::StartView(QWidget* parent)
    : QWidget(parent),
      area_(named(new QScrollArea(this), "start_questions")),
      content_(named(new QWidget(area_), "start_content")),
      end_(named(new QFrame(this), "start_end")) {
  named(this, "start_page", tr("What to learn"));
  area_->setFrameShape(QFrame::NoFrame);
  welcome_ = text_label("start_welcome", content_);
  about_ = text_label("start_about", content_, "muted");
  auto* column = new QVBoxLayout(content_);
  column->setSpacing(kGap);
  column->addWidget(welcome_);
  column->addWidget(about_);
  add_goals();
  add_known();
  add_minutes();
  column->addStretch(1);
  make_scrolling(area_, content_);
  add_end();
  auto* both = new QVBoxLayout(this);
  both->setContentsMargins(0, 0, 0, 0);
  both->setSpacing(0);
  both->addWidget(area_, 1);
  both->addWidget(end_);
  both->addStretch(0);
  setFocusProxy(write_);
  order_tabs();
  show_parts();
  fit();
}

void StartView::add_end() {
  trouble_ = sentence_label("start_trouble", end_, "trouble");
  write_ = named(new QPushButton(end_), "start_write");
  write_->setProperty("role", QStringLiteral("primary"));
  skip_ = named(new QPushButton(end_), "start_skip");
  input_ = text_label("start_input", content_, "muted");
  for (auto* button : {write_, skip_}) button->setAutoDefault(true);
  connect(write_, &QPushButton::clicked, this, &StartView::write_wanted);
  connect(skip_, &QPushButton::clicked, this, &StartView::skip_wanted);
  auto* row = new QWidget(end_);
  auto* flow = new FlowLayout(kGap, kGap, row);
  flow->addWidget(write_);
  flow->addWidget(skip_);
  auto* column = new QVBoxLayout(end_);
  column->setSpacing(kGap);
  column->addWidget(trouble_);
  column->addWidget(row);
  auto* questions = static_cast<QVBoxLayout*>(content_->layout());
  questions->insertWidget(questions->count() - 1, input_);
  trouble_->hide();
}

void StartView::show_answers(const practice::LearningAnswers& answers, bool is_first) {
  is_first_ = is_first;
  const QSignalBlocker quiet(this);
  welcome_->setText(is_first ? tr("Welcome. ようこそ。") : tr("What do you want to learn?"));
  about_->setText(is_first ? tr("Three questions, then you write. You can change every answer later.")
                           : tr("Only what you change here is changed."));
  known_->button(nothing)->setText(is_first ? tr("I am new") : tr("Mark nothing"));
  known_->button(nothing)->updateGeometry();
  skip_->setText(is_first ? tr("Skip (Esc)") : tr("Back (Esc)"));
  choose(goal_, answers.goal ? goal_id(*answers.goal) : -1);
  choose(kanji_, answers.goal == LearningGoal::kanji_by_jlpt        ? 1
                 : answers.goal == LearningGoal::kanji_by_frequency ? 2
                                                                    : 0);
  own_text_->clear();
  known_text_->clear();
  choose(known_, nothing);
  level_->setCurrentIndex(0);
  const auto all = practice::daily_minutes();
  const auto at = answers.minutes ? std::find(all.begin(), all.end(), *answers.minutes) : all.end();
  choose(minutes_, at == all.end() ? -1 : static_cast<int>(at - all.begin()));
  show_result({});
  show_parts();
}

bool StartView::wants_check() const { return known_->checkedId() == check && !found_; }

void StartView::show_result(const std::optional<practice::PlacementResult>& result) {
  found_ = result;
  if (!result) {
    show_parts();
    return;
  }
  const QSignalBlocker quiet(this);
  choose(known_, check);
  choose(result_, result->known.empty() ? refuse : take);
  result_words_->setText(StartWords::found(*result, answers().goal));
  show_parts();
}

void StartView::show_plan(char32_t first, const QString& trouble, const std::vector<char32_t>& own_list) {
  const bool checks = wants_check();
  write_->setText(checks       ? tr("Start the test")
                  : first != 0 ? tr("Write %1").arg(to_text(first))
                               : tr("Save"));
  write_->setEnabled(trouble.isEmpty());
  write_->setToolTip(tr("Enter: start"));
  own_found_->setText(
      own_list.empty()
          ? QString()
          : tr("%n characters: %1", nullptr, static_cast<int>(own_list.size())).arg(in_a_row(own_list)));
  trouble_->setText(trouble);
  trouble_->setVisible(!trouble.isEmpty());
  if (trouble.isEmpty() && first == 0 && !checks) {
    trouble_->setText(tr("You know every character of this choice already. Choose something else to write."));
    trouble_->show();
  }
  fit();
}

void StartView::show_known(const std::vector<char32_t>& known, int studied) {
  QStringList said;
  if (!known.empty())
    said.append(tr("%Ln characters will be marked as known: %1", nullptr, static_cast<int>(known.size()))
                    .arg(in_a_row(known)));
  if (studied > 0)
    said.append(tr("%Ln characters are already studied and stay as they are.", nullptr, studied));
  known_found_->setText(said.join(QLatin1Char('\n')));
}

void StartView::show_input(const QString& sentence) { input_->setText(sentence); }

void StartView::fit() {
  const double points = QFontInfo(font()).pointSizeF();
  const int em = QFontInfo(font()).pixelSize();
  QFont large = font();
  large.setPointSizeF(points * 1.7);
  welcome_->setFont(large);
  QFont button = font();
  button.setPointSizeF(points * 1.3);
  write_->setFont(button);
  for (auto* text : {own_text_, known_text_})
    text->setFixedHeight(QFontMetrics(text->font()).lineSpacing() * kTextLines + em);
  const int width = area_->viewport()->width();
  const int beside = std::max(kMargin, (width - std::min(width - 2 * kMargin, em * kWidest_em)) / 2);
  content_->layout()->setContentsMargins(beside, kMargin, beside, kMargin);
  end_->layout()->setContentsMargins(beside, kGap, beside, kGap);
  // The button follows the questions; where they do not fit, they scroll above it.
  area_->setMaximumHeight(content_->layout()->heightForWidth(width));
}

void StartView::keyPressEvent(QKeyEvent* event) {
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && write_->isEnabled()) {
    write_->click();
    return;
  }
  QWidget::keyPressEvent(event);
}

void StartView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

void StartView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

}  // namespace nazori::ui
