#include "editor/panels/light_panel.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <set>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/document/object_edits.h"
#include "editor/panels/colour_fields.h"

namespace editor {
namespace {

constexpr double Largest = std::numeric_limits<float>::max();

/// Formats with four digits; large numbers as integers, which are more readable than an exponent.
QString text_of(double number) {
  const bool is_large = number >= 1e4 && number < 1e7;
  return is_large ? QLocale::c().toString(number, 'f', 0).remove(',') : QLocale::c().toString(number, 'g', 4);
}

QString name_of(const Emitter& emitter) {
  if (emitter.kind == Emitter::Kind::AreaLight) return LightPanel::tr("light");
  if (emitter.kind == Emitter::Kind::MeshLight) return LightPanel::tr("mesh light");
  return emitter.name.empty() ? LightPanel::tr("faces of a mesh") : QString::fromStdString(emitter.name);
}

/// An area light above the centre of the bounds, facing down.
grf::AreaLight light_over(const grf::Box3d& bounds) {
  constexpr double Part = 0.25;
  const bool is_empty = bounds.isEmpty();
  const double size = is_empty ? 1 : std::max(Part * bounds.size().length(), 1e-3);
  const grf::Vec3d middle = is_empty ? grf::Vec3d(0) : bounds.center();
  const double height = is_empty ? 1 : bounds.max.y + size / 4;
  grf::AreaLight light;
  light.corner = grf::Vec3f(grf::Vec3d(middle.x - size / 2, height, middle.z - size / 2));
  light.edge1 = grf::Vec3f(static_cast<float>(size), 0, 0);
  light.edge2 = grf::Vec3f(0, 0, static_cast<float>(size));
  constexpr float Radiance = 10;
  light.radiance = grf::Colour(Radiance);
  return light;
}

grf::Vec3f& vector_of(grf::AreaLight& light, std::size_t which) {
  return which == 0 ? light.corner : which == 1 ? light.edge1 : light.edge2;
}

}  // namespace

LightPanel::LightPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      list_(new QTreeWidget(this)),
      pages_(new QStackedWidget(this)),
      problem_(problem_label(this)) {
  setAccessibleName(tr("Lights"));
  list_->setAccessibleName(tr("Lights of the scene"));
  list_->setToolTip(tr("All emitters, with their world-space area and their emitted power"));
  list_->setHeaderLabels({tr("Light"), tr("Area, m²"), tr("Power, W")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setIconSize({2 * Grid, 2 * Grid});
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  QWidget* buttons = make_buttons();
  hint_ = hint_label({}, pages_);
  pages_->addWidget(hint_);
  about_ = hint_label({}, pages_);
  pages_->addWidget(about_);
  pages_->addWidget(make_form());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(Grid, Grid, Grid, Grid);
  layout->setSpacing(Grid);
  layout->addWidget(list_, 1);
  layout->addWidget(buttons);
  layout->addWidget(pages_);
  layout->addWidget(problem_);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &LightPanel::choose_item);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (concerns_lights(change)) show_lights();
  });
  show_lights();
}

QWidget* LightPanel::make_buttons() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(tool_button(
      "add", tr("Add a light"), tr("Add an area light above the scene, facing down"), [this] { add(); },
      row));
  remove_ = tool_button(
      "delete", tr("Delete the light"), {}, [this] { remove(); }, row);
  layout->addWidget(remove_);
  layout->addStretch(1);
  return row;
}

QWidget* LightPanel::make_form() {
  auto* form = new QWidget(pages_);
  auto* layout = new QGridLayout(form);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(Grid / 2);
  layout->setVerticalSpacing(Grid);
  const std::array<QString, 3> names = {tr("Corner"), tr("Edge 1"), tr("Edge 2")};
  const std::array<QString, 3> helps = {
      tr("a corner of the light, in the local space of its transform"),
      tr("edge vector from the corner; the light emits along its normal, edge 1 × edge 2"),
      tr("the other edge vector from the corner")};
  for (std::size_t line = 0; line < 3; ++line) {
    layout->addWidget(new QLabel(names[line], form), static_cast<int>(line), 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const QString name = tr("%1, %2").arg(names[line], QString("xyz").mid(static_cast<qsizetype>(axis), 1));
      vectors_[line][axis] = number_box({name, tr("%1: %2").arg(name, helps[line]), -Largest, Largest}, form);
      layout->addWidget(vectors_[line][axis], static_cast<int>(line), static_cast<int>(axis) + 1);
    }
  }
  radiance_ = new ColourFields(tr("Radiance"), tr("emitted radiance, W/(sr m²)"), Largest, form);
  power_ = number_box({tr("Power"), tr("Emitted power: π × area × mean of the radiance's RGB values"), 0,
                       Largest, 10, tr("W")},
                      form);
  layout->addWidget(new QLabel(tr("Radiance"), form), 3, 0);
  layout->addWidget(radiance_, 3, 1, 1, 3);
  layout->addWidget(new QLabel(tr("Power"), form), 4, 0);
  layout->addWidget(power_, 4, 1, 1, 3);
  layout->setRowStretch(5, 1);
  connect_form();
  return form;
}

void LightPanel::connect_form() {
  const auto finish = [this] { document_.finish_gesture(); };
  for (std::size_t line = 0; line < 3; ++line) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto take = [this, line, axis](double number) {
        if (chosen_light() == nullptr) return;
        grf::AreaLight light = chosen_light()->light;
        vector_of(light, line)[static_cast<int>(axis)] = static_cast<float>(number);
        change(tr("Move light"), light, QString("light %1 %2").arg(line).arg(axis));
      };
      connect_number(vectors_[line][axis], this, take, finish);
    }
  }
  connect(radiance_, &ColourFields::edited, this, [this](const grf::Colour& radiance) {
    if (chosen_light() == nullptr) return;
    grf::AreaLight light = chosen_light()->light;
    light.radiance = radiance;
    change(tr("Set light radiance"), light, "light radiance");
  });
  connect(radiance_, &ColourFields::finished, this, finish);
  connect_number(
      power_, this, [this](double power) { change_power(power); }, finish);
}

