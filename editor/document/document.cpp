#include "editor/document/document.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "editor/document/image_files.h"
#include "editor/document/light_edits.h"
#include "editor/document/model_import.h"
#include "editor/document/save.h"
#include "editor/document/scene_places.h"
#include "grf/relocate.h"
#include "grf/scene_path.h"

namespace editor {
namespace {

/// Radiance of the default sky over a scene without lights.
const grf::Vec3f PlainSky = grf::Vec3f(0.7F);

/// The file to which a scene's file names are relative; for an unsaved scene, in the current folder.
QString naming_path(const QString& path) { return path.isEmpty() ? QStringLiteral("Untitled.grf") : path; }

using FaceWord = FaceSelection::Faces::block_type;

/// Compresses a selection for a step: a bit per face would need far more memory than the edit of a few faces.
QByteArray packed(const FaceSelection& selection) {
  std::vector<FaceWord> words;
  for (std::uint32_t mesh = 0; mesh < selection.mesh_count(); ++mesh) {
    boost::to_block_range(selection.of_mesh(mesh), std::back_inserter(words));
  }
  // The lowest level is fast, and sufficient for runs of selected or unselected faces.
  QByteArray bytes = qCompress(reinterpret_cast<const uchar*>(words.data()),
                               static_cast<qsizetype>(words.size()) * qsizetype(sizeof(FaceWord)), 1);
  bytes.squeeze();
  return bytes;
}

/// Restores a packed selection of the faces of these objects.
FaceSelection unpacked(const QByteArray& packed, const SceneObjects& objects) {
  const QByteArray bytes = qUncompress(packed);
  std::vector<FaceWord> words(static_cast<std::size_t>(bytes.size()) / sizeof(FaceWord));
  // Unlike memcpy, it accepts the null pointers of an empty scene.
  std::copy_n(bytes.constData(), words.size() * sizeof(FaceWord), reinterpret_cast<char*>(words.data()));
  FaceSelection selection(objects);
  auto first = words.begin();
  for (std::uint32_t mesh = 0; mesh < selection.mesh_count(); ++mesh) {
    FaceSelection::Faces faces = selection.of_mesh(mesh);
    const auto end = first + static_cast<std::ptrdiff_t>(faces.num_blocks());
    boost::from_block_range(first, end, faces);
    selection.set_faces(mesh, faces);
    first = end;
  }
  return selection;
}

}  // namespace

grf::Scene moved(grf::Scene scene, const QString& from, const QString& to) {
  if (from != to) grf::relocate(scene, naming_path(from).toStdString(), naming_path(to).toStdString());
  return scene;
}

/// An undo command. Its file names are relative to the document's file, and are updated when that is saved
/// elsewhere.
class Document::Step : public QUndoCommand {
 public:
  /// Selects other objects after the step, if there are some.
  Step(Document& document, const QString& text, ScenePatch patch, QString key,
       std::optional<std::vector<grf::ScenePath>> objects, bool amends)
      : QUndoCommand(text),
        document_(document),
        patch_(std::move(patch)),
        selection_(document.packed_selection()),
        objects_before_(document.selected_objects_),
        objects_after_(std::move(objects)),
        key_(std::move(key)),
        gesture_(document.gesture_),
        relocations_(document.relocations_.size()),
        amends_(amends) {}

  int id() const override { return 1; }
  void undo() override {
    document_.finish_gesture();
    follow_file();
    const Change change = document_.change_of(patch_);
    patch_.revert(document_.scene_);
    document_.show_change(change, &selection_, *objects_before_);
    if (takes_plain_sky_) document_.set_background(PlainSky);
  }
  void redo() override {
    follow_file();
    const Change change = document_.change_of(patch_);
    patch_.apply(document_.scene_);
    document_.show_change(change, nullptr, objects_after_);
    takes_plain_sky_ = document_.take_plain_sky();
  }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& later = static_cast<const Step&>(*other);
    if (later.amends_) return amend(later);
    const bool is_of_same_gesture = !key_.isEmpty() && key_ == later.key_ && gesture_ == later.gesture_ &&
                                    relocations_ == later.relocations_ && selection_ == later.selection_;
    if (!is_of_same_gesture) return false;
    patch_.append(later.patch_);
    if (later.objects_after_) objects_after_ = later.objects_after_;
    takes_plain_sky_ = takes_plain_sky_ || later.takes_plain_sky_;
    return true;
  }

