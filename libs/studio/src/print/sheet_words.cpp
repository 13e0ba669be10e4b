// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/sheet_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::SheetWords)
};

using scan::CellFlaw;
using scan::CellState;

QString remark_words(const scan::CellRemark& remark) {
  switch (remark.flaw) {
    case CellFlaw::small:
      return Words::tr("too small");
    case CellFlaw::large:
      return Words::tr("too large");
    case CellFlaw::high:
      return Words::tr("too high");
    case CellFlaw::low:
      return Words::tr("too low");
    case CellFlaw::left:
      return Words::tr("too far left");
    case CellFlaw::right:
      return Words::tr("too far right");
    case CellFlaw::leans_left:
      return Words::tr("leans to the left");
    case CellFlaw::leans_right:
      return Words::tr("leans to the right");
    case CellFlaw::missing_stroke:
      return Words::tr("stroke %1 is missing").arg(remark.stroke);
    case CellFlaw::short_stroke:
      return Words::tr("stroke %1 is too short").arg(remark.stroke);
    case CellFlaw::extra_ink:
      return Words::tr("has ink that belongs to no stroke");
  }
  return {};
}

}  // namespace

QString sheet_words(const scan::SheetReading& sheet) {
  const auto count = [&](CellState state) {
    return static_cast<int>(std::count_if(sheet.cells.begin(), sheet.cells.end(),
                                          [state](const auto& cell) { return cell.state == state; }));
  };
  const int cells = static_cast<int>(sheet.cells.size()) - count(CellState::traced);
  const QString kind = sheet.mark.layout == print::Layout::quiz ? Words::tr("Quiz, page %1:")
                                                                : Words::tr("Practice sheet, page %1:");
  return kind.arg(sheet.mark.page) + QLatin1Char(' ') + Words::tr("%n cells, ", nullptr, cells) +
         Words::tr("%1 legible, %2 not legible, %3 empty.")
             .arg(count(CellState::legible))
             .arg(count(CellState::illegible))
             .arg(count(CellState::empty));
}

bool needs_care(const scan::CellReading& cell) {
  return cell.state == CellState::illegible || (cell.state == CellState::legible && !cell.remarks.empty());
}

QString cell_words(std::size_t number, const scan::CellReading& cell) {
  QString what;
  if (cell.state == CellState::illegible) {
    what = cell.looks_like ? Words::tr("not legible, looks like %1").arg(to_text(*cell.looks_like))
                           : Words::tr("not legible");
  } else {
    QStringList remarks;
    for (const auto& remark : cell.remarks) remarks.append(remark_words(remark));
    what = remarks.isEmpty() ? Words::tr("legible") : remarks.join(Words::tr(", "));
  }
  return Words::tr("Cell %1, %2: %3").arg(number).arg(to_text(cell.box.character), what);
}

}  // namespace nazori::ui
