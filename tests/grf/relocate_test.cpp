#include "grf/relocate.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/summary.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "tests/grf/reading.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class RelocateTest : public testing::Test {
 protected:
  Scene read_scene(const std::string& name) {
    Diagnostics diagnostics;
    const auto scene = read(folder.path(name), diagnostics);
    EXPECT_EQ(diagnostics.to_text(), "");
    return scene ? *scene : Scene();
  }

  std::string moved(const std::string& text, const std::string& to) {
    folder.add("home/scene.grf", text);
    Scene scene = read_scene("home/scene.grf");
    relocate(scene, folder.path("home/scene.grf"), folder.path(to));
    return to_text(scene);
  }

  test::TemporaryFolder folder;
};

TEST_F(RelocateTest, NamesFilesFromTheNewPlace) {
  folder.add("home/parts/part.grf", triangle());
  folder.add("home/gold.brdf", "ward");
  const std::string text =
      "include \"parts\\part.grf\" def t = texture \"wood.png\" b = brdf \"gold.brdf\" m = brdf measured "
      "\"m.binary\" "
      "mesh = " +
      triangle("texture \"a/b.png\"") + " begin " + triangle("brdf \"gold.brdf\"", "texture \"../c.png\"") +
      "end";
  const std::string written = moved(text, "other/new/scene.grf");
  for (const char* name :
       {"include \"../../home/parts/part.grf\"", "texture \"../../home/wood.png\"",
        "b = brdf \"../../home/gold.brdf\"", "measured \"../../home/m.binary\"",
        "texture \"../../home/a/b.png\"", "    brdf \"../../home/gold.brdf\"", "texture \"../../c.png\""}) {
    EXPECT_THAT(written, HasSubstr(name));
  }
}

TEST_F(RelocateTest, NamesImagesOfParametersFromTheNewPlace) {
  folder.add("home/brdfs/rough.brdf", "ward sx=texture \"c.png\" g");
  const std::string text = "def a = brdf ward sx=texture \"a.png\" r begin " +
                           triangle("brdf ward sx=texture \"../b.png\" a * 0.5") +
                           triangle("brdf \"brdfs/rough.brdf\"") + "end";
  const std::string written = moved(text, "other/scene.grf");
  for (const char* name : {"sx=texture \"../home/a.png\" r", "sx=texture \"../b.png\" a * 0.5",
                           "brdf \"../home/brdfs/rough.brdf\""}) {
    EXPECT_THAT(written, HasSubstr(name));
  }
  const Scene absolute = with_absolute_names(read_scene("home/scene.grf"), folder.path("home/scene.grf"));
  EXPECT_THAT(to_text(absolute), HasSubstr("sx=texture \"" + folder.path("home/brdfs/c.png") + "\" g"));
  EXPECT_EQ(summarize(absolute).textures, 3U);
}

TEST_F(RelocateTest, NamesFilesByAbsolutePaths) {
  folder.add("home/parts/part.grf", triangle("texture \"d.png\"", "brdf measured \"../n.binary\""));
  folder.add("home/gold.brdf", "ward");
  folder.add("home/scene.grf", "include \"parts/part.grf\" def m = brdf measured \"m.binary\" begin " +
                                   triangle("texture \"../c.png\"") + triangle("texture \"/e.png\"") + "end");
  const std::string written =
      to_text(with_absolute_names(read_scene("home/scene.grf"), folder.path("home/scene.grf")));
  for (const char* name : {"home/parts/d.png", "home/n.binary", "home/m.binary", "c.png"}) {
    EXPECT_THAT(written, HasSubstr('"' + folder.path(name) + '"'));
  }
  EXPECT_THAT(written, HasSubstr("\"/e.png\""));
  EXPECT_THAT(written, Not(HasSubstr("include")));
}

TEST_F(RelocateTest, ChangesNothingInTheSameFolder) {
  const std::string text = "def t = texture \"a\\\\..\\b.png\"\nbegin\nend\n";
  EXPECT_EQ(moved(text, "home/other.grf"), text);
}

