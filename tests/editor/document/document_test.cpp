#include "editor/document/document.h"

#include <QDir>
#include <QFile>
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include "editor/document/definitions.h"
#include "editor/document/geometry_edits.h"
#include "editor/document/light_edits.h"
#include "editor/document/scene_places.h"
#include "grf/read.h"
#include "grf/scene_path.h"
#include "grf/write.h"
#include "renderer/options/op_file.h"
#include "tests/editor/scene_of.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::HasSubstr;

const std::string Scene = R"(def gold = brdf ward sx=0.2
def tile = begin mesh
  begin vertexs
    (0, 0, 0) (2, 0, 0) (2, 1, 0) (0, 1, 0)
  end vertexs
  begin faces
    (0, 1, 2)
    (0, 2, 3)
  end faces
end mesh
begin
  use tile
  transform scale (2, 2, 2) begin
    use tile
  end
  begin mesh "floor"
    texture "wood.png"
    begin vertexs
      (0, 0, 0) (1, 0, 0) (0, 1, 0)
    end vertexs
    begin faces
      (0, 1, 2)
    end faces
  end mesh
end
)";

class Documents : public testing::Test {
 protected:
  Documents() { document_.take(scene_of(Scene), "/nowhere/scene.grf", {}); }

  void select(FaceId face) {
    FaceSelection selection(document_.objects());
    selection.set(face);
    document_.select(selection);
  }
  static SurfaceEdit brdf(const std::string& name) {
    SurfaceEdit edit;
    edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{name, {}});
    return edit;
  }

  Document document_;
};

TEST_F(Documents, KnowTheirObjects) {
  const SceneObjects& objects = document_.objects();
  ASSERT_EQ(objects.meshes.size(), 2U);
  EXPECT_EQ(objects.meshes[0].name, "tile");
  EXPECT_TRUE(objects.meshes[0].is_definition);
  EXPECT_EQ(objects.meshes[1].flat_surfaces.front().texture, "/nowhere/wood.png");
  ASSERT_EQ(objects.instances->size(), 3U);
  EXPECT_EQ(objects.faces, 3U);
  EXPECT_EQ(objects.triangles, 5U);
  EXPECT_EQ(objects.bounds.max, grf::Vec3d(4, 2, 0));
}

TEST_F(Documents, AssignToFacesAndBack) {
  const grf::Scene before = document_.scene();
  select({0, 1});
  document_.edit_surfaces("Assign gold", brdf("gold"));
  EXPECT_THAT(grf::to_text(document_.scene()), HasSubstr("(0, 1, 2)\n    brdf gold\n    (0, 2, 3)"));
  EXPECT_EQ(document_.objects().meshes[0].flat_surfaces.back().brdf->keyword, "ward");
  EXPECT_TRUE(document_.is_modified());
  const grf::Scene after = document_.scene();
  document_.select(FaceSelection(document_.objects()));
  document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), before);
  EXPECT_EQ(grf::to_text(document_.scene()), grf::to_text(before));
  EXPECT_TRUE(document_.selection().has({0, 1}));
  EXPECT_FALSE(document_.is_modified());
  document_.undo_stack().redo();
  EXPECT_EQ(document_.scene(), after);
}

TEST_F(Documents, OfAllFacesTheMeshSaysWhatTheyHave) {
  FaceSelection all(document_.objects());
  all.select_all();
  document_.select(all);
  document_.edit_surfaces("Assign gold", brdf("gold"));
  const MeshObject& tile = document_.objects().meshes[0];
  EXPECT_EQ(tile.mesh->surfaces.size(), 1U);
  EXPECT_FALSE(common_surface(document_.objects(), all).brdf.is_mixed);
  EXPECT_TRUE(common_surface(document_.objects(), all).texture.is_mixed);
  EXPECT_DOUBLE_EQ(selected_area(document_.objects(), all), 2 + 8 + 0.5);
}

TEST_F(Documents, MergeTheStepsOfAGesture) {
  select({1, 0});
  for (int i = 0; i < 3; ++i) {
    SurfaceEdit edit;
    edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(0.1F * static_cast<float>(i)));
    document_.edit_surfaces("Colour", edit, "colour");
  }
  EXPECT_EQ(document_.undo_stack().count(), 1);
  document_.finish_gesture();
  document_.edit_surfaces("Colour", brdf("gold"), "colour");
  EXPECT_EQ(document_.undo_stack().count(), 2);
  document_.undo_stack().undo();
  document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(Scene));
}

