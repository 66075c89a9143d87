#include "editor/document/scene_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/format.h"
#include "editor/document/document.h"
#include "grf/read.h"
#include "tests/editor/scene_of.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string Lamp = R"(begin mesh "lamp" brdf ward light rgb (2, 2, 2)
  begin vertexs (0, 0, 0) (1, 0, 0) (1, 1, 0) (0, 1, 0) end vertexs
  begin faces (0, 1, 2, 3) end faces
end mesh
)";

class SceneExports : public testing::Test {
 protected:
  SceneExports() { document_.take(scene_of(Lamp), QString::fromStdString(folder_.path("lamp.grf")), {}); }

  ExportRequest request(const char* format, const std::string& name = "out") {
    ExportRequest request = export_request(document_);
    request.format = convert::find_format(format);
    request.path = QString::fromStdString(folder_.path(name));
    return request;
  }

  test::TemporaryFolder folder_;
  Document document_;
};

TEST_F(SceneExports, TellLossesWithoutWriting) {
  const auto stl = try_to_write(request("stl")).losses();
  EXPECT_THAT(stl, Contains(HasSubstr("name")));
  EXPECT_THAT(stl, Contains(HasSubstr("BRDF")));
  EXPECT_THAT(stl, Contains(HasSubstr("polygon"))) << "the quadrilateral is cut";
  EXPECT_THAT(try_to_write(request("ply")).losses(),
              AllOf(Contains(HasSubstr("name")), Not(Contains(HasSubstr("polygon")))));
  EXPECT_THAT(try_to_write(request("grf")).losses(), IsEmpty());
  EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_F(SceneExports, LoseWhatTheyTold) {
  for (const char* format : {"obj", "ply", "ply-ascii", "gltf", "glb", "stl", "grf"}) {
    const ExportRequest wanted = request(format, std::string("out.") + format);
    EXPECT_EQ(try_to_write(wanted).losses().size(), write(wanted).losses().size()) << format;
    EXPECT_THAT(folder_.names(), Contains(std::string("out.") + format));
  }
}

// The camera of the project, and not one that frames the scene.
TEST_F(SceneExports, HaveTheCameraOfTheProject) {
  options::RenderOptions now = document_.options().valid_options();
  now.eye = grf::Vec3f(7, 8.5F, 9);
  now.target = grf::Vec3f(7, 8.5F, 0);
  now.field_of_view = 90;
  document_.options().set_options("Camera", now);
  for (const char* format : {"gltf", "pbrt", "mitsuba", "usd"}) {
    const std::string name = std::string("out.") + format;
    const grf::Diagnostics diagnostics = write(request(format, name));
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.to_text();
    EXPECT_THAT(test::bytes_of(folder_.path(name)), HasSubstr("8.5")) << format;
  }
  const auto file = test::bytes_of(folder_.path("out.gltf"));
  EXPECT_THAT(file, HasSubstr("\"yfov\":1.57079"));
}

TEST_F(SceneExports, OfProjectsWithoutACameraLeaveItOpen) {
  EXPECT_FALSE(write(request("gltf", "out.gltf")).has_errors());
  EXPECT_THAT(test::bytes_of(folder_.path("out.gltf")), Not(HasSubstr("camera")));
}

TEST_F(SceneExports, WriteOneFileOfGrfAndLeaveIncludedOnes) {
  const std::string part = folder_.add("part.grf", Lamp);
  const std::string scene = folder_.add("scene.grf", "include \"part.grf\"\n");
  grf::Diagnostics diagnostics;
  document_.take(*grf::read(scene, diagnostics), QString::fromStdString(scene), {});
  FaceSelection all(document_.objects());
  all.select_all();
  document_.select(all);
  SurfaceEdit red;
  red.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(1, 0, 0));
  document_.edit_surfaces("Colour", red);
  EXPECT_FALSE(write(request("grf", "out.grf")).has_errors());
  EXPECT_EQ(test::bytes_of(part), Lamp) << "it is saved, and not exported";
  EXPECT_THAT(test::bytes_of(folder_.path("out.grf")),
              AllOf(HasSubstr("rgb (1, 0, 0)"), Not(HasSubstr("include"))));
  ExportRequest old = request("grf", "old.grf");
  old.is_grf2008 = true;
  EXPECT_THAT(try_to_write(old).to_text(), HasSubstr("radiance")) << "mesh lights of 2008 have radiance 1";
  EXPECT_FALSE(write(old).has_errors());
  EXPECT_THAT(test::bytes_of(folder_.path("old.grf")), Not(HasSubstr("begin mesh \"lamp\"")));
}

}  // namespace
}  // namespace editor
