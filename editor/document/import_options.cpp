#include "editor/document/import_options.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "converters/assign_default_brdf.h"
#include "converters/mesh_operations/scene_placement.h"
#include "converters/scene_building.h"
#include "editor/document/preferences.h"
#include "editor/document/scene_loader.h"
#include "grf/check.h"
#include "grf/read.h"
#include "renderer/reflectance/scheme.h"

namespace editor {
namespace {

QString import_group(const QString& type) { return "import/types/" + type; }

std::vector<grf::TransformStep> import_placement(const ImportOptions& options) {
  std::vector<grf::TransformStep> steps;
  if (options.is_z_up) steps.push_back(convert::z_up_to_y_up());
  const auto units = convert::length_units();
  const auto unit = std::ranges::find(units, options.unit, &convert::LengthUnit::name);
  if (unit != units.end() && unit->metres != 1) {
    steps.push_back({grf::TransformStep::Kind::Scale, grf::Vec3f(static_cast<float>(unit->metres))});
  }
  return steps;
}

}  // namespace

bool ImportOptions::are_default() const {
  return !is_z_up && unit == "m" && !operations.any() && brdf.empty() &&
         std::ranges::find(left_out, true) == left_out.end();
}

std::vector<ImportedMesh> imported_meshes(const LoadedScene& loaded) {
  std::vector<ImportedMesh> meshes;
  grf::BlockList blocks = loaded.model.scene.contents;  // shares the meshes
  convert::for_each_mesh(blocks, [&meshes](const grf::Shared<grf::Mesh>& mesh) {
    meshes.push_back({QString::fromStdString(mesh->name), mesh->face_count()});
  });
  return meshes;
}

std::optional<grf::BrdfModel> read_import_brdf(const std::string& text, grf::Diagnostics& diagnostics) {
  if (text.empty()) return std::nullopt;
  auto brdf = grf::read_brdf(text, "BRDF", diagnostics);
  if (!brdf || !grf::check(*brdf, reflectance::catalogue().brdfs, "BRDF", diagnostics)) return std::nullopt;
  return brdf;
}

std::shared_ptr<const LoadedScene> with_options(const LoadedScene& loaded, const ImportOptions& options) {
  auto result = std::make_shared<LoadedScene>(loaded);
  grf::Scene& scene = result->model.scene;
  grf::Diagnostics& diagnostics = result->model.diagnostics;
  const std::string path = loaded.path.toStdString();
  const grf::SourceLocation location = grf::whole_file(path);
  const std::size_t known_losses = diagnostics.losses().size();
  if (!options.left_out.empty()) {
    std::size_t next = 0;
    convert::keep_meshes(scene.contents, [&](const grf::Mesh&) { return !options.left_out.at(next++); });
  }
  if (const auto brdf = read_import_brdf(options.brdf, diagnostics)) {
    convert::assign_default_brdf(scene, *brdf);
  }
  if (options.operations.any()) convert::apply(options.operations, scene, location, diagnostics);
  convert::place(scene, import_placement(options), location);
  for (std::size_t i = known_losses; i < diagnostics.losses().size(); ++i) {
    result->model.losses.append(QString::fromStdString(diagnostics.losses()[i]));
  }
  result->objects = std::make_shared<const SceneObjects>(objects_of(scene, result->model.path.toStdString()));
  return result;
}

QString import_type(const QString& file) { return QFileInfo(file).suffix().toLower(); }

ImportOptions remembered_import_options(const QString& type) {
  QSettings settings;
  settings.beginGroup(import_group(type));
  ImportOptions options;
  options.is_z_up = settings.value("up", Preferences::load().is_z_up ? "z" : "y").toString() == "z";
  options.unit = settings.value("unit", "m").toString().toStdString();
  options.brdf = settings.value("brdf").toString().toStdString();
  if (settings.contains("weld")) options.operations.weld = settings.value("weld").toDouble();
  if (settings.contains("decimate")) options.operations.decimate = settings.value("decimate").toDouble();
  const QString normals = settings.value("normals").toString();
  if (normals == "smooth") options.operations.normals = convert::Normals::Smooth;
  if (normals == "flat") options.operations.normals = convert::Normals::Flat;
  options.operations.crease = settings.value("crease").toDouble();
  return options;
}

void remember_import_options(const QString& type, const ImportOptions& options) {
  QSettings settings;
  settings.beginGroup(import_group(type));
  const auto set = [&settings](const QString& key, const QVariant& value, bool is_set) {
    is_set ? settings.setValue(key, value) : settings.remove(key);
  };
  const convert::MeshOperations& operations = options.operations;
  const bool is_flat = operations.normals == convert::Normals::Flat;
  set("up", options.is_z_up ? "z" : "y", options.is_z_up != Preferences::load().is_z_up);
  set("unit", QString::fromStdString(options.unit), options.unit != "m");
  set("brdf", QString::fromStdString(options.brdf), !options.brdf.empty());
  set("weld", operations.weld.value_or(0), operations.weld.has_value());
  set("decimate", operations.decimate.value_or(1), operations.decimate.has_value());
  set("normals", is_flat ? "flat" : "smooth", operations.normals != convert::Normals::Keep);
  set("crease", operations.crease, operations.normals == convert::Normals::Smooth);
}

bool asks_for_import_options(const QString& type) {
  return QSettings().value(import_group(type) + "/asks", true).toBool();
}

void set_asks_for_import_options(const QString& type, bool asks) {
  QSettings().setValue(import_group(type) + "/asks", asks);
}

}  // namespace editor
