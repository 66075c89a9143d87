// Tests which geometry is built for the view, where and how often.
#include "editor/view/geometry_store.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>

#include <gtest/gtest.h>

#include "tests/grf/height_field.h"

namespace editor {
namespace {

/// Meshes with so many faces per side, each with its own arrays.
SceneObjects meshes(std::size_t count, std::uint32_t side) {
  SceneObjects objects;
  for (std::size_t i = 0; i < count; ++i) {
    objects.meshes.emplace_back().mesh = grf::Shared<grf::Mesh>(grf::height_field(side));
    objects.triangles += objects.meshes.back().mesh->geometry->triangle_count();
  }
  return objects;
}

/// Blocks the threads of the pool while it lives, so that no result arrives too early.
class HeldThreads {
 public:
  HeldThreads() {
    QThreadPool& pool = *QThreadPool::globalInstance();
    for (int i = 0; i < pool.maxThreadCount(); ++i) pool.start([this] { held_.acquire(); });
  }
  ~HeldThreads() {
    held_.release(QThreadPool::globalInstance()->maxThreadCount());
    QThreadPool::globalInstance()->waitForDone();
  }

 private:
  QSemaphore held_;
};

void wait_for_threads() {
  QThreadPool::globalInstance()->waitForDone();
  QTest::qWait(10);
}

TEST(GeometryStore, DoesNotBeginAgainWhatIsBeingMade) {
  GeometryStore store;
  QSignalSpy changed(&store, &GeometryStore::changed);
  SceneObjects objects = meshes(1, 150);
  {
    const HeldThreads held;
    store.set_objects(objects);
    ASSERT_FALSE(store.has_all_meshes());
    for (int edit = 0; edit < 5; ++edit) {
      objects.meshes[0].mesh.edit().surfaces.emplace_back();
      store.set_objects(objects);
    }
  }
  wait_for_threads();
  EXPECT_TRUE(store.has_all_meshes());
  EXPECT_EQ(changed.count(), 1);
}

TEST(GeometryStore, MakesTheMeshesOfALargeSceneInThreadsAndThoseOfAnEditAtOnce) {
  GeometryStore store;
  SceneObjects objects = meshes(60, 20);
  {
    const HeldThreads held;
    store.set_objects(objects);
    const auto shapes = store.shapes();
    const auto made = std::count_if(shapes.begin(), shapes.end(),
                                    [](const MeshShape& shape) { return shape.geometry != nullptr; });
    EXPECT_EQ(made, 40'000 / (2 * 19 * 19 * 3)) << "as many as have 40,000 corners";
  }
  wait_for_threads();
  ASSERT_TRUE(store.has_all_meshes());
  const auto shapes = store.shapes();
  objects.meshes[30].mesh = grf::Shared<grf::Mesh>(grf::height_field(20));
  store.set_objects(objects);
  EXPECT_TRUE(store.has_all_meshes()) << "else it flickers";
  EXPECT_NE(store.shapes()[30].geometry, shapes[30].geometry);
  EXPECT_EQ(store.shapes()[0].geometry, shapes[0].geometry);
}

}  // namespace
}  // namespace editor
