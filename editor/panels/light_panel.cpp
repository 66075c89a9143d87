#include "editor/panels/light_panel.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMenu>
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
#include "editor/panels/environment_form.h"
#include "editor/panels/lamp_form.h"

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
  layout->addWidget(new EnvironmentForm(document_, this));
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
  QToolButton* add_button = tool_button(
      "add", tr("Add a light"),
      tr("Add a rectangular light above the scene, facing down; the arrow has discs and spheres"),
      [this] { add(); }, row);
  auto* menu = new QMenu(add_button);
  const auto add_shape = [this, menu](const QString& name, const QString& tip, LampShape shape) {
    menu->addAction(name, this, [this, shape] { add(shape); })->setToolTip(tip);
  };
  add_shape(tr("&Rectangle"), tr("Add a rectangular light above the scene, facing down"),
            LampShape::Rectangle);
  add_shape(tr("&Disc"), tr("Add a disc above the scene, facing down: a mesh light"), LampShape::Disc);
  add_shape(tr("&Sphere"), tr("Add a spherical light above the scene: a mesh light"), LampShape::Sphere);
  menu->setToolTipsVisible(true);
  add_button->setMenu(menu);
  add_button->setPopupMode(QToolButton::MenuButtonPopup);
  layout->addWidget(add_button);
  remove_ = tool_button(
      "delete", tr("Delete the light"), {}, [this] { remove(); }, row);
  layout->addWidget(remove_);
  layout->addStretch(1);
  return row;
}

QWidget* LightPanel::make_form() {
  auto* page = new QWidget(pages_);
  auto* layout = tight_layout<QVBoxLayout>(page, Grid);
  corner_ = make_corner();
  form_ = new LampForm(page);
  layout->addWidget(corner_);
  layout->addWidget(form_, 1);
  connect(form_, &LampForm::edited, this, [this](const Lamp& lamp, const QString& title, const QString& key) {
    if (this->lamp()) {
      change_lamp(lamp, title, key);
    } else if (chosen_light() != nullptr) {
      grf::AreaLight light = chosen_light()->light;
      light.radiance = lamp.radiance;
      change(title, light, key);
    }
  });
  connect(form_, &LampForm::finished, &document_, &Document::finish_gesture);
  connect(form_, &LampForm::aim_requested, this, &LightPanel::aim_requested);
  connect(form_, &LampForm::highlight_requested, this, &LightPanel::highlight_requested);
  return page;
}

QWidget* LightPanel::make_corner() {
  auto* form = new QWidget(pages_);
  auto* layout = tight_layout<QGridLayout>(form);
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
      NumberBox* box =
          number_box({name, tr("%1: %2").arg(name, helps[line]), -Largest, Largest, 0.1, "m"}, form);
      vectors_[line][axis] = box;
      layout->addWidget(box, static_cast<int>(line), static_cast<int>(axis) + 1);
      const auto take = [this, line, axis](double number) {
        if (chosen_light() == nullptr) return;
        grf::AreaLight light = chosen_light()->light;
        vector_of(light, line)[static_cast<int>(axis)] = static_cast<float>(number);
        change(tr("Move light"), light, QString("light %1 %2").arg(line).arg(axis));
      };
      connect_number(box, this, take, [this] { document_.finish_gesture(); });
    }
  }
  return form;
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
  if (change.moves_objects() || change.definitions) return true;
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
  const std::optional<Lamp> lamp = this->lamp();
  const bool has_form = lamp || light != nullptr;
  enable(remove_, tr("Delete the light"),
         has_form ? QString() : tr("Select a light first; emission of faces is edited in the Surface dock."));
  pages_->setCurrentIndex(has_form ? 2 : emitter != nullptr ? 1 : 0);
  hint_->setText(emitters_.empty() ? tr("The scene has no lights.\n\nAdd an area light with +, or select "
                                        "faces and set their emission in the Surface dock.")
                                   : tr("Select a light to edit it, or add one."));
  if (emitter != nullptr && !has_form) {
    about_->setText(
        emitter->count == 1
            ? tr("One face of a mesh emits. It is selected: edit its emission in the Surface dock.")
            : tr("%1 faces of a mesh emit. They are selected: edit their emission in the Surface dock.")
                  .arg(emitter->count));
  }
  corner_->setVisible(light != nullptr && !lamp);
  if (lamp) return form_->show_lamp(*lamp, emitter->area);
  if (light == nullptr) return;
  grf::AreaLight shown = light->light;
  for (std::size_t line = 0; line < 3; ++line) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vectors_[line][axis]->set_value(static_cast<double>(vector_of(shown, line)[static_cast<int>(axis)]));
    }
  }
  form_->show_output(shown.radiance.value_or(grf::Colour(1)), world_area(*light));
}

std::optional<Lamp> LightPanel::lamp() const {
  if (chosen_emitter() == nullptr) return std::nullopt;
  return lamp_at(document_.scene(), document_.objects(), *path_);
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
  if (!scene) return report(diagnostics);
  document_.replace(text, std::move(*scene), key);
}

void LightPanel::report(const grf::Diagnostics& diagnostics) {
  show_or_hide(problem_, QString::fromStdString(diagnostics.entries().front().message));
}

void LightPanel::change_lamp(const Lamp& lamp, const QString& title, const QString& key) {
  grf::Diagnostics diagnostics;
  auto edited = editor::change_lamp(document_.scene(), document_.objects(), *path_, lamp, diagnostics);
  if (!edited) return report(diagnostics);
  document_.select_objects({*path_});
  path_ = edited->paths.front();
  document_.replace_objects(title, std::move(*edited), key);
}

void LightPanel::add(LampShape shape) {
  document_.replace(tr("Add light"),
                    add_lamp(document_.scene(), lamp_over(shape, document_.objects().bounds)));
  const SceneObjects& objects = document_.objects();
  choose(shape == LampShape::Rectangle ? objects.lights.back().path : objects.instances->back().path);
  emit chosen(*path_);
}

void LightPanel::remove() {
  grf::Diagnostics diagnostics;
  auto scene = remove_objects(document_.scene(), {*path_}, {}, diagnostics);
  path_.reset();
  if (scene) document_.replace(tr("Delete light"), std::move(*scene));
}

}  // namespace editor
