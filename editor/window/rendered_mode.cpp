#include "editor/window/rendered_mode.h"

#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QtConcurrent>
#include <algorithm>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/controls/actions.h"
#include "editor/image/scale_bar.h"
#include "editor/rendering/cost_page.h"
#include "editor/rendering/fitted_image.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/scene_view.h"

namespace editor {
namespace {

/// The region that Return chooses, for those without a pointer.
const QRectF MiddleRegion(0.25, 0.25, 0.5, 0.5);
/// Fractions of the view; a smaller drag chooses no region.
constexpr double LeastRegionSide = 0.01;

/// Converts an image, or its error if that is not null, for the screen, transparent outside the region.
std::shared_ptr<const QImage> screen_image(const image::Image& image, const image::Image* error,
                                           const std::optional<job::PreviewRegion>& region) {
  const QImage whole = fitted(image, {image.width, image.height}, error);
  if (!region) return std::make_shared<const QImage>(whole);
  auto limited = std::make_shared<QImage>(whole.size(), QImage::Format_ARGB32_Premultiplied);
  limited->fill(Qt::transparent);
  const transport::CropWindow inside = job::pixels_of(*region, image.width, image.height);
  QPainter painter(limited.get());
  painter.setClipRect(inside.x, inside.y, inside.width, inside.height);
  painter.drawImage(0, 0, whole);
  return limited;
}

}  // namespace

RenderedMode::RenderedMode(SceneView& view, RenderPanel& panel, QWidget& window)
    : QObject(&window), view_(view), panel_(panel), error_scale_(new ScaleBar(&view)) {
  make_actions(window);
  error_scale_->setAccessibleName(tr("Scale of the error in the view"));
  error_scale_->set_settings(error_screen_settings());
  error_scale_->setAutoFillBackground(true);
  error_scale_->hide();
  connect(panel_.error_action(), &QAction::toggled, this, [this] {
    convert();
    show_note();
  });
  view_.installEventFilter(this);
  connect(&view_, &SceneView::view_changed, this, &RenderedMode::follow_view);
  Preview& preview = panel_.preview();
  connect(&preview, &Preview::image_changed, this, &RenderedMode::take);
  connect(&preview, &Preview::state_changed, this, &RenderedMode::show_note);
  connect(&preview, &Preview::stopped, this, &RenderedMode::show_note);
  connect(&conversion_, &QFutureWatcher<ScreenImage>::finished, this, &RenderedMode::show_converted);
}

RenderedMode::~RenderedMode() {
  conversion_.disconnect(this);
  conversion_.waitForFinished();
}

void RenderedMode::make_actions(QWidget& window) {
  limit_ = new_switch(
      window,
      {tr("Preview re&gion"),
       {},
       QKeySequence("Ctrl+Alt+W"),
       tr("Render the mode Rendered only in a rectangle that is dragged; Return takes the middle")},
      false, [this](bool is_wanted) { choose_region(is_wanted); });
  denoise_ = new_switch(window,
                        {tr("&Denoise the view"),
                         {},
                         QKeySequence("Ctrl+Alt+N"),
                         tr("Smooth the noise of the mode Rendered; renders to files are never denoised")},
                        false, [this](bool) { follow_view(); });
}

void RenderedMode::fill(QMenu& menu) { menu.addActions({limit_, denoise_, panel_.error_action()}); }

bool RenderedMode::is_on() const { return view_.mode() == DisplayMode::Rendered; }

void RenderedMode::follow_view() {
  if (is_on() && !view_.camera().is_orthographic() && view_.isVisible()) {
    panel_.set_preview_view(
        PreviewView{size_in_pixels(), view_.camera().view(), denoise_->isChecked(), preview_region()});
  } else {
    panel_.set_preview_view({});
    latest_.reset();
  }
  // The last image stays until the next one arrives, if one will.
  if (!panel_.preview().is_on()) view_.set_rendered(nullptr);
  show_note();
}

void RenderedMode::take(const SharedImage& image, const transport::RenderProgress& progress) {
  if (!is_on()) return;
  latest_ = image;
  done_ = progress.done;
  convert();
  show_note();
}

QSize RenderedMode::size_in_pixels() const {
  const double ratio = view_.devicePixelRatioF();
  return QSize(qRound(view_.width() * ratio), qRound(view_.height() * ratio)).expandedTo({1, 1});
}

std::optional<FramedRegion> RenderedMode::framed_region() const {
  if (!region_ || view_.camera().is_orthographic()) return std::nullopt;
  const QSize size = size_in_pixels();
  return FramedRegion{view_.camera().view(),
                      {size.width(), size.height()},
                      job::pixels_of(*preview_region(), size.width(), size.height())};
}

std::optional<job::PreviewRegion> RenderedMode::preview_region() const {
  if (!region_) return std::nullopt;
  return job::PreviewRegion{region_->left(), region_->top(), region_->right(), region_->bottom()};
}

/// Converts one image at a time: those that arrive meanwhile are skipped, except the last one.
void RenderedMode::convert() {
  waiting_ = latest_;
  if (conversion_.isRunning() || !waiting_) return;
  // Until there is an image of a smaller region, the last one is limited; one of a larger region comes soon.
  const auto region = region_ ? preview_region() : panel_.preview().region();
  conversion_.setFuture(QtConcurrent::run([image = std::exchange(waiting_, nullptr), error = shown_error(),
                                           region] { return screen_image(*image, error.get(), region); }));
}

/// Null if it is not shown, or not known yet.
RenderedMode::SharedImage RenderedMode::shown_error() const {
  const auto& accuracy = panel_.preview().accuracy();
  if (!panel_.error_action()->isChecked() || !accuracy) return nullptr;
  return {accuracy, &accuracy->error};
}

/// Shows the scale at the right of the view, below the note.
void RenderedMode::show_error_scale() {
  const bool is_shown = is_on() && panel_.error_action()->isChecked() && !view_.camera().is_orthographic();
  error_scale_->setVisible(is_shown);
  if (!is_shown) return;
  const int top = 5 * Grid;
  const QSize size(error_scale_->sizeHint().width(), std::min(40 * Grid, view_.height() - top - Grid));
  error_scale_->setGeometry({{view_.width() - size.width() - Grid, top}, size});
  QPalette palette = view_.palette();
  QColor ground = colours_of(theme_of(palette)).window;
  ground.setAlphaF(0.85F);
  palette.setColor(QPalette::Window, ground);
  error_scale_->setPalette(palette);
}

void RenderedMode::show_converted() {
  if (latest_) view_.set_rendered(conversion_.result());
  if (waiting_) convert();
}

void RenderedMode::show_note() {
  using job::PreviewState;
  show_error_scale();
  if (is_choosing_)
    return view_.set_note(tr("Drag the region to render, Return: the middle, Escape: cancel"));
  if (!is_on()) return view_.set_note({});
  if (view_.camera().is_orthographic()) return view_.set_note(tr("Rendered: only in perspective (5)"));
  const Preview& preview = panel_.preview();
  const QString percent = tr("%1 %").arg(100 * done_, 0, 'f', 0);
  QString note = !preview.is_on()      ? tr("Rendered: stopped")
                 : preview.is_paused() ? tr("Rendered: paused") + " · " + percent
                                       : tr("Rendered") + " · " + percent;
  const bool shows_error = panel_.error_action()->isChecked();
  if (shows_error) note += " · " + (preview.accuracy() ? tr("error of pixels") : tr("measuring the error"));
  if (denoise_->isChecked() && !(shows_error && preview.accuracy())) note += " · " + tr("denoised");
  view_.set_note(note);
}

// The region

void RenderedMode::choose_region(bool is_wanted) {
  if (!is_wanted) return end_choice({});
  is_choosing_ = true;
  pressed_at_.reset();
  view_.setCursor(Qt::CrossCursor);
  view_.setFocus();
  view_.set_tool_painter([this](QPainter& painter) {
    if (pressed_at_) painter.drawRect(QRectF(*pressed_at_, dragged_to_).normalized());
  });
  show_note();
}

void RenderedMode::end_choice(const std::optional<QRectF>& region) {
  region_ = region;
  if (std::exchange(is_choosing_, false)) {
    pressed_at_.reset();
    view_.unsetCursor();
    view_.set_tool_painter({});
  }
  limit_->setChecked(region.has_value());
  convert();
  follow_view();
  show_note();
}

bool RenderedMode::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show || event->type() == QEvent::Hide) follow_view();
  if (!is_choosing_) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
      return drag(static_cast<QMouseEvent&>(*event));
    case QEvent::KeyPress:
      return press_key(static_cast<QKeyEvent&>(*event));
    default:
      return QObject::eventFilter(watched, event);
  }
}

bool RenderedMode::press_key(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Escape) {
    end_choice({});
  } else if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    end_choice(MiddleRegion);
  } else {
    return false;
  }
  return true;
}

/// The other buttons still move the camera.
bool RenderedMode::drag(const QMouseEvent& event) {
  dragged_to_ = event.position();
  if (event.type() == QEvent::MouseMove) {
    view_.update();
    return pressed_at_.has_value();
  }
  if (event.button() != Qt::LeftButton) return false;
  if (event.type() == QEvent::MouseButtonPress) {
    pressed_at_ = event.position();
    return true;
  }
  if (!pressed_at_) return false;
  const QRectF dragged = QRectF(*pressed_at_, dragged_to_).normalized() & QRectF(view_.rect());
  const QRectF region(dragged.x() / view_.width(), dragged.y() / view_.height(),
                      dragged.width() / view_.width(), dragged.height() / view_.height());
  const bool is_region = std::min(region.width(), region.height()) >= LeastRegionSide;
  end_choice(is_region ? std::optional(region) : std::nullopt);
  return true;
}

}  // namespace editor
