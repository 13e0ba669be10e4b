// SPDX-License-Identifier: Apache-2.0
#include "characters/writing_report.h"

#include <QLabel>
#include <QVBoxLayout>

#include "kanji_text.h"
#include "nazori/writing/explanation.h"
#include "sentence_label.h"
#include "writing_language.h"

namespace nazori::ui {
namespace {

QString lines(const std::vector<std::string>& sentences) {
  QStringList list;
  for (const auto& sentence : sentences) list.append(to_text(sentence));
  return list.join(QLatin1Char('\n'));
}

}  // namespace

WritingReport::WritingReport(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("writing_report"));
  setAccessibleName(tr("What was found in your writing"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  points_ = add_label("report_points", "title");
  faults_ = add_label("report_faults", "");
  parts_ = add_label("report_parts", "muted");
  pen_ = add_label("report_pen", "");
}

QLabel* WritingReport::add_label(const char* name, const char* role) {
  auto* label = sentence_label(name, this);
  label->setProperty("role", QString::fromLatin1(role));
  layout()->addWidget(label);
  return label;
}

void WritingReport::show_grade(const writing::Grade& grade, const practice::PenReport& pen) {
  const auto language = writing_language();
  points_->setText(grade.accepted ? tr("Accepted: %1 of 100 points").arg(grade.score)
                                  : tr("Not yet: %1 of 100 points").arg(grade.score));
  faults_->setText(lines(writing::explain(grade, language)));
  parts_->setText(lines(writing::explain_score(grade, language)));
  auto motion = writing::explain(pen.remarks, language);
  if (auto pace = writing::explain_pace(pen.motions, pen.remarks, language); !pace.empty())
    motion.insert(motion.begin(), std::move(pace));
  pen_->setText(lines(motion));
  pen_->setVisible(!motion.empty());
}

}  // namespace nazori::ui