TEST(Gestures, KeepTheFacesOfEachStep) {
  // With the BRDFs that the steps set at first on the last two faces, the steps change faces only.
  for (const bool are_there : {true, false}) {
    SCOPED_TRACE(are_there);
    std::string faces;
    for (int face = 0; face < 15; ++face) faces += "(0, 1, 2) ";
    if (are_there) faces += "brdf ward (0, 1, 2) brdf phong (0, 1, 2) ";
    Document document;
    document.take(
        scene_of(
            "begin mesh brdf diffuse begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces " +
            faces + "end faces end mesh"),
        {}, {});
    const auto brdf_of = [&document](std::size_t face) {
      return std::get<grf::BrdfModel>(*document.objects().meshes[0].mesh->surface(face).brdf).keyword;
    };
    const auto brdfs = [&] {
      std::vector<std::string> keywords;
      for (std::size_t face = 0; face < 15; ++face) keywords.push_back(brdf_of(face));
      return keywords;
    };
    const auto assign = [&](std::size_t first, std::size_t end, const std::string& keyword) {
      grf::Scene scene = document.scene();
      grf::Mesh& mesh = grf::find_mesh(scene, document.objects().meshes[0].path)->edit();
      grf::Surface surface = mesh.surfaces.front();
      surface.brdf = grf::BrdfModel();
      std::get<grf::BrdfModel>(*surface.brdf).keyword = keyword;
      const auto found = std::ranges::find(mesh.surfaces, surface);
      const auto index = static_cast<std::uint32_t>(found - mesh.surfaces.begin());
      if (found == mesh.surfaces.end()) mesh.surfaces.push_back(surface);
      for (std::size_t face = first; face < end; ++face) mesh.surface_of_face.edit()[face] = index;
      document.replace("Assign", scene, "assign");
    };
    const std::vector<std::string> before(15, "diffuse");
    std::vector<std::string> after(5, "ward");
    after.insert(after.end(), 10, "phong");
    assign(0, 10, "ward");
    assign(5, 15, "phong");
    document.finish_gesture();
    EXPECT_EQ(document.undo_stack().count(), 1);
    EXPECT_EQ(brdfs(), after);
    document.undo_stack().undo();
    EXPECT_EQ(brdfs(), before);
    document.undo_stack().redo();
    EXPECT_EQ(brdfs(), after);
  }
}

TEST_F(Documents, CopyWhatAFaceHas) {
  select({0, 0});
  document_.edit_surfaces("Copy", edit_to(document_.objects().meshes[1].mesh->surfaces.front()));
  EXPECT_EQ(document_.objects().meshes[0].flat_surfaces.back().texture, "/nowhere/wood.png");
}

TEST_F(Documents, ReplaceScenesAndKeepTheSelection) {
  select({1, 0});
  grf::Scene scene = document_.scene();
  grf::find_mesh(scene, document_.objects().meshes[1].path)->edit().name = "ground";
  document_.replace("Rename", scene);
  EXPECT_TRUE(document_.selection().has({1, 0}));
  EXPECT_EQ(document_.objects().meshes[1].name, "ground");
  document_.undo_stack().undo();
  EXPECT_EQ(document_.objects().meshes[1].name, "floor");
}

TEST_F(Documents, SaveTheScene) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  select({0, 0});
  document_.edit_surfaces("Assign gold", brdf("gold"));
  const QString path = QString::fromStdString(folder.path("saved.grf"));
  ASSERT_TRUE(document_.save(path, diagnostics)) << diagnostics.to_text();
  EXPECT_FALSE(document_.is_modified());
  EXPECT_EQ(document_.name(), "saved.grf");
  EXPECT_EQ(document_.objects().meshes[1].flat_surfaces.front().texture, "/nowhere/wood.png");
  const auto saved = grf::read(path.toStdString(), diagnostics);
  ASSERT_TRUE(saved) << diagnostics.to_text();
  EXPECT_EQ(*saved, document_.scene());
}

