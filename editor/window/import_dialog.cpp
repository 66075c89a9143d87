#include "editor/window/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <numbers>
#include <utility>

#include "converters/mesh_operations/scene_placement.h"
#include "editor/appearance/theme.h"
#include "editor/controls/counted.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/text.h"
#include "editor/view/scene_view.h"

namespace editor {
namespace {

constexpr double DegreesPerRadian = 180 / std::numbers::pi;
constexpr double UsualCrease = 30;  // degrees

enum NormalsChoice { FromFile, SmoothNormals, FlatNormals };

QWidget* row_of(QWidget* first, QWidget* second) {
  auto* row = new QWidget;
  auto* layout = tight_layout<QHBoxLayout>(row);
  layout->addWidget(first);
  layout->addWidget(second, 1);
  return row;
}

QString size_text(const SceneObjects& objects) {
  QString faces = counted(objects.faces, ImportDialog::tr("1 face"), ImportDialog::tr("%1 faces"));
  if (objects.mesh_bounds.isEmpty()) return faces;
  const grf::Vec3d size = objects.mesh_bounds.size();
  const auto metres = [](double length) { return QString::number(length, 'g', 4); };
  return ImportDialog::tr("%1 × %2 × %3 m, %4").arg(metres(size.x), metres(size.y), metres(size.z), faces);
}

}  // namespace

ImportDialog::ImportDialog(std::shared_ptr<const LoadedScene> loaded, QWidget* parent)
    : QDialog(parent),
      loaded_(std::move(loaded)),
      type_(import_type(loaded_->path)),
      result_(loaded_),
      applying_(this) {
  setWindowTitle(tr("Import %1").arg(QFileInfo(loaded_->path).fileName()));
  auto* rows = new QVBoxLayout(this);
  auto* columns = new QHBoxLayout;
  columns->addWidget(picture_column(), 1);
  auto* form = new QFormLayout;
  add_placement(*form);
  add_mesh_operations(*form);
  add_brdf(*form);
  add_objects(*form);
  columns->addLayout(form);
  rows->addLayout(columns, 1);
  skips_ = new QCheckBox(tr("Do not show &again for .%1 files").arg(type_), this);
  skips_->setAccessibleName(tr("Do not show again"));
  skips_->setToolTip(tr("Import with these options at once; File > Append with options shows them again"));
  skips_->setChecked(!asks_for_import_options(type_));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  import_ = buttons->button(QDialogButtonBox::Ok);
  import_->setText(tr("&Import"));
  connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
  auto* last = new QHBoxLayout;
  last->addWidget(skips_, 1);
  last->addWidget(buttons);
  rows->addLayout(last);
  set_options(remembered_import_options(type_));
  resize(110 * Grid, 66 * Grid);
  import_->setFocus();
  view_->show(loaded_->objects);
  view_->frame_all();
  apply();
}

QWidget* ImportDialog::picture_column() {
  auto* column = new QWidget(this);
  auto* rows = tight_layout<QVBoxLayout>(column);
  view_ = new SceneView(column);
  view_->setMinimumSize(40 * Grid, 40 * Grid);
  view_->setAccessibleName(tr("Picture of the model"));
  size_ = new QLabel(column);
  size_->setAccessibleName(tr("Resulting size"));
  size_->setToolTip(tr("Size of the imported model along x, y and z, with y up"));
  rows->addWidget(view_, 1);
  rows->addWidget(size_);
  return column;
}

void ImportDialog::add_placement(QFormLayout& form) {
  up_ = narrow_list(tr("Up axis"), tr("The axis of the file that points up; it becomes y"), 8, this);
  up_->addItem(tr("y"));
  up_->addItem(tr("z"));
  unit_ = narrow_list(tr("Unit"), tr("The unit of the file's lengths; they become metres"), 8, this);
  for (const convert::LengthUnit& unit : convert::length_units()) unit_->addItem(text_of(unit.name));
  form.addRow(tr("&Up axis"), up_);
  form.addRow(tr("Uni&t"), unit_);
  for (QComboBox* list : {up_, unit_}) connect(list, &QComboBox::activated, this, &ImportDialog::apply);
}

void ImportDialog::add_mesh_operations(QFormLayout& form) {
  normals_ =
      narrow_list(tr("Normals"), tr("Vertex normals: those of the file, smooth ones, or none"), 8, this);
  normals_->addItems({tr("from the file"), tr("smooth"), tr("flat")});
  crease_ = number_box({tr("Crease angle"), tr("Edges over this angle stay sharp."), 0, 180, 1, "deg"}, this);
  welds_ = new QCheckBox(tr("&Weld"), this);
  welds_->setToolTip(tr("Merge vertices that are closer than the tolerance"));
  weld_ = number_box({tr("Weld tolerance"), tr("In the unit of the file; 0 merges equal positions.")}, this);
  decimates_ = new QCheckBox(tr("&Decimate to %"), this);
  decimates_->setToolTip(tr("Reduce the triangles to about this percentage"));
  decimate_ = number_box({tr("Percentage of triangles"), tr("Percentage to keep."), 0.01, 100, 1}, this);
  form.addRow(tr("&Normals"), row_of(normals_, crease_));
  form.addRow(welds_, weld_);
  form.addRow(decimates_, decimate_);
  connect(normals_, &QComboBox::activated, this, &ImportDialog::apply);
  for (QCheckBox* box : {welds_, decimates_}) connect(box, &QCheckBox::clicked, this, &ImportDialog::apply);
  for (NumberBox* box : {crease_, weld_, decimate_}) {
    connect(box, &NumberBox::edited, this, &ImportDialog::apply);
  }
}

void ImportDialog::add_brdf(QFormLayout& form) {
  brdf_ = new QLineEdit(this);
  brdf_->setAccessibleName(tr("BRDF"));
  brdf_->setPlaceholderText("diffuse kd=0.5");
  brdf_->setToolTip(tr("BRDF for faces without a material, such as ward sx=0.15 ks=0.3 kd=0.2"));
  problem_ = problem_label(this);
  problem_->setWordWrap(true);
  form.addRow(tr("&BRDF"), brdf_);
  form.addRow(problem_);
  connect(brdf_, &QLineEdit::textChanged, this, &ImportDialog::apply);
}

void ImportDialog::add_objects(QFormLayout& form) {
  objects_ = new QListWidget(this);
  objects_->setAccessibleName(tr("Objects"));
  objects_->setToolTip(tr("The objects to import, with their numbers of faces"));
  for (const ImportedMesh& mesh : imported_meshes(*loaded_)) {
    const QString faces = counted(mesh.faces, tr("1 face"), tr("%1 faces"));
    auto* item = new QListWidgetItem(tr("%1 (%2)").arg(mesh.name, faces), objects_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
  form.addRow(tr("&Objects"), objects_);
  connect(objects_, &QListWidget::itemChanged, this, &ImportDialog::apply);
}

void ImportDialog::set_options(const ImportOptions& options) {
  const convert::MeshOperations& operations = options.operations;
  up_->setCurrentIndex(options.is_z_up ? 1 : 0);
  unit_->setCurrentText(QString::fromStdString(options.unit));
  const bool is_smooth = operations.normals == convert::Normals::Smooth;
  normals_->setCurrentIndex(is_smooth                                      ? SmoothNormals
                            : operations.normals == convert::Normals::Flat ? FlatNormals
                                                                           : FromFile);
  crease_->set_value(is_smooth ? operations.crease * DegreesPerRadian : UsualCrease);
  welds_->setChecked(operations.weld.has_value());
  weld_->set_value(operations.weld.value_or(0));
  decimates_->setChecked(operations.decimate.has_value());
  decimate_->set_value(100 * operations.decimate.value_or(0.5));
  const QSignalBlocker blocker(brdf_);
  brdf_->setText(QString::fromStdString(options.brdf));
}

ImportOptions ImportDialog::options() const {
  ImportOptions options;
  convert::MeshOperations& operations = options.operations;
  options.is_z_up = up_->currentIndex() == 1;
  options.unit = unit_->currentText().toStdString();
  if (normals_->currentIndex() == SmoothNormals) {
    operations.normals = convert::Normals::Smooth;
    operations.crease = crease_->value() / DegreesPerRadian;
  }
  if (normals_->currentIndex() == FlatNormals) operations.normals = convert::Normals::Flat;
  if (welds_->isChecked()) operations.weld = weld_->value();
  if (decimates_->isChecked()) operations.decimate = decimate_->value() / 100;
  options.brdf = brdf_->text().trimmed().toStdString();
  for (int row = 0; row < objects_->count(); ++row) {
    options.left_out.push_back(objects_->item(row)->checkState() != Qt::Checked);
  }
  return options;
}

/// Applies the options in a thread, and shows the result.
void ImportDialog::apply() {
  crease_->setEnabled(normals_->currentIndex() == SmoothNormals);
  weld_->setEnabled(welds_->isChecked());
  decimate_->setEnabled(decimates_->isChecked());
  const ImportOptions now = options();
  grf::Diagnostics diagnostics;
  const bool is_valid = now.brdf.empty() || read_import_brdf(now.brdf, diagnostics);
  show_or_hide(problem_,
               is_valid ? QString() : QString::fromStdString(diagnostics.entries().front().message));
  import_->setEnabled(is_valid);
  if (!is_valid) return;
  applying_.start([loaded = loaded_, now](const StopFlag&) { return with_options(*loaded, now); },
                  [this](const std::shared_ptr<const LoadedScene>& scene) { take(scene); });
}

void ImportDialog::take(const std::shared_ptr<const LoadedScene>& scene) {
  const bool is_framed = result_->objects->mesh_bounds == scene->objects->mesh_bounds;
  result_ = scene;
  view_->show(scene->objects);
  if (!is_framed) view_->frame_all();
  size_->setText(size_text(*scene->objects));
  if (is_accepted_) accept();
}

void ImportDialog::accept() {
  is_accepted_ = true;
  if (applying_.is_busy()) return import_->setEnabled(false);
  remember_import_options(type_, options());
  set_asks_for_import_options(type_, !skips_->isChecked());
  QDialog::accept();
}

}  // namespace editor
