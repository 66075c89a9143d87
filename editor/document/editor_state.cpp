#include "editor/document/editor_state.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "grf/text_file.h"

namespace editor {
namespace {

/// The runs of selected faces of a mesh: the first face and the number of faces of each.
QJsonArray runs_of(const FaceSelection::Faces& faces) {
  QJsonArray runs;
  for (auto first = faces.find_first(); first != FaceSelection::Faces::npos;) {
    std::size_t end = first;
    while (end < faces.size() && faces[end]) ++end;
    runs.append(static_cast<qint64>(first));
    runs.append(static_cast<qint64>(end - first));
    first = end < faces.size() ? faces.find_next(end) : FaceSelection::Faces::npos;
  }
  return runs;
}

QJsonArray json_of(const FaceSelection& selection, const SceneObjects& objects) {
  QJsonArray meshes;
  for (const std::uint32_t mesh : selection.meshes()) {
    QJsonArray path;
    for (const std::uint32_t index : objects.meshes[mesh].path) path.append(static_cast<qint64>(index));
    meshes.append(QJsonObject{{"path", path},
                              {"name", QString::fromStdString(objects.meshes[mesh].name)},
                              {"face_count", static_cast<qint64>(selection.of_mesh(mesh).size())},
                              {"runs", runs_of(selection.of_mesh(mesh))}});
  }
  return meshes;
}

/// Reads sets of faces, and remembers whether something did not fit the scene.
class FaceSetReader {
 public:
  explicit FaceSetReader(const SceneObjects& objects) : objects_(objects) {}

  bool fits() const { return fits_; }
  FaceSelection read(const QJsonValue& value) {
    FaceSelection selection(objects_);
    if (!value.isArray()) fits_ = fits_ && value.isUndefined();
    for (const auto& mesh : value.toArray()) fits_ = read_mesh(mesh, selection) && fits_;
    return selection;
  }

 private:
  /// The mesh that an entry describes, if the scene has it with this name and number of faces.
  std::optional<std::uint32_t> mesh_of(const QJsonValue& entry) const {
    grf::ScenePath path;
    for (const auto& index : entry["path"].toArray()) {
      path.push_back(static_cast<std::uint32_t>(index.toInteger(-1)));
    }
    const auto mesh = objects_.mesh_at(path);
    if (!mesh) return std::nullopt;
    const MeshObject& object = objects_.meshes[*mesh];
    const bool is_same =
        entry["face_count"].toInteger(-1) == static_cast<qint64>(object.mesh->face_count()) &&
        entry["name"].toString().toStdString() == object.name;
    return is_same ? mesh : std::nullopt;
  }

  bool read_mesh(const QJsonValue& entry, FaceSelection& selection) const {
    const auto mesh = mesh_of(entry);
    const QJsonArray runs = entry["runs"].toArray();
    if (!mesh || runs.size() % 2 != 0) return false;
    FaceSelection::Faces faces = selection.of_mesh(*mesh);
    const auto face_count = static_cast<qint64>(faces.size());
    for (qsizetype i = 0; i < runs.size(); i += 2) {
      const qint64 first = runs[i].toInteger(-1);
      const qint64 count = runs[i + 1].toInteger(-1);
      if (first < 0 || count < 1 || first >= face_count || count > face_count - first) return false;
      faces.set(static_cast<std::size_t>(first), static_cast<std::size_t>(count), true);
    }
    selection.set_faces(*mesh, faces);
    return true;
  }

