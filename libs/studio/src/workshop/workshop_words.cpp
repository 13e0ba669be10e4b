// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/workshop_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "nazori/author/stroke_edits.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::WorkshopWords)
};

using author::EditKind;
using author::FindingKind;

QString done_words(EditKind kind) {
  switch (kind) {
    case EditKind::none:
      return {};
    case EditKind::draw_stroke:
      return Words::tr("stroke drawn");
    case EditKind::add_strokes:
      return Words::tr("strokes added");
    case EditKind::delete_stroke:
      return Words::tr("stroke deleted");
    case EditKind::insert_point:
      return Words::tr("point added");
    case EditKind::move_point:
      return Words::tr("point moved");
    case EditKind::delete_point:
      return Words::tr("point deleted");
    case EditKind::move_stroke:
      return Words::tr("stroke moved");
    case EditKind::split_stroke:
      return Words::tr("stroke split");
    case EditKind::join_strokes:
      return Words::tr("strokes joined");
    case EditKind::reverse_stroke:
      return Words::tr("stroke reversed");
    case EditKind::reorder_strokes:
      return Words::tr("order changed");
    case EditKind::set_ending:
      return Words::tr("ending changed");
    case EditKind::set_width:
      return Words::tr("width changed");
    case EditKind::set_depth:
      return Words::tr("depth changed");
    case EditKind::move_number:
      return Words::tr("number moved");
    case EditKind::set_facts:
      return Words::tr("details changed");
    case EditKind::groove:
      return Words::tr("groove cut");
    case EditKind::raise:
      return Words::tr("relief raised");
    case EditKind::smooth:
      return Words::tr("relief smoothed");
    case EditKind::erase:
      return Words::tr("relief erased");
    case EditKind::stamp:
      return Words::tr("stamp pressed");
    case EditKind::load_relief:
      return Words::tr("height map loaded");
    case EditKind::clear_relief:
      return Words::tr("relief cleared");
  }
  return {};
}

QString tenth(double value) { return QLocale().toString(value, 'f', 1); }

}  // namespace

QString tool_name(author::Tool tool) {
  switch (tool) {
    case author::Tool::draw:
      return Words::tr("Draw strokes");
    case author::Tool::place:
      return Words::tr("Place points");
    case author::Tool::edit:
      return Words::tr("Edit strokes");
    case author::Tool::groove:
      return Words::tr("Groove");
    case author::Tool::raise:
      return Words::tr("Raise");
    case author::Tool::smooth:
      return Words::tr("Smooth");
    case author::Tool::erase:
      return Words::tr("Erase");
    case author::Tool::stamp:
      return Words::tr("Stamp");
  }
  return {};
}

QString stamp_name(author::StampShape shape) {
  switch (shape) {
    case author::StampShape::dot:
      return Words::tr("Dot");
    case author::StampShape::ring:
      return Words::tr("Ring");
    case author::StampShape::bar:
      return Words::tr("Bar");
    case author::StampShape::cross:
      return Words::tr("Cross");
    case author::StampShape::square:
      return Words::tr("Square");
    case author::StampShape::triangle:
      return Words::tr("Triangle");
  }
  return {};
}

QString ending_name(kanji::StrokeEnding ending) {
  switch (ending) {
    case kanji::StrokeEnding::stop:
      return Words::tr("stop");
    case kanji::StrokeEnding::hook:
      return Words::tr("hook");
    case kanji::StrokeEnding::taper:
      return Words::tr("sweep");
    case kanji::StrokeEnding::either:
      return Words::tr("any ending");
  }
  return {};
}

QString edit_words(EditKind kind, author::EditWay way) {
  const QString done = done_words(kind);
  switch (way) {
    case author::EditWay::undone:
      return done.isEmpty() ? Words::tr("There is nothing to undo.") : Words::tr("Undone: %1.").arg(done);
    case author::EditWay::redone:
      return done.isEmpty() ? Words::tr("There is nothing to redo.") : Words::tr("Redone: %1.").arg(done);
    case author::EditWay::made:
      break;
  }
  return done.isEmpty() ? QString() : done.left(1).toUpper() + done.mid(1) + Words::tr(".");
}

