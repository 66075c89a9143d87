// The parsers of the tests refuse what USD and MaterialX do not have.
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/converters/usd/mtlx_document.h"
#include "tests/converters/usd/usda_stage.h"

namespace convert {
namespace {

using Mistakes = std::vector<std::pair<std::string, std::string>>;

template <class Parse>
void expect_refusals(const std::string& text, const Mistakes& mistakes, const Parse& parse) {
  ASSERT_NO_THROW(parse(text));
  for (const auto& [what, with] : mistakes) {
    std::string wrong = text;
    const std::size_t at = wrong.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    EXPECT_THROW(parse(wrong.replace(at, what.size(), with)), std::runtime_error) << what << " -> " << with;
  }
}

const std::string Usda = R"(#usda 1.0
(
    defaultPrim = "World"
    metersPerUnit = 1
    upAxis = "Y"
)
def Xform "World"
{
    matrix4d xformOp:transform = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1) )
    uniform token[] xformOpOrder = ["xformOp:transform"]
    def Mesh "m" (
        customData = {
            dictionary grf = {
                string name = "a \"b\"\nc"
            }
        }
    )
    {
        float3[] extent = [(0, 0, 0), (1, 1, 0)]
        uniform token subdivisionScheme = "none"
        int[] faceVertexCounts = [3, 3]
        int[] faceVertexIndices = [0, 1, 2, 0, 2, 3]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
        normal3f[] normals = [(0, 0, 1), (0, 0, 1), (0, 0, 1), (0, 0, 1)] ( interpolation = "vertex" )
        color3f[] primvars:displayColor = [(1, 1, 1), (1, 0, 0)] ( interpolation = "uniform" )
        uniform token subsetFamily:materialBind:familyType = "partition"
        def GeomSubset "s" (
            prepend apiSchemas = ["MaterialBindingAPI"]
        )
        {
            uniform token elementType = "face"
            int[] indices = [0, 1]
            rel material:binding = </World/mat>
        }
    }
    def Material "mat"
    {
        token outputs:surface.connect = </World/mat/p.outputs:surface>
        def Shader "p"
        {
            uniform token info:id = "UsdPreviewSurface"
            float inputs:roughness = 0.5
            token outputs:surface
        }
    }
    def Xform "i" (
        instanceable = true
        prepend references = </World/mat>
    )
    {
    }
}
)";

TEST(ExchangeGrammars, OfUsdAreStrict) {
  const Mistakes mistakes = {
      {"#usda 1.0", "#usda 2.0"},
      {"\"World\"\n    meters", "\"Word\"\n    meters"},
      {"upAxis = \"Y\"", "upAxis = \"Z\""},
      {"def Mesh \"m\"", "def Mash \"m\""},
      {"def Mesh \"m\"", "def Mesh \"1m\""},
      {"def Material \"mat\"", "def Material \"m\""},
      {"int[] faceVertexCounts", "float[] faceVertexCounts"},
      {"[3, 3]", "[3, 4]"},
      {"[3, 3]", "[2, 4]"},
      {"[3, 3]", "[3, 3"},
      {"0, 2, 3]", "0, 2, 4]"},
      {"0, 2, 3]", "0, 2, 2.5]"},
      {"(0, 1, 0)]\n", "(0, 1)]\n"},
      {"(0, 0, 1)] ( interpolation", "(0, 0, 1), (0, 0, 1)] ( interpolation"},
      {"\"vertex\"", "\"faceVarying\""},
      {"(1, 0, 0)] (", "(1, 0, 0), (1, 0, 0)] ("},
      {"indices = [0, 1]", "indices = [0]"},
      {"indices = [0, 1]", "indices = [0, 1, 1]"},
      {"indices = [0, 1]", "indices = [0, 2]"},
      {"</World/mat>\n        }", "</World/mut>\n        }"},
      {"</World/mat>\n        }", "</World/i>\n        }"},
      {"p.outputs:surface", "p.outputs:out"},
      {"\"UsdPreviewSurface\"", "\"UsdPreview\""},
      {"inputs:roughness", "inputs:rough"},
      {"float inputs:roughness", "color3f inputs:roughness"},
      {"references = </World/mat>", "references = </World/none>"},
      {"\\n", "\n"},
      {"uniform token[] xformOpOrder = [\"xformOp:transform\"]\n", ""},
      {", (0, 0, 0, 1) )", " )"},
      {"uniform token subdivisionScheme = \"none\"", "uniform token subdivisionScheme = \"catmullClark\""},
      {"\"face\"", "\"point\""},
      {"    }\n}\n", "    }\n"},
  };
  expect_refusals(Usda, mistakes, [](const std::string& text) { return test::parse_usda(text); });
}

const std::string Mtlx = R"(<?xml version="1.0"?>
<materialx version="1.39" colorspace="lin_rec709">
  <image name="i" type="color3">
    <input name="file" type="filename" value="a.png" colorspace="srgb_texture"/>
  </image>
  <oren_nayar_diffuse_bsdf name="d" type="BSDF">
    <input name="color" type="color3" nodename="i"/>
    <input name="roughness" type="float" value="0.5"/>
  </oren_nayar_diffuse_bsdf>
  <surface name="s" type="surfaceshader">
    <input name="bsdf" type="BSDF" nodename="d"/>
  </surface>
  <surfacematerial name="m" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="s"/>
  </surfacematerial>
  <look name="look">
    <materialassign name="a" material="m" geom="/World/a, /World/b"/>
  </look>
</materialx>
)";

TEST(ExchangeGrammars, OfMaterialxAreStrict) {
  const Mistakes mistakes = {
      {"1.39", "1.37"},
      {"<image name", "<picture name"},
      {"type=\"BSDF\">", "type=\"color3\">"},
      {"name=\"color\"", "name=\"colour\""},
      {"type=\"float\" value", "type=\"color3\" value"},
      {"value=\"0.5\"", "value=\"0.5, 0.5\""},
      {"value=\"0.5\"", "value=\"half\""},
      {"value=\"0.5\"", "value=\"0.5\" nodename=\"i\""},
      {"nodename=\"d\"", "nodename=\"e\""},
      {"nodename=\"d\"", "nodename=\"i\""},
      {"name=\"s\"", "name=\"d\""},
      {"</surface>", "</surfaces>"},
      {"material=\"m\"", "material=\"s\""},
      {"/World/a", "World/a"},
      {"a.png", "a & b.png"},
      {"</materialx>", ""},
      {"</materialx>", "</materialx><materialx/>"},
  };
  expect_refusals(Mtlx, mistakes, [](const std::string& text) { return test::parse_mtlx(text); });
}

}  // namespace
}  // namespace convert
