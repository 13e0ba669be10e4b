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

using practice::KnownAlready;
using practice::LearningGoal;

constexpr int kMargin = 28;
constexpr int kWidest_em = 60;
constexpr int kGap = 12;
constexpr int kTextLines = 3;

/// The ids of the first row of answers; kanji has a row of its own.
enum Goal : std::uint8_t { hiragana, katakana, kanji, own };
/// The ids of the row about what is known.
enum Known : std::uint8_t { nothing, kana, some_kanji, check };
enum Result : std::uint8_t { take, refuse };

Goal goal_id(LearningGoal goal) {
  switch (goal) {
    case LearningGoal::hiragana:
      return hiragana;
    case LearningGoal::katakana:
      return katakana;
    case LearningGoal::own_list:
      return own;
    case LearningGoal::kanji_by_grade:
    case LearningGoal::kanji_by_jlpt:
    case LearningGoal::kanji_by_frequency:
      break;
  }
  return kanji;
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

void StartView::order_tabs() {
  // The keyboard begins on the button, so the questions come next, not the pages of the window.
  QList<QWidget*> order{write_};
  const auto add = [&order](const QButtonGroup& group) {
    for (auto* button : group.buttons()) order.append(button);
  };
  add(*goal_);
  add(*kanji_);
  order.append(own_text_);
  add(*known_);
  order.append(level_);
  add(*result_);
  add(*minutes_);
  order.append(skip_);
  for (qsizetype i = 1; i < order.size(); ++i) setTabOrder(order[i - 1], order[i]);
}

QLabel* StartView::add_question(const QString& words) {
  auto* label = text_label("start_question", content_);
  label->setText(words);
  static_cast<QVBoxLayout*>(content_->layout())->addSpacing(kGap / 2);
  content_->layout()->addWidget(label);
  return label;
}

QButtonGroup* StartView::add_row(const QList<ChoiceButton*>& buttons, const char* name,
                                 const QString& spoken) {
  auto* row = named(new QWidget(content_), name, spoken);
  auto* flow = new FlowLayout(kGap, kGap, row);
  auto* group = new QButtonGroup(row);
  group->setProperty("question", spoken);
  for (auto* button : buttons) {
    button->setParent(row);
    flow->addWidget(button);
    group->addButton(button, static_cast<int>(group->buttons().size()));
    // A screen reader says the question with each of its answers.
    button->setAccessibleName(tr("%1: %2").arg(spoken, button->text()));
  }
  connect(group, &QButtonGroup::idToggled, this, [this](int, bool on) {
    if (on) note_change();
  });
  content_->layout()->addWidget(row);
  return group;
}

void StartView::add_goals() {
  const QString question = tr("What would you like to write?");
  add_question(question);
  const auto card = [this](const char* name, const QString& words, const char16_t* glyph,
                           const QString& more) {
    return new ChoiceButton(name, words, content_, QString::fromUtf16(glyph), more);
  };
  goal_ = add_row({card("start_hiragana", tr("Hiragana"), u"あ", tr("the first step")),
                   card("start_katakana", tr("Katakana"), u"ア", tr("for words from abroad")),
                   card("start_kanji", tr("Kanji"), u"字", tr("by grade, JLPT or frequency")),
                   card("start_own", tr("My own list"), u"帳", tr("type or paste any text"))},
                  "start_goal", question);
  const QString order = tr("Which kanji first?");
  kanji_ = add_row({new ChoiceButton("start_by_grade", tr("By school grade"), content_),
                    new ChoiceButton("start_by_jlpt", tr("By JLPT level"), content_),
                    new ChoiceButton("start_by_frequency", tr("By frequency"), content_)},
                   "start_order", order);
  kanji_row_ = kanji_->button(0)->parentWidget();
  own_text_ =
      named(new QPlainTextEdit(content_), "start_own_text", tr("Text with the characters you want to write"));
  own_text_->setPlaceholderText(tr("Type or paste any text. Its kanji become your list."));
  own_text_->setTabChangesFocus(true);
  own_found_ = text_label("start_own_found", content_, "muted");
  connect(own_text_, &QPlainTextEdit::textChanged, this, [this] { note_change(); });
  content_->layout()->addWidget(own_text_);
  content_->layout()->addWidget(own_found_);
}

void StartView::add_known() {
  const QString question = tr("What can you write already?");
  add_question(question);
  known_ = add_row({new ChoiceButton("start_nothing", tr("I am new"), content_),
                    new ChoiceButton("start_kana", tr("I know kana"), content_),
                    new ChoiceButton("start_some_kanji", tr("I know some kanji"), content_),
                    new ChoiceButton("start_check", tr("Test me, 2 minutes"), content_)},
                   "start_known", question);
  level_ = named(new QComboBox(content_), "start_level", tr("How many kanji do you know?"));
  make_narrow(level_, 16);
  for (int grade = 1; grade <= 6; ++grade)
    level_->addItem(tr("up to grade %1").arg(grade),
                    QVariant::fromValue(QPoint(static_cast<int>(KnownAlready::Kind::up_to_grade), grade)));
  level_->addItem(tr("all school kanji"),
                  QVariant::fromValue(QPoint(static_cast<int>(KnownAlready::Kind::up_to_grade), 7)));
  for (int level = 4; level >= 1; --level)
    level_->addItem(tr("up to old JLPT level %1").arg(level),
                    QVariant::fromValue(QPoint(static_cast<int>(KnownAlready::Kind::up_to_jlpt), level)));
  connect(level_, &QComboBox::currentIndexChanged, this, [this] { note_change(); });
  content_->layout()->addWidget(level_);
  static_cast<QVBoxLayout*>(content_->layout())->setAlignment(level_, Qt::AlignLeft);
  result_words_ = text_label("start_result", content_);
  content_->layout()->addWidget(result_words_);
  result_ = add_row({new ChoiceButton("start_take", tr("Mark these as known"), content_),
                     new ChoiceButton("start_refuse", tr("Mark nothing"), content_)},
                    "start_result_row", tr("The result of the test"));
  result_row_ = result_->button(0)->parentWidget();
}

void StartView::add_minutes() {
  const QString question = tr("How long a day?");
  add_question(question);
  QList<ChoiceButton*> buttons;
  for (const int minutes : practice::daily_minutes()) {
    const QByteArray name = "start_minutes_" + QByteArray::number(minutes);
    buttons.append(new ChoiceButton(name.constData(), tr("%1 min").arg(minutes), content_));
  }
  minutes_ = add_row(buttons, "start_minutes", question);
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

void StartView::choose(QButtonGroup* group, int id) {
  group->setExclusive(false);
  for (auto* button : group->buttons()) {
    button->setChecked(group->id(button) == id);
    // Tab stops once in each row: at the chosen answer, else at the first.
    button->setFocusPolicy(group->id(button) == std::max(id, 0) ? Qt::StrongFocus : Qt::ClickFocus);
  }
  group->setExclusive(true);
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
  choose(known_, nothing);
  level_->setCurrentIndex(0);
  const auto all = practice::daily_minutes();
  const auto at = answers.minutes ? std::find(all.begin(), all.end(), *answers.minutes) : all.end();
  choose(minutes_, at == all.end() ? -1 : static_cast<int>(at - all.begin()));
  show_result({});
  show_parts();
}

practice::LearningAnswers StartView::answers() const {
  practice::LearningAnswers answers;
  constexpr LearningGoal kOrders[] = {LearningGoal::kanji_by_grade, LearningGoal::kanji_by_jlpt,
                                      LearningGoal::kanji_by_frequency};
  switch (goal_->checkedId()) {
    case hiragana:
      answers.goal = LearningGoal::hiragana;
      break;
    case katakana:
      answers.goal = LearningGoal::katakana;
      break;
    case kanji:
      answers.goal = kOrders[std::clamp(kanji_->checkedId(), 0, 2)];
      break;
    case own:
      answers.goal = LearningGoal::own_list;
      break;
    default:
      break;
  }
  if (answers.goal == LearningGoal::own_list) {
    answers.own_text = own_text_->toPlainText().toStdString();
    answers.list_name = tr("My list").toStdString();
  }
  KnownAlready known;
  switch (known_->checkedId()) {
    case kana:
      known.kind = KnownAlready::Kind::kana;
      break;
    case some_kanji: {
      const QPoint level = level_->currentData().toPoint();
      known.kind = static_cast<KnownAlready::Kind>(level.x());
      known.level = level.y();
      break;
    }
    case check:
      if (found_ && result_->checkedId() == take) {
        known.kind = KnownAlready::Kind::checked;
        known.characters = found_->known;
      }
      break;
    default:
      break;
  }
  answers.known = std::move(known);
  if (const int at = minutes_->checkedId(); at >= 0)
    answers.minutes = practice::daily_minutes()[static_cast<std::size_t>(at)];
  return answers;
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

void StartView::note_change() {
  // A result is about the list that was checked.
  if (found_ && (sender() == goal_ || sender() == kanji_ || sender() == own_text_)) found_.reset();
  show_parts();
  emit changed();
}

void StartView::show_parts() {
  kanji_row_->setVisible(goal_->checkedId() == kanji);
  for (auto* one : {static_cast<QWidget*>(own_text_), static_cast<QWidget*>(own_found_)})
    one->setVisible(goal_->checkedId() == own);
  level_->setVisible(known_->checkedId() == some_kanji);
  const bool has_result = known_->checkedId() == check && found_.has_value();
  result_words_->setVisible(has_result);
  result_row_->setVisible(has_result && !found_->known.empty());
  name_kana();
}

void StartView::name_kana() {
  auto* button = known_->button(kana);
  const QString words = goal_->checkedId() == hiragana   ? tr("I know katakana")
                        : goal_->checkedId() == katakana ? tr("I know hiragana")
                                                         : tr("I know kana");
  if (button->text() == words) return;
  button->setText(words);
  button->setAccessibleName(tr("%1: %2").arg(known_->property("question").toString(), words));
  button->updateGeometry();
}

void StartView::show_plan(char32_t first, const QString& trouble, const std::vector<char32_t>& own) {
  first_ = first;
  const bool checks = wants_check();
  write_->setText(checks       ? tr("Start the test")
                  : first != 0 ? tr("Write %1").arg(to_text(first))
                               : tr("Save"));
  write_->setEnabled(trouble.isEmpty());
  write_->setToolTip(tr("Enter: start"));
  QString in_a_row;
  for (std::size_t i = 0; i < own.size() && i < 30; ++i) in_a_row += to_text(own[i]);
  if (own.size() > 30) in_a_row += QStringLiteral("…");
  own_found_->setText(
      own.empty() ? QString() : tr("%n characters: %1", nullptr, static_cast<int>(own.size())).arg(in_a_row));
  trouble_->setText(trouble);
  trouble_->setVisible(!trouble.isEmpty());
  if (trouble.isEmpty() && first == 0 && !checks) {
    trouble_->setText(tr("You know every character of this choice already. Choose something else to write."));
    trouble_->show();
  }
  fit();
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
  own_text_->setFixedHeight(QFontMetrics(own_text_->font()).lineSpacing() * kTextLines + em);
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