 private:
  /// Becomes the step to the present scene, so that many amendments take no more memory than one.
  bool amend(const Step& later) {
    if (relocations_ != later.relocations_) return false;
    grf::Scene before = document_.scene_;
    later.patch_.revert(before);
    patch_.revert(before);
    patch_ = ScenePatch::between(before, document_.scene_);
    objects_after_ = later.objects_after_;
    return true;
  }
  void follow_file() {
    for (; relocations_ < document_.relocations_.size(); ++relocations_) {
      const Relocation& relocation = document_.relocations_[relocations_];
      patch_.relocate(relocation.from, relocation.to, relocation.moved);
    }
  }

  Document& document_;
  ScenePatch patch_;
  QByteArray selection_;  // before the step, packed; steps with the same selection share it
  grf::Shared<std::vector<grf::ScenePath>> objects_before_;
  std::optional<std::vector<grf::ScenePath>> objects_after_;
  QString key_;
  int gesture_;
  std::size_t relocations_;  // number of relocations that were applied to it
  bool amends_;
  bool takes_plain_sky_ = false;
};

Document::Document(QObject* parent) : QObject(parent) {
  connect(&undo_stack_, &EditStack::revision_changed, this, [this] { set_saved(saved_); });
}

// Commands refer to the document.
Document::~Document() { undo_stack_.disconnect(this); }

QString Document::name() const { return path_.isEmpty() ? tr("Untitled") : QFileInfo(path_).fileName(); }

void Document::clear() { take({}, {}, {}); }

void Document::take(grf::Scene scene, const QString& path, grf::Diagnostics diagnostics, EditorState state,
                    bool is_modified) {
  undo_stack_.clear();
  origin_ = revision();
  state_ = {};
  saved_state_ = {};
  removed_faces_.clear();
  set_saved(origin_);
  path_ = path;
  diagnostics_ = std::move(diagnostics);
  set_selection({});
  selected_objects_ = {};
  relocations_.clear();
  imports_.clear();
  has_plain_sky_ = false;
  show(std::move(scene));
  if (state.hidden.fits(*objects_)) state_ = std::move(state);
  saved_state_ = state_;
  emit editor_state_changed();
  options_.open_beside(path_);
  light_by_plain_sky();
  if (is_modified) set_saved(std::nullopt);
  emit path_changed();
  emit scene_replaced();
  if (has_plain_sky_) emit scene_has_no_lights();
}

void Document::take_import(const ImportedModel& model) {
  take(moved(model.scene, model.path, {}), {}, model.diagnostics, {}, true);
  add_import(model.folder);
  if (model.cameras.empty()) return;
  options::RenderOptions view = options_.valid_options();
  view.cameras = model.cameras;
  view.camera = model.cameras.front().name;
  options_.follow(view);
  options_.set_options({}, view);  // saved with the scene, like options that the author chose
}

void Document::merge(const QString& text, const grf::Scene& scene, const QString& path) {
  ImportedModel model;
  model.scene = scene;
  model.path = path;
  merge_imports(text, {model});
}

void Document::merge_imports(const QString& text, const std::vector<ImportedModel>& models) {
  grf::Scene result = scene_;
  auto& blocks = outermost_blocks(result).blocks;
  for (const ImportedModel& model : models) {
    add_import(model.folder);
    grf::BlockList added = moved(model.scene, model.path, path_).contents;
    blocks.insert(blocks.end(), std::make_move_iterator(added.blocks.begin()),
                  std::make_move_iterator(added.blocks.end()));
  }
  replace(text, std::move(result));
}

void Document::add_import(std::shared_ptr<const ImportFolder> folder) {
  if (folder) imports_.push_back(std::move(folder));
}

/// Emits a signal when the scene becomes modified, or equal to its file.
void Document::set_saved(std::optional<std::uint64_t> revision) {
  saved_ = revision;
  if (!is_modified()) undo_stack_.setClean();  // for windows that only show the options
  if (was_modified_ == is_modified()) return;
  was_modified_ = is_modified();
  emit modified_changed(was_modified_);
}

bool Document::save(const QString& path, grf::Diagnostics& diagnostics) {
  const SaveResult result = write(save_request(path));
  take_saved(result);
  diagnostics = result.diagnostics;
  return result.is_done;
}

SaveRequest Document::save_request(const QString& path) {
  finish_gesture();  // a later edit must not be merged into a saved step
  const bool has_options = options_.is_edited() || (path != path_ && options_.is_from_file());
  return {scene_,
          naming_path(path_).toStdString(),
          path,
          imports_,
          has_options ? std::optional(options_.snapshot()) : std::nullopt,
          state_,
          objects_,
          origin_,
          revision()};
}

