// SPDX-License-Identifier: Apache-2.0
#include "characters/characters.h"

#include <QFileInfo>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "characters/character_actions.h"
#include "characters/draw_panel.h"
#include "characters/guided_stage.h"
#include "characters/information_panel.h"
#include "characters/library_panel.h"
#include "characters/memory_stage.h"
#include "characters/trace_stage.h"
#include "characters/watch_stage.h"
#include "characters/writing_panel.h"
#include "desk.h"
#include "error_text.h"
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
  auto& controller = desk.controller();
  controller.set_strokes_visible(preferences.strokes_visible);
  controller.set_numbers_visible(preferences.numbers_visible);
  controller.set_arrows_visible(preferences.arrows_visible);
  controller.set_snapping(preferences.snapping);
  files_->set_folder(preferences.folder);
  library_panel_->show_list(preferences.list);

  memory_ = new MemoryStage(desk, *actions_, writing_panel_);
  auto* trace = new TraceStage(desk, *actions_);
  guided_ = new GuidedStage(desk, *actions_);
  stages_ = {{QStringLiteral("watch"), actions_->watch, new WatchStage(desk, *actions_), study::Stage::watch},
             {QStringLiteral("trace"), actions_->trace, trace, study::Stage::trace},
             {QStringLiteral("guided"), actions_->guided, guided_, study::Stage::guided},
             {QStringLiteral("memory"), actions_->memory, memory_, study::Stage::memory}};
  QSettings settings(desk.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  memory_->load(settings);
  guided_->load(settings);
  const QString last = settings.value(QStringLiteral("stage")).toString();
  stage_ = trace;
  for (const auto& entry : stages_) {
    entry.stage->setParent(this);
    if (entry.id == last) stage_ = entry.stage;
    connect(entry.action, &QAction::triggered, this, [this, stage = entry.stage] { enter_stage(stage); });
    connect(entry.stage, &CharacterStage::hiding_changed, this, &Characters::show_hiding);
  }
  actions_->adopt(*session_actions_);
  connect_actions();
  connect_work();
  connect_session();
  connect_study_actions();
}

Characters::~Characters() = default;

QString Characters::id() const { return QStringLiteral("characters"); }
QString Characters::name() const { return tr("&Characters"); }
QString Characters::purpose() const { return tr("Carved characters to see, feel and write"); }
Icon Characters::drawing() const { return Icon::strokes; }

QString Characters::title() const {
  if (stage_->hides_character()) return tr("Write from memory");
  return own_.tablet ? to_text(own_.name) : tablet_ ? to_text(desk().preferences().kanji) : QString();
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
  tools.append(stage_->tools());
  return tools;
}

QString Characters::tablet_description() const {
  return tr(
      "The character as grooves to be traced: the left button presses the stylus down, the right button "
      "turns");
}

void Characters::enter() {
  entered_ = true;
  const auto& session = desk().session();
  // Back from another page: what was written goes on.
  returns_ = true;
  enter_stage(session.is_running() && !session.is_away() ? stage_for(session.stage()) : stage_);
  returns_ = false;
  show_session();
  if (!tablet_ && path_.empty() && !desk().session().is_running()) choose(desk().preferences().kanji, true);
}

void Characters::leave() {
  stage_->leave();
  session_bar_->hide();
  desk().controller().set_guides({});
  entered_ = false;
}

void Characters::enter_stage(CharacterStage* stage) {
  stage_->leave();
  stage_ = stage;
  for (const auto& entry : stages_) {
    for (auto* action : entry.stage->own_actions()) action->setEnabled(false);
    if (entry.stage == stage) entry.action->setChecked(true);
  }
  for (auto* action : stage->own_actions()) action->setEnabled(true);
  for (const auto& entry : stages_)
    if (entry.stage == stage && entered_) desk().session().enter_stage(entry.name);
  begin_lesson();
  show_hiding();
  emit tools_changed();
  desk().save_later();
}

void Characters::begin_lesson() {
  const auto& session = desk().session();
  const bool taught = session.is_running() && !session.is_away();
  guided_->set_help(taught ? std::optional(session.help()) : std::nullopt);
  for (const auto& entry : stages_)
    entry.stage->set_on_miss(taught ? [this](int stroke) { return desk().session().note_miss(stroke); }
                                    : CharacterStage::OnMiss());
  const bool unrated = session.state() == StudySession::State::judged;
  memory_->set_resumes(returns_ || (taught && unrated), unrated);
  stage_->enter({sheet_, tablet_});
}

void Characters::show_hiding() {
  const bool hidden = stage_->hides_character();
  information_panel_->set_hidden_character(hidden);
  library_panel_->set_current(hidden || !sheet_ ? 0 : sheet_->character.code_point);
  emit title_changed();
}

void Characters::save(QSettings& settings) const {
  for (const auto& entry : stages_)
    if (entry.stage == stage_) settings.setValue(QStringLiteral("stage"), entry.id);
  memory_->save(settings);
  guided_->save(settings);
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
  // A character that was asked for before must not come after the files.
  if (files_->open(paths, own_)) awaited_ = 0;
}

void Characters::ask_and_open() {
  if (files_->ask_and_open(own_)) awaited_ = 0;
}

