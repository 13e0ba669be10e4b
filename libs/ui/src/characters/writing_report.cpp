// SPDX-License-Identifier: Apache-2.0
#include "characters/writing_report.h"

#include <QLabel>
#include <QVBoxLayout>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/writing_language.h"
#include "nazori/writing/explanation.h"

namespace nazori::ui {
namespace {

QString lines(const std::vector<std::string>& sentences) { return joined(sentences, QStringLiteral("\n")); }

}  // namespace

WritingReport::WritingReport(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("writing_report"));
  setAccessibleName(tr("Feedback on your writing"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  verdict_ = add_label("report_verdict", "title");
  mistakes_ = add_label("report_faults", "");
  parts_ = add_label("report_parts", "muted");
  pen_ = add_label("report_pen", "");
}

QLabel* WritingReport::add_label(const char* name, const char* role) {
  auto* label = sentence_label(name, this);
  label->setProperty("role", QString::fromLatin1(role));
  layout()->addWidget(label);
  return label;
}

QString WritingReport::verdict(const writing::Grade& grade) {
  if (!grade.accepted) return tr("Not quite");
  return grade.form ? tr("Correct. Form: %1").arg(stars(grade)) : tr("Correct");
}

QString WritingReport::stars(const writing::Grade& grade) {
  if (!grade.form) return verdict(grade);
  return QString(*grade.form, QChar(0x2605)) + QString(writing::kBestForm - *grade.form, QChar(0x2606));
}

QString WritingReport::spoken_verdict(const writing::Grade& grade) {
  if (!grade.form) return verdict(grade);
  return tr("Correct. Form: %1 of %2 stars").arg(*grade.form).arg(writing::kBestForm);
}

void WritingReport::show_grade(const writing::Grade& grade, const practice::PenReport& pen) {
  const auto language = writing_language();
  // A refused writing shows what to mend, and no figure beside it.
  verdict_->setText(verdict(grade));
  verdict_->setAccessibleName(spoken_verdict(grade));
  mistakes_->setText(lines(writing::explain(grade, language)));
  parts_->setText(lines(writing::explain_score(grade, language)));
  parts_->setVisible(grade.accepted);
  auto motion = writing::explain(pen.remarks, language);
  if (auto pace = writing::explain_pace(pen.motions, pen.remarks, language); !pace.empty())
    motion.insert(motion.begin(), std::move(pace));
  pen_->setText(lines(motion));
  pen_->setVisible(!motion.empty());
}

}  // namespace nazori::ui
