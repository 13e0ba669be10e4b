// SPDX-License-Identifier: Apache-2.0
#include "characters/characters.h"

#include <QFileInfo>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "characters/character_actions.h"
#include "characters/draw_panel.h"
#include "characters/guided_page.h"
#include "characters/information_panel.h"
#include "characters/library_panel.h"
#include "characters/memory_page.h"
#include "characters/trace_page.h"
#include "characters/watch_page.h"
#include "characters/writing_panel.h"
#include "desk.h"
#include "error_text.h"
#include "feedback_tone.h"
#include "file_exchange.h"
#include "kanji_text.h"
#include "signals.h"
#include "study/session_actions.h"
#include "study/session_bar.h"
#include "study/session_panel.h"
#include "study/study_dialogs.h"

namespace nazori::ui {

namespace {

/// Of which the last is there at first.
QWidget* stack_up(const char* name, const QList<QWidget*>& pieces, QWidget* window) {
  auto* side = new QWidget(window);
  side->setObjectName(QString::fromLatin1(name));
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  for (auto* piece : pieces) {
    column->addWidget(piece, piece == pieces.front() && pieces.size() == 2 ? 0 : 1);
    piece->setVisible(piece == pieces.back());
  }
  return side;
}

}  // namespace

Characters::Characters(Desk& desk)
    : Workplace(desk),
      practice_(desk.practice()),
      actions_(new CharacterActions(&desk.window())),
      session_actions_(new SessionActions(&desk.window())),
      library_panel_(new LibraryPanel(&desk.library(), &desk.window())),
      information_panel_(new InformationPanel(&desk.window())),
      writing_panel_(new WritingPanel(&desk.window())),
      draw_panel_(new DrawPanel(desk, &desk.window())),
      session_panel_(new SessionPanel(desk.session(), *session_actions_, desk.learner(), &desk.window())),
      session_bar_(new SessionBar(desk.session(), *session_actions_, desk.learner(), &desk.window())),
      left_side_(stack_up("left_side", {draw_panel_, session_panel_, library_panel_}, &desk.window())),
      right_side_(stack_up("right_side", {writing_panel_, information_panel_}, &desk.window())),
      files_(new FileExchange(&desk.workshop(), &desk.window())) {
  const Preferences& preferences = desk.preferences();
  auto& tablet = desk.tablet();
  tablet.set_strokes_visible(preferences.strokes_visible);
  tablet.set_numbers_visible(preferences.numbers_visible);
  tablet.set_arrows_visible(preferences.arrows_visible);
  tablet.set_snapping(preferences.snapping);
  practice_.watch().set_reduced_motion(preferences.reduced_motion);
  practice_.set_first_character(preferences.kanji);
  files_->set_folder(preferences.folder);
  library_panel_->show_list(preferences.list);
  make_pages();
  actions_->adopt(*session_actions_);
  connect_actions();
  connect_practice();
  connect_work();
  connect_session();
  connect_study_actions();
}

void Characters::make_pages() {
  memory_page_ = new MemoryPage(practice_.memory(), desk(), *actions_, writing_panel_);
  stages_ = {
      {QStringLiteral("watch"), actions_->watch, new WatchPage(practice_.watch(), desk(), *actions_)},
      {QStringLiteral("trace"), actions_->trace, new TracePage(practice_.trace(), desk(), *actions_)},
      {QStringLiteral("guided"), actions_->guided, new GuidedPage(practice_.guided(), desk(), *actions_)},
      {QStringLiteral("memory"), actions_->memory, memory_page_}};
  QSettings settings(desk().settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  const QString last = settings.value(QStringLiteral("stage")).toString();
  for (const auto& entry : stages_) {
    entry.page->setParent(this);
    entry.page->load(settings);
    if (entry.id == last) practice_.enter_stage(entry.page->stage());
    connect(entry.action, &QAction::triggered, this,
            [this, page = entry.page] { practice_.enter_stage(page->stage()); });
  }
}

const Characters::StageEntry& Characters::current() const {
  return *std::find_if(stages_.begin(), stages_.end(), [this](const StageEntry& entry) {
    return &entry.page->stage() == &practice_.current_stage();
  });
}

Characters::~Characters() = default;

QString Characters::id() const { return QStringLiteral("characters"); }
QString Characters::name() const { return tr("&Characters"); }
QString Characters::purpose() const { return tr("Carved characters to see, feel and write"); }
Icon Characters::drawing() const { return Icon::strokes; }

QString Characters::title() const {
  if (practice_.current_stage().hides_character()) return tr("Write from memory");
  if (practice_.own().tablet) return to_text(practice_.own().name);
  return practice_.tablet() ? to_text(desk().preferences().kanji) : QString();
}

Workplace::Panel Characters::left() const {
  return {left_side_, tr("&List of characters"), tr("Show or fold away the list")};
}

Workplace::Panel Characters::right() const {
  return {right_side_, tr("&Information"), tr("Show or fold away the information")};
}

QWidget* Characters::under_tablet() const { return session_bar_; }

ActionSet* Characters::actions() const { return actions_; }

QList<Tool> Characters::tools() const {
  QList<Tool> tools;
  for (const auto& entry : stages_) tools.append({entry.action, true});
  tools.append(Tool{});
  tools.append(current().page->tools());
  return tools;
}

QString Characters::tablet_description() const {
  return tr(
      "The character as grooves to be traced: the left button presses the stylus down, the right button "
      "turns");
}

void Characters::enter() {
  practice_.enter();
  show_session();
}

void Characters::leave() {
  practice_.leave();
  session_bar_->hide();
}

void Characters::show_stage() {
  for (const auto& entry : stages_)
    for (auto* action : entry.page->own_actions()) action->setEnabled(false);
  current().action->setChecked(true);
  for (auto* action : current().page->own_actions()) action->setEnabled(true);
  emit tools_changed();
  desk().save_later();
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
  searching_ = false;
  desk().preferences().kanji = sheet->character.code_point;
  practice_.set_first_character(sheet->character.code_point);
  desk().save_later();
  for (const auto& entry : stages_) entry.action->setEnabled(true);
  information_panel_->show_character(sheet);
}

void Characters::show_own() {
  const auto& own = practice_.own();
  const QString name = to_text(own.name);
  information_panel_->show_own(name, own.map_size, desk().tablet().stroke_count());
  desk().say(Feedback::good, own.has_strokes
                                 ? tr("%1 is on the desk.").arg(name)
                                 : tr("%1 is on the desk. A .str file adds its strokes.").arg(name));
}

void Characters::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("stage"), current().id);
  for (const auto& entry : stages_) entry.page->save(settings);
}