TEST_F(RelocateTest, LeavesAbsoluteNamesAsTheyAre) {
  EXPECT_THAT(moved("def t = texture \"/images/a.png\" begin end", "other/scene.grf"),
              HasSubstr("\"/images/a.png\""));
}

TEST_F(RelocateTest, LeavesIncludedFilesAsTheyAre) {
  const std::string part = triangle("texture \"wood.png\"");
  folder.add("home/part.grf", part);
  folder.add("home/scene.grf", "include \"part.grf\"");
  folder.add("other/x", "");
  Scene scene = read_scene("home/scene.grf");
  relocate(scene, folder.path("home/scene.grf"), folder.path("other/scene.grf"));
  Diagnostics diagnostics;
  EXPECT_TRUE(write(scene, folder.path("other/scene.grf"), diagnostics));
  EXPECT_EQ(diagnostics.to_text(), "");
  EXPECT_EQ(test::bytes_of(folder.path("home/part.grf")), part);
  EXPECT_EQ(*block<Include>(read_scene("other/scene.grf").contents).contents,
            *block<Include>(read_scene("home/scene.grf").contents).contents);
}

TEST_F(RelocateTest, LeavesDataThatAFileOfABrdfNamesToThatFile) {
  folder.add("home/gold.brdf", "measured \"gold.binary\"");
  folder.add("home/scene.grf", "def a = brdf \"gold.brdf\" begin end");
  Scene scene = read_scene("home/scene.grf");
  relocate(scene, folder.path("home/scene.grf"), folder.path("other/scene.grf"));
  const auto& brdf = std::get<BrdfModel>(block<DefinitionScope>(scene.contents).definitions[0].body);
  EXPECT_EQ(brdf.instance_file, "../home/gold.brdf");
  EXPECT_EQ(brdf.data_file, "gold.binary");
}

TEST_F(RelocateTest, CopiesNoMeshThatNamesNoFile) {
  folder.add("home/scene.grf", triangle("brdf ward rgb (1, 0, 0)"));
  const Scene before = read_scene("home/scene.grf");
  Scene scene = before;
  relocate(scene, folder.path("home/scene.grf"), folder.path("other/scene.grf"));
  EXPECT_EQ(&mesh_of(scene), &mesh_of(before));
}

class FlattenTest : public RelocateTest {
 protected:
  /// The text of the scene as one file, which is read again to see that it can be.
  std::string flat(const std::string& text) {
    const std::string path = folder.add("scene.grf", text);
    const Scene scene = flatten(read_scene("scene.grf"), path);
    EXPECT_EQ(scene_of(to_text(scene)), scene);
    return to_text(scene);
  }

  const std::string light = "light begin (0, 2, 0) (1, 0, 0) (0, 0, 1) end";
  const std::string light_text = "light begin\n  (0, 2, 0)\n  (1, 0, 0)\n  (0, 0, 1)\nend";
};

TEST_F(FlattenTest, PutsBlocksWhereTheIncludeWasWithAllComments) {
  folder.add("light.grf", "// a lamp\n" + light + " // bright\n// the end of the lamp");
  EXPECT_EQ(flat("// one\ninclude \"light.grf\" // two\n// three\nparams begin end\n// four\ninclude "
                 "\"light.grf\"\n// five"),
            "// one\n// two\n// a lamp\n" + light_text +
                "  // bright\n// the end of the lamp\n// three\nparams begin\nend\n" +
                "// four\n// a lamp\n" + light_text + "  // bright\n// the end of the lamp\n// five\n");
}

TEST_F(FlattenTest, KeepsTheCommentsOfEmptyFiles) {
  folder.add("nothing.grf", "// nothing");
  EXPECT_EQ(flat("// one\ninclude \"nothing.grf\""), "// one\n// nothing\n");
  EXPECT_EQ(flat("transform scale (2, 2, 2) begin\n// one\ninclude \"nothing.grf\" end"),
            "transform scale (2, 2, 2) begin\n  // one\n  // nothing\nend\n");
}

