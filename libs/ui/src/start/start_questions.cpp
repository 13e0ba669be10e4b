// SPDX-License-Identifier: Apache-2.0
// The questions of the first start: their rows of answers, and what is chosen.
#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"
#include "start/choice_button.h"
#include "start/start_view.h"

namespace nazori::ui {
namespace {

using practice::KnownAlready;
using practice::LearningGoal;

constexpr int kGap = 12;

}  // namespace

StartView::Goal StartView::goal_id(LearningGoal goal) {
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
  order.append(known_text_);
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
  own_text_ = add_text("start_own", tr("Text with the characters you want to write"),
                       tr("Type or paste any text. Its kanji become your list."), own_found_);
}

QPlainTextEdit* StartView::add_text(const char* name, const QString& spoken, const QString& example,
                                    QLabel*& found) {
  const QByteArray both(name);
  auto* text = named(new QPlainTextEdit(content_), (both + "_text").constData(), spoken);
  text->setPlaceholderText(example);
  text->setTabChangesFocus(true);
  found = text_label((both + "_found").constData(), content_, "muted");
  connect(text, &QPlainTextEdit::textChanged, this, [this] { note_change(); });
  content_->layout()->addWidget(text);
  content_->layout()->addWidget(found);
  return text;
}

void StartView::add_known() {
  const QString question = tr("What can you write already?");
  add_question(question);
  known_ = add_row({new ChoiceButton("start_nothing", tr("I am new"), content_),
                    new ChoiceButton("start_kana", tr("I know kana"), content_),
                    new ChoiceButton("start_some_kanji", tr("I know some kanji"), content_),
                    new ChoiceButton("start_listed", tr("I know these…"), content_),
                    new ChoiceButton("start_check", tr("Test me, 2 minutes"), content_)},
                   "start_known", question);
  add_levels();
  known_text_ = add_text("start_known", tr("Text with the characters you know"),
                         tr("Paste any text or list, from another program for example. Every kanji and kana "
                            "in it counts as known."),
                         known_found_);
  result_words_ = text_label("start_result", content_);
  content_->layout()->addWidget(result_words_);
  result_ = add_row({new ChoiceButton("start_take", tr("Mark these as known"), content_),
                     new ChoiceButton("start_refuse", tr("Mark nothing"), content_)},
                    "start_result_row", tr("The result of the test"));
  result_row_ = result_->button(0)->parentWidget();
}

void StartView::add_levels() {
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

void StartView::choose(QButtonGroup* group, int id) {
  group->setExclusive(false);
  for (auto* button : group->buttons()) {
    button->setChecked(group->id(button) == id);
    // Tab stops once in each row: at the chosen answer, else at the first.
    button->setFocusPolicy(group->id(button) == std::max(id, 0) ? Qt::StrongFocus : Qt::ClickFocus);
  }
  group->setExclusive(true);
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
    case listed:
      known.kind = KnownAlready::Kind::listed;
      answers.known_text = known_text_->toPlainText().toStdString();
      break;
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
  for (auto* one : {static_cast<QWidget*>(known_text_), static_cast<QWidget*>(known_found_)})
    one->setVisible(known_->checkedId() == listed);
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

}  // namespace nazori::ui
