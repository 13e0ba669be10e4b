// SPDX-License-Identifier: Apache-2.0
// What a widget draws, as a list of shapes, words and pictures in their order, each with its exact place.
#pragma once

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QResizeEvent>
#include <QScreen>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <vector>

#include "nazori/widgets/look/palette.h"

namespace nazori::ui::test {

/// UTF-8 as a text of Qt.
inline QString words(const char* text) { return QString::fromUtf8(text); }

/// The name of a colour of the window, else its number.
inline QString name_of(const QColor& colour) {
  const Colours& c = current_colours();
  const std::pair<const char*, QColor> all[] = {
      {"paper", c.paper}, {"surface", c.surface}, {"line", c.line},           {"edge", c.edge},
      {"ink", c.ink},     {"muted", c.muted},     {"vermilion", c.vermilion}, {"indigo", c.indigo},
      {"moss", c.moss},   {"amber", c.amber}};
  for (const auto& [name, known] : all)
    if (known.rgba() == colour.rgba()) return QString::fromLatin1(name);
  return colour.name(QColor::HexArgb);
}

/// One thing that was drawn. Lengths are those of the picture, also where the painter was scaled.
struct Drawn {
  enum class Kind { shape, words, picture };
  Kind kind = Kind::shape;
  QRectF box;           ///< of a shape without its pen; of words their width, from the ascent to the descent
  QPolygonF points;     ///< the corners of a shape
  double corner = 0;    ///< radius of a rounded box
  bool round = false;   ///< an ellipse
  QString text;         ///< the words
  double baseline = 0;  ///< of words
  QFont font;           ///< of words
  QPen pen{Qt::NoPen};  ///< its width as drawn
  QBrush fill{Qt::NoBrush};  ///< of a shape

  /// "indigo 2", "line 1 dashed", "none".
  [[nodiscard]] QString pen_words() const {
    if (pen.style() == Qt::NoPen) return QStringLiteral("none");
    const QString words = QStringLiteral("%1 %2").arg(name_of(pen.color())).arg(rounded(pen.widthF()));
    return pen.style() == Qt::SolidLine ? words : words + QStringLiteral(" dashed");
  }
  [[nodiscard]] QString fill_words() const {
    return fill.style() == Qt::NoBrush ? QStringLiteral("none") : name_of(fill.color());
  }
  /// To a hundredth, which is far below what can be seen.
  static double rounded(double value) { return std::round(value * 100) / 100 + 0.0; }
};

/// All that was drawn, in its order.
struct Drawing {
  std::vector<Drawn> all;

  [[nodiscard]] std::vector<Drawn> boxes() const {
    return some([](const Drawn& one) { return one.kind == Drawn::Kind::shape && one.points.size() > 2; });
  }
  [[nodiscard]] std::vector<Drawn> lines() const {
    return some([](const Drawn& one) { return one.kind == Drawn::Kind::shape && one.points.size() == 2; });
  }
  [[nodiscard]] std::vector<Drawn> pictures() const {
    return some([](const Drawn& one) { return one.kind == Drawn::Kind::picture; });
  }
  [[nodiscard]] std::vector<Drawn> words() const {
    return some([](const Drawn& one) { return one.kind == Drawn::Kind::words; });
  }
  /// The first words that begin so; none: words of no width.
  [[nodiscard]] Drawn words(const QString& begin) const {
    for (const Drawn& one : all)
      if (one.kind == Drawn::Kind::words && one.text.startsWith(begin)) return one;
    return {};
  }

 private:
  template <class Which>
  [[nodiscard]] std::vector<Drawn> some(Which which) const {
    std::vector<Drawn> found;
    std::copy_if(all.begin(), all.end(), std::back_inserter(found), which);
    return found;
  }
};

/// A place to draw on that remembers what is drawn.
class Recorder final : public QPaintDevice, private QPaintEngine {
 public:
  explicit Recorder(QSize size) : QPaintEngine(AllFeatures), size_(size) {}