TEST_F(Documents, NameTheSameFilesInStepsOfBeforeTheyWereSavedElsewhere) {
  select({1, 0});
  SurfaceEdit edit;
  edit.texture = AttributeEdit<grf::TextureAttribute>::set(grf::Texture{"steel.png", {}});
  document_.edit_surfaces("Texture", edit);
  grf::Scene scene = document_.scene();
  grf::find_mesh(scene, document_.objects().meshes[1].path)->edit().name = "ground";
  document_.replace("Rename", scene);
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document_.save(QString::fromStdString(folder.path("saved.grf")), diagnostics));
  const auto texture = [this] { return document_.objects().meshes[1].flat_surfaces.front().texture; };
  for (const char* expected : {"/nowhere/steel.png", "/nowhere/wood.png"}) {
    document_.undo_stack().undo();
    EXPECT_EQ(texture(), expected);
  }
  document_.undo_stack().redo();
  EXPECT_EQ(texture(), "/nowhere/steel.png");
  document_.undo_stack().redo();
  EXPECT_EQ(document_.objects().meshes[1].name, "ground");
  EXPECT_EQ(texture(), "/nowhere/steel.png");
}

TEST(DocumentOfAFileThatIsIncludedTwice, IsEditedAtBothPlaces) {
  const test::TemporaryFolder folder;
  folder.add("part.grf",
             "begin mesh begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces (0, 1, 2) end "
             "faces end mesh");
  const std::string path = folder.path("scene.grf");
  grf::Diagnostics diagnostics;
  const auto scene =
      grf::read_text("include \"part.grf\" transform translation (2, 0, 0) begin include \"part.grf\" end",
                     path, diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  Document document;
  document.take(*scene, QString::fromStdString(path), {});
  int told = 0;
  QObject::connect(&document, &Document::status_message, [&told] { ++told; });
  FaceSelection selection(document.objects());
  selection.set({1, 0});
  document.select(selection);
  SurfaceEdit edit;
  edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(1, 0, 0));
  document.edit_surfaces("Colour", edit);
  EXPECT_EQ(told, 1);
  for (const MeshObject& object : document.objects().meshes) {
    EXPECT_EQ(object.flat_surfaces.front().colour, grf::Colour(1, 0, 0));
  }
  ASSERT_TRUE(document.save(QString::fromStdString(path), diagnostics)) << diagnostics.to_text();
  const auto saved = grf::read(path, diagnostics);
  ASSERT_TRUE(saved) << diagnostics.to_text();
  EXPECT_EQ(*saved, document.scene());
  document.undo_stack().undo();
  EXPECT_EQ(document.scene(), *scene);
}

TEST(DocumentThatIncludesAFile, WritesThatFileAgainWhereItsEditIsUndone) {
  const test::TemporaryFolder folder;
  const std::string part =
      folder.add("part.grf",
                 "begin mesh \"one\" begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs "
                 "begin faces (0, 1, 2) end faces end mesh");
  const std::string path = folder.add("scene.grf", "include \"part.grf\"");
  grf::Diagnostics diagnostics;
  Document document;
  document.take(grf::read(path, diagnostics).value(), QString::fromStdString(path), {});
  const std::string as_read = test::bytes_of(part);
  ASSERT_TRUE(document.save(QString::fromStdString(path), diagnostics)) << diagnostics.to_text();
  EXPECT_EQ(test::bytes_of(part), as_read) << "what holds what it held is not written in another style";
  grf::Scene scene = document.scene();
  grf::find_mesh(scene, document.objects().meshes[0].path)->edit().name = "two";
  document.replace("Rename", scene);
  ASSERT_TRUE(document.save(QString::fromStdString(path), diagnostics)) << diagnostics.to_text();
  EXPECT_THAT(test::bytes_of(part), HasSubstr("two"));
  document.undo_stack().undo();
  ASSERT_TRUE(document.save(QString::fromStdString(path), diagnostics)) << diagnostics.to_text();
  EXPECT_THAT(test::bytes_of(part), HasSubstr("one"));
}

