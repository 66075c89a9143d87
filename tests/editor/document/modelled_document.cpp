#include "tests/editor/document/modelled_document.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "converters/grf2008.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/write.h"
#include "tests/editor/document/plain_edits.h"
#include "tests/support/grammar_of_2008.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

constexpr float Sky = 0.7F;

bool is_same(const FlatSurface& a, const FlatSurface& b) {
  return a.colour == b.colour && a.brdf == b.brdf && a.terms == b.terms && a.texture == b.texture &&
         a.emission == b.emission;
}

bool is_same(const LightObject& a, const LightObject& b) {
  return a.path == b.path && a.light == b.light && a.to_world == b.to_world;
}

bool is_same(const ObserverObject& a, const ObserverObject& b) {
  return a.path == b.path && a.number == b.number && a.position == b.position;
}

bool is_same(const MeshInstance& a, const MeshInstance& b) {
  return a.mesh == b.mesh && a.path == b.path && a.to_world == b.to_world;
}

bool is_same(const MeshObject& a, const MeshObject& b);

template <class Item>
bool are_same(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Item& one, const Item& other) { return is_same(one, other); });
}

bool is_same(const MeshObject& a, const MeshObject& b) {
  return a.path == b.path && a.name == b.name && a.mesh == b.mesh && a.is_definition == b.is_definition &&
         a.is_light == b.is_light && are_same(a.flat_surfaces, b.flat_surfaces);
}

bool is_same(const SceneObjects& a, const SceneObjects& b) {
  return are_same(a.meshes, b.meshes) && are_same(*a.instances, *b.instances) &&
         are_same(a.lights, b.lights) && are_same(a.observers, b.observers) &&
         a.mesh_bounds == b.mesh_bounds && a.bounds == b.bounds && a.faces == b.faces &&
         a.triangles == b.triangles;
}

/// Finds differences that a non-structural change does not announce, so that a view would be out of date.
std::string unsaid(const Change& change, const SceneObjects& before, const SceneObjects& now) {
  if (change.is_structural) return {};
  if (!change.transforms && !are_same(*before.instances, *now.instances)) return "instances";
  if (before.meshes.size() != now.meshes.size()) return "the number of meshes";
  for (std::uint32_t i = 0; i < now.meshes.size(); ++i) {
    const MeshObject& one = before.meshes[i];
    const MeshObject& other = now.meshes[i];
    const bool is_told = std::find(change.meshes.begin(), change.meshes.end(), i) != change.meshes.end();
    if (!is_told && !(one.mesh == other.mesh)) return "a mesh";
    if (!is_told && !change.definitions && !are_same(one.flat_surfaces, other.flat_surfaces)) return "a look";
    if (!change.names && one.name != other.name) return "a name";
  }
  const bool are_lights_told = change.lights || change.transforms;
  if (!are_lights_told && !are_same(before.lights, now.lights)) return "lights";
  if (!are_lights_told && !are_same(before.observers, now.observers)) return "observers";
  return {};
}

std::string options_file(const std::string& path) {
  return std::filesystem::path(path).replace_extension("op").string();
}

}  // namespace

ModelledDocument::ModelledDocument() {
  QObject::connect(&document_, &Document::changed, [this](const Change& change) {
    const std::string what = unsaid(change, seen_, document_.objects());
    if (!what.empty()) problem_ = "a change does not say that it changed " + what;
    seen_ = document_.objects();
  });
}

void ModelledDocument::write(const std::string& path, const std::string& text) {
  grf::Diagnostics diagnostics;
  grf::replace_file(path, text, diagnostics);
  const auto scene = grf::read(path, diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.to_text());
  disk_[path] = plain_reading(*scene, path).project.main;
}

std::vector<std::string> ModelledDocument::paths() const {
  std::vector<std::string> paths;
  for (const auto& [path, contents] : disk_) {
    if (!have_unclear_names(on_disk(path))) paths.push_back(path);
  }
  return paths;
}

PlainProject ModelledDocument::on_disk(const std::string& path) const {
  PlainProject project;
  project.main = disk_.at(path);
  for (const PlainObject& object : project.main.objects) {
    if (object.kind == PlainObject::Kind::Include) project.files[object.name] = disk_.at(object.name);
  }
  return project;
}

void ModelledDocument::open(const std::string& path) {
  grf::Diagnostics diagnostics;
  auto scene = grf::read(path, diagnostics);
  if (!scene) return fail("cannot read: " + diagnostics.to_text());
  document_.take(std::move(*scene), QString::fromStdString(path), diagnostics);
  ++scenes_;
  path_ = path;
  first_ = on_disk(path);
  const auto options = options_on_disk_.find(options_file(path));
  have_options_file_ = options != options_on_disk_.end();
  std::tie(first_.depth, first_.background) =
      have_options_file_ ? options->second : std::pair(options::RenderOptions().depth, 0.0F);
  has_sky_ = !have_options_file_ && document_.objects().faces > 0 && !emits(first_);
  if (has_sky_) first_.background = Sky;
  are_options_edited_ = false;
  state_ = first_;
  steps_.clear();
  index_ = 0;
  clean_ = 0;
}

void ModelledDocument::save(const std::string& path) {
  grf::Diagnostics diagnostics;
  if (!document_.save(QString::fromStdString(path), diagnostics)) {
    return fail("cannot save: " + diagnostics.to_text());
  }
  disk_[path] = state_.main;
  for (const auto& [name, contents] : state_.files) disk_[name] = contents;
  if (are_options_edited_ || (path != path_ && have_options_file_)) {
    options_on_disk_[options_file(path)] = {state_.depth, state_.background};
    are_options_edited_ = false;
    have_options_file_ = true;
  }
  finish_gesture();
  path_ = path;
  clean_ = index_;
  check_disk();
}

