#include "editor/panels/camera_panel.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/document/document.h"
#include "editor/document/render_camera.h"
#include "renderer/job/camera_path.h"

namespace editor {
namespace {

constexpr double MostCameraNumber = std::numeric_limits<float>::max();
constexpr int NameColumn = 0;
constexpr int RendersColumn = 1;

using options::RenderOptions;
using transport::View;

bool is_free_name(const std::vector<options::NamedCamera>& cameras, const std::string& name) {
  return std::ranges::find(cameras, name, &options::NamedCamera::name) == cameras.end();
}

}  // namespace

struct CameraPanel::Field {
  NumberInfo info;
  std::function<double(const View&)> read;
  std::function<void(View&, double)> write;
};

CameraPanel::CameraPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), list_(new QTreeWidget(this)) {
  setAccessibleName(tr("Cameras"));
  list_->setAccessibleName(tr("Cameras of the scene"));
  list_->setToolTip(tr("A double click looks through a camera; the check mark selects the one that renders"));
  list_->setHeaderLabels({tr("Camera"), tr("Renders")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setIconSize({2 * Grid, 2 * Grid});
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(Grid, Grid, Grid, Grid);
  layout->setSpacing(Grid);
  layout->addWidget(list_, 1);
  layout->addWidget(make_buttons());
  layout->addWidget(make_form());
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    row_ = std::max(0, list_->indexOfTopLevelItem(item));
    document_.options().finish_step();
    show_form();
  });
  connect(list_, &QTreeWidget::itemActivated, this, [this] { emit look_requested(view()); });
  connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
    if (column == RendersColumn) return choose_for_render(item);
    rename(item, column);
  });
  connect(&document_.options(), &OpDocument::changed, this, &CameraPanel::show_cameras);
  connect(&document_, &Document::scene_replaced, this, [this] {
    row_ = 0;
    show_cameras();
  });
  show_cameras();
}

QSize CameraPanel::sizeHint() const { return {360, 420}; }

QWidget* CameraPanel::make_buttons() {
  auto* row = new QWidget(this);
  auto* layout = tight_layout<QHBoxLayout>(row);
  const auto add = [&](const QString& icon, const QString& name, const QString& tip,
                       const std::function<void()>& act) {
    QToolButton* button = tool_button(icon, name, tip, act, row);
    layout->addWidget(button);
    return button;
  };
  add("add", tr("Add a camera"), tr("Add a camera at the viewpoint of the 3D view"),
      [this] { emit add_requested(); });
  remove_ = add("delete", tr("Delete the camera"), {}, [this] { remove(); });
  add("camera", tr("Move the camera to the view"),
      tr("Move the selected camera to the viewpoint of the 3D view"), [this] { emit place_requested(); });
  add("through", tr("Look through the camera"), tr("View the scene through the selected camera"),
      [this] { emit look_requested(view()); });
  layout->addStretch(1);
  return row;
}

void CameraPanel::add_row(QGridLayout& grid, const QString& label, const std::vector<Field>& fields) {
  const int row = grid.rowCount();
  grid.addWidget(new QLabel(label, this), row, 0);
  int column = 1;
  for (const Field& field : fields) {
    NumberBox* box = number_box(field.info, this);
    grid.addWidget(box, row, column++);
    boxes_.emplace_back(box, field.read);
    connect_number(
        box, this,
        [this, field](double number) {
          View changed = view();
          field.write(changed, number);
          if (changed.eye == changed.target) return;
          change(changed, tr("Set camera: %1").arg(field.info.name), field.info.name);
        },
        [this] { document_.options().finish_step(); });
  }
}