TEST_F(Documents, GiveTheirNamesToWhatIsMergedIn) {
  document_.merge("Merge", scene_of("light begin (0, 0, 1) (1, 0, 0) (0, 1, 0) end"), "/nowhere/other.grf");
  std::vector<std::string> names;
  for (const PlacedDefinition& each : definitions_at(document_.scene(), document_.objects().lights[0].path)) {
    names.push_back(each.definition->name);
  }
  EXPECT_THAT(names, testing::ElementsAre("gold", "tile"));
}

TEST_F(Documents, ForgetASurfaceOfWhichAllFacesAreDeleted) {
  select({0, 1});
  document_.edit_surfaces("Assign gold", brdf("gold"));
  ASSERT_EQ(count_uses(document_.scene()).size(), 2U) << "gold and tile";
  document_.replace("Delete faces",
                    without_faces({document_.scene(), document_.objects(), document_.selection()}));
  EXPECT_EQ(count_uses(document_.scene()).size(), 1U);
}

TEST_F(Documents, BringBackTheGreySkyWhereTheFirstLightIsUndone) {
  document_.take(scene_of(Scene), "", {});
  const grf::Vec3f sky = document_.options().valid_options().background;
  EXPECT_GT(sky.x, 0);
  document_.replace("Add light", add_light(document_.scene(), grf::AreaLight()));
  EXPECT_EQ(document_.options().valid_options().background, grf::Vec3f(0));
  EXPECT_EQ(document_.undo_stack().count(), 1);
  document_.undo_stack().undo();
  EXPECT_EQ(document_.options().valid_options().background, sky);
  EXPECT_TRUE(document_.objects().lights.empty());
}

TEST_F(Documents, WriteNoOptionsThatNobodyGave) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  document_.take(scene_of(Scene), "", {});
  ASSERT_TRUE(document_.save(QString::fromStdString(folder.path("dark.grf")), diagnostics));
  document_.replace("Add light", add_light(document_.scene(), grf::AreaLight()));
  ASSERT_TRUE(document_.save(QString::fromStdString(folder.path("dark.grf")), diagnostics));
  EXPECT_FALSE(QFile::exists(QString::fromStdString(folder.path("dark.op"))));
}

TEST_F(Documents, TakeOptionsAlongToAnotherFolder) {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder other;
  grf::Diagnostics diagnostics;
  folder.add("scene.op", "# mine\nBPT_Depth 3\nBPT_EM_Background sky.exr\n");
  document_.take(scene_of(Scene), QString::fromStdString(folder.path("scene.grf")), {});
  ASSERT_TRUE(document_.save(QString::fromStdString(other.path("scene.grf")), diagnostics))
      << diagnostics.to_text();
  const auto read = options::read_op_file(other.path("scene.op"), diagnostics);
  ASSERT_TRUE(read) << diagnostics.to_text();
  EXPECT_EQ(read->depth, 3);
  EXPECT_EQ(read->environment, folder.path("sky.exr"));
  EXPECT_THAT(test::bytes_of(other.path("scene.op")), HasSubstr("# mine"));
}

TEST_F(Documents, SayWhyOptionsCannotBeRead) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(QDir().mkdir(QString::fromStdString(folder.path("scene.op"))));
  std::size_t errors = 0;
  QObject::connect(&document_.options(), &OpDocument::path_changed,
                   [&] { errors = document_.options().diagnostics().error_count(); });
  document_.take(scene_of(Scene), QString::fromStdString(folder.path("scene.grf")), {});
  EXPECT_EQ(errors, 1U);
}

TEST_F(Documents, EndStepsOfOptionsWhereAGestureEnds) {
  const auto move_camera = [this](float x) {
    options::RenderOptions now = document_.options().valid_options();
    now.eye = grf::Vec3f(x, 0, 0);
    document_.options().set_options("Move the camera", now, "camera");
  };
  for (const float x : {1.0F, 2.0F}) move_camera(x);
  EXPECT_EQ(document_.undo_stack().count(), 1);
  document_.finish_gesture();
  move_camera(3);
  ASSERT_EQ(document_.undo_stack().count(), 2);
  document_.undo_stack().undo();
  EXPECT_EQ(document_.options().valid_options().eye, grf::Vec3f(2, 0, 0));
}

