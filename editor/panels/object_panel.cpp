#include "editor/panels/object_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <limits>

#include "editor/appearance/theme.h"
#include "editor/controls/expression.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/document/scene_places.h"
#include "editor/panels/shape_form.h"

namespace editor {
namespace {

constexpr double LargestNumber = std::numeric_limits<float>::max();

template <class Transform>
auto& vector_of_row(Transform& transform, int row) {
  return row == 0 ? transform.position : row == 1 ? transform.rotation : transform.scale;
}

}  // namespace

ObjectPanel::ObjectPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      shape_(new ShapeForm(document, this)),
      pages_(new QStackedWidget(this)),
      problem_(problem_label(this)) {
  setAccessibleName(tr("Object"));
  pages_->addWidget(hint_label(
      tr("Select an object to place it: click it in the 3D view, or in the scene outliner."), pages_));
  pages_->addWidget(make_form());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(Grid, Grid, Grid, Grid);
  layout->setSpacing(Grid);
  layout->addWidget(shape_);
  layout->addWidget(pages_, 1);
  layout->addWidget(problem_);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.moves_objects() || change.names) show_object();
  });
  connect(&document_, &Document::selected_objects_changed, this, &ObjectPanel::show_object);
  show_object();
}

QSize ObjectPanel::sizeHint() const { return {360, 220}; }

QWidget* ObjectPanel::make_form() {
  auto* form = new QWidget(pages_);
  auto* layout = tight_layout<QGridLayout>(form);
  layout->setVerticalSpacing(Grid);
  name_ = new QLabel(form);
  name_->setTextFormat(Qt::PlainText);
  layout->addWidget(name_, 0, 0, 1, 4);
  const std::array<QString, 3> names = {tr("Position"), tr("Rotation"), tr("Scale")};
  const std::array<QString, 3> helps = {tr("translation relative to the parent, after rotation and scale"),
                                        tr("rotation about the axis; about x first, then y, then z"),
                                        tr("scale factor, applied first; not 0")};
  for (int axis = 0; axis < 3; ++axis) {
    auto* letter = new QLabel(QString("XYZ").mid(axis, 1), form);
    letter->setAlignment(Qt::AlignCenter);
    layout->addWidget(letter, 1, axis + 1);
  }
  for (int row = 0; row < 3; ++row) {
    const auto index = static_cast<std::size_t>(row);
    layout->addWidget(new QLabel(names[index], form), row + 2, 0);
    for (int axis = 0; axis < 3; ++axis) {
      const QString name = tr("%1, %2").arg(names[index], QString("xyz").mid(axis, 1));
      NumberInfo info{name, tr("%1: %2").arg(name, helps[index]), -LargestNumber, LargestNumber};
      if (row == Position) info.unit = "m";
      if (row == Rotation) info = {info.name, info.help, info.minimum, info.maximum, 5, "deg"};
      NumberBox* box = number_box(info, form);
      boxes_[index][static_cast<std::size_t>(axis)] = box;
      layout->addWidget(box, row + 2, axis + 1);
      connect_number(
          box, this, [this, row, axis](double number) { take(static_cast<Row>(row), axis, number); },
          [this] { document_.finish_gesture(); });
    }
  }
  layout->addWidget(new QLabel(tr("Size"), form), 5, 0);
  size_ = new QLabel(form);
  size_->setToolTip(tr("Size of the object's bounds in world space, along x, y and z"));
  layout->addWidget(size_, 5, 1, 1, 3);
  note_ = hint_label({}, form);
  layout->addWidget(note_, 6, 0, 1, 4);
  layout->setRowStretch(7, 1);
  return form;
}

void ObjectPanel::show_new_shape(const PrimitiveShape& shape) { shape_->begin(shape); }

void ObjectPanel::show_lengths_in(const QString& unit) {
  length_unit_ = unit;
  editor::show_lengths_in(unit, *this);
  show_object();
}

QString ObjectPanel::name_of(const grf::ScenePath& path) const {
  const grf::ScenePath block = moved_block(document_.scene(), path);
  if (block != path) {
    const auto& include = std::get<grf::Include>(block_at(document_.scene(), block)->content);
    return tr("Included file %1").arg(QString::fromStdString(include.file));
  }
  for (const MeshInstance& instance : *document_.objects().instances) {
    if (!is_inside(instance.path, path)) continue;
    const std::string& name = document_.objects().meshes[instance.mesh].name;
    return name.empty() ? tr("Mesh without a name") : QString::fromStdString(name);
  }
  return tr("Light or observer");
}

void ObjectPanel::show_object() {
  const std::vector<grf::ScenePath>& selected = document_.selected_objects();
  pages_->setCurrentIndex(selected.empty() ? 0 : 1);
  show_or_hide(problem_, {});
  if (selected.empty()) return;
  const grf::ScenePath& active = selected.back();
  shown_ = object_transform_at(document_.scene(), active);
  const QString name = name_of(active);
  name_->setText(selected.size() == 1
                     ? name
                     : tr("%1, active of %n selected objects", nullptr, int(selected.size())).arg(name));
  for (int row = 0; row < 3; ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      NumberBox* box = boxes_[static_cast<std::size_t>(row)][static_cast<std::size_t>(axis)];
      box->set_value(vector_of_row(shown_, row)[axis]);
      box->setEnabled(row == Position || !shown_.has_shear);
    }
  }
  const grf::Box3d bounds = object_bounds(document_.objects(), moved_block(document_.scene(), active));
  const grf::Vec3d size = bounds.isEmpty() ? grf::Vec3d(0) : bounds.size();
  const double unit = length_unit(length_unit_);
  size_->setText(QStringLiteral("%1 × %2 × %3 %4")
                     .arg(size.x / unit, 0, 'g', 4)
                     .arg(size.y / unit, 0, 'g', 4)
                     .arg(size.z / unit, 0, 'g', 4)
                     .arg(length_unit_));
  note_->setVisible(shown_.has_shear);
  note_->setText(
      tr("The transform shears the object, so that rotation and scale cannot be edited as "
         "numbers. Reset the transform to edit them."));
}

void ObjectPanel::take(Row row, int axis, double number) {
  const std::vector<grf::ScenePath>& selected = document_.selected_objects();
  if (selected.empty()) return;
  ObjectTransform wanted = shown_;
  vector_of_row(wanted, row)[axis] = number;
  grf::Diagnostics diagnostics;
  auto edited = set_object_transform(document_.scene(), selected, wanted, diagnostics);
  if (!edited) {
    show_or_hide(problem_, QString::fromStdString(diagnostics.entries().front().message));
    return;
  }
  const std::array<QString, 3> texts = {tr("Move"), tr("Rotate"), tr("Scale")};
  document_.replace_objects(texts[static_cast<std::size_t>(row)], std::move(*edited),
                            QStringLiteral("object %1 %2").arg(row).arg(axis));
}

}  // namespace editor