QWidget* CameraPanel::make_form() {
  auto* form = new QWidget(this);
  auto* grid = tight_layout<QGridLayout>(form);
  grid->setVerticalSpacing(Grid);
  const auto vector_row = [&](const QString& label, const QString& help, grf::Vec3d View::*field) {
    std::vector<Field> fields;
    for (int axis = 0; axis < 3; ++axis) {
      const QString letter = QString("xyz").mid(axis, 1);
      fields.push_back({{tr("Camera: %1, %2").arg(label, letter), tr("%1: %2").arg(letter, help),
                         -MostCameraNumber, MostCameraNumber, 0.1, "m"},
                        [=](const View& shown) { return (shown.*field)[axis]; },
                        [=](View& changed, double number) { (changed.*field)[axis] = number; }});
    }
    add_row(*grid, label, fields);
  };
  vector_row(tr("Position"), tr("position of the camera in world space"), &View::eye);
  vector_row(tr("Look at"), tr("the point that the camera looks at, in world space"), &View::target);
  add_row(*grid, tr("Lens"),
          {{{tr("Field of view"), tr("Vertical field of view"), 0.01, 179.99, 1, "deg"},
            [](const View& shown) { return double(shown.field_of_view); },
            [](View& changed, double number) { changed.field_of_view = static_cast<float>(number); }},
           {{tr("Focal length"), tr("Focal length of a full-frame camera, whose sensor is 24 mm high"), 0.01,
             1e5, 1, "mm"},
            [](const View& shown) { return focal_length_of(double(shown.field_of_view)); },
            [](View& changed, double number) {
              changed.field_of_view = static_cast<float>(field_of_view_of(number));
            }}});
  add_row(*grid, tr("Focus"),
          {{{tr("Lens radius"),
             tr("Depth of field: the radius of the lens, half its aperture; 0: everything is sharp"), 0,
             MostCameraNumber, 0.01, "m"},
            [](const View& shown) { return double(shown.lens_radius); },
            [](View& changed, double number) { changed.lens_radius = static_cast<float>(number); }},
           {{tr("Focus distance"), tr("Distance to the plane in focus, along the view direction"), 0,
             MostCameraNumber, 0.1, "m"},
            [](const View& shown) { return double(focus_distance_of(shown)); },
            [](View& changed, double number) { changed.focus_distance = static_cast<float>(number); }}});
  auto* focus = new QPushButton(tr("Focus on…"), form);
  focus->setToolTip(tr("Click the point of the scene that shall be in focus"));
  connect(focus, &QPushButton::clicked, this, &CameraPanel::focus_requested);
  auto* level = new QPushButton(tr("Level the horizon"), form);
  level->setToolTip(tr("Remove the roll: the up vector becomes the vertical"));
  connect(level, &QPushButton::clicked, this, [this] {
    View changed = view();
    changed.up = {0, 1, 0};
    change(changed, tr("Level the horizon"), {});
  });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(focus);
  buttons->addWidget(level);
  buttons->addStretch(1);
  grid->addLayout(buttons, grid->rowCount(), 0, 1, 4);
  return form;
}

View CameraPanel::view() const {
  const RenderOptions& now = document_.options().valid_options();
  if (row_ > 0) return job::view_of(now.cameras[static_cast<std::size_t>(row_) - 1]);
  return own_camera(document_);
}

void CameraPanel::add(const View& view) {
  RenderOptions wanted = document_.options().valid_options();
  View with_lens = view;
  with_lens.lens_radius = wanted.lens_radius;
  wanted.cameras.push_back(named_camera(free_name().toStdString(), with_lens));
  row_ = static_cast<int>(wanted.cameras.size());
  document_.options().set_options(tr("Add camera"), wanted);
}

QString CameraPanel::free_name() const {
  const auto& cameras = document_.options().valid_options().cameras;
  for (int number = 1;; ++number) {
    QString name = tr("camera %1").arg(number);
    if (is_free_name(cameras, name.toStdString())) return name;
  }
}

void CameraPanel::place(const View& view) {
  View placed = view;
  const View before = this->view();
  placed.lens_radius = before.lens_radius;
  placed.focus_distance = before.focus_distance;
  change(placed, tr("Move the camera"), {});
}

