#include "editor/panels/uv_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/controls/counted.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/panels/uv_view.h"

namespace editor {
namespace {

constexpr double LargestCoordinate = 1e6;
constexpr double SmallestSize = 1e-6;

/// The same transform for drawing.
QTransform drawn(const UvTransform& transform) {
  const grf::Vec2d origin = transform({0, 0});
  const grf::Vec2d x = transform({1, 0}) - origin;
  const grf::Vec2d y = transform({0, 1}) - origin;
  return {x.x, x.y, y.x, y.y, origin.x, origin.y};
}

}  // namespace

UvPanel::UvPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), pages_(new QStackedWidget(this)) {
  setAccessibleName(tr("UV"));
  pages_->addWidget(hint_label(tr("Select faces to see and edit their texture coordinates (UVs)."), pages_));
  pages_->addWidget(make_page());
  tight_layout<QVBoxLayout>(this)->addWidget(pages_);
  connect(&document_, &Document::selection_changed, this, &UvPanel::show_selection);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.is_structural || change.definitions || !change.meshes.empty()) show_selection();
  });
}

QSize UvPanel::sizeHint() const { return {360, 420}; }

void UvPanel::showEvent(QShowEvent*) { show_selection(); }

void UvPanel::set_menu(QMenu* menu) { menu_->setMenu(menu); }

QWidget* UvPanel::make_page() {
  auto* page = new QWidget(pages_);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(Grid, Grid, Grid, Grid);
  auto* line = new QHBoxLayout;
  count_ = new QLabel(page);
  line->addWidget(count_, 1);
  menu_ = tool_button(
      "texture", tr("Project"), tr("Project or transform the texture coordinates of the selected faces"),
      [] {}, page);
  menu_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  menu_->setPopupMode(QToolButton::InstantPopup);
  line->addWidget(menu_);
  line->addWidget(tool_button(
      "fit", tr("Fit the view"), tr("Fit the image and the faces into the view"), [this] { view_->fit(); },
      page));
  column->addLayout(line);
  view_ = new UvView(page);
  column->addWidget(view_, 1);
  hint_ = problem_label(page);
  column->addWidget(hint_);
  auto* grid = new QGridLayout;
  grid->setSpacing(Grid / 2);
  add_row(*grid, Centre, tr("Centre"), tr("centre of the bounds of the texture coordinates"));
  add_row(*grid, Size, tr("Size"), tr("size of their bounds; the image has the size 1"));
  add_rotation(*grid);
  column->addLayout(grid);
  connect(view_, &UvView::moving, this, [this](const QPointF& offset) {
    UvTransform move;
    move.offset = {offset.x(), offset.y()};
    change(tr("Move texture coordinates"), move);
    for (int axis = 0; axis < 2; ++axis)
      boxes_[Centre][static_cast<std::size_t>(axis)]->set_value(bounds_.center()[axis] + move.offset[axis]);
  });
  connect(view_, &UvView::moved, this, &UvPanel::finish);
  return page;
}

void UvPanel::add_row(QGridLayout& grid, Row row, const QString& name, const QString& help) {
  grid.addWidget(new QLabel(tr("%1 u, v").arg(name), this), row, 0);
  for (int axis = 0; axis < 2; ++axis) {
    const QString full_name = QStringLiteral("%1, %2").arg(name, QString("uv").mid(axis, 1));
    NumberInfo info{tr("UV %1").arg(full_name.toLower()), tr("%1: %2").arg(full_name, help),
                    -LargestCoordinate, LargestCoordinate, 0.05};
    if (row == Size) info.minimum = SmallestSize;
    NumberBox* box = number_box(info, this);
    boxes_[row][static_cast<std::size_t>(axis)] = box;
    grid.addWidget(box, row, axis + 1);
    const auto take = [this, row, axis](double number) {
      UvTransform transform;
      transform.pivot = bounds_.center();
      if (row == Centre) transform.offset[axis] = number - bounds_.center()[axis];
      if (row == Size) transform.scale[axis] = number / bounds_.size()[axis];
      change(row == Centre ? tr("Move texture coordinates") : tr("Scale texture coordinates"), transform);
    };
    connect_number(box, this, take, [this] { finish(); });
  }
}

void UvPanel::add_rotation(QGridLayout& grid) {
  grid.addWidget(new QLabel(tr("Rotate by"), this), 2, 0);
  rotation_ =
      number_box({tr("UV rotation"), tr("Rotate by: angle to the left, about the centre of the bounds"), -360,
                  360, 5, "deg"},
                 this);
  grid.addWidget(rotation_, 2, 1, 1, 2);
  const auto take = [this](double degrees) {
    UvTransform transform;
    transform.pivot = bounds_.center();
    transform.rotation = degrees;
    change(tr("Rotate texture coordinates"), transform);
  };
  connect_number(rotation_, this, take, [this] { finish(); });
}

/// An edit by something else ends a gesture.
void UvPanel::show_selection() {
  if (is_editing_) return show_faces();
  if (gesture_) document_.finish_gesture();
  gesture_.reset();
  view_->cancel_gesture();
  pages_->setCurrentIndex(document_.selection().empty() ? 0 : 1);
  if (!isVisible() || document_.selection().empty()) return;
  view_->show_image(first_texture(document_.objects(), document_.selection()));
  show_faces();
  view_->refit();
  bounds_ = uv_bounds(document_.objects(), document_.selection());
  show_numbers();
}

void UvPanel::show_faces() { view_->show_outlines(uv_outlines(document_.objects(), document_.selection())); }

void UvPanel::show_numbers() {
  const bool has_uvs = !bounds_.isEmpty();
  const std::size_t count = document_.selection().count();
  const auto drawn_count = static_cast<std::size_t>(view_->outlines().size());
  count_->setText(drawn_count > 0 && drawn_count < count
                      ? tr("%1 of %2 faces are drawn").arg(count_text(drawn_count), count_text(count))
                      : counted(count, tr("1 face"), tr("%1 faces")));
  show_or_hide(hint_, has_uvs ? QString() : tr("The faces have no texture coordinates: project some."));
  for (int axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double size = has_uvs ? bounds_.size()[axis] : 0;
    boxes_[Centre][i]->set_value(has_uvs ? bounds_.center()[axis] : 0);
    boxes_[Centre][i]->setEnabled(has_uvs);
    boxes_[Size][i]->set_value(size);
    boxes_[Size][i]->setEnabled(size > 0);
  }
  rotation_->set_value(0);
  rotation_->setEnabled(has_uvs);
}

void UvPanel::change(const QString& text, const UvTransform& transform) {
  if (bounds_.isEmpty()) return;
  if (!gesture_)
    gesture_ = {document_.scene(), document_.shared_objects(), document_.selection(), text, transform};
  gesture_->text = text;
  gesture_->transform = transform;
  if (!is_live()) return view_->show_transform(drawn(transform));
  const SelectedFaces before = {gesture_->scene, *gesture_->objects, gesture_->selection};
  is_editing_ = true;
  document_.replace(text, with_transformed_uvs(before, transform), QStringLiteral("texture coordinates"));
  is_editing_ = false;
}

void UvPanel::finish() {
  const std::optional<Gesture> done = std::exchange(gesture_, std::nullopt);
  if (!done) return;
  document_.finish_gesture();
  if (!is_live()) return emit edit_requested(done->text, done->transform);
  bounds_ = uv_bounds(document_.objects(), document_.selection());
  show_numbers();
}

}  // namespace editor
