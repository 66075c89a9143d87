#include "editor/document/light_edits.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "editor/document/object_edits.h"
#include "editor/document/scene_places.h"
#include "grf/write.h"
#include "tests/editor/moved_object.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using testing::HasSubstr;

const std::string SceneOfLights = R"(def tile = begin mesh
  begin vertexs
    (0, 0, 0) (1, 0, 0) (1, 1, 0) (0, 1, 0)
  end vertexs
  begin faces
    (0, 1, 2, 3)
  end faces
end mesh
begin
  transform scale (2, 2, 2) begin
    light begin rgb (1, 2, 3) (0, 0, 0) (1, 0, 0) (0, 1, 0) end
    params begin dependent view (1, 1, 1) end
    use tile
  end
  use tile
  begin mesh "floor"
    begin vertexs
      (0, 0, 0) (1, 0, 0) (0, 1, 0)
    end vertexs
    begin faces
      (0, 1, 2)
    end faces
  end mesh
  mesh light begin rgb (5, 5, 5)
    begin vertexs
      (0, 0, 0) (1, 0, 0) (0, 1, 0)
    end vertexs
    begin faces
      (0, 1, 2)
    end faces
  end
end
)";

class LightEdits : public testing::Test {
 protected:
  LightEdits() { document_.take(scene_of(SceneOfLights), {}, {}); }

  void take(std::optional<grf::Scene> scene) {
    ASSERT_TRUE(scene) << diagnostics_.to_text();
    EXPECT_EQ(scene_of(grf::to_text(*scene)), *scene);
    document_.replace("Edit", std::move(*scene));
  }
  const SceneObjects& objects() const { return document_.objects(); }
  void select(FaceId face) {
    FaceSelection selection(objects());
    selection.set(face);
    document_.select(selection);
  }

  Document document_;
  grf::Diagnostics diagnostics_;
};

TEST_F(LightEdits, PowerAndRadianceBelongTogether) {
  EXPECT_DOUBLE_EQ(power_of(grf::Colour(1, 2, 3), 4), 8 * std::numbers::pi);
  const grf::Colour radiance = radiance_of(60, 4, grf::Colour(1, 2, 3));
  EXPECT_NEAR(power_of(radiance, 4), 60, 1e-4);
  EXPECT_FLOAT_EQ(radiance.z, 3 * radiance.x);
  EXPECT_NEAR(power_of(radiance_of(60, 4, grf::Colour(0)), 4), 60, 1e-4);
  EXPECT_EQ(radiance_of(60, 0, grf::Colour(7)), grf::Colour(7));
}

TEST_F(LightEdits, EmittersAreListedWithTheirPower) {
  select({0, 0});
  document_.edit_surfaces("Emit", emission_of_power(objects(), document_.selection(), 60, grf::Colour(1)));
  const std::vector<Emitter> emitters = emitters_of(objects());
  ASSERT_EQ(emitters.size(), 3U);
  EXPECT_EQ(emitters[0].kind, Emitter::Kind::AreaLight);
  EXPECT_DOUBLE_EQ(emitters[0].area, 4);
  EXPECT_DOUBLE_EQ(emitters[0].power, 8 * std::numbers::pi);
  EXPECT_EQ(emitters[1].kind, Emitter::Kind::Faces);
  EXPECT_EQ(emitters[1].name, "tile");
  EXPECT_DOUBLE_EQ(emitters[1].area, 5);  // of both instances
  EXPECT_NEAR(emitters[1].power, 60, 1e-4);
  EXPECT_EQ(emitters[2].kind, Emitter::Kind::MeshLight);
  EXPECT_DOUBLE_EQ(emitters[2].power, 2.5 * std::numbers::pi);
}

TEST_F(LightEdits, FacesOfMeshLightsGetARadianceAlone) {
  select({2, 0});
  EXPECT_EQ(common_surface(objects(), document_.selection()).emission.value, grf::Colour(5));
  SurfaceEdit edit = emission_of_power(objects(), document_.selection(), 10, grf::Colour(1));
  grf::BrdfModel brdf;
  brdf.keyword = "ward";
  edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(brdf);
  document_.edit_surfaces("Emit", edit);
  EXPECT_FALSE(objects().meshes[2].mesh->surfaces.front().brdf);
  EXPECT_NEAR(emitters_of(objects()).back().power, 10, 1e-5);
}

TEST_F(LightEdits, LightsAreAddedChangedAndRemoved) {
  const grf::AreaLight light = {grf::Vec3f(0, 3, 0), grf::Vec3f(1, 0, 0), grf::Vec3f(0, 0, 2),
                                grf::Colour(4)};
  take(add_light(document_.scene(), light));
  ASSERT_EQ(objects().lights.size(), 2U);
  EXPECT_EQ(objects().lights[1].light, light);
  const grf::AreaLight larger = {grf::Vec3f(-0.5F, 3, -1), grf::Vec3f(2, 0, 0), grf::Vec3f(0, 0, 4),
                                 grf::Colour(4)};
  take(change_light(document_.scene(), objects().lights[1].path, larger, diagnostics_));
  EXPECT_EQ(world_area(objects().lights[1]), 8);
  take(remove_objects(document_.scene(), {objects().lights[1].path}, {}, diagnostics_));
  EXPECT_EQ(document_.scene(), scene_of(SceneOfLights));
  EXPECT_FALSE(change_light(document_.scene(), grf::ScenePath{0, 2}, light, diagnostics_));
}

