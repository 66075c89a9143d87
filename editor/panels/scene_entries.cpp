#include "editor/panels/scene_entries.h"

#include <QFileInfo>
#include <array>
#include <map>
#include <numbers>
#include <unordered_map>
#include <utility>
#include <variant>

#include "editor/controls/counted.h"
#include "editor/document/definitions.h"
#include "editor/panels/scene_tree.h"
#include "grf/write.h"

namespace editor {
namespace {

using Kind = SceneEntry::Kind;

QString count_of_faces(std::size_t faces) {
  return counted(faces, SceneTree::tr("1 face"), SceneTree::tr("%1 faces"));
}
QString face_count(const grf::Mesh& mesh) { return count_of_faces(mesh.face_count()); }

/// The numbers of objects and faces in an item.
QString numbers_in(const SceneEntry& entry) {
  const QString objects =
      counted(entry.children.size(), SceneTree::tr("1 object"), SceneTree::tr("%1 objects"));
  return entry.faces == 0 ? objects : SceneTree::tr("%1, %2").arg(objects, count_of_faces(entry.faces));
}

QString text_of(const grf::Vec3f& v, int digits = 4) {
  const auto number = [digits](float value) {
    return QString::number(static_cast<double>(value), 'g', digits);
  };
  return QString("(%1, %2, %3)").arg(number(v.x), number(v.y), number(v.z));
}

QString text_of(const std::vector<grf::TransformStep>& steps) {
  QStringList words;
  for (const grf::TransformStep& step : steps) {
    const bool is_turn = step.kind == grf::TransformStep::Kind::Rotation;
    const auto degrees = static_cast<float>(180 / std::numbers::pi);
    const QString word = is_turn                                        ? SceneTree::tr("rotated by %1°")
                         : step.kind == grf::TransformStep::Kind::Scale ? SceneTree::tr("scaled by %1")
                                                                        : SceneTree::tr("translated by %1");
    words << word.arg(text_of(is_turn ? step.value * degrees : step.value));
  }
  return words.join(", ");
}

class Builder {
 public:
  explicit Builder(const Document& document) : document_(document), uses_(count_uses(document.scene())) {
    const SceneObjects& objects = document.objects();
    for (std::uint32_t i = 0; i < objects.meshes.size(); ++i) meshes_.emplace(objects.meshes[i].path, i);
    for (const MeshInstance& instance : *objects.instances) {
      meshes_.emplace(instance.path, instance.mesh);
      places_.emplace(instance.path, grf::Vec3f(grf::Vec3d(0) * instance.to_world));
    }
  }

  std::unique_ptr<SceneEntry> build() {
    auto root = std::make_unique<SceneEntry>();
    SceneEntry* objects = root->add(group(
        SceneTree::tr("Objects"), SceneTree::tr("The objects of the scene, nested as in its scene graph")));
    path_.clear();
    add_blocks(document_.scene().contents, 0, *objects);
    objects->detail =
        objects->children.empty() ? SceneTree::tr("none") : QString::number(objects->children.size());
    const std::vector<std::pair<QString, Kind>> kinds = {
        {SceneTree::tr("BRDFs"), Kind::Brdf},
        {SceneTree::tr("Sampling schemes"), Kind::Pdf},
        {SceneTree::tr("Colours"), Kind::Colour},
        {SceneTree::tr("Textures"), Kind::Texture},
        {SceneTree::tr("Mesh definitions"), Kind::DefinedMesh}};
    for (const auto& [name, kind] : kinds) {
      auto& found = definitions_[kind];
      if (found.empty()) continue;
      SceneEntry* of_kind = root->add(group(name, SceneTree::tr("Named definitions of the scene")));
      of_kind->detail = QString::number(found.size());
      for (auto& each : found) of_kind->add(std::move(each));
    }
    return root;
  }

 private:
  static std::unique_ptr<SceneEntry> group(const QString& name, const QString& help) {
    auto entry = std::make_unique<SceneEntry>();
    entry->name = name;
    entry->help = help;
    return entry;
  }

  std::unique_ptr<SceneEntry> entry(Kind kind, const QString& name, const QString& detail,
                                    const QString& help) {
    auto made = std::make_unique<SceneEntry>();
    made->kind = kind;
    made->name = name;
    made->detail = detail;
    made->help = help;
    made->path = path_;
    const auto mesh = meshes_.find(path_);
    if (mesh != meshes_.end()) made->mesh = mesh->second;
    if (made->mesh) made->faces = document_.objects().meshes[*made->mesh].mesh->face_count();
    return made;
  }

  void add_blocks(const grf::BlockList& list, std::size_t before, SceneEntry& parent) {
    path_.push_back(static_cast<std::uint32_t>(before));
    for (const grf::Block& block : list.blocks) {
      std::visit([&](const auto& content) { add(content, parent); }, block.content);
      ++path_.back();
    }
    path_.pop_back();
  }

