// Threads that read snapshots of a scene while it is edited: one writes them, as saving and autosave do, and
// one flattens them, as the view does. Without Qt, so that ThreadSanitizer sees everything.
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "editor/document/definitions.h"
#include "editor/document/object_edits.h"
#include "editor/document/scene_places.h"
#include "editor/document/surface_edits.h"
#include "grf/read.h"
#include "grf/topology.h"
#include "grf/write.h"
#include "tests/editor/moved_object.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

std::string mesh(const std::string& name) {
  return "begin mesh \"" + name +
         "\" rgb red begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) (0,0,1) end begin faces (0,1,2,3) (0,1,4) "
         "rgb (0,1,0) (1,2,4) end end\n";
}

/// A snapshot of the edited scene, which shares unedited data with it.
struct State {
  grf::Scene scene;
  std::shared_ptr<const SceneObjects> objects;
};

/// A thread that works on the latest snapshot it was given, and on the last one before it ends.
class Reader {
 public:
  explicit Reader(std::function<void(const State&)> work)
      : work_(std::move(work)), thread_([this] { run(); }) {}
  ~Reader() {
    give(std::nullopt);
    thread_.join();
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void give(std::optional<State> state) {
    const std::lock_guard lock(mutex_);
    ends_ = !state;
    if (state) latest_ = std::move(state);
    changed_.notify_one();
  }

 private:
  void run() {
    while (const auto state = next()) work_(*state);
  }
  std::optional<State> next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ends_ || latest_; });
    return std::exchange(latest_, std::nullopt);
  }

  std::function<void(const State&)> work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<State> latest_;
  bool ends_ = false;
  std::thread thread_;
};

/// Applies edits, undo and redo as the document does.
class EditedScene {
 public:
  explicit EditedScene(grf::Scene scene) : scene_(std::move(scene)) { rebuild(); }

  State state() const { return {scene_, objects_}; }
  const grf::Scene& scene() const { return scene_; }

  void paint(std::uint32_t number, bool is_undone) {
    FaceSelection selection(*objects_);
    for (std::uint32_t i = 0; i < objects_->meshes.size(); ++i) selection.set({i, number % 3});
    SurfaceEdit edit;
    edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(static_cast<float>(number % 7) / 8));
    const FaceSelection faces = at_all_places(scene_, *objects_, selection);
    const ScenePatch patch = ScenePatch::of_meshes(scene_, edited(*objects_, faces, edit));
    patch.apply(scene_);
    follow(patch);
    if (!is_undone) return;
    patch.revert(scene_);
    follow(patch);
  }
  void replace(std::optional<grf::Scene> scene) {
    grf::Diagnostics diagnostics;
    ASSERT_TRUE(scene.has_value());
    edit_all_places(scene_, *scene, diagnostics);
    const ScenePatch patch = ScenePatch::between(scene_, *scene);
    scene.reset();
    patch.apply(scene_);
    rebuild();
  }

 private:
  void follow(const ScenePatch& patch) {
    Change change = patch.change();
    for (const grf::ScenePath& path : patch.meshes()) change.meshes.push_back(*objects_->mesh_at(path));
    auto objects = std::make_shared<SceneObjects>(*objects_);
    update(*objects, scene_, "", change);
    objects_ = std::move(objects);
  }
  void rebuild() { objects_ = std::make_shared<const SceneObjects>(objects_of(scene_, "")); }

  grf::Scene scene_;
  std::shared_ptr<const SceneObjects> objects_;
};

TEST(ThreadsOfAnEditor, ReadStatesThatStayAsTheyWere) {
  const test::TemporaryFolder folder;
  folder.add("part.grf", mesh("panel"));
  const std::string path =
      folder.add("scene.grf", "def red = rgb (1,0,0) m = " + mesh("") + "begin use m\n" + mesh("box") +
                                  "include \"part.grf\" transform scale (2,2,2) "
                                  "begin include \"part.grf\" end end");
  grf::Diagnostics problems;
  auto read = grf::read(path, problems);
  ASSERT_TRUE(read) << problems.to_text();
  EditedScene edited(std::move(*read));
  std::size_t seen = 0;
  {
    Reader saving([&path](const State& state) {
      const std::string before = grf::to_text(state.scene);
      grf::Diagnostics diagnostics;
      EXPECT_TRUE(grf::write(state.scene, path, diagnostics)) << diagnostics.to_text();
      EXPECT_EQ(grf::to_text(state.scene), before);
    });
    Reader drawing([&seen](const State& state) {
      for (const MeshInstance& instance : *state.objects->instances) {
        const grf::Mesh& of_instance = *state.objects->meshes[instance.mesh].mesh;
        seen += of_instance.geometry.triangulation().size() + of_instance.geometry.topology().boundary_edges;
        for (const grf::Surface& surface : of_instance.surfaces) seen += names_a_definition(surface) ? 1 : 0;
      }
    });
    for (std::uint32_t i = 0; i < 300; ++i) {
      grf::Diagnostics diagnostics;
      const grf::ScenePath box = {0, 3};
      edited.paint(i, i % 4 == 3);
      if (i % 10 == 0) edited.replace(moved_object(edited.scene(), box, grf::Vec3d(1, 0, 0), diagnostics));
      if (i % 10 == 5)
        edited.replace(rename_object(edited.scene(), {{0, 0}}, "red" + std::to_string(i), diagnostics));
      saving.give(edited.state());
      drawing.give(edited.state());
    }
  }
  const auto saved = grf::read(path, problems);
  ASSERT_TRUE(saved) << problems.to_text();
  EXPECT_EQ(*saved, edited.scene()) << "the last state was written";
  EXPECT_GT(seen, 0U);
}

}  // namespace
}  // namespace editor