TEST_F(FlattenTest, NamesFilesOfOtherFoldersFromTheOneFile) {
  folder.add("a/gold.brdf", "ward");
  folder.add("a/b/part.grf", triangle("texture \"wood.png\" brdf measured \"..\\m.binary\""));
  folder.add("a/part.grf",
             "include \"b/part.grf\" def t = texture \"stone.png\" m = " + triangle("texture \"../c.png\"") +
                 " begin " + triangle("texture t") + "use m end");
  const std::string text = flat("include \"a/part.grf\"");
  for (const char* name : {"texture \"a/b/wood.png\"", "measured \"a/m.binary\"",
                           "t = texture \"a/stone.png\"", "texture \"c.png\"", "    texture t\n"}) {
    EXPECT_THAT(text, HasSubstr(name));
  }
  EXPECT_THAT(text, Not(HasSubstr("include")));
}

TEST_F(FlattenTest, WritesFilesOfBrdfsOut) {
  folder.add("a/gold.brdf", "// bright\nward sx=0.1");
  folder.add("a/measured.brdf", "measured \"gold.binary\" linear=false");
  folder.add("a/part.grf", triangle("brdf \"gold.brdf\"", "brdf \"measured.brdf\""));
  const std::string text =
      flat("include \"a/part.grf\" def b = brdf \"a/measured.brdf\" m = " + triangle("brdf \"a/gold.brdf\"") +
           " begin end");
  EXPECT_THAT(text, HasSubstr("  brdf ward sx=0.1\n"));
  EXPECT_THAT(text, HasSubstr("    brdf measured \"a/gold.binary\" linear=false\n"));
  EXPECT_THAT(text, HasSubstr("def b = brdf measured \"a/gold.binary\" linear=false\n"))
      << "from the same folder";
  EXPECT_THAT(text, Not(HasSubstr(".brdf")));
}

TEST_F(FlattenTest, GivesEveryFaceTheSurfaceThatItHad) {
  folder.add("part.grf", triangle("brdf a rgb c", "(0, 1, 2) brdf ward") +
                             "def c = rgb (0, 0, 1) a = brdf phong begin " + triangle("brdf a rgb c") +
                             "include \"inner.grf\" end");
  folder.add("inner.grf", triangle("brdf a rgb c"));
  const std::string path =
      folder.add("scene.grf",
                 "def a = brdf ward c = rgb (1, 0, 0) begin transform scale (2, 2, 2) begin "
                 "include \"part.grf\" end include \"inner.grf\" end");
  const auto meaning = [](const Scene& scene) {
    std::vector<std::string> surfaces;
    SceneVisitor visitor;
    visitor.mesh = [&](const Mesh& mesh, const Placement& placement, const Block&) {
      for (std::size_t i = 0; i < mesh.face_count(); ++i) {
        const ResolvedSurface surface = resolve(mesh.surface(i), placement.scope);
        surfaces.push_back(surface.brdf->keyword + (surface.colour.x > 0 ? " red" : " blue") +
                           (placement.to_world[0][0] > 1 ? " large" : ""));
      }
    };
    visit(scene, visitor);
    return surfaces;
  };
  const Scene scene = read_scene("scene.grf");
  EXPECT_THAT(meaning(scene), ElementsAre("ward red large", "ward red large", "phong blue large",
                                          "phong blue large", "ward red"));
  EXPECT_EQ(meaning(flatten(scene, path)), meaning(scene));
  EXPECT_EQ(meaning(scene_of(to_text(flatten(scene, path)))), meaning(scene));
}

TEST_F(FlattenTest, ChangesNothingInASceneOfOneFile) {
  const std::string path =
      folder.add("scene.grf", "def t = texture \"a.png\" begin " +
                                  triangle("texture t brdf measured \"b.binary\"") + light + " end");
  const Scene scene = read_scene("scene.grf");
  EXPECT_EQ(flatten(scene, path), scene);
}

}  // namespace
}  // namespace grf
