#include "editor/document/lamp.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "editor/document/light_edits.h"
#include "grf/write.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using testing::HasSubstr;

void expect_vector(const grf::Vec3d& vector, const grf::Vec3d& expected, double tolerance = 1e-6) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(vector[axis], expected[axis], tolerance) << axis;
}

class Lamps : public testing::Test {
 protected:
  void take(const std::string& text) {
    document_.take(scene_of(text), {}, {});
    path_ = objects().lights.front().path;
  }
  void add(const Lamp& lamp) {
    document_.replace("Add", add_lamp(document_.scene(), lamp));
    path_ = lamp.shape == LampShape::Rectangle ? objects().lights.back().path : objects().meshes.back().path;
  }
  Lamp lamp() const {
    const auto found = lamp_at(document_.scene(), objects(), path_);
    EXPECT_TRUE(found);
    return found.value_or(Lamp());
  }
  template <class Edit>
  void change(const Edit& edit) {
    Lamp changed = lamp();
    edit(changed);
    auto edited = change_lamp(document_.scene(), objects(), path_, changed, diagnostics_);
    ASSERT_TRUE(edited) << diagnostics_.to_text();
    path_ = edited->paths.front();
    document_.replace("Edit", std::move(edited->scene));
    EXPECT_EQ(scene_of(grf::to_text(document_.scene())), document_.scene());
  }
  const SceneObjects& objects() const { return document_.objects(); }
  const grf::AreaLight& light() const { return objects().lights.front().light; }
  /// Twice the sum of the area vectors of all faces of the last mesh in world space.
  grf::Vec3d area_vector() const {
    const MeshInstance& instance = objects().instances->back();
    const grf::Mesh& mesh = *objects().meshes[instance.mesh].mesh;
    grf::Vec3d sum(0);
    for (std::size_t face = 0; face < mesh.face_count(); ++face)
      sum += grf::doubled_area_vector(*mesh.geometry, face, instance.to_world);
    return sum;
  }

  Document document_;
  grf::ScenePath path_;
  grf::Diagnostics diagnostics_;
};

TEST_F(Lamps, RectanglesAreReadAsAuthored) {
  take("light begin (-0.5, 3, -1) (1, 0, 0) (0, 0, 2) end\n");  // emits along x × z = -y
  Lamp expected;
  expected.centre = grf::Vec3d(0, 3, 0);
  expected.height = 2;
  EXPECT_EQ(lamp(), expected);
  // By the right-hand rule of the format, toward +x: yaw -90, level.
  take("light begin rgb (1, 2, 3) (0, 0, 0) (0, 0, 1) (0, -3, 0) end\n");
  EXPECT_EQ(lamp().yaw, -90);
  EXPECT_EQ(lamp().elevation, 0);
  EXPECT_EQ(lamp().roll, 0);
  EXPECT_EQ(lamp().radiance, grf::Colour(1, 2, 3));
  expect_vector(direction_of(lamp()), grf::Vec3d(1, 0, 0));
  // No rectangle.
  take("light begin (0, 0, 0) (1, 0, 0) (0.5, 0, 1) end\n");
  EXPECT_FALSE(lamp_at(document_.scene(), objects(), path_));
  // World space counts.
  const std::string skew = "light begin (0, 0, 0) (1, 0, 2) (1, 0, -2) end\n";
  take(skew);
  EXPECT_FALSE(lamp_at(document_.scene(), objects(), path_));
  take("transform scale (2, 1, 1) begin\n" + skew + "end\n");
  EXPECT_NEAR(lamp().width, std::sqrt(8), 1e-6);
}