QString selection_words(const author::OwnCharacter& character, const author::Selection& selection) {
  if (!selection.stroke) return {};
  const auto& stroke = character.strokes[*selection.stroke];
  QString words = Words::tr("Stroke %1 of %2, %3, %4.")
                      .arg(*selection.stroke + 1)
                      .arg(character.strokes.size())
                      .arg(ending_name(stroke.ending),
                           Words::tr("%n points", nullptr, static_cast<int>(stroke.points.size())));
  if (selection.number) {
    const auto at = author::number_places(character.strokes)[*selection.stroke];
    return words + QLatin1Char(' ') +
           Words::tr("Its number: %1 from the left, %2 from the top, %3.")
               .arg(
                   tenth(at.x), tenth(at.y),
                   stroke.number_position ? Words::tr("placed by hand") : Words::tr("placed by the program"));
  }
  if (!selection.point) return words;
  const auto& point = stroke.points[*selection.point];
  QString which = Words::tr("Point %1").arg(*selection.point + 1);
  if (*selection.point == 0)
    which = Words::tr("Start");
  else if (*selection.point + 1 == stroke.points.size())
    which = Words::tr("End");
  return words + QLatin1Char(' ') +
         Words::tr("%1: %2 from the left, %3 from the top, %4 wide.")
             .arg(which, tenth(point.at.x), tenth(point.at.y), tenth(2 * point.half_width));
}

QString character_words(const author::OwnCharacter& character) {
  const QString name = to_text(character.facts.name);
  QString words = name.isEmpty() ? Words::tr("No name yet") : name;
  words += Words::tr(": ");
  words += character.strokes.empty()
               ? Words::tr("no strokes.")
               : Words::tr("%n strokes.", nullptr, static_cast<int>(character.strokes.size()));
  if (!character.hand.is_untouched())
    words += QLatin1Char(' ') + Words::tr("The relief was changed by hand.");
  if (character.facts.instead_of)
    words += QLatin1Char(' ') +
             Words::tr("Used instead of the published %1.").arg(to_text(*character.facts.instead_of));
  return words;
}

QString stroke_words(std::size_t number, const author::OwnStroke& stroke) {
  return Words::tr("%1  %2").arg(number).arg(ending_name(stroke.ending));
}

QString finding_words(const author::Finding& finding) {
  const QString stroke = QString::number(finding.stroke.value_or(0) + 1);
  const QString second = QString::number(finding.second.value_or(0) + 1);
  const QString amount = tenth(finding.amount);
  switch (finding.kind) {
    case FindingKind::no_strokes:
      return Words::tr("There are no strokes.");
    case FindingKind::no_name:
      return Words::tr("The character has no name.");
    case FindingKind::number_far:
      return Words::tr("Stroke %1: its number is far from its start.").arg(stroke);
    case FindingKind::numbers_overlap:
      return Words::tr("The numbers of strokes %1 and %2 cover each other.").arg(stroke, second);
    case FindingKind::number_hides_start:
      return Words::tr("The number of stroke %1 covers the start of stroke %2.").arg(stroke, second);
    case FindingKind::part_empty:
      return Words::tr("The part %1 has no strokes.").arg(to_text(finding.text));
    case FindingKind::stroke_in_no_part:
      return Words::tr("Stroke %1 belongs to no part.").arg(stroke);
    case FindingKind::outside:
      return Words::tr("Stroke %1 leaves the tablet.").arg(stroke);
    case FindingKind::no_length:
      return Words::tr("Stroke %1 has no length.").arg(stroke);
    case FindingKind::doubled:
      return Words::tr("Strokes %1 and %2 lie on each other.").arg(stroke, second);
    case FindingKind::ending_differs:
      return Words::tr("Stroke %1: its ending does not look as it is said to be.").arg(stroke);
    case FindingKind::point_off_line:
      return Words::tr("Stroke %1: the line turns back sharply at a point.").arg(stroke);
    case FindingKind::too_shallow:
      return Words::tr("Stroke %1 is too shallow to feel.").arg(stroke);
    case FindingKind::too_narrow:
      return Words::tr("Stroke %1 is narrower than the tip of a stylus.").arg(stroke);
    case FindingKind::thin_wall:
      return Words::tr("The wall between strokes %1 and %2 is too thin to feel (%3 of 109).")
          .arg(stroke, second, amount);
    case FindingKind::count_differs:
      return Words::tr("The dictionary counts %1 strokes.").arg(QLocale().toString(finding.amount, 'f', 0));
    case FindingKind::licence_lost:
      return Words::tr("A copy of a character of KanjiVG must name KanjiVG's licence and authors.");
    case FindingKind::svg_view_box:
    case FindingKind::svg_size:
    case FindingKind::svg_root_id:
    case FindingKind::svg_style:
    case FindingKind::svg_group_id:
    case FindingKind::svg_stroke_id:
    case FindingKind::svg_number_count:
    case FindingKind::svg_number_order:
      return Words::tr("The SVG is not as KanjiVG's tools expect it.");
    case FindingKind::no_licence:
      return Words::tr("No licence is named. Others will not know what they may do with it.");
  }
  return {};
}

}  // namespace nazori::ui