/// Compares the written files with the model.
void ModelledDocument::check_disk() {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(path_, diagnostics);
  if (!scene) return fail("cannot read what was saved: " + diagnostics.to_text());
  fail(differences(on_disk(path_), plain_reading(*scene, path_).project));
  check_grammar_of_2008(*scene);
}

/// Checks that the scene that was written has a form of 2008, and is in it as long as it says nothing newer.
void ModelledDocument::check_grammar_of_2008(const grf::Scene& scene) {
  grf::Diagnostics diagnostics;
  const auto old = convert::to_grf2008(scene, path_, diagnostics);
  if (!old) return fail("no form of 2008: " + diagnostics.to_text());
  fail(test::difference_from_grammar_of_2008(grf::to_text(*old)));
  if (*old == scene) fail(test::difference_from_grammar_of_2008(test::bytes_of(path_)));
}

void ModelledDocument::replace(const QString& text, grf::Scene scene, PlainProject after,
                               const QString& key) {
  const bool is_other = !(scene == document_.scene());
  selection_before_ = selection();
  document_.replace(text, std::move(scene), key);
  erase_lost_files(after);
  if (is_other) push(text, key, true, std::move(after));
}

void ModelledDocument::edit_surfaces(const QString& text, const SurfaceEdit& edit, PlainProject after,
                                     const QString& key) {
  selection_before_ = selection();
  document_.edit_surfaces(text, edit, key);
  if (after != state_) push(text, key, true, std::move(after));
}

void ModelledDocument::merge(const QString& text, const grf::Scene& scene, const std::string& path,
                             PlainProject after) {
  selection_before_ = selection();
  document_.merge(text, scene, QString::fromStdString(path));
  push(text, {}, true, std::move(after));
}

void ModelledDocument::set_depth(int depth, const QString& key) {
  options::RenderOptions options = document_.options().valid_options();
  options.depth = depth;
  document_.options().set_options("Depth", options, key);
  if (depth == state_.depth) return;
  PlainProject after = state_;
  after.depth = depth;
  push("Depth", key, false, std::move(after));
  are_options_edited_ = true;
}

void ModelledDocument::push(const QString& text, const QString& key, bool is_of_scene, PlainProject after) {
  if (is_of_scene && has_sky_ && after.background == Sky && emits(after)) after.background = 0;
  steps_.resize(index_);
  if (clean_ && *clean_ > index_) clean_.reset();
  const int gesture = is_of_scene ? scene_gesture_ : options_gesture_;
  const bool merges = index_ > 0 && clean_ != index_ && !key.isEmpty() && steps_.back().key == key &&
                      steps_.back().is_of_scene == is_of_scene && steps_.back().gesture == gesture &&
                      (!is_of_scene || steps_.back().selection == selection_before_);
  if (!merges) {
    steps_.push_back({text, key, is_of_scene, gesture, selection_before_, std::move(after)});
    ++index_;
  } else {
    steps_.back().after = std::move(after);
    const bool is_nothing = !is_of_scene && steps_.back().after == state_at(index_ - 1);
    if (is_nothing) steps_.resize(--index_);
  }
  state_ = state_at(index_);
}

void ModelledDocument::finish_gesture() {
  document_.finish_gesture();
  ++scene_gesture_;
  ++options_gesture_;
}

void ModelledDocument::undo() {
  if (index_ == 0) return;
  document_.undo_stack().undo();
  const Step& step = steps_[--index_];
  state_ = state_at(index_);
  ++options_gesture_;
  are_options_edited_ = are_options_edited_ || !step.is_of_scene;
  if (!step.is_of_scene) return;
  ++scene_gesture_;
  if (!(selection() == step.selection)) fail("undo does not select what was selected");
}

void ModelledDocument::redo() {
  if (index_ == steps_.size()) return;
  document_.undo_stack().redo();
  are_options_edited_ = are_options_edited_ || !steps_[index_].is_of_scene;
  state_ = state_at(++index_);
}

std::string ModelledDocument::check() {
  PlainReading reading = plain_reading(scene(), path_);
  PlainProject& found = reading.project;
  const options::RenderOptions& options = document_.options().valid_options();
  found.depth = options.depth;
  found.background = options.background.x;
  fail(differences(state_, found));
  if (!reading.has_one_text_per_file) fail("a file has two texts");
  if (!is_same(document_.objects(), objects_of(scene(), path_))) fail("objects are not up to date");
  check_stack();
  check_selection();
  places_ = std::move(reading.places);
  return std::exchange(problem_, {});
}

void ModelledDocument::check_stack() {
  QUndoStack& stack = document_.undo_stack();
  if (stack.count() != int(steps_.size()) || stack.index() != int(index_)) {
    return fail(fmt::format("step {} of {} where {} of {} was expected", stack.index(), stack.count(), index_,
                            steps_.size()));
  }
  if (document_.is_modified() != (clean_ != index_)) fail("the modified flag is wrong");
  if (stack.undoText() != (index_ > 0 ? steps_[index_ - 1].text : QString())) fail("another text of undo");
  if (stack.redoText() != (index_ < steps_.size() ? steps_[index_].text : QString())) {
    fail("another text of redo");
  }
}

void ModelledDocument::check_selection() {
  const SceneObjects& objects = document_.objects();
  std::size_t count = 0;
  bool is_valid = selection().mesh_count() == objects.meshes.size();
  for (std::uint32_t i = 0; is_valid && i < objects.meshes.size(); ++i) {
    is_valid = selection().of_mesh(i).size() == objects.meshes[i].mesh->face_count() &&
               selection().count(i) == selection().of_mesh(i).count();
    count += selection().count(i);
  }
  if (!is_valid || count != selection().count()) fail("the selection is not one of these faces");
}

}  // namespace editor