TEST_F(Lamps, OneNumberChangesOnlyWhatItMust) {
  const std::string text = "light begin rgb (3, 4, 5) (-0.35, 3.3, -1.7) (0.7, 0, 0) (0, 0, 2.2) end\n";
  take(text);
  change([](Lamp& lamp) { lamp.centre.x += 0.1; });
  EXPECT_EQ(light(),
            (grf::AreaLight{{-0.25F, 3.3F, -1.7F}, {0.7F, 0, 0}, {0, 0, 2.2F}, grf::Colour(3, 4, 5)}));
  change([](Lamp& lamp) { lamp.centre.x -= 0.1; });
  EXPECT_EQ(document_.scene(), scene_of(text));
  change([](Lamp& lamp) { lamp.width = 0.9; });
  EXPECT_EQ(light(),
            (grf::AreaLight{{-0.45F, 3.3F, -1.7F}, {0.9F, 0, 0}, {0, 0, 2.2F}, grf::Colour(3, 4, 5)}));
  change([](Lamp& lamp) { lamp.width = 0.7; });
  EXPECT_EQ(document_.scene(), scene_of(text));
  for (int turn = 0; turn < 4; ++turn) change([](Lamp& lamp) { lamp.yaw += 90; });
  EXPECT_EQ(document_.scene(), scene_of(text));
  change([](Lamp& lamp) { lamp.radiance = grf::Colour(9); });
  EXPECT_EQ(light().corner, grf::Vec3f(-0.35F, 3.3F, -1.7F));
  EXPECT_EQ(light().radiance, grf::Colour(9));
}

TEST_F(Lamps, RectanglesUnderTransformsAreSetInWorldSpace) {
  for (const char* steps : {"scale (2, 2, 2) rotation (0.3, 0.4, 0.5) translation (1, 2, 3)",
                            "scale (-1, 1, 1) rotation (0.3, 0.4, 0.5) translation (1, 2, 3)",
                            "scale (1, 3, -2) translation (1, 2, 3)"}) {
    take(std::string("transform ") + steps + " begin\nlight begin (0, 1, 0) (1, 0, 0) (0, 0, 1) end\nend\n");
    const auto wanted = [](Lamp& lamp) {
      lamp.centre = grf::Vec3d(4, 5, 6);
      lamp.yaw = 30;
      lamp.elevation = -20;
      lamp.roll = 15;
      lamp.width = 1.5;
      lamp.height = 0.25;
    };
    Lamp expected;
    wanted(expected);
    change(wanted);
    const Lamp found = lamp();
    expect_vector(found.centre, expected.centre, 3e-6);
    EXPECT_NEAR(found.yaw, 30, 1e-4) << steps;
    EXPECT_NEAR(found.elevation, -20, 1e-4) << steps;
    EXPECT_NEAR(found.roll, 15, 1e-4) << steps;
    EXPECT_NEAR(found.width, 1.5, 1e-6) << steps;
    EXPECT_NEAR(found.height, 0.25, 1e-6) << steps;
    // A mirroring transform carries the front along: by hand, from the edges in world space.
    const LightObject& object = objects().lights.front();
    grf::Vec3d edge1, edge2;
    object.to_world.multDirMatrix(grf::Vec3d(light().edge1), edge1);
    object.to_world.multDirMatrix(grf::Vec3d(light().edge2), edge2);
    const bool is_mirrored = std::string(steps).find('-') != std::string::npos;
    const grf::Vec3d normal = (is_mirrored ? edge2.cross(edge1) : edge1.cross(edge2)).normalized();
    const double yaw = 30 * std::numbers::pi / 180, elevation = -20 * std::numbers::pi / 180;
    expect_vector(normal, {-std::sin(yaw) * std::cos(elevation), std::sin(elevation),
                           -std::cos(yaw) * std::cos(elevation)});
  }
}

TEST_F(Lamps, AimKeepsTheCentreAndALevelSide) {
  take("light begin (-0.5, 3, -1) (1, 0, 0) (0, 0, 2) end\n");
  const grf::Vec3d point(2, 0.5, -4);
  change([&](Lamp& lamp) { aim(lamp, point); });
  expect_vector(lamp().centre, grf::Vec3d(0, 3, 0));
  const grf::Vec3d normal = grf::Vec3d(light().edge1).cross(grf::Vec3d(light().edge2)).normalized();
  expect_vector(normal, (point - grf::Vec3d(0, 3, 0)).normalized());
  EXPECT_EQ(light().edge1.y, 0);
  EXPECT_NEAR(lamp().width, 1, 1e-6);
  EXPECT_NEAR(lamp().height, 2, 1e-6);
  // Straight down again, without a turn about the vertical.
  const double yaw = lamp().yaw;
  change([](Lamp& lamp) { aim(lamp, grf::Vec3d(0, 0, 0)); });
  EXPECT_EQ(lamp().elevation, -90);
  EXPECT_NEAR(lamp().yaw, yaw, 1e-4);
}

