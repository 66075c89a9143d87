#include "editor/document/reimport.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "editor/document/scene_places.h"

namespace editor {
namespace {

using grf::Mesh;
using grf::Shared;

constexpr std::string_view Imported = "imported \"";
constexpr std::string_view From = "\" from \"";

/// The object and file of a comment.
struct ImportSource {
  std::string object;
  std::string file;
};

std::string comment_of(const ImportSource& source) {
  return std::string(Imported) + source.object + std::string(From) + source.file + "\"";
}

std::optional<ImportSource> source_of(const grf::Comments& comments) {
  for (const std::string& comment : comments.before) {
    // A writer may set the slashes of a comment apart from its text.
    const std::string_view text =
        std::string_view(comment).substr(std::min(comment.find_first_not_of(' '), comment.size()));
    const std::size_t from = text.rfind(From);
    if (!text.starts_with(Imported) || from == std::string_view::npos || !text.ends_with('"')) continue;
    const std::size_t file = from + From.size();
    return ImportSource{std::string(text.substr(Imported.size(), from - Imported.size())),
                        std::string(text.substr(file, text.size() - 1 - file))};
  }
  return std::nullopt;
}

using MeshAction = std::function<void(Shared<Mesh>& mesh, grf::Comments& comments)>;

/// Calls the action for each mesh of the file's own blocks and definitions.
void for_each_mesh(grf::BlockList& list, const MeshAction& action) {
  for (grf::Block& block : list.blocks) {
    if (auto* mesh = std::get_if<Shared<Mesh>>(&block.content)) action(*mesh, block.comments);
    if (auto* transform = std::get_if<grf::Transform>(&block.content)) for_each_mesh(transform->body, action);
    auto* scope = std::get_if<grf::DefinitionScope>(&block.content);
    if (scope == nullptr) continue;
    for (grf::Definition& definition : scope->definitions) {
      if (auto* mesh = std::get_if<Shared<Mesh>>(&definition.body)) action(*mesh, definition.comments);
    }
    for_each_mesh(scope->body, action);
  }
}

class ReimportText {
  Q_DECLARE_TR_FUNCTIONS(editor::ReimportText)
};

/// The name of an object for people.
QString name_of(const std::string& object) { return QString::fromStdString(object); }

/// Returns a mesh with the geometry of one and the surfaces of the other, by the order of faces.
Mesh with_geometry_of(const Mesh& mesh, const Mesh& from) {
  Mesh result = mesh;
  result.geometry = from.geometry;
  std::vector<std::uint32_t> surfaces = *mesh.surface_of_face;
  surfaces.resize(from.face_count(), 0);
  result.surface_of_face = std::move(surfaces);
  if (mesh.geometry->positions.size() != from.geometry->positions.size()) result.irradiance = from.irradiance;
  return result;
}

}  // namespace

void mark_imported(grf::Scene& scene, const QString& file) {
  for_each_mesh(scene.contents, [&](const Shared<Mesh>& mesh, grf::Comments& comments) {
    comments.before.push_back(comment_of({mesh->name, file.toStdString()}));
  });
}

QString import_source(const grf::Scene& scene, grf::ScenePathView path) {
  const grf::Block* block = block_at(scene, path);
  if (block == nullptr) return {};
  grf::BlockList list{{*block}, {}};  // shares the meshes
  QString file;
  for_each_mesh(list, [&](const Shared<Mesh>&, const grf::Comments& comments) {
    const auto source = source_of(comments);
    if (source && file.isEmpty()) file = QString::fromStdString(source->file);
  });
  return file;
}

Reimported reimported(const grf::Scene& scene, const QString& file, const grf::Scene& model) {
  std::map<std::string, Shared<Mesh>> objects;
  grf::BlockList read = model.contents;  // shares the meshes
  for_each_mesh(
      read, [&](const Shared<Mesh>& mesh, const grf::Comments&) { objects.try_emplace(mesh->name, mesh); });
  Reimported result{scene, 0, {}};
  std::set<std::string> used;
  for_each_mesh(result.scene.contents, [&](Shared<Mesh>& mesh, const grf::Comments& comments) {
    const auto source = source_of(comments);
    if (!source || QString::fromStdString(source->file) != file) return;
    const auto object = objects.find(source->object);
    if (object == objects.end()) {
      result.problems +=
          ReimportText::tr("%1 is no longer in the file: it stays as it was").arg(name_of(source->object));
      return;
    }
    used.insert(source->object);
    const Mesh& now = *object->second;
    const auto before = static_cast<qlonglong>(mesh->face_count());
    const qlonglong more = static_cast<qlonglong>(now.face_count()) - before;
    const QString name = name_of(source->object);
    if (more > 0) {
      result.problems +=
          more == 1
              ? ReimportText::tr("%1 has 1 more face, with the surface of the mesh").arg(name)
              : ReimportText::tr("%1 has %2 more faces, with the surface of the mesh").arg(name).arg(more);
    } else if (more < 0) {
      result.problems += more == -1 ? ReimportText::tr("%1 has 1 face less").arg(name)
                                    : ReimportText::tr("%1 has %2 fewer faces").arg(name).arg(-more);
    }
    if (now.geometry == mesh->geometry) return;
    mesh = with_geometry_of(*mesh, now);
    ++result.meshes;
  });
  for (const auto& [name, mesh] : objects) {
    if (!used.contains(name))
      result.problems +=
          ReimportText::tr("%1 is new in the file: append the file to get it").arg(name_of(name));
  }
  return result;
}

}  // namespace editor