void Characters::open_drawing(bool open) {
  if (open) desk().open_left_panel();
  draw_panel_->setVisible(open);
  actions_->draw_to_find->setChecked(open);
  show_session();
  if (open)
    draw_panel_->begin();
  else
    desk().focus_tablet();
}

void Characters::close_drawing() {
  open_drawing(false);
  // What was said of the drawing holds no more.
  desk().say(Feedback::hint, tr("Closed. What lies on the tablet stays."));
}

void Characters::take_appearance() {
  information_panel_->refresh();
  session_actions_->draw_icons();
  session_bar_->refresh();
  session_panel_->refresh();
}

bool Characters::opens(const QStringList& paths) const {
  return std::all_of(paths.begin(), paths.end(), [](const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    return suffix == QLatin1String("raw") || suffix == QLatin1String("png") || suffix == QLatin1String("str");
  });
}

void Characters::open_files(const QStringList& paths) {
  if (files_->open(paths, practice_.own())) practice_.expect_files();
}

void Characters::ask_and_open() {
  if (files_->ask_and_open(practice_.own())) practice_.expect_files();
}

void Characters::ask_and_save() {
  const auto& own = practice_.own();
  const QString file_name =
      own.tablet ? to_text(own.name).section(QLatin1Char('.'), 0, 0) : to_text(desk().preferences().kanji);
  files_->ask_and_save(practice_.tablet(), own, file_name);
}

void Characters::connect_actions() {
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(actions_->find, [this] {
    if (actions_->draw_to_find->isChecked()) open_drawing(false);
    searching_ = true;
    show_session();
    desk().open_left_panel();
    library_panel_->focus_search();
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
            [this](char32_t character) { emit desk().character_shown(character); });
  subscribe(practice_.character_missing, this, [this](char32_t character) {
    desk().say(Feedback::advice,
               tr("%1 has no strokes in the database. The tablet is as it was.").arg(to_text(character)));
  });
  subscribe(practice_.own_arrived, this, [this] {
    for (const auto& entry : stages_) entry.action->setEnabled(entry.action == actions_->trace);
  });
  subscribe(practice_.own_shown, this, [this] { show_own(); });
  subscribe(practice_.wanted, this, [this] { emit wants_to_be_entered(); });
  subscribe(practice_.feedback, this,
            [this](const practice::PracticeStage&, const practice::StageFeedback& feedback) {
              desk().say(to_feedback(feedback.tone), StageWords::sentence(feedback, &practice_.memory()));
            });
}

void Characters::connect_work() {
  connect(&desk(), &Desk::character_wanted, this, [this](char32_t code_point) {
    practice_.show(code_point);
    emit wants_to_be_entered();
  });
  connect(files_, &FileExchange::say, &desk(), &Desk::say);
  connect(files_, &FileExchange::folder_changed, this, [this](const QString& folder) {
    desk().preferences().folder = folder;
    desk().save_later();
  });
  connect(library_panel_, &LibraryPanel::character_chosen, this, [this](char32_t code_point) {
    practice_.show(code_point);
    desk().close_drawers();
  });
  connect(library_panel_, &LibraryPanel::list_changed, this, [this](kanji::List list) {
    desk().preferences().list = list;
    desk().save_later();
  });
  connect(information_panel_, &InformationPanel::character_chosen, this,
          [this](char32_t code_point) { practice_.show(code_point); });
  connect(draw_panel_, &DrawPanel::closed, this, &Characters::close_drawing);
  connect(draw_panel_, &DrawPanel::character_chosen, this, [this](char32_t code_point) {
    open_drawing(false);
    practice_.show(code_point);
    desk().close_drawers();
  });
}

}  // namespace nazori::ui