TEST(SurfaceEdits, EditInPlaceASurfaceOfWhichAllFacesAreSelected) {
  // The surfaces of the faces are 0 0 1 1 2; the first surface is the mesh's own.
  Document document;
  document.take(scene_of(R"(begin mesh
    rgb (1, 0, 0)
    begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs
    begin faces
      (0, 1, 2) (0, 1, 2)
      rgb (0, 1, 0) (0, 1, 2) (0, 1, 2)
      rgb (0, 0, 1) (0, 1, 2)
    end faces
  end mesh)"),
                {}, {});
  const auto colours = [&document] {
    std::vector<grf::Colour> found;
    for (std::size_t face = 0; face < 5; ++face) {
      found.push_back(std::get<grf::Colour>(*document.objects().meshes[0].mesh->surface(face).colour));
    }
    return found;
  };
  const auto paint = [&document](const std::vector<std::uint32_t>& faces, const grf::Colour& colour) {
    FaceSelection selection(document.objects());
    for (const std::uint32_t face : faces) selection.set({0, face});
    document.select(selection);
    SurfaceEdit edit;
    edit.colour = AttributeEdit<grf::ColourAttribute>::set(colour);
    document.edit_surfaces("Colour", edit);
  };
  const grf::Colour red(1, 0, 0);
  const grf::Colour green(0, 1, 0);
  const grf::Colour blue(0, 0, 1);
  const grf::Colour grey(0.5F);
  const auto before = document.objects().meshes[0].mesh->surface_of_face;
  paint({2, 3}, grey);
  EXPECT_EQ(colours(), (std::vector{red, red, grey, grey, blue}));
  EXPECT_TRUE(document.objects().meshes[0].mesh->surface_of_face.shares(before))
      << "no face has another number";
  paint({2}, green);
  EXPECT_EQ(colours(), (std::vector{red, red, green, grey, blue})) << "not all of its faces";
  paint({0, 1}, green);
  EXPECT_EQ(colours(), (std::vector{green, green, green, grey, blue})) << "the mesh's own";
  paint({4}, grey);
  EXPECT_EQ(colours(), (std::vector{green, green, green, grey, grey})) << "one that is there already";
  for (int i = 0; i < 4; ++i) document.undo_stack().undo();
  EXPECT_EQ(colours(), (std::vector{red, red, green, green, blue}));
  for (int i = 0; i < 4; ++i) document.undo_stack().redo();
  EXPECT_EQ(colours(), (std::vector{green, green, green, grey, grey}));
}

/// Bytes that are allocated and not freed.
std::size_t allocated() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// A mesh of a million faces, all the same triangle.
grf::Scene million_faces() {
  grf::MeshDraft draft;
  draft.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  constexpr std::uint32_t Corners[] = {0, 1, 2};
  for (int i = 0; i < 1'000'000; ++i) draft.add_face(Corners, 0);
  draft.free_spare_memory();
  grf::Scene scene;
  scene.contents.blocks.emplace_back().content = grf::Shared<grf::Mesh>(std::move(draft));
  return scene;
}

TEST(LargeScenes, UndoHundredEditsOfDifferentFacesWithOnePercentOfTheirMemory) {
  if (test::HasSanitizers) GTEST_SKIP() << "sanitizers allocate otherwise";
  const std::size_t without_scene = allocated();
  Document document;
  document.take(million_faces(), {}, {});
  const std::size_t of_scene = allocated() - without_scene;
  std::vector<FaceSelection> painted;
  for (std::uint32_t i = 0; i < 100; ++i) {
    FaceSelection selection(document.objects());
    for (const std::uint32_t face : {i, 9'000 * i + 127, 9'000 * i + 128}) selection.set({0, face});
    document.select(selection);
    painted.push_back(std::move(selection));
    SurfaceEdit edit;
    edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(static_cast<float>(i) / 100.0F));
    document.edit_surfaces("Colour", edit);
  }
  ASSERT_EQ(document.undo_stack().count(), 100);
  for (auto selection = painted.rbegin(); selection != painted.rend(); ++selection) {
    document.select(FaceSelection(document.objects()));
    document.undo_stack().undo();
    ASSERT_EQ(document.selection(), *selection);
  }
  document.undo_stack().setIndex(100);
  const std::size_t with_steps = allocated();
  document.undo_stack().clear();
  EXPECT_LT(with_steps - allocated(), of_scene / 100);
}

}  // namespace
}  // namespace editor
