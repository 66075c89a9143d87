#include "converters/format.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "grf/write.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::HasSubstr;

/// The name of the format that a file with these bytes is taken for; empty after an error.
std::string recognised(const std::string& name, std::string_view bytes) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  const Format* format = recognise(folder.add(name, bytes), diagnostics);
  EXPECT_EQ(format == nullptr, diagnostics.has_errors());
  return format == nullptr ? "" : std::string(format->name);
}

TEST(Formats, HaveAllThatTheTableNeeds) {
  for (const Format& format : formats()) {
    EXPECT_FALSE(format.name.empty());
    EXPECT_FALSE(format.title.empty());
    EXPECT_FALSE(format.keeps.empty());
    EXPECT_FALSE(format.loses.empty());
    EXPECT_NE(format.sniff, nullptr);
    EXPECT_TRUE(format.read != nullptr || format.write != nullptr);
    ASSERT_FALSE(format.extensions.empty());
    EXPECT_EQ(find_format(format.name), &format);
    for (const std::string_view extension : format.extensions) {
      EXPECT_EQ(grf::lower_case(extension), extension);
      const Format* of_name = format_of_name("some.folder/file." + std::string(extension));
      ASSERT_NE(of_name, nullptr);
      // Of formats with one extension, all but the first are other ways to write it, which a name asks for;
      // a format that is only read may have that of one that is only written.
      const bool is_shared = of_name->read == nullptr && format.write == nullptr;
      EXPECT_TRUE(of_name == &format || (of_name < &format && (format.read == nullptr || is_shared)))
          << format.name;
      if (format.read != nullptr) {
        EXPECT_EQ(read_format_of_name("file." + std::string(extension)), &format);
      }
    }
  }
}

TEST(Formats, AreToldByContentFirst) {
  EXPECT_EQ(recognised("a.grf", "# exported\r\n\r\nmtllib a.mtl\n"), "obj");
  EXPECT_EQ(recognised("a.obj", "// a scene\n  Begin Mesh\n"), "grf");
  EXPECT_EQ(recognised("a", "\xEF\xBB\xBF// a scene\n//\n\ntransform scale (1, 1, 1)"), "grf");
  EXPECT_EQ(recognised("a.dat", "v 1 2 3"), "obj");
  EXPECT_EQ(recognised("a.obj", "ply\r\nformat ascii 1.0\r\n"), "ply");
  EXPECT_EQ(recognised("a.dat", std::string_view("\xFE\xFF\0v\0 \0001", 8)), "obj");
  EXPECT_EQ(recognised("a.nff", "v\nfrom 0 0 5\nat 0 0 0\n"), "other");
  EXPECT_EQ(recognised("a.nff", "s 0 0 0 1\n"), "other");
  EXPECT_EQ(recognised("a.nff", "f 1 0 0 0.5 0.5 20 0 1\n"), "other");
}

TEST(Formats, AreToldByNameWhereTheContentSaysNothing) {
  EXPECT_EQ(recognised("a.GRF", ""), "grf");
  EXPECT_EQ(recognised("a.igrf", "beginning"), "grf");
  EXPECT_EQ(recognised("a.Obj", "something else"), "obj");
  EXPECT_EQ(recognised("a.obj", std::string(5000, '#')), "obj");
}

TEST(Formats, OfNamesAreTheFirstOfTheirExtension) {
  EXPECT_EQ(format_of_name("a.ply"), find_format("ply"));
  EXPECT_EQ(recognised("a.ply", "something else"), "ply");
}

TEST(Formats, OfXmlAreMitsubaIfItIsAScene) {
  EXPECT_EQ(recognised("a.xml", "<?xml version=\"1.0\"?>\n<!-- x -->\n<scene version=\"3.0.0\">"), "mitsuba");
  EXPECT_EQ(recognised("a.xml", "<mesh>"), "other");
  EXPECT_EQ(recognised("a.xml", "<!-- <scene version=\"3.0.0\">"), "other");
  EXPECT_EQ(format_of_name("a.xml"), find_format("mitsuba"));
  EXPECT_EQ(recognised("a.xml", "<?xml version=\"1.0\"?>\n<materialx version=\"1.39\">"), "materialx");
  EXPECT_EQ(recognised("a.x", "#usda 1.0\n("), "usd");
  EXPECT_EQ(recognised("a.pbrt", "WorldBegin"), "pbrt");
}

TEST(Formats, OfFilesThatCannotBeToldAreAnError) {
  EXPECT_EQ(recognised("a.dat", "vertices 1 2 3"), "");
  EXPECT_EQ(recognised("obj", "vertices 1 2 3"), "");
  grf::Diagnostics diagnostics;
  const test::TemporaryFolder folder;
  EXPECT_EQ(recognise(folder.add("empty.dat", ""), diagnostics), nullptr);
  EXPECT_EQ(recognise(folder.path("missing.dat"), diagnostics), nullptr);
  EXPECT_EQ(recognise(folder.path(), diagnostics), nullptr);
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("empty.dat: error: the file is empty"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("missing.dat: error: cannot read the file: No such file"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("it is a directory"));
}

TEST(GrfFormat, ReadsWhatItWrites) {
  const Format& format = *find_format("grf");
  const Reading original = read_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  const test::TemporaryFolder folder;
  const std::string path = folder.path("out.grf");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(format.write(*original.scene, path, diagnostics));
  EXPECT_EQ(read(format, path, {}, diagnostics)->scene, original.scene);
}

TEST(GrfFormat, TheOptionGivesABrdfToBareFacesEverywhere) {
  const test::TemporaryFolder folder;
  const std::string mesh = "begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs\n";
  folder.add("inner.grf", mesh + "begin faces (0,1,2) end faces end mesh\n");
  const std::string path =
      folder.add("outer.grf", "include \"inner.grf\"\ntransform scale (2,2,2) begin\n" + mesh +
                                  "begin faces brdf phong n=3 (0,1,2) brdf none (1,2,0)\n"
                                  "light rgb (1,1,1) (2,1,0) end faces end mesh end\n");
  grf::Diagnostics diagnostics;
  const ReadOptions options{grf::read_brdf("ward sx=0.15", "option", diagnostics)};
  const auto import = read(*find_format("grf"), path, options, diagnostics);
  ASSERT_TRUE(import.has_value()) << diagnostics.to_text();
  const std::vector<grf::Mesh> meshes = meshes_of(import->scene);
  ASSERT_EQ(meshes.size(), 2U);
  EXPECT_EQ(meshes[0].surface(0).brdf, grf::BrdfAttribute(*options.brdf));
  EXPECT_EQ(std::get<grf::BrdfModel>(*meshes[1].surface(0).brdf).keyword, "phong");
  EXPECT_EQ(meshes[1].surface(1).brdf, grf::BrdfAttribute(*options.brdf));
  EXPECT_FALSE(meshes[1].surface(2).brdf.has_value()) << "what emits without a BRDF is black";
}

}  // namespace
}  // namespace convert
