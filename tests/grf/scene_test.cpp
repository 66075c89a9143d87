#include "grf/scene.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "grf/surface.h"
#include "tests/grf/reading.h"

namespace grf {
namespace {

TEST(Shared, CopiesShareUntilOneIsEdited) {
  Shared<std::string> a(std::string("one"));
  const Shared<std::string> b = a;
  EXPECT_EQ(&*a, &*b);
  a.edit() += " more";
  EXPECT_EQ(*a, "one more");
  EXPECT_EQ(*b, "one");
  EXPECT_FALSE(a == b);
}

TEST(Shared, IsEditedInPlaceWhereNobodyElseHasIt) {
  Shared<std::string> a(std::string("one"));
  const std::string* place = &*a;
  a.edit() = "two";
  EXPECT_EQ(&*a, place);
}

// Nothing but the count of owners orders the one thread's reading before the other one's writing: it is for
// ThreadSanitizer to say whether that is enough.
TEST(Shared, IsEditedInPlaceOnceAnotherThreadHasLetGo) {
  for (int i = 0; i < 100; ++i) {
    Shared<std::string> value(std::string("one"));
    const std::string* place = &*value;
    std::atomic<bool> has_let_go = false;
    std::thread reader([&, copy = std::make_unique<Shared<std::string>>(value)]() mutable {
      EXPECT_EQ(**copy, "one");
      copy.reset();
      has_let_go.store(true, std::memory_order_relaxed);
    });
    while (!has_let_go.load(std::memory_order_relaxed)) std::this_thread::yield();
    value.edit() = "two";
    EXPECT_EQ(&*value, place);
    reader.join();
  }
}

TEST(Shared, ComparesValues) {
  EXPECT_EQ(Shared<std::string>(std::string("one")), Shared<std::string>(std::string("one")));
}

TEST(SceneEquality, IgnoresLocations) {
  EXPECT_EQ(scene_of(triangle("brdf ward sx=1")), scene_of("\n\n" + triangle("\nbrdf\nward sx=1")));
}

TEST(SceneEquality, SeesEveryDifference) {
  const std::string text =
      "def a = rgb (1, 0, 0) begin transform scale (1, 2, 3) begin " +
      triangle("\"name\" rgb a brdf ward sx=1 pdf diffuse light rgb (1, 2, 3)", "rgb none (0, 1, 2)") +
      "light begin rgb (1, 2, 3) (0, 0, 0) (1, 0, 0) (0, 1, 0) end // behind\n end end // end\n";
  const Scene scene = scene_of(text);
  const std::pair<const char*, const char*> changes[] = {
      {"(1, 2, 3) begin", "(1, 2, 4) begin"},
      {"scale", "rotation"},
      {"\"name\"", "\"nome\""},
      {"sx=1", "sx=2"},
      {"sx=1", "sy=1"},
      {"sx=1", "sx=true"},
      {"ward", "phong"},
      {"pdf diffuse", ""},
      {"light rgb (1", "light rgb (2"},
      {"rgb none", ""},
      {"(0, 1, 2) (0, 1, 2)", "(0, 2, 1) (0, 1, 2)"},
      {"(0, 1, 0) end vertexs", "(0, 1, 1) end vertexs"},
      {"(0, 1, 0) end vertexs", "normal (0, 0, 1) (0, 1, 0) end vertexs"},
      {"(0, 1, 0) end vertexs", "rgb (0, 0, 1) (0, 1, 0) end vertexs"},
      {"begin rgb (1, 2, 3)", "begin"},
      {"// behind", "// before"},
      {"// end", ""},
      {"a = rgb (1, 0", "a = rgb (1, 1"},
  };
  for (const auto& [from, to] : changes) {
    std::string changed = text;
    const std::size_t place = changed.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    changed.replace(place, std::string(from).size(), to);
    EXPECT_FALSE(scene_of(changed) == scene) << from << " -> " << to;
  }
}

TEST(MeshEquality, ComparesTheSurfacesOfFacesAndNotTheirList) {
  Surface red;
  red.colour = Colour(1, 0, 0);
  Surface blue;
  blue.colour = Colour(0, 0, 1);
  const std::uint32_t corners[] = {0, 1, 2};
  MeshDraft a;
  a.positions = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
  MeshDraft b = a;
  a.surfaces = {Surface(), red, blue};
  a.add_face(corners, 1);
  a.add_face(corners, 2);
  b.surfaces = {Surface(), blue, red, red};
  b.add_face(corners, 3);
  b.add_face(corners, 1);
  EXPECT_EQ(Mesh(grf::MeshDraft(a)), Mesh(grf::MeshDraft(b)));
  b.surface_of_face = std::vector<std::uint32_t>{1, 3};
  EXPECT_FALSE(Mesh(grf::MeshDraft(a)) == Mesh(grf::MeshDraft(b)));
  b.surface_of_face = std::vector<std::uint32_t>{3, 1};
  b.surfaces[0] = red;
  EXPECT_FALSE(Mesh(grf::MeshDraft(a)) == Mesh(grf::MeshDraft(b)))
      << "what the mesh says itself is part of it";
}

TEST(OptionalVertexValues, AreEqualIfTheSameVerticesHaveTheSame) {
  OptionalVertexValues<Vec3f> a;
  OptionalVertexValues<Vec3f> b;
  EXPECT_EQ(a, b);
  a.set(1, Vec3f(1, 0, 0));
  EXPECT_FALSE(a == b);
  EXPECT_FALSE(a.has(0));
  EXPECT_TRUE(a.has(1));
  EXPECT_FALSE(a.has(2));
  b.set(3, Vec3f(0));
  b.set(1, Vec3f(1, 0, 0));
  EXPECT_FALSE(a == b);
  a.set(3, Vec3f(0));
  EXPECT_EQ(a, b);
}

TEST(SurfaceHash, IsTheSameForEqualSurfaces) {
  Surface a;
  a.brdf = BrdfModel{{"ward", {{"kd", Colour(0, 0, 1), {}}, {"fast", true, {}}}, {}}, {}, {}, {}};
  a.colour = Reference{"red", {}};
  a.emission = Colour(0, 1, 1);
  Surface b = a;
  std::get<BrdfModel>(*b.brdf) =
      BrdfModel{{"WARD", {{"KD", Colour(-0.0F, 0, 1), {}}, {"fast", true, {}}}, {}}, {}, {}, {}};
  b.emission = Colour(-0.0F, 1, 1);
  a.opacity = Opacity{Opacity::Kind::Mask, 0};
  b.opacity = Opacity{Opacity::Kind::Mask, -0.0F};
  EXPECT_EQ(a, b);
  EXPECT_EQ(hash_value(a), hash_value(b));
  EXPECT_NE(written_key(a), written_key(b));
  b.opacity->kind = Opacity::Kind::Blend;
  EXPECT_NE(hash_value(a), hash_value(b));
  b = a;
  b.pdf = Reference{"few", {}};
  EXPECT_NE(hash_value(a), hash_value(b));
}

TEST(SurfaceIndex, FindsSurfacesThatTheListHas) {
  std::vector<Surface> surfaces = {Surface()};
  SurfaceIndex index(surfaces);
  Surface red;
  red.colour = Colour(1, 0, 0);
  EXPECT_EQ(index.index_of(Surface()), 0U);
  EXPECT_EQ(index.index_of(red), 1U);
  EXPECT_EQ(index.index_of(red), 1U);
  EXPECT_EQ(SurfaceIndex(surfaces).index_of(red), 1U);
  EXPECT_EQ(surfaces.size(), 2U);
}

TEST(PartOfAMesh, HasTheFacesAndTheVerticesThatTheyUse) {
  const Mesh mesh =
      mesh_of(scene_of("begin mesh \"a\" brdf ward // shiny\n begin vertexs (0, 0, 0) normal (0, 0, 1) rgb "
                       "(1, 0, 0) uv (0, 1) irad (1, 2, 3) (1, 0, 0) "
                       "(2, 0, 0) (3, 0, 0) (4, 0, 0) end begin faces (0, 1, 2) rgb (1, 0, 0) (3, 2, 1, 4) "
                       "brdf none (1, 2, 3) (2, 3, 4) end end"));
  const Mesh expected =
      mesh_of(scene_of("begin mesh rgb (1, 0, 0) begin vertexs (2, 0, 0) (3, 0, 0) (4, 0, 0) "
                       "normal (0, 0, 1) rgb (1, 0, 0) uv (0, 1) irad (1, 2, 3) (1, 0, 0) end begin faces "
                       "(0, 1, 2) brdf ward (1, 0, 3, 2) "
                       "end end"));
  const std::uint32_t faces[] = {3, 1};
  EXPECT_EQ(submesh(mesh, faces), expected);
}

TEST(PartOfAMesh, OfNoFacesIsEmpty) {
  EXPECT_EQ(submesh(mesh_of(scene_of(triangle("\"a\" brdf ward"))), {}), Mesh());
}

TEST(PartOfAMesh, OfAllFacesIsTheMesh) {
  const Mesh mesh = mesh_of(scene_of(triangle("brdf ward", "(0, 1, 2) rgb (1, 0, 0)")));
  const std::uint32_t faces[] = {0, 1};
  EXPECT_EQ(submesh(mesh, faces), mesh);
}

}  // namespace
}  // namespace grf