TEST_F(LightEdits, ObserversAreAddedMovedAndRemoved) {
  take(add_observer(document_.scene(), grf::Vec3d(0, 0, 9)));
  ASSERT_EQ(objects().observers.size(), 2U);
  EXPECT_EQ(objects().observers[1].position, grf::Vec3d(0, 0, 9));
  take(move_observer(document_.scene(), objects().observers[0], grf::Vec3d(4, 6, 8), diagnostics_));
  EXPECT_EQ(objects().observers[0].position, grf::Vec3d(4, 6, 8));
  EXPECT_THAT(grf::to_text(document_.scene()), HasSubstr("dependent view (2, 3, 4)"));
  take(remove_objects(document_.scene(), {}, {objects().observers[0]}, diagnostics_));
  ASSERT_EQ(objects().observers.size(), 1U);
  EXPECT_EQ(objects().observers[0].position, grf::Vec3d(0, 0, 9));
  // Two of four: the others of their block are kept.
  for (const double z : {1.0, 2.0, 3.0}) take(add_observer(document_.scene(), grf::Vec3d(0, 0, z)));
  ASSERT_EQ(objects().observers.size(), 4U);
  take(remove_objects(document_.scene(), {}, {objects().observers[0], objects().observers[2]}, diagnostics_));
  ASSERT_EQ(objects().observers.size(), 2U);
  EXPECT_EQ(objects().observers[0].position, grf::Vec3d(0, 0, 1));
  EXPECT_EQ(objects().observers[1].position, grf::Vec3d(0, 0, 3));
  take(remove_objects(document_.scene(), {}, objects().observers, diagnostics_));
  EXPECT_TRUE(objects().observers.empty());
  EXPECT_THAT(grf::to_text(document_.scene()), Not(HasSubstr("begin params")));
}

TEST_F(LightEdits, ObjectsAreMovedInTheWorld) {
  const auto place = [this](std::size_t instance) {
    return grf::Vec3d(0) * (*objects().instances)[instance].to_world;
  };
  // Twice, by the same path.
  for (int i = 0; i < 2; ++i) {
    take(moved_object(document_.scene(), grf::ScenePath{0, 1, 2}, grf::Vec3d(1, 0, 0), diagnostics_));
  }
  EXPECT_EQ(place(0), grf::Vec3d(2, 0, 0));
  EXPECT_THAT(grf::to_text(document_.scene()), HasSubstr("transform translation (1, 0, 0)"));
  EXPECT_EQ(place(1), grf::Vec3d(0));
  take(moved_object(document_.scene(), grf::ScenePath{0, 1}, grf::Vec3d(0, 5, 0), diagnostics_));
  EXPECT_EQ(place(0), grf::Vec3d(2, 5, 0));
  EXPECT_THAT(grf::to_text(document_.scene()), HasSubstr("scale (2, 2, 2) translation (0, 5, 0)"));
}

TEST_F(LightEdits, ObjectsAreDuplicatedAsInstances) {
  take(duplicate_object(document_.scene(), grf::ScenePath{0, 3}, grf::Vec3d(3, 0, 0), diagnostics_));
  ASSERT_EQ(objects().meshes.size(), 3U);
  ASSERT_EQ(objects().instances->size(), 5U);
  const std::string text = grf::to_text(document_.scene());
  EXPECT_THAT(text, HasSubstr("def floor = begin mesh \"floor\""));
  EXPECT_THAT(text, HasSubstr("use floor\n  transform translation (3, 0, 0) begin\n    use floor"));
  // The copy of an object with its own transform stands beside that.
  const grf::ScenePath copy = {0, 5, 0};
  ASSERT_NE(block_at(document_.scene(), copy), nullptr);
  take(duplicate_object(document_.scene(), copy, grf::Vec3d(3, 0, 0), diagnostics_));
  EXPECT_THAT(grf::to_text(document_.scene()),
              HasSubstr("transform translation (6, 0, 0) begin\n    use floor"));
}

TEST_F(LightEdits, ObjectsAreRenamedAndRemoved) {
  take(rename_object(document_.scene(), grf::ScenePath{0, 3}, "the \"floor\"", diagnostics_));
  EXPECT_EQ(objects().meshes[1].name, "the \"floor\"");
  take(rename_object(document_.scene(), grf::ScenePath{0, 0}, "slab", diagnostics_));
  EXPECT_THAT(grf::to_text(document_.scene()), HasSubstr("use slab"));
  EXPECT_FALSE(rename_object(document_.scene(), grf::ScenePath{0, 1}, "x", diagnostics_));
  EXPECT_FALSE(remove_objects(document_.scene(), {{0, 0}}, {}, diagnostics_));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("'slab' is used 2 times"));
  // With all its uses, it can be deleted.
  take(remove_objects(document_.scene(), {{0, 0}, {0, 1, 2}, {0, 2}}, {}, diagnostics_));
  EXPECT_EQ(objects().instances->size(), 2U);
}

}  // namespace
}  // namespace editor
