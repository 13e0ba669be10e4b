// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWindow>
#include <QStringList>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVariantAnimation>
#include <memory>
#include <optional>

#include "nazori/practice/tablet_control.h"
#include "nazori/view/tablet_view.h"

namespace nazori::ui {

/// The tablet on the screen, and the mouse or pen on the tablet. Draws only when something has changed. While
/// the stylus moves, draws at the rate of the screen and reads the newest pose of the servo just before
/// drawing.
///
/// One finger writes, two fingers move and zoom. While a pen is near, fingers and palm are ignored.
/// Left button or pen tip: stylus down, wheel or pressure: depth. Right button: turn and tilt. Middle button,
/// or right with Shift: move. Wheel: nearer and farther. Home: as at the start. The buttons on a pen's barrel
/// do the same while its tip is up.
class TabletWindow final : public QOpenGLWindow {
  Q_OBJECT
 public:
  explicit TabletWindow(practice::TabletControl* controller);
  ~TabletWindow() override;

  /// OpenGL 3.3 core as the scene needs it.
  [[nodiscard]] static QSurfaceFormat surface_format();
  /// Whether this display can give such a context at all.
  [[nodiscard]] static bool is_possible();

  void set_theme(view::Theme theme);
  /// Numbers on the tablet grow with the text of the window.
  void set_text_size(int text_pt);
  void set_reduced_motion(bool reduced) { reduced_motion_ = reduced; }
  /// The hand that writes: brush and light are on its side.
  void set_hand(view::Hand hand);

  /// Moves of the camera, for menus and keys. Amounts are those of a drag in logical pixels; a factor for
  /// zoom.
  void orbit_by(double right, double down);
  void pan_by(double right, double down);
  void zoom_by(double factor);
  void reset_camera();

 signals:
  void drawing_failed(nazori::base::Error error);
  void files_dropped(QStringList paths);
  /// Tab was pressed: the focus goes to the next or the previous widget.
  void focus_leaves(bool forwards);

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeGL(int width, int height) override;
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void touchEvent(QTouchEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Drag : std::uint8_t { none, stylus, orbit, pan };

  [[nodiscard]] geometry::TabletShape shape() const;
  [[nodiscard]] std::optional<geometry::TabletPoint> point_under(QPointF position) const;
  void request_frame();
  void set_camera(const view::Camera& camera);
  void update_style();
  void glide_to(const view::Camera& camera);
  /// The camera after a drag: to the right turns the tablet to the right, upwards lays it flatter.
  [[nodiscard]] view::Camera turned(QPointF drag) const;
  [[nodiscard]] view::Camera panned(QPointF from, QPointF to) const;
  [[nodiscard]] view::Camera zoomed(double factor, QPointF at) const;
  void drag_camera(QPointF to);
  /// @param event_ms  of the window system's clock, 0 unknown.
  void point_stylus(QPointF position, bool pressed, std::optional<double> pressure, quint64 event_ms);
  [[nodiscard]] bool pen_is_near() const;
  void begin_drag(Drag drag, QPointF position);
  void release_graphics();

  practice::TabletControl* controller_;
  std::unique_ptr<view::TabletView> view_;
  view::Theme theme_ = view::Theme::light;
  view::Style style_;
  view::Camera camera_;
  double text_scale_ = 1;
  bool tablet_stale_ = true;
  view::Hand hand_ = view::Hand::right;
  bool reduced_motion_ = false;
  bool pen_down_ = false;
  bool pen_in_proximity_ = false;
  QElapsedTimer since_pen_;  ///< last event of a pen; not valid: none yet
  int fingers_ = 0;          ///< on the tablet
  QPointF pinch_middle_;
  double pinch_apart_ = 0;
  Drag drag_ = Drag::none;
  QPointF drag_from_;
  haptics::Vec3 drawn_proxy_m_{0};
  haptics::Vec3 drawn_device_m_{0};
  QElapsedTimer since_frame_;
  QElapsedTimer since_move_;
  QTimer frame_timer_;
  QTimer still_timer_;
  QVariantAnimation glide_;
};

}  // namespace nazori::ui