  void add(const grf::Shared<grf::Mesh>& mesh, SceneEntry& parent) {
    parent.add(entry(Kind::Mesh, display_name_of(*mesh), face_count(*mesh), SceneTree::tr("A mesh")));
  }
  void add(const grf::MeshLight& light, SceneEntry& parent) {
    parent.add(entry(Kind::MeshLight, SceneTree::tr("mesh light"), face_count(*light.mesh),
                     SceneTree::tr("A mesh that emits light")));
  }
  void add(const grf::AreaLight&, SceneEntry& parent) {
    parent.add(
        entry(Kind::AreaLight, SceneTree::tr("light"), {}, SceneTree::tr("A parallelogram area light")));
  }
  void add(const grf::Include& include, SceneEntry& parent) {
    const QString file = QString::fromStdString(include.file);
    SceneEntry* made = parent.add(entry(Kind::Include, QFileInfo(file).fileName(), SceneTree::tr("file"),
                                        SceneTree::tr("The blocks of the file %1").arg(file)));
    add_blocks(*include.contents, 0, *made);
  }
  void add(const grf::Transform& transform, SceneEntry& parent) {
    const QString text = text_of(transform.steps);
    auto made = entry(Kind::Transform, SceneTree::tr("transform"), {}, text);
    add_blocks(transform.body, 0, *made);
    const bool is_of_one = made->children.size() == 1 && made->children.front()->children.empty() &&
                           made->children.front()->kind != Kind::Include;
    if (is_of_one) made = std::move(made->children.front());
    if (is_of_one) made->help += ", " + text;
    if (!is_of_one) made->detail = contents_of(*made);
    parent.add(std::move(made));
  }
  void add(const grf::DefinitionScope& scope, SceneEntry& parent) {
    path_.push_back(0);
    for (const grf::Definition& definition : scope.definitions) {
      add_definition(definition);
      ++path_.back();
    }
    path_.pop_back();
    add_blocks(scope.body, scope.definitions.size(), parent);
  }
  void add(const grf::Params& params, SceneEntry& parent) {
    for (std::size_t i = 0; i < params.views.size(); ++i) {
      SceneEntry* made = parent.add(entry(Kind::Observer, SceneTree::tr("observer"), text_of(params.views[i]),
                                          SceneTree::tr("The viewpoint for view-dependent irradiance")));
      made->observer = i;
    }
  }
  void add(const grf::Use& use, SceneEntry& parent) {
    const QString name = QString::fromStdString(use.mesh.name);
    const auto place = places_.find(path_);
    const QString detail = place == places_.end() ? SceneTree::tr("use") : text_of(place->second, 3);
    parent.add(entry(Kind::Instance, name, detail, SceneTree::tr("An instance of the mesh '%1'").arg(name)));
  }

  void add_definition(const grf::Definition& definition) {
    const auto found = uses_.find(&definition);
    const std::size_t uses = found == uses_.end() ? 0 : found->second;
    const QString detail =
        uses == 0 ? SceneTree::tr("unused") : counted(uses, SceneTree::tr("1 use"), SceneTree::tr("%1 uses"));
    const QString name = QString::fromStdString(definition.name);
    static constexpr std::array Kinds = {Kind::Colour, Kind::Brdf, Kind::Pdf, Kind::Texture,
                                         Kind::DefinedMesh};
    const Kind kind = Kinds[definition.body.index()];
    definitions_[kind].push_back(entry(
        kind, name, detail, std::visit([](const auto& body) { return description(body); }, definition.body)));
  }
  static QString description(const grf::Colour& colour) {
    return SceneTree::tr("Colour %1").arg(text_of(colour));
  }
  static QString description(const grf::BrdfModel& brdf) {
    return QString::fromStdString(grf::to_text(brdf));
  }
  static QString description(const grf::PdfModel& pdf) { return QString::fromStdString(grf::to_text(pdf)); }
  static QString description(const grf::Texture& texture) { return QString::fromStdString(texture.file); }
  static QString description(const grf::Shared<grf::Mesh>& mesh) { return face_count(*mesh); }

  const Document& document_;
  std::unordered_map<const grf::Definition*, std::size_t> uses_;
  std::map<grf::ScenePath, std::uint32_t> meshes_;
  std::map<grf::ScenePath, grf::Vec3f> places_;  // of instances, in the world
  std::map<Kind, std::vector<std::unique_ptr<SceneEntry>>> definitions_;
  grf::ScenePath path_;
};

}  // namespace

bool SceneEntry::is_definition() const {
  return kind == Kind::Brdf || kind == Kind::Pdf || kind == Kind::Colour || kind == Kind::Texture ||
         kind == Kind::DefinedMesh;
}

bool SceneEntry::can_be_renamed() const { return is_definition() || kind == Kind::Mesh; }

SceneEntry* SceneEntry::add(std::unique_ptr<SceneEntry> child) {
  child->parent = this;
  child->row = static_cast<int>(children.size());
  if (!child->is_definition()) faces += child->faces;
  children.push_back(std::move(child));
  return children.back().get();
}

void SceneEntry::number_children() {
  for (std::size_t i = 0; i < children.size(); ++i) {
    children[i]->parent = this;
    children[i]->row = static_cast<int>(i);
  }
}

QString display_name_of(const grf::Mesh& mesh) {
  return mesh.name.empty() ? SceneTree::tr("mesh") : QString::fromStdString(mesh.name);
}

QString contents_of(const SceneEntry& transform) {
  const SceneEntry* only = &transform;
  while (only->children.size() == 1) only = only->children.front().get();
  return only != &transform && only->children.empty() ? only->name : numbers_in(transform);
}

std::unique_ptr<SceneEntry> entries_of(const Document& document) { return Builder(document).build(); }

QString icon_of(SceneEntry::Kind kind) {
  switch (kind) {
    case Kind::Group:
      return "objects";
    case Kind::Mesh:
    case Kind::DefinedMesh:
      return "mesh";
    case Kind::MeshLight:
    case Kind::AreaLight:
      return "light";
    case Kind::Instance:
      return "instance";
    case Kind::Transform:
      return "transform";
    case Kind::Include:
      return "include";
    case Kind::Observer:
      return "observer";
    case Kind::Brdf:
      return "brdf";
    case Kind::Pdf:
      return "pdf";
    case Kind::Colour:
      return "colour";
    case Kind::Texture:
      return "texture";
  }
  return "objects";
}

}  // namespace editor
