#include "editor/document/document.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "editor/document/image_files.h"
#include "editor/document/model_import.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/scene_path.h"
#include "grf/write.h"

namespace editor {
namespace {

/// The file from which a scene names others: one that was never saved does so from the current folder.
QString naming_path(const QString& path) { return path.isEmpty() ? QStringLiteral("Untitled.grf") : path; }

/// Files as they are named from another file.
grf::Scene moved(grf::Scene scene, const QString& from, const QString& to) {
  if (from != to) grf::relocate(scene, naming_path(from).toStdString(), naming_path(to).toStdString());
  return scene;
}

std::vector<MeshSurfaces> moved(std::vector<MeshSurfaces> all, const QString& from, const QString& to) {
  if (from == to) return all;
  for (MeshSurfaces& surfaces : all) {
    grf::Mesh holder;
    holder.surfaces = surfaces.surfaces;
    grf::Scene scene;
    scene.contents.blocks.emplace_back().content = grf::Shared(std::move(holder));
    scene = moved(std::move(scene), from, to);
    surfaces.surfaces = (*grf::find_mesh(scene, grf::ScenePath{0}))->surfaces;
  }
  return all;
}

/// Which mesh of before each mesh is: shared ones in their order, then changed ones with as many faces, in
/// their order if there are as many of them, else by their paths.
std::vector<std::optional<std::uint32_t>> matched_meshes(const SceneObjects& before,
                                                         const SceneObjects& now) {
  std::vector<std::optional<std::uint32_t>> matches(now.meshes.size());
  std::multimap<const grf::Mesh*, std::uint32_t> known;
  for (std::uint32_t i = 0; i < before.meshes.size(); ++i) known.emplace(&*before.meshes[i].mesh, i);
  std::vector<std::uint32_t> changed;
  for (std::uint32_t i = 0; i < now.meshes.size(); ++i) {
    const auto same = known.lower_bound(&*now.meshes[i].mesh);
    if (same == known.end() || same->first != &*now.meshes[i].mesh) {
      changed.push_back(i);
      continue;
    }
    matches[i] = same->second;
    known.erase(same);
  }
  std::set<std::uint32_t> left;
  for (const auto& [mesh, number] : known) left.insert(number);
  std::map<grf::ScenePath, std::uint32_t> places;
  for (const std::uint32_t number : left) places.emplace(before.meshes[number].path, number);
  const bool are_in_order = left.size() == changed.size();
  auto next = left.begin();
  for (const std::uint32_t i : changed) {
    const auto place = places.find(now.meshes[i].path);
    std::optional<std::uint32_t> match;
    if (are_in_order) {
      match = *next++;
    } else if (place != places.end()) {
      match = place->second;
    }
    if (!match || before.meshes[*match].mesh->face_count() != now.meshes[i].mesh->face_count()) continue;
    matches[i] = match;
  }
  return matches;
}

}  // namespace

/// A command that takes up the steps of its gesture. What it holds names files from a path: the document may
/// be saved elsewhere before it is undone.
class Document::MergingCommand : public QUndoCommand {
 public:
  MergingCommand(const QString& text, QString key, int gesture, QString path)
      : QUndoCommand(text), path_(std::move(path)), key_(std::move(key)), gesture_(gesture) {}

 protected:
  const QString path_;

  bool is_of_same_gesture(const MergingCommand& later) const {
    return !key_.isEmpty() && key_ == later.key_ && gesture_ == later.gesture_;
  }

 private:
  QString key_;
  int gesture_;
};

class Document::SceneCommand : public MergingCommand {
 public:
  SceneCommand(Document& document, const QString& text, grf::Scene after, const QString& key)
      : MergingCommand(text, key, document.gesture_, document.path_),
        document_(document),
        before_(document.scene_),
        after_(std::move(after)),
        selection_(document.selection_) {}

  int id() const override { return 1; }
  void undo() override { document_.show(moved(before_, path_, document_.path_), &selection_); }
  void redo() override { document_.show(moved(after_, path_, document_.path_), nullptr); }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& later = static_cast<const SceneCommand&>(*other);
    if (!is_of_same_gesture(later) || path_ != later.path_) return false;
    after_ = later.after_;
    return true;
  }

 private:
  Document& document_;
  grf::Scene before_;
  grf::Scene after_;
  FaceSelection selection_;  // before
};

class Document::SurfaceCommand : public MergingCommand {
 public:
  SurfaceCommand(Document& document, const QString& text, std::vector<MeshSurfaces> after, const QString& key)
      : MergingCommand(text, key, document.gesture_, document.path_),
        document_(document),
        after_(std::move(after)),
        selection_(document.selection_) {
    for (const MeshSurfaces& surfaces : after_) {
      before_.push_back(surfaces_of(**grf::find_mesh(document.scene_, surfaces.path), surfaces.path));
    }
  }