void CameraPanel::focus_on(const grf::Vec3d& point) {
  View changed = view();
  const double distance = (point - changed.eye).dot((changed.target - changed.eye).normalized());
  if (!(distance > 0)) return;
  changed.focus_distance = static_cast<float>(distance);
  change(changed, tr("Focus the camera"), {});
}

void CameraPanel::change(const View& view, const QString& title, const QString& key) {
  RenderOptions wanted = document_.options().valid_options();
  if (row_ > 0) {
    options::NamedCamera& camera = wanted.cameras[static_cast<std::size_t>(row_) - 1];
    camera = named_camera(camera.name, view);
  } else {
    place_own_camera(wanted, view);
    wanted.lens_radius = view.lens_radius;
    wanted.focus_distance = view.focus_distance > 0 ? std::optional(view.focus_distance) : std::nullopt;
    emit render_camera_chosen();
  }
  document_.options().set_options(title, wanted, key);
}

void CameraPanel::rename(QTreeWidgetItem* item, int column) {
  const int row = list_->indexOfTopLevelItem(item);
  RenderOptions wanted = document_.options().valid_options();
  const std::string name = item->text(column).trimmed().toStdString();
  const bool is_free = !name.empty() && name != "none" && name.find('"') == std::string::npos &&
                       is_free_name(wanted.cameras, name);
  if (row > 0 && is_free) {
    std::string& old = wanted.cameras[static_cast<std::size_t>(row) - 1].name;
    if (wanted.camera == old) wanted.camera = name;
    old = name;
    document_.options().set_options(tr("Rename camera"), wanted);
  }
  show_cameras();
}

void CameraPanel::choose_for_render(QTreeWidgetItem* item) {
  const int row = list_->indexOfTopLevelItem(item);
  RenderOptions wanted = document_.options().valid_options();
  wanted.camera = row > 0 ? wanted.cameras[static_cast<std::size_t>(row) - 1].name : std::string();
  emit render_camera_chosen();
  document_.options().set_options(tr("Select the camera that renders"), wanted);
  show_cameras();
}

void CameraPanel::remove() {
  if (row_ == 0) return;
  RenderOptions wanted = document_.options().valid_options();
  const auto camera = wanted.cameras.begin() + row_ - 1;
  if (wanted.camera == camera->name) wanted.camera.clear();
  wanted.cameras.erase(camera);
  --row_;
  document_.options().set_options(tr("Delete camera"), wanted);
}

void CameraPanel::show_cameras() {
  const QSignalBlocker blocker(list_);
  const RenderOptions& now = document_.options().valid_options();
  row_ = std::min(row_, static_cast<int>(now.cameras.size()));
  // Items stay where the number of cameras does, so that an editor of a name is not closed.
  while (list_->topLevelItemCount() > static_cast<int>(now.cameras.size()) + 1)
    delete list_->takeTopLevelItem(1);
  while (list_->topLevelItemCount() < static_cast<int>(now.cameras.size()) + 1) {
    auto* item = new QTreeWidgetItem(list_);
    item->setIcon(NameColumn, icon("camera"));
    if (list_->topLevelItemCount() > 1) item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    const std::string name = row > 0 ? now.cameras[static_cast<std::size_t>(row) - 1].name : std::string();
    QTreeWidgetItem* item = list_->topLevelItem(row);
    item->setText(NameColumn, row > 0 ? QString::fromStdString(name) : tr("Render camera"));
    item->setCheckState(RendersColumn, now.camera == name ? Qt::Checked : Qt::Unchecked);
  }
  list_->setCurrentItem(list_->topLevelItem(row_));
  show_form();
}

void CameraPanel::show_form() {
  enable(remove_, tr("Delete the camera"),
         row_ > 0 ? QString() : tr("The camera of the render options cannot be deleted."));
  const View shown = view();
  for (const auto& [box, read] : boxes_) box->set_value(read(shown));
}

}  // namespace editor
