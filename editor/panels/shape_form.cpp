#include "editor/panels/shape_form.h"

#include <QFormLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "grf/scene_path.h"

namespace editor {
namespace {

using ShapeKind = PrimitiveShape::Kind;

constexpr double LeastLength = 1e-6;
constexpr double MostSegments = 1024;

QString new_shape_title(ShapeKind kind) {
  const std::array titles = {ShapeForm::tr("New plane"),  ShapeForm::tr("New box"),
                             ShapeForm::tr("New sphere"), ShapeForm::tr("New cylinder"),
                             ShapeForm::tr("New disc"),   ShapeForm::tr("New torus")};
  return titles[static_cast<std::size_t>(kind)];
}

}  // namespace

ShapeForm::ShapeForm(Document& document, QWidget* parent)
    : QGroupBox(parent), document_(document), rows_(new QFormLayout(this)) {
  rows_->setContentsMargins(Grid, Grid, Grid, Grid);
  rows_->setSpacing(Grid);
  using Shape = PrimitiveShape;
  add_field(tr("Width"), tr("Width of the new shape"), tr("extent along x"), &Shape::width,
            {ShapeKind::Plane, ShapeKind::Box});
  add_field(tr("Depth"), tr("Depth of the new shape"), tr("extent along z"), &Shape::depth,
            {ShapeKind::Plane, ShapeKind::Box});
  add_field(tr("Radius"), tr("Radius of the new shape"),
            tr("distance from the axis; of a torus to the middle of its tube"), &Shape::radius,
            {ShapeKind::Sphere, ShapeKind::Cylinder, ShapeKind::Disc, ShapeKind::Torus});
  add_field(tr("Tube radius"), tr("Tube radius of the new shape"), tr("radius of the tube of a torus"),
            &Shape::tube_radius, {ShapeKind::Torus});
  add_field(tr("Height"), tr("Height of the new shape"), tr("extent along y"), &Shape::height,
            {ShapeKind::Box, ShapeKind::Cylinder});
  add_field(tr("Segments"), tr("Segments of the new shape"),
            tr("number of faces about the y axis; spheres and tubes have half as many across"), nullptr,
            {ShapeKind::Sphere, ShapeKind::Cylinder, ShapeKind::Disc, ShapeKind::Torus});
  connect(&document_.undo_stack(), &EditStack::revision_changed, this, &ShapeForm::end_if_edited);
  connect(&document_, &Document::scene_replaced, this, &ShapeForm::end_if_edited);
  connect(&document_, &Document::selected_objects_changed, this, &ShapeForm::show_if_selected);
  connect(&document_, &Document::saved, this, [this] {
    path_.clear();
    show_if_selected();
  });
  hide();
}

void ShapeForm::add_field(const QString& label, const QString& name, const QString& help,
                          double PrimitiveShape::*length, std::vector<ShapeKind> kinds) {
  const bool is_length = length != nullptr;
  NumberInfo info{name, help, is_length ? LeastLength : 3};
  if (is_length) info.unit = "m";
  if (!is_length) info = {name, help, 3, MostSegments, 1, {}};
  NumberBox* box = number_box(info, this);
  box->set_whole(!is_length);
  rows_->addRow(label, box);
  const Field field = {box, length, std::move(kinds)};
  fields_.push_back(field);
  connect_number(
      box, this, [this, field](double value) { take(field, value); }, [] {});
}

void ShapeForm::begin(const PrimitiveShape& shape) {
  shape_ = shape;
  path_ = document_.selected_objects().back();
  revision_ = document_.revision();
  setTitle(new_shape_title(shape.kind));
  for (const Field& field : fields_) {
    rows_->setRowVisible(field.box, std::ranges::find(field.kinds, shape.kind) != field.kinds.end());
    field.box->set_value(field.length != nullptr ? shape.*field.length : shape.segments);
  }
  show_if_selected();
}

void ShapeForm::take(const Field& field, double value) {
  if (path_.empty()) return;
  if (field.length != nullptr) {
    shape_.*field.length = value;
  } else {
    shape_.segments = static_cast<int>(std::lround(value));
  }
  grf::Scene scene = document_.scene();
  grf::Shared<grf::Mesh>* mesh = grf::find_mesh(scene, path_);
  if (mesh == nullptr) return;
  grf::Mesh made = mesh_of(shape_);
  made.name = (*mesh)->name;
  *mesh = std::move(made);
  is_amending_ = true;
  document_.amend_objects(title(), {std::move(scene), {path_}});
  is_amending_ = false;
  revision_ = document_.revision();
}

void ShapeForm::end_if_edited() {
  if (is_amending_ || document_.revision() == revision_) return;
  path_.clear();
  show_if_selected();
}

void ShapeForm::show_if_selected() {
  const auto& selected = document_.selected_objects();
  setVisible(!path_.empty() && !selected.empty() && selected.back() == path_);
}

}  // namespace editor