QSize LightPanel::sizeHint() const { return {360, 480}; }

void LightPanel::choose(grf::ScenePathView path) {
  path_.emplace(path.begin(), path.end());
  show_lights();
}

const Emitter* LightPanel::chosen_emitter() const {
  const auto found = std::ranges::find_if(
      emitters_, [this](const Emitter& emitter) { return path_ && emitter.path == *path_; });
  return found == emitters_.end() ? nullptr : &*found;
}

const LightObject* LightPanel::chosen_light() const {
  const auto& lights = document_.objects().lights;
  const auto found = std::ranges::find_if(
      lights, [this](const LightObject& light) { return path_ && light.path == *path_; });
  return found == lights.end() ? nullptr : &*found;
}

bool LightPanel::concerns_lights(const Change& change) const {
  if (change.is_structural || change.transforms || change.lights || change.definitions) return true;
  std::set<grf::ScenePath> emitted;
  for (const Emitter& emitter : emitters_) emitted.insert(emitter.path);
  return std::ranges::any_of(change.meshes, [&](std::uint32_t i) {
    const MeshObject& mesh = document_.objects().meshes[i];
    return emits(mesh) || emitted.contains(mesh.path);
  });
}

void LightPanel::show_lights() {
  const QSignalBlocker blocker(list_);
  emitters_ = emitters_of(document_.objects());
  list_->clear();
  for (const Emitter& emitter : emitters_) {
    auto* item =
        new QTreeWidgetItem(list_, {name_of(emitter), text_of(emitter.area), text_of(emitter.power)});
    item->setIcon(0, icon(emitter.kind == Emitter::Kind::Faces ? "mesh" : "light"));
    for (const int column : {1, 2}) item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    if (path_ && emitter.path == *path_) list_->setCurrentItem(item);
  }
  show_chosen();
}

void LightPanel::show_chosen() {
  const LightObject* light = chosen_light();
  const Emitter* emitter = chosen_emitter();
  show_or_hide(problem_, {});
  enable(remove_, tr("Delete the light"),
         light == nullptr ? tr("Select a light first; emission of faces is edited in the Surface dock.")
                          : QString());
  pages_->setCurrentIndex(light != nullptr ? 2 : emitter != nullptr ? 1 : 0);
  hint_->setText(emitters_.empty() ? tr("The scene has no lights.\n\nAdd an area light with +, or select "
                                        "faces and set their emission in the Surface dock.")
                                   : tr("Select a light to edit it, or add one."));
  if (emitter != nullptr && light == nullptr) {
    about_->setText(
        emitter->count == 1
            ? tr("One face of a mesh emits. It is selected: edit its emission in the Surface dock.")
            : tr("%1 faces of a mesh emit. They are selected: edit their emission in the Surface dock.")
                  .arg(emitter->count));
  }
  if (light == nullptr) return;
  grf::AreaLight shown = light->light;
  for (std::size_t line = 0; line < 3; ++line) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vectors_[line][axis]->set_value(static_cast<double>(vector_of(shown, line)[static_cast<int>(axis)]));
    }
  }
  const grf::Colour radiance = shown.radiance.value_or(grf::Colour(1));
  radiance_->show_colour(radiance);
  power_->set_value(power_of(radiance, world_area(*light)));
}

void LightPanel::choose_item() {
  const int row = list_->indexOfTopLevelItem(list_->currentItem());
  if (row < 0) return;
  const Emitter emitter = emitters_[static_cast<std::size_t>(row)];
  path_ = emitter.path;
  FaceSelection selection(document_.objects());
  if (const auto mesh = document_.objects().mesh_at(emitter.path)) {
    const MeshObject& object = document_.objects().meshes[*mesh];
    for (std::uint32_t face = 0; face < object.mesh->face_count(); ++face) {
      const bool emits = object.is_light || object.mesh->surface(face).emission;
      if (emits) selection.set({*mesh, face});
    }
  }
  document_.select(std::move(selection));
  show_chosen();
  emit chosen(emitter.path);
}

void LightPanel::change(const QString& text, const grf::AreaLight& light, const QString& key) {
  grf::Diagnostics diagnostics;
  auto scene = change_light(document_.scene(), *path_, light, diagnostics);
  if (scene) {
    document_.replace(text, std::move(*scene), key);
  } else {
    show_or_hide(problem_, QString::fromStdString(diagnostics.entries().front().message));
  }
}

void LightPanel::change_power(double power) {
  const LightObject* light = chosen_light();
  if (light == nullptr) return;
  grf::AreaLight changed = light->light;
  changed.radiance = radiance_of(power, world_area(*light), changed.radiance.value_or(grf::Colour(1)));
  change(tr("Set light power"), changed, "light power");
}

void LightPanel::add() {
  document_.replace(tr("Add light"), add_light(document_.scene(), light_over(document_.objects().bounds)));
  choose(document_.objects().lights.back().path);
  emit chosen(*path_);
}

void LightPanel::remove() {
  grf::Diagnostics diagnostics;
  auto scene = remove_objects(document_.scene(), {*path_}, {}, diagnostics);
  path_.reset();
  if (scene) document_.replace(tr("Delete light"), std::move(*scene));
}

}  // namespace editor