  const SceneObjects& objects_;
  bool fits_ = true;
};

}  // namespace

FaceSelection EditorState::selectable(FaceSelection faces) const {
  if (!hidden.empty()) faces.remove(hidden);
  if (!locked.empty()) faces.remove(locked);
  return faces;
}

EditorState EditorState::carried_over(const FaceCorrespondence& correspondence) const {
  EditorState carried;
  carried.hidden = correspondence.carried_over(hidden);
  carried.locked = correspondence.carried_over(locked);
  for (const auto& [name, faces] : face_sets) {
    carried.face_sets.emplace(name, correspondence.carried_over(faces));
  }
  return carried;
}

void RemovedFaces::remember(const EditorState& state, const SceneObjects& before,
                            const FaceCorrespondence& correspondence) {
  for (const std::uint32_t mesh : correspondence.removed()) {
    RemovedMesh removed = {before.meshes[mesh].mesh,
                           before.meshes[mesh].path,
                           state.hidden.of_mesh(mesh),
                           state.locked.of_mesh(mesh),
                           {}};
    for (const auto& [name, faces] : state.face_sets) {
      if (faces.count(mesh) > 0) removed.face_sets.emplace(name, faces.of_mesh(mesh));
    }
    if (removed.hidden.any() || removed.locked.any() || !removed.face_sets.empty())
      meshes_.push_back(std::move(removed));
  }
}

void RemovedFaces::restore(EditorState& state, const SceneObjects& now,
                           const FaceCorrespondence& correspondence) {
  for (const std::uint32_t mesh : correspondence.added()) {
    const MeshObject& object = now.meshes[mesh];
    // The last one, since a mesh may be removed more than once; copies of a mesh share its geometry.
    const auto is_same = [&](const RemovedMesh& removed) {
      return removed.path == object.path && removed.mesh->geometry.shares(object.mesh->geometry);
    };
    const auto found = std::find_if(meshes_.rbegin(), meshes_.rend(), is_same);
    if (found == meshes_.rend()) continue;
    state.hidden.set_faces(mesh, found->hidden);
    state.locked.set_faces(mesh, found->locked);
    for (const auto& [name, faces] : found->face_sets) {
      const auto set = state.face_sets.find(name);
      if (set != state.face_sets.end()) set->second.set_faces(mesh, faces);
    }
    meshes_.erase(std::next(found).base());
  }
}

QString editor_file_beside(const QString& scene_path) { return scene_path + ".editor.json"; }

EditorState read_editor_state(const QString& scene_path, const SceneObjects& objects,
                              grf::Diagnostics& diagnostics) {
  EditorState state(objects);
  const QString path = editor_file_beside(scene_path);
  if (scene_path.isEmpty() || !QFile::exists(path)) return state;
  const auto warn = [&](std::string_view what) {
    diagnostics.warning(grf::whole_file(path.toStdString()), what);
  };
  grf::Diagnostics errors;
  const auto bytes = grf::read_file(path.toStdString(), errors);
  const QJsonDocument document =
      QJsonDocument::fromJson(bytes ? QByteArray::fromStdString(*bytes) : QByteArray());
  if (!document.isObject()) {
    warn("cannot read which faces are hidden, locked or in named sets: they are ignored");
    return state;
  }
  FaceSetReader reader(objects);
  const QJsonObject object = document.object();
  state.hidden = reader.read(object["hidden"]);
  state.locked = reader.read(object["locked"]);
  const QJsonObject face_sets = object["face_sets"].toObject();
  for (auto set = face_sets.begin(); set != face_sets.end(); ++set) {
    state.face_sets.emplace(set.key().toStdString(), reader.read(set.value()));
  }
  if (!reader.fits()) {
    warn("some hidden, locked or named faces are of meshes that the scene does not have: they are ignored");
  }
  return state;
}

bool write_editor_state(const EditorState& state, const SceneObjects& objects, const QString& scene_path,
                        grf::Diagnostics& diagnostics) {
  const QString path = editor_file_beside(scene_path);
  if (state.empty()) {
    if (!QFile::exists(path) || QFile::remove(path)) return true;
    diagnostics.error(grf::whole_file(path.toStdString()), "cannot remove the file");
    return false;
  }
  QJsonObject object;
  if (!state.hidden.empty()) object["hidden"] = json_of(state.hidden, objects);
  if (!state.locked.empty()) object["locked"] = json_of(state.locked, objects);
  QJsonObject face_sets;
  for (const auto& [name, faces] : state.face_sets) {
    face_sets[QString::fromStdString(name)] = json_of(faces, objects);
  }
  if (!face_sets.empty()) object["face_sets"] = face_sets;
  return grf::replace_file(path.toStdString(),
                           QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString(), diagnostics);
}

}  // namespace editor