  [[nodiscard]] const Drawing& picture() const { return picture_; }
  [[nodiscard]] QPaintEngine* paintEngine() const override {
    return const_cast<Recorder*>(this);  // Qt asks a constant device for what it draws with
  }

 protected:
  [[nodiscard]] int metric(PaintDeviceMetric which) const override {
    const double dpi = QGuiApplication::primaryScreen()->logicalDotsPerInch();
    switch (which) {
      case PdmWidth:
        return size_.width();
      case PdmHeight:
        return size_.height();
      case PdmDpiX:
      case PdmDpiY:
      case PdmPhysicalDpiX:
      case PdmPhysicalDpiY:
        return static_cast<int>(std::lround(dpi));
      case PdmDepth:
        return 32;
      case PdmDevicePixelRatio:
        return 1;
      case PdmDevicePixelRatioScaled:
        return static_cast<int>(devicePixelRatioFScale());
      default:
        return 0;
    }
  }

 private:
  bool begin(QPaintDevice* /*device*/) override { return true; }
  bool end() override { return true; }
  [[nodiscard]] Type type() const override { return User; }

  void updateState(const QPaintEngineState& now) override {
    const auto changed = now.state();
    if (changed.testFlag(DirtyPen)) pen_ = now.pen();
    if (changed.testFlag(DirtyBrush)) brush_ = now.brush();
    if (changed.testFlag(DirtyFont)) font_ = now.font();
    if (changed.testFlag(DirtyTransform)) transform_ = now.transform();
  }

  [[nodiscard]] Drawn with_pen() const {
    Drawn made;
    made.pen = pen_;
    if (!pen_.isCosmetic()) made.pen.setWidthF(pen_.widthF() * transform_.m11());
    made.fill = brush_;
    return made;
  }

  void drawPath(const QPainterPath& path) override {
    const QPainterPath seen = transform_.map(path);
    Drawn made = with_pen();
    made.box = seen.boundingRect();
    int curves = 0;
    for (int i = 0; i < seen.elementCount(); ++i) {
      made.points.append(seen.elementAt(i));
      curves += seen.elementAt(i).type == QPainterPath::CurveToElement ? 1 : 0;
    }
    // A rounded box begins where its left side meets the first corner.
    made.round = curves == 4 && seen.elementCount() == 13;
    if (curves == 4 && !made.round) made.corner = std::abs(made.points.front().y() - made.box.top());
    picture_.all.push_back(made);
  }
  void add_polygon(const QPolygonF& polygon, bool filled) {
    Drawn made = with_pen();
    if (!filled) made.fill = Qt::NoBrush;
    made.points = transform_.map(polygon);
    made.box = made.points.boundingRect();
    picture_.all.push_back(made);
  }
  void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
    add_polygon(QPolygonF(QList<QPointF>(points, points + count)), mode != PolylineMode);
  }
  void drawPolygon(const QPoint* points, int count, PolygonDrawMode mode) override {
    QPolygonF polygon;
    for (int i = 0; i < count; ++i) polygon.append(QPointF(points[i]));
    add_polygon(polygon, mode != PolylineMode);
  }
  void drawRects(const QRectF* rects, int count) override {
    for (int i = 0; i < count; ++i)
      add_polygon(
          QPolygonF({rects[i].topLeft(), rects[i].topRight(), rects[i].bottomRight(), rects[i].bottomLeft()}),
          true);
  }
  void drawRects(const QRect* rects, int count) override {
    for (int i = 0; i < count; ++i) {
      const QRectF rect(rects[i]);
      drawRects(&rect, 1);
    }
  }
  void drawLines(const QLineF* lines, int count) override {
    for (int i = 0; i < count; ++i) add_polygon(QPolygonF({lines[i].p1(), lines[i].p2()}), false);
  }
  void drawLines(const QLine* lines, int count) override {
    for (int i = 0; i < count; ++i)
      add_polygon(QPolygonF({QPointF(lines[i].p1()), QPointF(lines[i].p2())}), false);
  }
  void drawEllipse(const QRectF& rect) override {
    QPainterPath path;
    path.addEllipse(rect);
    drawPath(path);
  }
  void drawEllipse(const QRect& rect) override { drawEllipse(QRectF(rect)); }
  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    const QPointF place = transform_.map(at);
    Drawn made;
    made.kind = Drawn::Kind::words;
    made.pen = pen_;
    made.text = item.text();
    made.font = font_;
    made.baseline = place.y();
    made.box = QRectF(place.x(), place.y() - item.ascent(), item.width(), item.ascent() + item.descent());
    picture_.all.push_back(made);
  }
  void add_picture(const QRectF& rect) {
    Drawn made;
    made.kind = Drawn::Kind::picture;
    made.box = transform_.mapRect(rect);
    picture_.all.push_back(made);
  }
  void drawPixmap(const QRectF& rect, const QPixmap& /*picture*/, const QRectF& /*part*/) override {
    add_picture(rect);
  }
  void drawImage(const QRectF& rect, const QImage& /*picture*/, const QRectF& /*part*/,
                 Qt::ImageConversionFlags /*flags*/) override {
    add_picture(rect);
  }

  QSize size_;
  Drawing picture_;
  QPen pen_;
  QBrush brush_;
  QFont font_;
  QTransform transform_;
};

