#include "grf/scene_path.h"

#include <cstddef>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grf/visit.h"
#include "tests/grf/scene_generator.h"

namespace grf {
namespace {

/// A path with a dangling view in a placement would show in what is found, so each is looked up at once in a
/// copy of the scene.
RC_GTEST_PROP(ScenePaths, LeadToWhatAVisitorMeets, ()) {
  const Scene scene = SceneGenerator(true).scene();
  Scene copy = scene;
  std::size_t met = 0;
  const auto block = [&](const Placement& placement, const Block& expected) {
    const ScenePlace place = find(copy, placement.path);
    RC_ASSERT(place.definition == nullptr);
    RC_ASSERT(place.block != nullptr);
    RC_ASSERT(*place.block == expected);
    ++met;
  };
  SceneVisitor visitor;
  visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block& in) {
    block(placement, in);
    if (placement.instance_of != nullptr) return;
    RC_ASSERT(**find_mesh(copy, placement.path) == mesh);
  };
  visitor.mesh_light = [&](const MeshLight& light, const Placement& placement, const Block& in) {
    block(placement, in);
    RC_ASSERT(**find_mesh(copy, placement.path) == *light.mesh);
  };
  visitor.light = [&](const AreaLight&, const Placement& placement, const Block& in) {
    block(placement, in);
    RC_ASSERT(find_mesh(copy, placement.path) == nullptr);
    RC_ASSERT(find_blocks(copy, placement.path) == nullptr);
  };
  visitor.transform = [&](const Transform& transform, const Placement& placement, const Block& in) {
    block(placement, in);
    RC_ASSERT(*find_blocks(copy, placement.path) == transform.body);
  };
  visitor.definition = [&](const Definition& expected, const Placement& placement) {
    const ScenePlace place = find(copy, placement.path);
    RC_ASSERT(place.block == nullptr);
    RC_ASSERT(place.definition != nullptr);
    RC_ASSERT(*place.definition == expected);
    ++met;
  };
  visit(scene, visitor);
  RC_CLASSIFY(met > 3);
}

TEST(ScenePaths, ThatLeadNowhereFindNothing) {
  Scene empty;
  for (const ScenePath& path : {ScenePath{7}, ScenePath{0, 0}, ScenePath{0, 0, 0}}) {
    EXPECT_EQ(find(empty, path).block, nullptr);
    EXPECT_EQ(find(empty, path).definition, nullptr);
    EXPECT_EQ(find_mesh(empty, path), nullptr);
    EXPECT_EQ(find_blocks(empty, path), nullptr);
  }
  EXPECT_EQ(find_blocks(empty, {}), &empty.contents);
}

}  // namespace
}  // namespace grf
