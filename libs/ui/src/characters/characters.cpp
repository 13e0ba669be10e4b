// SPDX-License-Identifier: Apache-2.0
#include "characters/characters.h"

#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>

#include "characters/character_actions.h"
#include "characters/confusable_view.h"
#include "characters/draw_panel.h"
#include "characters/information_panel.h"
#include "characters/library_panel.h"
#include "characters/spoken_readings.h"
#include "characters/stage_table.h"
#include "characters/stage_view.h"
#include "characters/standing_bar.h"
#include "characters/writing_panel.h"
#include "nazori/kanji/own_characters.h"
#include "nazori/studio/parts/key_writing.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/dialogs/file_exchange.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/feedback_tone.h"
#include "nazori/widgets/words/kanji_text.h"
#include "study/question_view.h"
#include "study/session_actions.h"
#include "study/session_answers.h"
#include "study/session_bar.h"
#include "study/session_panel.h"
#include "study/study_dialogs.h"

namespace nazori::ui {

namespace {

/// Puts widgets on top of each other; the last one is visible at first. @param each_fills  one at a time is
/// shown, and fills the side.
QWidget* stack_up(const char* name, const QList<QWidget*>& pieces, bool each_fills, QWidget* window) {
  auto* side = named(new QWidget(window), name);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  for (auto* piece : pieces) {
    column->addWidget(piece, each_fills || piece == pieces.back() ? 1 : 0);
    piece->setVisible(piece == pieces.back());
  }
  return side;
}

}  // namespace

Characters::Characters(WindowParts& parts)
    : Page(parts, {QStringLiteral("characters"), tr("&Characters"),
                   tr("Carved characters to see, feel and write"), Icon::strokes,
                   tr("The character as grooves to trace. The left button presses the stylus down; the right "
                      "button turns the tablet. M: move the pen by keys")}),
      practice_(parts.practice()),
      actions_(new CharacterActions(&parts.window())),
      session_actions_(new SessionActions(&parts.window())),
      library_panel_(new LibraryPanel(&parts.library(), &parts.learner(), &parts.window())),
      information_panel_(new InformationPanel(&parts.window())),
      standing_bar_(new StandingBar(
          {session_actions_->study_this, session_actions_->know_this, session_actions_->add_to_list},
          &parts.window())),
      confusable_view_(new ConfusableView({actions_->tell_apart}, &parts.window())),
      writing_panel_(new WritingPanel(&parts.window())),
      draw_panel_(new DrawPanel(parts, &parts.window())),
      session_panel_(new SessionPanel(parts.session(), parts.learner(), &parts.window())),
      session_bar_(new SessionBar(parts.session(), *session_actions_, &parts.window())),
      question_view_(new QuestionView(parts.session(), actions_->show_right, &parts.window())),
      session_answers_(new SessionAnswers(parts.session(), *session_actions_, parts.learner(),
                                          {actions_->hint, actions_->undo_stroke, actions_->give_up},
                                          &parts.window())),
      above_tablet_(new QWidget(&parts.window())),
      left_side_(stack_up("left_side", {draw_panel_, library_panel_}, true, &parts.window())),
      right_side_(stack_up("right_side", {writing_panel_, information_panel_}, false, &parts.window())),
      files_(new FileExchange(&parts.workshop(), &parts.window())),
      spoken_readings_(new SpokenReadings(parts, *actions_, this)),
      key_ground_(parts.tablet()),
      key_writing_(
          new KeyWriting(parts, key_ground_,
                         {actions_->key_pen, actions_->pen_down, actions_->pen_start, actions_->pen_where},
                         is_tablet, this)) {
  const Preferences& preferences = parts.preferences();
  parts.tablet().set_switches({preferences.strokes_visible, preferences.numbers_visible,
                               preferences.arrows_visible, preferences.snapping});
  practice_.watch().set_reduced_motion(preferences.reduced_motion);
  practice_.set_first_character(preferences.kanji);
  files_->set_folder(preferences.folder);
  library_panel_->show_list(preferences.list);
  make_stage_views();
  actions_->adopt(*session_actions_);
  connect_actions();
  connect_practice();
  connect_work();
  connect_session();
  connect_study_actions();
  connect_standing();
  // Another page with the tablet may be shown before this one was entered.
  hide_session();
}

void Characters::make_stage_views() {
  auto* column = new QVBoxLayout(above_tablet_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  // In a low window the bar and the question share a line.
  auto* head = new QBoxLayout(QBoxLayout::TopToBottom);
  head->setSpacing(0);
  head->addWidget(session_bar_);
  head->addWidget(question_view_, 1);
  column->addLayout(head);
  connect(question_view_, &QuestionView::room_changed, this, [this, head](practice::QuestionRoom room) {
    const bool is_low = room == practice::QuestionRoom::line;
    head->setDirection(is_low ? QBoxLayout::RightToLeft : QBoxLayout::TopToBottom);
    session_bar_->set_short(is_low);
    if (practice_.is_entered()) session_answers_->show_state();
  });
  QSettings settings(parts().settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  const base::Settings values = read_settings(settings);
  const std::string_view last = base::text_setting(values, "stage");
  const StageViewParts view_parts{parts(), *actions_, writing_panel_};
  for (const auto& row : stage_rows()) {
    auto& stage = *practice_.stage_named(row.id);
    auto* action = actions_->stages[static_cast<qsizetype>(stages_.size())];
    auto* view = row.make_view(stage, view_parts);
    view->setParent(this);
    view->load(values);
    if (auto* strip = view->above_tablet()) column->addWidget(strip);
    stages_.push_back({action, action->toolTip(), view});
    if (last == row.id) practice_.enter_stage(stage);
    connect(action, &QAction::triggered, this, [this, &stage] { practice_.enter_stage(stage); });
  }
}

const Characters::StageEntry& Characters::entry_of(const practice::PracticeStage& stage) const {
  return *std::find_if(stages_.begin(), stages_.end(),
                       [&stage](const StageEntry& entry) { return &entry.view->stage() == &stage; });
}

const Characters::StageEntry& Characters::current() const { return entry_of(practice_.current_stage()); }

void Characters::show_available() {
  for (const auto& entry : stages_) {
    const bool can = entry.view->stage().can_practise({practice_.sheet(), practice_.tablet()});
    const QString why = can ? QString() : entry.view->why_unavailable();
    entry.action->setEnabled(can);
    entry.action->setToolTip(why.isEmpty() ? entry.tip : why);
  }
}

Characters::~Characters() = default;

QString Characters::title() const {
  if (practice_.current_stage().hides_character()) return tr("Write from memory");
  if (practice_.own().tablet) return to_text(practice_.own().name);
  return practice_.tablet() ? to_text(parts().preferences().kanji) : QString();
}

Page::Panel Characters::left() const {
  return {left_side_, tr("&List of characters"), tr("Show or hide the list")};
}

Page::Panel Characters::right() const {
  return {right_side_, tr("&Information"), tr("Show or hide the information")};
}

QWidget* Characters::above_tablet() const { return above_tablet_; }

QWidget* Characters::under_tablet() const { return session_answers_; }

practice::FoldedPanels Characters::folded() const { return practice::folded_panels(parts().session()); }

ActionSet* Characters::actions() const { return actions_; }

QList<Tool> Characters::tools() const {
  QList<Tool> tools;
  for (const auto& entry : stages_) tools.append({entry.action, true});
  tools.append(Tool{});
  tools.append({actions_->speak});
  tools.append(Tool{});
  tools.append(current().view->tools());
  return tools;
}

void Characters::enter() {
  practice_.enter();
  show_cross();
  show_session();
}

void Characters::leave() {
  key_writing_->end();
  practice_.leave();
  parts().tablet().set_cross(view::WritingCross::none);
  hide_session();
}

void Characters::hide_session() {
  for (auto* one : std::initializer_list<QWidget*>{session_bar_, question_view_, session_answers_})
    one->hide();
}

void Characters::show_stage() {
  for (const auto& entry : stages_)
    for (auto* action : entry.view->own_actions()) action->setEnabled(false);
  current().action->setChecked(true);
  for (auto* action : current().view->own_actions()) action->setEnabled(true);
  emit tools_changed();
  show_session();
  parts().save_later();
}

void Characters::show_hiding() {
  const bool hidden = practice_.current_stage().hides_character();
  const auto& sheet = practice_.sheet();
  information_panel_->set_hidden_character(hidden);
  library_panel_->set_current(hidden || !sheet ? 0 : sheet->character.code_point);
  emit title_changed();
}

void Characters::show_character() {
  const auto& sheet = practice_.sheet();
  parts().preferences().kanji = sheet->character.code_point;
  practice_.set_first_character(sheet->character.code_point);
  parts().save_later();
  show_available();
  information_panel_->show_character(sheet);
  show_standing();
}

void Characters::show_own() {
  const auto& own = practice_.own();
  const QString name = to_text(own.name);
  information_panel_->show_own(name, own.map_size, parts().tablet().stroke_count());
  parts().announce(Feedback::good, own.has_strokes
                                       ? tr("Opened %1.").arg(name)
                                       : tr("Opened %1. Open a .str file to add its strokes.").arg(name));
}

void Characters::save(QSettings& settings) const {
  auto values = read_settings(settings);
  values.insert_or_assign("stage", std::string(practice_.current_stage().id()));
  for (const auto& entry : stages_) entry.view->save(values);
  write_settings(settings, values);
}

void Characters::open_drawing(bool open) {
  if (open) parts().open_left_panel();
  draw_panel_->setVisible(open);
  actions_->draw_to_find->setChecked(open);
  show_session();
  if (open)
    draw_panel_->begin();
  else
    parts().focus_tablet();
}

void Characters::open_search() {
  if (actions_->draw_to_find->isChecked()) open_drawing(false);
  show_session();
  parts().open_left_panel();
}

void Characters::close_drawing() {
  open_drawing(false);
  // The sentence about the drawing is no longer true.
  parts().announce(Feedback::hint, tr("Closed. The tablet was not changed."));
}

void Characters::refresh_appearance() {
  information_panel_->refresh();
  session_actions_->draw_icons();
  question_view_->refresh();
  session_panel_->refresh();
}

void Characters::connect_actions() {
  on(actions_->make_model, [this] { ask_model(); });
  on(actions_->find, [this] {
    open_search();
    library_panel_->focus_search();
  });
  on(actions_->find_by_parts, [this](bool open) {
    open_search();
    library_panel_->show_parts(open);
  });
  on(actions_->find_by_radical, [this](bool open) {
    open_search();
    library_panel_->show_radicals(open);
  });
  connect(library_panel_, &LibraryPanel::table_shown, this, [this](bool by_parts, bool by_radical) {
    actions_->find_by_parts->setChecked(by_parts);
    actions_->find_by_radical->setChecked(by_radical);
  });
  on(actions_->writing_cross, [this] {
    auto& cross = parts().preferences().cross;
    cross = static_cast<view::WritingCross>((static_cast<int>(cross) + 1) % 3);
    show_cross();
    parts().save_later();
    const QString names[] = {tr("Writing cross off."), tr("Writing cross: 十."), tr("Writing cross: 田.")};
    emit parts().respond(Feedback::hint, names[static_cast<std::size_t>(cross)]);
  });
  on(actions_->next_character, [this] {
    if (const char32_t next = library_panel_->neighbour(+1)) practice_.show(next);
  });
  on(actions_->previous_character, [this] {
    if (const char32_t before = library_panel_->neighbour(-1)) practice_.show(before);
  });
  on(actions_->back, [this] { practice_.travel(-1); });
  on(actions_->forward, [this] { practice_.travel(+1); });
  on(actions_->draw_to_find, [this](bool open) {
    if (open)
      open_drawing(true);
    else
      close_drawing();
  });
}

void Characters::connect_practice() {
  subscribe(practice_.stage_changed, this, [this] { show_stage(); });
  subscribe(practice_.hiding_changed, this, [this] { show_hiding(); });
  subscribe(practice_.character_arrived, this, [this](char32_t) { show_character(); });
  subscribe(practice_.character_shown, this,
            [this](char32_t character) { emit parts().character_shown(character); });
  subscribe(practice_.character_missing, this, [this](char32_t character) {
    parts().announce(Feedback::advice,
                     tr("There are no strokes for %1 in the database. The tablet was not changed.")
                         .arg(to_text(character)));
  });
  subscribe(practice_.own_arrived, this, [this] { show_available(); });
  subscribe(practice_.own_shown, this, [this] { show_own(); });
  subscribe(practice_.wanted, this, [this] { emit wants_to_be_entered(); });
  subscribe(practice_.feedback, this,
            [this](const practice::PracticeStage& stage, const practice::StageFeedback& feedback) {
              parts().announce(to_feedback(feedback.tone), entry_of(stage).view->sentence(feedback));
            });
}

void Characters::connect_work() {
  connect(&parts(), &WindowParts::show_character, this, [this](char32_t code_point) {
    practice_.look_up(code_point);
    emit wants_to_be_entered();
  });
  connect(&parts(), &WindowParts::own_characters_changed, this, [this] {
    // The tablet shows the character as it is now.
    const auto& sheet = practice_.sheet();
    if (!sheet) return;
    const char32_t shown = sheet->character.code_point;
    const auto* database = parts().learner().database();
    const auto now = database != nullptr ? database->find(shown) : std::nullopt;
    // One that was taken out stays on the tablet until another is chosen.
    if (!now) return;
    if (kanji::is_own(shown) || sheet->character.own_form || now->own_form) practice_.show(shown, false);
  });
  connect(files_, &FileExchange::announced, &parts(), &WindowParts::announce);
  connect(files_, &FileExchange::folder_changed, this, [this](const QString& folder) {
    parts().preferences().folder = folder;
    parts().save_later();
  });
  connect(library_panel_, &LibraryPanel::character_chosen, this, [this](char32_t code_point) {
    practice_.look_up(code_point);
    parts().close_drawers();
  });
  connect(library_panel_, &LibraryPanel::list_changed, this, [this](kanji::List list) {
    parts().preferences().list = list;
    parts().save_later();
  });
  connect(information_panel_, &InformationPanel::character_chosen, this,
          [this](char32_t code_point) { practice_.look_up(code_point); });
  connect(draw_panel_, &DrawPanel::closed, this, &Characters::close_drawing);
  connect(draw_panel_, &DrawPanel::character_chosen, this, [this](char32_t code_point) {
    open_drawing(false);
    practice_.look_up(code_point);
    parts().close_drawers();
  });
}

}  // namespace nazori::ui