void Document::take_saved(const SaveResult& result) {
  const SaveRequest& request = result.request;
  if (!result.is_done || request.origin != origin_) return;
  if (request.options) options_.take_written(*request.options, request.path, result.options);
  if (request.path != path_ || !result.copied.empty()) {
    grf::Scene scene = scene_;
    grf::relocate(scene, request.from, request.path.toStdString(), result.copied);
    path_ = request.path;
    relocations_.push_back({request.from, request.path.toStdString(), result.copied});
    std::erase_if(imports_,
                  [&](const auto& folder) { return is_copied(*folder, request.from, result.copied); });
    show(std::move(scene));
    emit path_changed();
  }
  saved_state_ = request.state;
  set_saved(request.revision);
  emit saved();
}

void Document::select(FaceSelection selection) {
  selection = state_.selectable(std::move(selection));
  if (selection == selection_) return;
  set_selection(std::move(selection));
  emit selection_changed();
}

void Document::set_editor_state(EditorState state) {
  if (state == state_) return;
  state_ = std::move(state);
  set_saved(saved_);
  emit editor_state_changed();
  select(selection_);
  std::vector<grf::ScenePath> objects = *selected_objects_;
  std::erase_if(objects, [this](const grf::ScenePath& path) { return is_hidden(path); });
  select_objects(std::move(objects));
}

/// Whether an object has faces, and all of them are hidden.
bool Document::is_hidden(grf::ScenePathView object) const {
  bool has_hidden_face = false;
  for (const MeshInstance& instance : *objects_->instances) {
    if (!is_inside(instance.path, object)) continue;
    if (state_.hidden.count(instance.mesh) < state_.hidden.of_mesh(instance.mesh).size()) return false;
    has_hidden_face = has_hidden_face || state_.hidden.count(instance.mesh) > 0;
  }
  return has_hidden_face;
}

void Document::select_objects(std::vector<grf::ScenePath> paths) {
  if (set_selected_objects(std::move(paths))) emit selected_objects_changed();
}

/// Returns whether others are selected now.
bool Document::set_selected_objects(std::vector<grf::ScenePath> paths) {
  std::erase_if(paths, [this](const grf::ScenePath& path) { return block_at(scene_, path) == nullptr; });
  if (paths == *selected_objects_) return false;
  selected_objects_ = std::move(paths);
  return true;
}

bool Document::transform_selected(const QString& text, const TransformAction& action) {
  grf::Diagnostics diagnostics;
  auto edited = transform_objects(scene_, *selected_objects_, action, diagnostics);
  if (!edited) {
    emit status_message(QString::fromStdString(diagnostics.entries().front().message));
    return false;
  }
  replace_objects(text, std::move(*edited));
  return true;
}

void Document::replace_objects(const QString& text, TransformedObjects edited, const QString& key) {
  push(text, ScenePatch::between(scene_, edited.scene), key, std::move(edited.paths));
}

void Document::amend_objects(const QString& text, TransformedObjects edited) {
  push(text, ScenePatch::between(scene_, edited.scene), {}, std::move(edited.paths), true);
}

void Document::set_selection(FaceSelection selection) {
  selection_ = std::move(selection);
  packed_selection_.clear();
}

const QByteArray& Document::packed_selection() {
  if (packed_selection_.isEmpty()) packed_selection_ = packed(selection_);
  return packed_selection_;
}

void Document::replace(const QString& text, grf::Scene scene, const QString& key) {
  grf::Diagnostics diagnostics;
  const std::size_t places = edit_all_places(scene_, scene, diagnostics);
  if (diagnostics.error_count() > 0)
    return emit status_message(QString::fromStdString(diagnostics.entries().front().message));
  push(text, ScenePatch::between(scene_, scene), key);
  if (places > 0) tell_of_places(places);
}

void Document::edit_surfaces(const QString& text, const SurfaceEdits& edits, const QString& key) {
  if (selection_.empty()) return;
  const FaceSelection faces = at_all_places(scene_, *objects_, selection_);
  const std::size_t places = faces.meshes().size() - selection_.meshes().size();
  push(text, ScenePatch::of_meshes(scene_, edited(*objects_, faces, edits)), key);
  if (places > 0) tell_of_places(places);
}

void Document::tell_of_places(std::size_t places) {
  emit status_message(
      tr("The edit also applies at %n other place(s) that include the file", nullptr, int(places)));
}

void Document::push(const QString& text, ScenePatch patch, const QString& key,
                    const std::optional<std::vector<grf::ScenePath>>& objects, bool amends) {
  if (!patch.empty()) undo_stack_.push(new Step(*this, text, std::move(patch), key, objects, amends));
}

