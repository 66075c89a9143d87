// The parsers of the tests refuse what the renderers would refuse.
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/converters/renderers/mitsuba_scene.h"
#include "tests/converters/renderers/pbrt_scene.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

const std::string Pbrt = R"(Film "rgb" "integer xresolution" [ 4 ] "integer yresolution" [ 3 ]
PixelFilter "box"
Sampler "halton" "integer pixelsamples" 4
Integrator "path" "integer maxdepth" [ 5 ]
LookAt 0 0 5 0 0 0 0 1 0
Camera "perspective" "float fov" [ 45 ]
WorldBegin
MakeNamedMaterial "a" "string type" [ "diffuse" ] "rgb reflectance" [ 0.5 0.5 0.5 ]
ObjectBegin "o"
NamedMaterial "a"
Shape "plymesh" "string filename" [ "a.ply" ]
ObjectEnd
AttributeBegin
AreaLightSource "diffuse" "rgb L" [ 1 2 3 ]
Shape "plymesh" "string filename" [ "a.ply" ]
ObjectInstance "o"
AttributeEnd
)";

TEST(RendererGrammars, OfPbrtAreStrict) {
  const test::TemporaryFolder folder;
  folder.add("a.ply", "");
  EXPECT_EQ(test::parse_pbrt(Pbrt, folder.path()).shapes.size(), 2U);
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"integer xresolution", "float xresolution"},
      {"xresolution", "width"},
      {"[ 4 ]", "[ 4.5 ]"},
      {"[ 45 ]", "[ 45 46 ]"},
      {"WorldBegin", "WorldStart"},
      {"\"halton\"", "\"haltn\""},
      {"0.5 0.5 0.5", "0.5 0.5"},
      {"0.5 0.5 0.5", "0.5 0.5 1.5"},
      {"NamedMaterial \"a\"\n", "NamedMaterial \"b\"\n"},
      {"a.ply", "b.ply"},
      {"ObjectInstance \"o\"", "ObjectInstance \"p\""},
      {"AttributeEnd", ""},
      {"ObjectEnd", "AttributeEnd"},
      {"NamedMaterial \"a\"\n", "AreaLightSource \"diffuse\" \"rgb L\" [ 1 2 3 ]\n"},
      {"LookAt 0 0 5 0 0 0 0 1 0", "LookAt 0 0 5 0 0 0 0 0 1"},
      {"\"rgb L\" [ 1 2 3 ]", "\"rgb L\" [ 1 2 3"},
      {"Integrator \"path\" \"integer maxdepth\" [ 5 ]", ""},
  };
  for (const auto& [what, with] : mistakes) {
    EXPECT_THROW(test::parse_pbrt(replaced(Pbrt, what, with), folder.path()), std::runtime_error) << with;
  }
}

const std::string Mitsuba = R"(<scene version="3.0.0">
  <integrator type="path"><integer name="max_depth" value="6"/></integrator>
  <bsdf type="twosided" id="a">
    <bsdf type="diffuse"><rgb name="reflectance" value="0.5 0.5 0.5"/></bsdf>
  </bsdf>
  <shape type="shapegroup" id="g">
    <shape type="ply"><string name="filename" value="a.ply"/><ref id="a"/></shape>
  </shape>
  <shape type="ply">
    <string name="filename" value="a.ply"/>
    <emitter type="area"><rgb name="radiance" value="1 2 3"/></emitter>
  </shape>
  <shape type="instance">
    <transform name="to_world"><matrix value="1 0 0 4 0 1 0 5 0 0 1 6 0 0 0 1"/></transform>
    <ref id="g"/>
  </shape>
</scene>
)";

TEST(RendererGrammars, OfMitsubaAreStrict) {
  const test::TemporaryFolder folder;
  folder.add("a.ply", "");
  EXPECT_EQ(test::parse_mitsuba(Mitsuba, folder.path()).all("shape").size(), 3U);
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"<integer name", "<float name"},
      {"max_depth", "maxDepth"},
      {"\"path\"", "\"paths\""},
      {"value=\"6\"", "value=\"6.5\""},
      {"0.5 0.5 0.5", "0.5 0.5"},
      {"0.5 0.5 0.5", "0.5 0.5 1.5"},
      {"<ref id=\"a\"/>", "<ref id=\"b\"/>"},
      {"<ref id=\"g\"/>", "<ref id=\"a\"/>"},
      {"<ref id=\"a\"/>", "<emitter type=\"area\"><rgb name=\"radiance\" value=\"1 2 3\"/></emitter>"},
      {"a.ply", "b.ply"},
      {"0 0 0 1\"/></transform>", "0 0 0\"/></transform>"},
      {"</bsdf>\n  </bsdf>", "</bsdf>\n"},
      {"name=\"filename\"", "name=\"file\""},
      {"\"twosided\"", "\"blendbsdf\""},
      {"</scene>", "</scene><scene/>"},
  };
  for (const auto& [what, with] : mistakes) {
    EXPECT_THROW(test::parse_mitsuba(replaced(Mitsuba, what, with), folder.path()), std::runtime_error)
        << with;
  }
}

}  // namespace
}  // namespace convert