  int id() const override { return 2; }
  void undo() override { document_.put_surfaces(moved(before_, path_, document_.path_), selection_); }
  void redo() override { document_.put_surfaces(moved(after_, path_, document_.path_), selection_); }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& later = static_cast<const SurfaceCommand&>(*other);
    if (!is_of_same_gesture(later) || path_ != later.path_ || !(selection_ == later.selection_)) return false;
    after_ = later.after_;
    return true;
  }

 private:
  Document& document_;
  std::vector<MeshSurfaces> before_;
  std::vector<MeshSurfaces> after_;
  FaceSelection selection_;
};

Document::Document(QObject* parent) : QObject(parent) {
  connect(&undo_stack_, &QUndoStack::cleanChanged, this,
          [this](bool is_clean) { emit modified_changed(!is_clean); });
}

// Commands refer to the document.
Document::~Document() { undo_stack_.disconnect(this); }

QString Document::name() const { return path_.isEmpty() ? tr("Untitled") : QFileInfo(path_).fileName(); }

void Document::clear() { take({}, {}, {}); }

void Document::take(grf::Scene scene, const QString& path, grf::Diagnostics diagnostics, bool is_modified) {
  undo_stack_.clear();
  path_ = path;
  diagnostics_ = std::move(diagnostics);
  selection_ = {};
  import_folders_.clear();
  show(std::move(scene), nullptr);
  if (is_modified) undo_stack_.resetClean();
  emit path_changed();
  emit taken();
}

void Document::take_import(const ImportedModel& model) {
  take(moved(model.scene, model.path, {}), {}, model.diagnostics, true);
  import_folders_.push_back(QFileInfo(model.path).path());
}

void Document::merge(const QString& text, const grf::Scene& scene, const QString& path) {
  grf::Scene result = scene_;
  grf::BlockList added = moved(scene, path, path_).contents;
  auto& blocks = result.contents.blocks;
  blocks.insert(blocks.end(), std::make_move_iterator(added.blocks.begin()),
                std::make_move_iterator(added.blocks.end()));
  replace(text, std::move(result));
}

void Document::merge_import(const QString& text, const ImportedModel& model) {
  import_folders_.push_back(QFileInfo(model.path).path());
  merge(text, model.scene, model.path);
}

bool Document::save(const QString& path, grf::Diagnostics& diagnostics) {
  const std::string from = naming_path(path_).toStdString();
  const std::size_t errors = diagnostics.error_count();
  const auto copied = copy_images(scene_, from, import_folders_, path.toStdString(), diagnostics);
  if (diagnostics.error_count() > errors) return false;
  grf::Scene scene = scene_;
  grf::relocate(scene, from, path.toStdString(), copied);
  if (!grf::write(scene, path.toStdString(), diagnostics)) return false;
  if (path != path_ || !copied.empty()) {
    path_ = path;
    show(std::move(scene), nullptr);
    emit path_changed();
  }
  undo_stack_.setClean();
  emit saved();
  return true;
}

grf::Scene Document::scene_for(const QString& path) const { return moved(scene_, path_, path); }

void Document::select(FaceSelection selection) {
  if (selection == selection_) return;
  selection_ = std::move(selection);
  emit selection_changed();
}

void Document::replace(const QString& text, grf::Scene scene, const QString& key) {
  undo_stack_.push(new SceneCommand(*this, text, std::move(scene), key));
}

void Document::edit_surfaces(const QString& text, const SurfaceEdit& edit, const QString& key) {
  edit_surfaces(
      text, [&edit](const grf::Surface&) { return edit; }, key);
}

void Document::edit_surfaces(const QString& text, const SurfaceEdits& edits, const QString& key) {
  if (selection_.empty()) return;
  undo_stack_.push(new SurfaceCommand(*this, text, edited(objects_, selection_, edits), key));
}

void Document::show(grf::Scene scene, const FaceSelection* selection) {
  scene_ = std::move(scene);
  SceneObjects objects = objects_of(scene_, path_.toStdString());
  FaceSelection carried = selection != nullptr ? *selection : carried_over(objects);
  objects_ = std::move(objects);
  const bool selects = !(carried == selection_);
  selection_ = std::move(carried);
  emit scene_changed();
  if (selects) emit selection_changed();
}

void Document::put_surfaces(const std::vector<MeshSurfaces>& surfaces, const FaceSelection& selection) {
  for (const MeshSurfaces& of_mesh : surfaces) {
    put(of_mesh, grf::find_mesh(scene_, of_mesh.path)->edit());
  }
  objects_ = objects_of(scene_, path_.toStdString());
  emit scene_changed();
  select(selection);
}

FaceSelection Document::carried_over(const SceneObjects& objects) const {
  const std::vector<std::optional<std::uint32_t>> before = matched_meshes(objects_, objects);
  FaceSelection carried(objects);
  for (std::uint32_t now = 0; now < objects.meshes.size(); ++now) {
    if (!before[now] || *before[now] >= selection_.mesh_count()) continue;
    const std::vector<bool>& faces = selection_.of_mesh(*before[now]);
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
      if (faces[face]) carried.set({now, face});
    }
  }
  return carried;
}

}  // namespace editor
