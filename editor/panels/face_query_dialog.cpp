#include "editor/panels/face_query_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <numbers>
#include <utility>

#include "editor/controls/counted.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/document/document.h"

namespace editor {
namespace {

/// Milliseconds for which the form rests before the faces are counted.
constexpr int CountDelay = 50;

double in_radians(double degrees) { return degrees * std::numbers::pi / 180; }

ValueRange range_of(const NumberBox& least, const NumberBox& most) {
  ValueRange range;
  if (least.has_value()) range.least = least.value();
  if (most.has_value()) range.most = most.value();
  return range;
}

/// Two widgets in one row, with a word between them.
QHBoxLayout* pair_of(QWidget* first, const QString& word, QWidget* second) {
  auto* row = new QHBoxLayout;
  row->setSpacing(Grid);
  row->addWidget(first, 1);
  row->addWidget(new QLabel(word));
  row->addWidget(second, 1);
  return row;
}

}  // namespace

FaceQueryDialog::FaceQueryDialog(Document& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      axis_(new QComboBox(this)),
      material_(new QLineEdit(this)),
      count_(new QLabel(this)) {
  setWindowTitle(tr("Select faces by"));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(2 * Grid, 2 * Grid, 2 * Grid, 2 * Grid);
  form->setVerticalSpacing(Grid);
  add_geometry(*form);
  material_->setAccessibleName(tr("Material"));
  material_->setPlaceholderText(tr("any"));
  material_->setToolTip(
      tr("Name of a BRDF's definition, or of its model; * stands for any letters, ? for one"));
  form->addRow(tr("Material"), material_);
  connect(material_, &QLineEdit::textChanged, this, &FaceQueryDialog::update_soon);
  add_similarities(*form);
  add_buttons(*form);
  timer_.setSingleShot(true);
  timer_.setInterval(CountDelay);
  connect(&timer_, &QTimer::timeout, this, &FaceQueryDialog::show_count);
  connect(&document_, &Document::changed, this, &FaceQueryDialog::update_soon);
  connect(&document_, &Document::selection_changed, this, &FaceQueryDialog::update_soon);
}

NumberBox* FaceQueryDialog::limit(const QString& name, const QString& help) {
  NumberBox* box = number_box({name, help, -std::numeric_limits<float>::max()}, this);
  box->set_default(tr("any"));
  box->set_blank(tr("any"));
  follow(box);
  return box;
}

void FaceQueryDialog::follow(NumberBox* box) {
  connect(box, &NumberBox::changing, this, &FaceQueryDialog::update_soon);
  connect(box, &NumberBox::edited, this, &FaceQueryDialog::update_soon);
  connect(box, &NumberBox::cleared, this, &FaceQueryDialog::update_soon);
}

void FaceQueryDialog::add_geometry(QFormLayout& form) {
  axis_->setAccessibleName(tr("Normal"));
  axis_->setToolTip(tr("Direction of the faces' normals in world space; y is up"));
  axis_->addItems({tr("any"), "+X", "-X", "+Y", "-Y", "+Z", "-Z"});
  connect(axis_, &QComboBox::currentIndexChanged, this, &FaceQueryDialog::update_soon);
  angle_ =
      number_box({tr("Angle"), tr("Largest angle between normal and direction"), 0, 180, 5, "deg"}, this);
  angle_->set_value(30);
  follow(angle_);
  form.addRow(tr("Normal"), pair_of(axis_, tr("within"), angle_));
  least_area_ = limit(tr("Least area"), tr("Least area of a face in world space, m²"));
  largest_area_ = limit(tr("Largest area"), tr("Largest area of a face in world space, m²"));
  form.addRow(tr("Area"), pair_of(least_area_, tr("to"), largest_area_));
  lowest_ = limit(tr("Lowest y"), tr("Least height of all corners of a face: y in world space"));
  highest_ = limit(tr("Highest y"), tr("Largest height of all corners of a face: y in world space"));
  form.addRow(tr("Height"), pair_of(lowest_, tr("to"), highest_));
}

NumberBox* FaceQueryDialog::add_tolerance(QFormLayout& form, QCheckBox*& box, const QString& name,
                                          const QString& tip, double value, double largest,
                                          const QString& unit) {
  box = new QCheckBox(name, this);
  box->setAccessibleName(tr("Same %1").arg(name));
  box->setToolTip(tip);
  connect(box, &QCheckBox::toggled, this, &FaceQueryDialog::update_soon);
  NumberBox* tolerance = number_box({tr("Tolerance of the %1").arg(name), tip, 0, largest, 1, unit}, this);
  tolerance->set_value(value);
  follow(tolerance);
  form.addRow(QString(), pair_of(box, tr("within"), tolerance));
  return tolerance;
}

void FaceQueryDialog::add_similarities(QFormLayout& form) {
  auto* grid = new QGridLayout;
  const auto add = [&](const QString& name, bool Similarity::*attribute, const QString& tip) {
    auto* box = new QCheckBox(name, this);
    box->setAccessibleName(tr("Same %1").arg(name));
    box->setToolTip(tip);
    connect(box, &QCheckBox::toggled, this, &FaceQueryDialog::update_soon);
    const int index = static_cast<int>(similarities_.size());
    grid->addWidget(box, index / 3, index % 3);
    similarities_.push_back({box, attribute});
  };
  add(tr("BRDF"), &Similarity::brdf, tr("The BRDF is that of a selected face"));
  add(tr("sampling"), &Similarity::pdf, tr("The sampling scheme is that of a selected face"));
  add(tr("colour"), &Similarity::colour, tr("The colour is that of a selected face"));
  add(tr("texture"), &Similarity::texture, tr("The texture is that of a selected face"));
  add(tr("emission"), &Similarity::emission, tr("The emission is that of a selected face"));
  add(tr("object"), &Similarity::object, tr("The face belongs to the mesh of a selected face"));
  form.addRow(tr("As selected"), grid);
  normal_tolerance_ =
      add_tolerance(form, has_normal_, tr("normal"),
                    tr("Largest angle to the mean normal of the selected faces"), 5, 180, "deg");
  area_tolerance_ = add_tolerance(
      form, has_area_, tr("area"),
      tr("Largest deviation from the mean area of the selected faces, in percent of it"), 10, 1000, "%");
}

void FaceQueryDialog::add_buttons(QFormLayout& form) {
  form.addRow(tr("Found"), count_);
  auto* row = new QHBoxLayout;
  using Combine = void (FaceSelection::*)(const FaceSelection&);
  const auto add = [&](const QString& text, const QString& tip, Combine combine) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    button->setAccessibleName(button->text().remove('&'));
    button->setAutoDefault(combine == nullptr);
    connect(button, &QPushButton::clicked, this, [this, combine] {
      FaceSelection made = found();
      if (combine != nullptr) {
        FaceSelection all = document_.selection();
        (all.*combine)(made);
        made = std::move(all);
      }
      document_.select(std::move(made));
    });
    row->addWidget(button);
  };
  add(tr("&Replace"), tr("Select the found faces only"), nullptr);
  add(tr("&Add"), tr("Add the found faces to the selection"), &FaceSelection::add);
  add(tr("&Subtract"), tr("Remove the found faces from the selection"), &FaceSelection::remove);
  add(tr("&Intersect"), tr("Keep only the found faces selected"), &FaceSelection::intersect);
  form.addRow(row);
}

FaceQuery FaceQueryDialog::query() const {
  FaceQuery query;
  if (const int axis = axis_->currentIndex() - 1; axis >= 0) {
    grf::Vec3d direction(0);
    direction[axis / 2] = axis % 2 == 0 ? 1 : -1;
    query.normal = DirectionRange{direction, in_radians(angle_->value())};
  }
  query.area = range_of(*least_area_, *largest_area_);
  query.height = range_of(*lowest_, *highest_);
  query.material = material_->text().trimmed().toStdString();
  for (const auto& [box, attribute] : similarities_) query.similarity.*attribute = box->isChecked();
  if (has_normal_->isChecked()) query.similarity.normal_radians = in_radians(normal_tolerance_->value());
  if (has_area_->isChecked()) query.similarity.area_fraction = area_tolerance_->value() / 100;
  return query;
}

FaceSelection FaceQueryDialog::found() const {
  return document_.editor_state().selectable(find_faces(query(), document_.selection(), document_.objects()));
}

void FaceQueryDialog::update_soon() {
  if (isVisible()) timer_.start();
}

void FaceQueryDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  show_count();
}

void FaceQueryDialog::show_count() {
  const bool compares = !query().similarity.empty();
  count_->setText(compares && document_.selection().empty()
                      ? tr("No face is selected to compare with")
                      : counted(found().count(), tr("1 face"), tr("%1 faces")));
}

}  // namespace editor