/// Sets the sky without an undo step, since it is not an edit that needs saving.
void Document::set_background(const grf::Vec3f& radiance) {
  options::RenderOptions now = options_.valid_options();
  now.background = radiance;
  options_.follow(now);
}

/// Adds a default sky, since a model without lights would be black; a scene with render options is left as it
/// is.
void Document::light_by_plain_sky() {
  const options::RenderOptions& now = options_.valid_options();
  const bool is_dark = now.environment.empty() && now.background == grf::Vec3f(0) && objects_->faces > 0 &&
                       emitters_of(*objects_).empty();
  has_plain_sky_ = is_dark && (path_.isEmpty() || !QFileInfo::exists(options_.path()));
  if (has_plain_sky_) set_background(PlainSky);
}

bool Document::has_plain_sky() const {
  return has_plain_sky_ && options_.valid_options().background == PlainSky;
}

/// Removes the default sky if there is another emitter now; returns false if there is nothing to remove.
bool Document::take_plain_sky() {
  const bool is_replaced = has_plain_sky() && !emitters_of(*objects_).empty();
  if (is_replaced) set_background(grf::Vec3f(0));
  return is_replaced;
}

void Document::finish_gesture() {
  ++gesture_;
  options_.finish_step();
}

Change Document::change_of(const ScenePatch& patch) const {
  Change change = patch.change();
  if (change.is_structural) return change;
  const std::set<grf::ScenePath> places = patch.meshes();
  for (std::uint32_t i = 0; i < objects_->meshes.size(); ++i) {
    if (places.contains(objects_->meshes[i].path)) change.meshes.push_back(i);
  }
  return change;
}

void Document::show(grf::Scene scene) {
  scene_ = std::move(scene);
  Change change;
  change.is_structural = true;
  show_change(change, nullptr, std::nullopt);
}

/// Restores the packed selection of faces and the objects, or updates the present selections.
void Document::show_change(const Change& change, const QByteArray* selection,
                           const std::optional<std::vector<grf::ScenePath>>& selected_objects) {
  const std::shared_ptr<const SceneObjects> before = objects_;
  if (change.is_structural) {
    objects_ = std::make_shared<const SceneObjects>(objects_of(scene_, path_.toStdString()));
  } else {
    auto objects = std::make_shared<SceneObjects>(*objects_);
    update(*objects, scene_, path_.toStdString(), change);
    objects_ = std::move(objects);
  }
  const bool changes_state = change.is_structural && carry_state_over(*before);
  bool selects = false;
  if (selection != nullptr || change.is_structural) {
    FaceSelection now = selection != nullptr
                            ? unpacked(*selection, *objects_)
                            : FaceCorrespondence(*before, *objects_).carried_over(selection_);
    now = state_.selectable(std::move(now));
    selects = !(now == selection_);
    if (selects) set_selection(std::move(now));
  }
  // Listeners find the selections and the state as they are after the change.
  std::vector<grf::ScenePath> objects = selected_objects       ? *selected_objects
                                        : change.is_structural ? objects_carried_over(*before)
                                                               : *selected_objects_;
  const bool selects_objects = set_selected_objects(std::move(objects));
  emit changed(change);
  if (selects) emit selection_changed();
  if (selects_objects) emit selected_objects_changed();
  if (changes_state) emit editor_state_changed();
}

/// Returns whether the state differs now.
bool Document::carry_state_over(const SceneObjects& before) {
  const FaceCorrespondence correspondence(before, *objects_);
  EditorState carried = state_.carried_over(correspondence);
  if (state_.hidden.fits(before)) removed_faces_.remember(state_, before, correspondence);
  removed_faces_.restore(carried, *objects_, correspondence);
  if (carried == state_) return false;
  state_ = std::move(carried);
  return true;
}

/// The selected objects that have the same meshes and lights at the same paths as before.
std::vector<grf::ScenePath> Document::objects_carried_over(const SceneObjects& before) const {
  const auto contents = [](const SceneObjects& objects, const grf::ScenePath& path) {
    std::vector<const grf::Geometry*> inside;
    for (const MeshInstance& instance : *objects.instances) {
      if (is_inside(instance.path, path)) inside.push_back(&*objects.meshes[instance.mesh].mesh->geometry);
    }
    for (const LightObject& light : objects.lights) {
      if (is_inside(light.path, path)) inside.push_back(nullptr);
    }
    return inside;
  };
  std::vector<grf::ScenePath> carried = *selected_objects_;
  std::erase_if(carried,
                [&](const auto& path) { return contents(before, path) != contents(*objects_, path); });
  return carried;
}

}  // namespace editor