TEST_F(Lamps, HighlightsObeyTheLawOfReflection) {
  Lamp lamp;
  lamp.centre = grf::Vec3d(9, 9, 9);
  const grf::Vec3d eye(3, 2, 1), point(0.5, 0.25, -1), normal = grf::Vec3d(0.2, 1, 0.3);
  for (const double sign : {1.0, -1.0}) {
    light_highlight(lamp, point, normal * sign, point - eye, 4);
    const grf::Vec3d to_lamp = (lamp.centre - point).normalized(), to_eye = (eye - point).normalized();
    EXPECT_NEAR((lamp.centre - point).length(), 4, 1e-12);
    // The half vector of both is the normal.
    expect_vector((to_lamp + to_eye).normalized(), normal.normalized(), 1e-12);
    expect_vector(direction_of(lamp), -to_lamp, 1e-12);
  }
}

TEST_F(Lamps, DiscsAndSpheresAreMeshesThatEmit) {
  document_.take(scene_of("begin mesh begin vertices (0,0,0) (1,0,0) (0,1,0) end vertices begin faces "
                          "(0,1,2) end faces end mesh\n"),
                 {}, {});
  Lamp disc;
  disc.shape = LampShape::Disc;
  disc.centre = grf::Vec3d(1, 2, 3);
  disc.radius = 0.5;
  disc.radiance = grf::Colour(4, 5, 6);
  add(disc);
  EXPECT_EQ(lamp(), disc);
  EXPECT_THAT(grf::to_text(document_.scene()),
              HasSubstr("transform scale (0.5, 0.5, 0.5) translation (1, 2, 3) begin"));
  // A regular polygon of 48 corners, whose front looks down.
  const double area = 24 * std::sin(2 * std::numbers::pi / 48) * 0.25;
  expect_vector(area_vector() / 2, grf::Vec3d(0, -area, 0));
  EXPECT_NEAR(emitters_of(objects()).back().power, std::numbers::pi * area * 5, 1e-4);
  const grf::Scene first = document_.scene();
  change([](Lamp& lamp) { lamp.radius = 2; });
  change([](Lamp& lamp) { lamp.centre.y = 7.5; });
  EXPECT_THAT(grf::to_text(document_.scene()), HasSubstr("scale (2, 2, 2) translation (1, 7.5, 3)"));
  change([](Lamp& lamp) { lamp.radiance = grf::Colour(1); });
  change([](Lamp& lamp) { aim(lamp, grf::Vec3d(4, 1, -2)); });
  expect_vector(area_vector().normalized(), (grf::Vec3d(4, 1, -2) - grf::Vec3d(1, 7.5, 3)).normalized());
  expect_vector(lamp().centre, grf::Vec3d(1, 7.5, 3));
  change([](Lamp& lamp) { aim(lamp, grf::Vec3d(1, 20, 3)); });
  EXPECT_NEAR(lamp().elevation, 90, 1e-4);
  disc.elevation = 0;
  disc.yaw = 90;
  add(disc);
  expect_vector(area_vector() / 2, grf::Vec3d(-area, 0, 0));

  Lamp sphere = disc;
  sphere.shape = LampShape::Sphere;
  sphere.elevation = Lamp().elevation;
  sphere.yaw = 0;
  add(sphere);
  EXPECT_EQ(lamp(), sphere);
  expect_vector(area_vector(), grf::Vec3d(0), 1e-6);  // closed
  const double whole = 4 * std::numbers::pi * 0.25;
  const double part = emitters_of(objects()).back().area / whole;
  EXPECT_LT(part, 1);
  EXPECT_GT(part, 0.97);
  // All fronts look outward.
  const MeshObject& mesh = objects().meshes.back();
  for (std::size_t face = 0; face < mesh.mesh->face_count(); ++face) {
    const grf::Vec3d normal = grf::doubled_area_vector(*mesh.mesh->geometry, face, {});
    EXPECT_GT(normal.dot(grf::Vec3d(mesh.mesh->geometry->positions[mesh.mesh->face(face).front()])), 0)
        << face;
  }
  change([](Lamp& lamp) { lamp.radius = 0.25; });
  EXPECT_EQ(lamp().radius, 0.25);
}

}  // namespace
}  // namespace editor
