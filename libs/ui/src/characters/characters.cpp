// SPDX-License-Identifier: Apache-2.0
#include "characters/characters.h"

#include <QFileInfo>
#include <QWidgetAction>
#include <algorithm>

#include "characters/character_actions.h"
#include "characters/information_panel.h"
#include "characters/library_panel.h"
#include "characters/stroke_counter.h"
#include "desk.h"
#include "error_text.h"
#include "file_exchange.h"
#include "kanji_text.h"

namespace nazori::ui {

Characters::Characters(Desk& desk)
    : Workplace(desk),
      actions_(new CharacterActions(&desk.window())),
      library_panel_(new LibraryPanel(&desk.library(), &desk.window())),
      information_panel_(new InformationPanel(&desk.window())),
      counter_(new StrokeCounter(desk.controller())),
      files_(new FileExchange(&desk.workshop(), &desk.window())) {
  auto* place = new QWidgetAction(this);
  place->setDefaultWidget(counter_);
  counter_place_ = place;
  const Preferences& preferences = desk.preferences();
  auto& controller = desk.controller();
  controller.set_strokes_visible(preferences.strokes_visible);
  controller.set_numbers_visible(preferences.numbers_visible);
  controller.set_arrows_visible(preferences.arrows_visible);
  controller.set_snapping(preferences.snapping);
  files_->set_folder(preferences.folder);
  library_panel_->show_list(preferences.list);
  connect_actions();
  connect_work();
}

Characters::~Characters() = default;

QString Characters::id() const { return QStringLiteral("characters"); }
QString Characters::name() const { return tr("&Characters"); }
QString Characters::purpose() const { return tr("Carved characters to see, feel and write"); }
Icon Characters::drawing() const { return Icon::strokes; }

QString Characters::title() const {
  return own_.tablet ? own_.name : tablet_ ? to_text(desk().preferences().kanji) : QString();
}

Workplace::Panel Characters::left() const {
  return {library_panel_, tr("&List of characters"), tr("Show or fold away the list")};
}

Workplace::Panel Characters::right() const {
  return {information_panel_, tr("&Information"), tr("Show or fold away the information")};
}

ActionSet* Characters::actions() const { return actions_; }

QList<Tool> Characters::tools() const {
  return {{actions_->previous_stroke},
          {counter_place_},
          {actions_->next_stroke},
          {},
          {actions_->strokes, true},
          {actions_->numbers, true},
          {actions_->arrows, true},
          {actions_->snap, true},
          {},
          {actions_->clear_ink}};
}

QString Characters::tablet_description() const {
  return tr(
      "The character as grooves to be traced: the left button presses the stylus down, the right button "
      "turns");
}

void Characters::enter() {
  entered_ = true;
  if (tablet_) {
    desk().controller().set_tablet(tablet_);
    tell(StrokeTeller::invitation(desk().controller()));
  } else if (path_.empty()) {
    choose(desk().preferences().kanji, true);
  }
  show_state();
}

void Characters::leave() { entered_ = false; }

void Characters::take_appearance() { information_panel_->refresh(); }

bool Characters::opens(const QStringList& paths) const {
  return std::all_of(paths.begin(), paths.end(), [](const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    return suffix == QLatin1String("raw") || suffix == QLatin1String("png") || suffix == QLatin1String("str");
  });
}

void Characters::open_files(const QStringList& paths) { files_->open(paths, own_); }

void Characters::ask_and_open() { files_->ask_and_open(own_); }

void Characters::ask_and_save() {
  const QString file_name = own_.tablet ? own_.name.section(QLatin1Char('.'), 0, 0) : title();
  files_->ask_and_save(tablet_, own_, file_name);
}

void Characters::connect_actions() {
  auto& controller = desk().controller();
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(actions_->find, [this] {
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

  on(actions_->next_stroke, [this, &controller] {
    controller.next_stroke();
    tell(StrokeTeller::stroke_shown(controller));
  });
  on(actions_->previous_stroke, [this, &controller] {
    controller.previous_stroke();
    tell(StrokeTeller::stroke_shown(controller));
  });
  on(actions_->all_strokes, [this, &controller] {
    controller.set_current_stroke(0);
    tell(StrokeTeller::stroke_shown(controller));
  });
  on(actions_->strokes, [this, &controller](bool show) {
    controller.set_strokes_visible(show);
    tell(controller.snapping() ? StrokeTeller::snapping(controller) : StrokeTeller::invitation(controller));
  });
  on(actions_->numbers, [&controller](bool show) { controller.set_numbers_visible(show); });
  on(actions_->arrows, [&controller](bool show) { controller.set_arrows_visible(show); });
  on(actions_->snap, [this, &controller](bool hold) {
    controller.set_snapping(hold);
    tell(StrokeTeller::snapping(controller));
  });
  on(actions_->clear_ink, [this, &controller] {
    controller.clear_ink();
    tell(StrokeTeller::invitation(controller));
  });
}

void Characters::connect_work() {
  connect(&desk(), &Desk::character_wanted, this, [this](char32_t code_point) {
    choose(code_point, true);
    emit wants_to_be_entered();
  });
  connect(&desk().library(), &Library::sheet_ready, this,
          [this](const std::shared_ptr<const CharacterSheet>& sheet) { take_sheet(sheet); });
  connect(&desk().library(), &Library::sheet_missing, this, [this](char32_t code_point) {
    desk().say(Feedback::advice,
               tr("%1 has no strokes in the database. The tablet is as it was.").arg(to_text(code_point)));
    if (!tablet_ && code_point != U'休') choose(U'休', false);
  });
  connect(&desk().workshop(), &Workshop::carved, this,
          [this](char32_t code_point, const Tablet& tablet) { take_tablet(code_point, tablet); });
  connect(&desk().workshop(), &Workshop::loaded, this, [this](const OwnTablet& loaded) { take_own(loaded); });
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
  auto& controller = desk().controller();
  connect(&controller, &TabletController::state_changed, this, [this, &controller] {
    if (!entered_) return;
    Preferences& preferences = desk().preferences();
    preferences.strokes_visible = controller.strokes_visible();
    preferences.numbers_visible = controller.numbers_visible();
    preferences.arrows_visible = controller.arrows_visible();
    preferences.snapping = controller.snapping();
    show_state();
    desk().save_later();
  });
  connect(&controller, &TabletController::stroke_event, this,
          [this, &controller](InkEvent event, int stroke) {
            if (entered_) tell(StrokeTeller::about(event, stroke, controller));
          });
}

void Characters::tell(const StrokeTeller::Sentence& sentence) { desk().say(sentence.kind, sentence.text); }

void Characters::show_state() {
  const auto& controller = desk().controller();
  const std::pair<QAction*, bool> states[] = {
      {actions_->strokes, controller.strokes_visible()},
      {actions_->numbers, controller.numbers_visible()},
      {actions_->arrows, controller.arrows_visible()},
      {actions_->snap, controller.snapping()},
  };
  for (const auto& [action, checked] : states) action->setChecked(checked);
  for (auto* action : {actions_->next_stroke, actions_->previous_stroke, actions_->all_strokes})
    action->setEnabled(controller.stroke_count() > 0);
  for (auto* action : {actions_->numbers, actions_->arrows}) action->setEnabled(controller.strokes_visible());
  counter_->refresh();
}

void Characters::choose(char32_t code_point, bool remember) {
  if (remember && (path_.empty() || path_[step_] != code_point)) {
    // A new way from here: what lay ahead is forgotten.
    if (!path_.empty()) path_.resize(step_ + 1);
    path_.push_back(code_point);
    step_ = path_.size() - 1;
  }
  desk().library().request_sheet(code_point);
}

void Characters::travel(int by) {
  const auto to = static_cast<std::ptrdiff_t>(step_) + by;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(path_.size())) return;
  step_ = static_cast<std::size_t>(to);
  choose(path_[step_], false);
}

void Characters::take_sheet(const std::shared_ptr<const CharacterSheet>& sheet) {
  information_panel_->show_character(sheet);
  library_panel_->set_current(sheet->character.code_point);
  desk().workshop().carve(sheet->character);
}

void Characters::take_tablet(char32_t code_point, const Tablet& tablet) {
  own_ = {};
  tablet_ = tablet;
  desk().preferences().kanji = code_point;
  desk().save_later();
  emit title_changed();
  if (!entered_) return;
  desk().controller().set_tablet(tablet);
  tell(StrokeTeller::invitation(desk().controller()));
  emit desk().character_shown(code_point);
}

void Characters::take_own(const OwnTablet& loaded) {
  own_ = loaded;
  tablet_ = own_.tablet;
  if (!entered_) emit wants_to_be_entered();
  desk().controller().set_tablet(tablet_);
  information_panel_->show_own(own_.name, own_.map_size, desk().controller().stroke_count());
  library_panel_->set_current(0);
  emit title_changed();
  desk().say(Feedback::good, own_.has_strokes
                                 ? tr("%1 is on the desk.").arg(own_.name)
                                 : tr("%1 is on the desk. A .str file adds its strokes.").arg(own_.name));
}

}  // namespace nazori::ui
