// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/brush_page.h"

#include <QHBoxLayout>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_review_bar.h"
#include "nazori/studio/brush/brush_words.h"
#include "nazori/studio/brush/tools_panel.h"
#include "nazori/studio/parts/key_writing.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kFrame_ms = 16;
constexpr double kAlmostDry = 0.12;
constexpr std::array<std::string_view, 3> kPlaces{"none", "beneath", "beside"};

}  // namespace

BrushPage::BrushPage(WindowParts& parts, int cells)
    : Page(parts,
           {QStringLiteral("brush"), tr("&Brush"), tr("Write with brush and ink on paper"), Icon::brush, {}}),
      cells_(cells),
      actions_(new BrushActions(&parts.window())),
      widget_(named(new QWidget(&parts.window()), "brush_page")),
      paper_(new PaperView(widget_)),
      panel_(new BrushToolsPanel(*actions_, widget_)),
      bar_(new BrushReviewBar(parts.brush_session(), parts.learner(), *actions_, widget_)),
      ground_(
          paint::Sheet::kSide_m,
          [this](geometry::TabletPoint at, bool down, double pressure) {
            paper_->move_brush({at.x, at.y}, down, pressure);
          },
          [this] { paper_->take_brush_away(); }),
      key_writing_(new KeyWriting(
          parts, ground_, {actions_->by_key, actions_->press, actions_->next_start, actions_->where},
          [this](const QObject* one) { return one == paper_; }, this)),
      felt_(inbox_.inbox(), parts.tablet(), [this] { return paper_->pen_clock_s(); }) {
  auto* row = new QHBoxLayout(widget_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  column->addWidget(bar_);
  column->addWidget(paper_, 1);
  row->addLayout(column, 1);
  row->addWidget(panel_);
  widget_->setFocusProxy(paper_);
  timer_.setInterval(kFrame_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  QSettings settings(parts.settings_file(), QSettings::IniFormat);
  settings.beginGroup(id());
  load(settings);
  connect_actions();
  connect_panel();
  connect_paper();
  connect_keys();
  connect_font_models();
  connect_device();
  connect_reviews();
  subscribe(parts.library().characters_ready, this, [this](const std::vector<kanji::Character>& characters) {
    for (const auto& character : characters) characters_[character.code_point] = character;
    if (entered_) show_model();
    if (reviews()) show_reviews();
  });
}

BrushPage::~BrushPage() = default;

QString BrushPage::title() const { return file_; }
QWidget* BrushPage::instead_of_tablet() const { return widget_; }
ActionSet* BrushPage::actions() const { return actions_; }

QList<Tool> BrushPage::tools() const {
  return {{actions_->dip_in_ink, true},
          {actions_->dip_in_water, true},
          {actions_->wipe, true},
          {},
          {actions_->undo, true},
          {actions_->redo, true},
          {},
          {actions_->dry, true},
          {actions_->new_sheet, true},
          {},
          {actions_->tools}};
}

void BrushPage::load(const QSettings& settings) {
  const base::Settings values = read_settings(settings);
  const auto known = [&](std::string_view key, const auto& names, const std::string& fallback) {
    const std::string text(base::text_setting(values, key));
    return std::find(names.begin(), names.end(), text) == names.end() ? fallback : text;
  };
  choice_.paper = known("paper", paint::paper_names(), choice_.paper);
  choice_.ink = known("ink", calligraphy::kInks, choice_.ink);
  choice_.brush.size = base::named_setting(values, "size", calligraphy::kBrushSizes, choice_.brush.size);
  choice_.brush.hair = base::named_setting(values, "hair", calligraphy::kHairs, choice_.brush.hair);
  choice_.ruling = static_cast<int>(base::number_setting(values, "ruling", choice_.ruling, 0, 6));
  choice_.place = base::named_setting(values, "model", kPlaces, choice_.place);
  const auto fonts = author::brush_fonts();
  const std::string font(base::text_setting(values, "font"));
  if (std::any_of(fonts.begin(), fonts.end(), [&](const auto& one) { return one.family == font; }))
    choice_.font = font;
  choice_.text = to_text(base::text_setting(values, "text"));
  choice_.guess_pressure = base::flag_setting(values, "guess_pressure", choice_.guess_pressure);
  choice_.left_hand = base::flag_setting(values, "left_hand", parts().preferences().left_handed);
  choice_.strengthen = base::flag_setting(values, "strengthen", choice_.strengthen);
  choice_.show_brush = base::flag_setting(values, "show_brush", choice_.show_brush);
  choice_.show_tools = base::flag_setting(values, "show_tools", choice_.show_tools);
  actions_->guess_pressure->setChecked(choice_.guess_pressure);
  actions_->left_hand->setChecked(choice_.left_hand);
  actions_->strengthen->setChecked(choice_.strengthen);
  actions_->show_brush->setChecked(choice_.show_brush);
  actions_->tools->setChecked(choice_.show_tools);
  panel_->setVisible(choice_.show_tools);
  panel_->show_text(choice_.text);
  paper_->set_left_hand(choice_.left_hand);
  paper_->set_shows_brush(choice_.show_brush);
}

void BrushPage::save(QSettings& settings) const {
  auto values = read_settings(settings);
  values.insert_or_assign("paper", choice_.paper);
  values.insert_or_assign("ink", choice_.ink);
  values.insert_or_assign(
      "size", std::string(calligraphy::kBrushSizes[static_cast<std::size_t>(choice_.brush.size)]));
  values.insert_or_assign("hair",
                          std::string(calligraphy::kHairs[static_cast<std::size_t>(choice_.brush.hair)]));
  base::set_number(values, "ruling", choice_.ruling);
  values.insert_or_assign("model", std::string(kPlaces[static_cast<std::size_t>(choice_.place)]));
  values.insert_or_assign("font", choice_.font);
  values.insert_or_assign("text", choice_.text.toStdString());
  base::set_flag(values, "guess_pressure", choice_.guess_pressure);
  base::set_flag(values, "left_hand", choice_.left_hand);
  base::set_flag(values, "strengthen", choice_.strengthen);
  base::set_flag(values, "show_brush", choice_.show_brush);
  base::set_flag(values, "show_tools", choice_.show_tools);
  write_settings(settings, values);
}

void BrushPage::enter() {
  entered_ = true;
  if (!writing_) start_writing();
  // As the panels beside the tablet: on the other side for the left hand.
  static_cast<QHBoxLayout*>(widget_->layout())
      ->setDirection(parts().preferences().left_handed ? QBoxLayout::RightToLeft : QBoxLayout::LeftToRight);
  show_place();
  panel_->show_ruling(ruling());
  if (!fonts_) font_models_.list();
  request_model();
  parts().note_opened();
  felt_.enter();
  parts().announce(
      Feedback::hint,
      felt_.is_felt()
          ? tr("Lower the stylus onto the sheet: you feel the brush. A button of the stylus, or I: ink. S: "
               "what is on the sheet.")
          : tr("Write on the sheet with mouse, pen or finger, or by keys (M). I: ink. W: water. S: what "
               "is on the sheet."));
  wake();
}

void BrushPage::leave() {
  entered_ = false;
  stop_teacher();
  key_writing_->end();
  felt_.leave();
  writing_->lift_pen();
}

void BrushPage::refresh_appearance() { paper_->refresh_appearance(); }

void BrushPage::start_writing() {
  writing_ = std::make_unique<calligraphy::BrushWriting>(inbox_.inbox(), choice_.paper, cells_);
  paper_->set_picture_side(writing_->size());
  subscribe(writing_->drawn, this, [this](const calligraphy::BrushFrame& frame) { show_frame(frame); });
  subscribe(writing_->done, this, [this](const calligraphy::Outcome& outcome) { show_outcome(outcome); });
  writing_->set_brush(choice_.brush);
  felt_.set_brush(calligraphy::form_of(choice_.brush));
  set_feeling();
  starts_ = choice_.ink != "sumi" && choice_.paper != calligraphy::kWater;
  if (starts_) writing_->set_ink(choice_.ink);
  set_handling();
}

void BrushPage::wake() {
  if (timer_.isActive()) return;
  since_tick_.start();
  timer_.start();
}

void BrushPage::tick() {
  const double seconds = static_cast<double>(since_tick_.nsecsElapsed()) * 1e-9;
  since_tick_.start();
  move_hand(seconds);
  writing_->tick(seconds);
  if (!writing_->is_busy() && !is_watching()) timer_.stop();
}

void BrushPage::show_frame(const calligraphy::BrushFrame& frame) {
  paper_->show_frame(frame);
  const auto& state = frame.state;
  // In a session the sheet before belongs to another character.
  const auto can = [this](calligraphy::Edit edit) {
    return edit != calligraphy::Edit::none && !(reviews() && edit == calligraphy::Edit::new_sheet);
  };
  actions_->undo->setEnabled(can(state.undoes));
  actions_->redo->setEnabled(can(state.redoes));
  actions_->dry->setEnabled(state.is_wet);
  panel_->show_state(state);
  note_strokes(state.strokes);
  felt_.set_wetness(state.fullness);
  paper_->setAccessibleDescription(sheet_words());
  if (state.fullness > kAlmostDry) warned_dry_ = false;
  if (state.fullness < kAlmostDry && !state.is_writing && !warned_dry_) {
    warned_dry_ = true;
    parts().announce(Feedback::advice, tr("The brush is almost dry. I: dip it in ink."));
  }
  if (writing_->is_busy()) wake();
}

QString BrushPage::sheet_words() const {
  const auto& state = writing_->state();
  return QStringList{paper_words(state), paper_name(state.paper) + QLatin1Char('.'), model_words(),
                     brush_words(state)}
      .join(QLatin1Char(' '));
}

}  // namespace nazori::ui