/// What a function draws on a picture of this size.
template <class Draw>
[[nodiscard]] Drawing drawn_by(QSize size, Draw draw) {
  Recorder recorder(size);
  QPainter painter(&recorder);
  draw(painter);
  painter.end();
  return recorder.picture();
}
/// What a widget draws, without the widgets inside it.
[[nodiscard]] inline Drawing drawn_by(QWidget& widget) {
  return drawn_by(widget.size(), [&](QPainter& painter) {
    widget.render(&painter, QPoint(), QRegion(), QWidget::RenderFlags());
  });
}

/// Gives a widget another size. One that is not shown is told of it only later.
inline void resize_unseen(QWidget& widget, QSize size) {
  const QSize before = widget.size();
  widget.resize(size);
  QResizeEvent event(size, before);
  QCoreApplication::sendEvent(&widget, &event);
}

/// A shape in words: its place, corner, pen and fill.
inline QString in_words(const Drawn& one) {
  const auto number = [](double value) { return QString::number(Drawn::rounded(value)); };
  const QStringList place{number(one.box.left()), number(one.box.top()), number(one.box.width()),
                          number(one.box.height())};
  QString shape = one.round ? QStringLiteral("disc ") : QStringLiteral("box ");
  if (one.kind == Drawn::Kind::picture) return QStringLiteral("picture ") + place.join(QLatin1Char(' '));
  if (one.points.size() == 2)
    return QStringLiteral("line %1 %2 %3 %4, %5")
        .arg(number(one.points[0].x()), number(one.points[0].y()), number(one.points[1].x()),
             number(one.points[1].y()), one.pen_words());
  shape += place.join(QLatin1Char(' '));
  if (one.corner > 0) shape += QStringLiteral(" corner ") + number(one.corner);
  return shape + QStringLiteral(", %1, %2").arg(one.pen_words(), one.fill_words());
}
inline QStringList in_words(const std::vector<Drawn>& all) {
  QStringList words;
  for (const Drawn& one : all) words.append(in_words(one));
  return words;
}

/// The words of a box as in_words() says it. @param pen  "indigo 2".
inline QString box_words(const QRectF& box, double corner, const QString& pen, const QString& fill) {
  const auto number = [](double value) { return QString::number(Drawn::rounded(value)); };
  QString words = QStringLiteral("box %1 %2 %3 %4")
                      .arg(number(box.left()), number(box.top()), number(box.width()), number(box.height()));
  if (corner > 0) words += QStringLiteral(" corner ") + number(corner);
  return words + QStringLiteral(", %1, %2").arg(pen, fill);
}
inline QString line_words(QPointF from, QPointF to, const QString& pen) {
  const auto number = [](double value) { return QString::number(Drawn::rounded(value)); };
  return QStringLiteral("line %1 %2 %3 %4, %5")
      .arg(number(from.x()), number(from.y()), number(to.x()), number(to.y()), pen);
}

}  // namespace nazori::ui::test