void Characters::ask_and_save() {
  const QString file_name =
      own_.tablet ? to_text(own_.name).section(QLatin1Char('.'), 0, 0) : to_text(desk().preferences().kanji);
  files_->ask_and_save(tablet_, own_, file_name);
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
    if (const char32_t next = library_panel_->neighbour(+1)) choose(next, true);
  });
  on(actions_->previous_character, [this] {
    if (const char32_t before = library_panel_->neighbour(-1)) choose(before, true);
  });
  on(actions_->back, [this] { travel(-1); });
  on(actions_->forward, [this] { travel(+1); });
  on(actions_->draw_to_find, [this](bool open) {
    if (open)
      open_drawing(true);
    else
      close_drawing();
  });
}

void Characters::connect_work() {
  connect(&desk(), &Desk::character_wanted, this, [this](char32_t code_point) {
    choose(code_point, true);
    emit wants_to_be_entered();
  });
  subscribe(desk().library().sheet_ready, this,
            [this](const std::shared_ptr<const practice::CharacterSheet>& sheet) { take_sheet(sheet); });
  subscribe(desk().library().sheet_missing, this, [this](char32_t code_point) {
    desk().say(Feedback::advice,
               tr("%1 has no strokes in the database. The tablet is as it was.").arg(to_text(code_point)));
    if (!tablet_ && code_point != U'休') choose(U'休', false);
  });
  subscribe(desk().workshop().carved, this,
            [this](char32_t code_point, const practice::Tablet& tablet) { take_tablet(code_point, tablet); });
  subscribe(desk().workshop().loaded, this, [this](const practice::OwnTablet& loaded) { take_own(loaded); });
  subscribe(desk().workshop().failed, this, [this](const std::filesystem::path&, const base::Error&) {
    // Files that could not be opened leave the tablet as it was; there is none yet when the window opens.
    if (entered_ && !tablet_ && awaited_ == 0) choose(desk().preferences().kanji, true);
  });
  connect(files_, &FileExchange::say, &desk(), &Desk::say);
  connect(files_, &FileExchange::folder_changed, this, [this](const QString& folder) {
    desk().preferences().folder = folder;
    desk().save_later();
  });
  connect(library_panel_, &LibraryPanel::character_chosen, this, [this](char32_t code_point) {
    choose(code_point, true);
    desk().close_drawers();
  });
  connect(library_panel_, &LibraryPanel::list_changed, this, [this](kanji::List list) {
    desk().preferences().list = list;
    desk().save_later();
  });
  connect(information_panel_, &InformationPanel::character_chosen, this,
          [this](char32_t code_point) { choose(code_point, true); });
  connect(draw_panel_, &DrawPanel::closed, this, &Characters::close_drawing);
  connect(draw_panel_, &DrawPanel::character_chosen, this, [this](char32_t code_point) {
    open_drawing(false);
    choose(code_point, true);
    desk().close_drawers();
  });
}

void Characters::choose(char32_t code_point, bool remember) {
  if (remember && (path_.empty() || path_[step_] != code_point)) {
    // A new way from here: what lay ahead is forgotten.
    if (!path_.empty()) path_.resize(step_ + 1);
    path_.push_back(code_point);
    step_ = path_.size() - 1;
  }
  awaited_ = code_point;
  desk().library().request_sheet(code_point);
}

void Characters::travel(int by) {
  const auto to = static_cast<std::ptrdiff_t>(step_) + by;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(path_.size())) return;
  step_ = static_cast<std::size_t>(to);
  choose(path_[step_], false);
}

void Characters::take_sheet(const std::shared_ptr<const practice::CharacterSheet>& sheet) {
  if (sheet->character.code_point != awaited_) return;
  coming_ = sheet;
  searching_ = false;
  desk().workshop().carve(sheet->character);
}

void Characters::take_tablet(char32_t code_point, const practice::Tablet& tablet) {
  if (!coming_ || coming_->character.code_point != code_point) return;
  own_ = {};
  tablet_ = tablet;
  sheet_ = coming_;
  desk().preferences().kanji = code_point;
  desk().save_later();
  for (const auto& entry : stages_) entry.action->setEnabled(true);
  information_panel_->show_character(sheet_);
  auto& session = desk().session();
  session.take_sheet(sheet_);
  if (entered_) {
    // For who studies, at the stage that is due; else at the one at hand.
    if (session.is_running() && !session.is_away() && stage_for(session.stage()) != stage_)
      enter_stage(stage_for(session.stage()));
    else
      begin_lesson();
  }
  show_hiding();
  if (entered_) emit desk().character_shown(code_point);
}

void Characters::take_own(const practice::OwnTablet& loaded) {
  own_ = loaded;
  tablet_ = own_.tablet;
  sheet_ = nullptr;
  emit wants_to_be_entered();
  // What no dictionary knows can only be traced.
  for (const auto& entry : stages_) entry.action->setEnabled(entry.action == actions_->trace);
  for (const auto& entry : stages_)
    if (entry.action == actions_->trace && entry.stage != stage_) enter_stage(entry.stage);
  begin_lesson();
  desk().session().take_sheet(nullptr);
  information_panel_->show_own(to_text(own_.name), own_.map_size, desk().controller().stroke_count());
  show_hiding();
  desk().say(Feedback::good,
             own_.has_strokes
                 ? tr("%1 is on the desk.").arg(to_text(own_.name))
                 : tr("%1 is on the desk. A .str file adds its strokes.").arg(to_text(own_.name)));
}

}  // namespace nazori::ui
