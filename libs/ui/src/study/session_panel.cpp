// SPDX-License-Identifier: Apache-2.0
#include "study/session_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <initializer_list>

#include "nazori/practice/character_history.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"
#include "study/ink_gallery.h"

namespace nazori::ui {
namespace {

constexpr std::size_t kMostEarlier = 3;
constexpr std::size_t kMostHardStrokes = 3;

}  // namespace

SessionPanel::SessionPanel(const practice::StudySession& session, practice::Learner& learner, QWidget* parent)
    : QWidget(parent), session_(session), learner_(learner) {
  setObjectName(QStringLiteral("session_panel"));
  setAccessibleName(tr("Character being studied"));
  kind_ = text_label("session_kind", this);
  history_ = text_label("session_history", this);
  mistakes_ = text_label("session_faults", this);
  parts_ = text_label("session_parts", this);
  ink_heading_ = text_label("session_ink_heading", this, "heading");
  ink_heading_->setText(tr("Earlier writing"));
  gallery_ = new InkGallery(this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  for (QWidget* one :
       std::initializer_list<QWidget*>{kind_, history_, mistakes_, parts_, ink_heading_, gallery_})
    column->addWidget(one);
  hide();
}

QString SessionPanel::why() const {
  if (session_.is_leech_lesson()) return tr("Relearning: forgotten too often");
  switch (session_.task().kind) {
    case study::TaskKind::step:
      return tr("Again today");
    case study::TaskKind::review:
      return tr("Review");
    case study::TaskKind::fresh:
      return tr("New");
  }
  return {};
}

QString SessionPanel::history() const {
  const auto card = learner_.store().card(session_.character());
  if (card.memory.reps == 0) return tr("Not yet written from memory.");
  QStringList said{tr("Written from memory: %n times", nullptr, card.memory.reps)};
  if (card.memory.lapses > 0) said.append(tr("Forgotten: %n times", nullptr, card.memory.lapses));
  return said.join(QLatin1Char('\n'));
}

QString SessionPanel::hard_strokes() const {
  QStringList lines;
  for (const auto& hard : practice::hard_strokes(learner_, session_.character(), kMostHardStrokes))
    lines.append(tr("Stroke %1 was wrong %n times.", nullptr, hard.times).arg(hard.stroke + 1));
  return lines.join(QLatin1Char('\n'));
}

void SessionPanel::show_ink() {
  std::vector<InkGallery::Piece> pieces;
  if (session_.state() == practice::StudySession::State::judged && !session_.is_away()) {
    if (!session_.ink().empty()) pieces.push_back({session_.ink(), tr("now")});
    const auto earlier = practice::earlier_writings(learner_, session_.character(), kMostEarlier);
    if (earlier && earlier->empty()) pieces.clear();
    for (const auto& one : earlier.value_or(std::vector<practice::EarlierWriting>()))
      pieces.push_back({one.ink, QStringLiteral("%1\n%2").arg(StudyWords::short_day(one.day),
                                                              StudyWords::rating(one.rating))});
  }
  ink_heading_->setVisible(!pieces.empty());
  gallery_->show_pieces(std::move(pieces));
}

void SessionPanel::show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet) {
  sheet_ = sheet;
  setVisible(session_.is_running() && !session_.is_away());
  if (!session_.is_running()) return;
  QFont large = font();
  large.setWeight(QFont::DemiBold);
  kind_->setFont(large);
  kind_->setText(why());
  history_->setText(history());
  const bool secret = session_.asks_from_memory();
  const QString hard = secret ? QString() : hard_strokes();
  mistakes_->setText(hard);
  mistakes_->setVisible(!hard.isEmpty());
  QStringList parts;
  if (!secret && sheet && sheet->character.code_point == session_.character())
    for (const auto& part : sheet->parts)
      parts.append(part.meaning.empty()
                       ? to_text(part.element)
                       : QStringLiteral("%1 %2").arg(to_text(part.element), to_text(part.meaning)));
  parts_->setVisible(session_.is_leech_lesson() && !parts.isEmpty());
  parts_->setText(tr("Parts: %1.").arg(parts.join(QStringLiteral(" + "))));
  show_ink();
}

void SessionPanel::refresh() { show_state(std::shared_ptr<const practice::CharacterSheet>(sheet_)); }

}  // namespace nazori::ui
