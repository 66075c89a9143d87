// Tests that real models render the same after all conversions: `bpt` renders the output of `grfconvert`.
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/image/image.h"
#include "tests/cli/bpt.h"
#include "tests/cli/grfconvert.h"
#include "tests/statistics/chi_square.h"
#include "tests/transport/block_statistics.h"

namespace {

using test::BlockStatistics;

const std::string Models = "/usr/share/assimp/models/";

/// Replacements of GRF text, as an author edits it: the first string by the second, wherever it occurs.
using Edits = std::vector<std::pair<std::string, std::string>>;

struct Model {
  std::string name;
  std::string file;
  std::string placement;  ///< on the floor of the stage, about a unit wide
  Edits surfaces;         ///< assigns the author's BRDFs
  Edits change;           ///< changes one parameter of these slightly

  friend void PrintTo(const Model& model, std::ostream* out) {  // NOLINT(readability-identifier-naming)
    *out << model.name;
  }
};

const Model Horse = {"Horse",
                     "/usr/share/glmark2/models/horse.3ds",
                     "translation (0, 0.8516, 0)",
                     {{"diffuse kd=0.75294125", "ward sx=0.08 sy=0.35 ks=0.4 kd=(0.25, 0.12, 0.06)"}},
                     {{"sx=0.08 sy=0.35", "sx=0.35 sy=0.08"}}};

const Model Duck = {"Duck",
                    Models + "Collada/duck.dae",
                    "translation (-14, -9.93, 4) scale (0.01, 0.01, 0.01)",
                    {{"diffuse kd=1", "coupled Rm=0.7 R0=0.08"}},
                    {{"Rm=0.7", "Rm=0.65"}}};

// All BRDFs of this model are metallic-roughness, some of them with a coat.
const Model Engine = {"Engine",
                      Models + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
                      "translation (0, 181, 0) scale (0.003, 0.003, 0.003)",
                      {{"baseColor=0.85 roughness=1", "baseColor=(0.8, 0.6, 0.4) metallic=1 roughness=0.45"},
                       {"roughness=1", "roughness=0.4 clearcoat=0.5 coatRoughness=0.2"}},
                      {{"metallic=1 roughness=0.45", "metallic=1 roughness=0.55"}}};

// This model is metallic-roughness with a texture. glTF has no TGA, so another model's image replaces it.
const Model PlainDuck = {
    "PlainDuck",
    Duck.file,
    Duck.placement,
    {{"diffuse kd=1", "gltf baseColor=0.9 roughness=0.4"}, {"Collada/duckCM.tga", "OBJ/SpiderTex.jpg"}},
    {{"baseColor=0.9", "baseColor=0.8"}}};

std::string edited(std::string text, const Edits& edits) {
  for (const auto& [before, after] : edits) {
    std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    for (; at != std::string::npos; at = text.find(before, at + after.size())) {
      text.replace(at, before.size(), after);
    }
  }
  return text;
}

/// Removes the extras of a JSON object recursively.
void remove_extras(nlohmann::json& json) {
  if (json.is_object()) json.erase("extras");
  for (nlohmann::json& part : json) {
    if (part.is_structured()) remove_extras(part);
  }
}

class ConversionPictures : public test::Bpt, public testing::WithParamInterface<Model> {
 protected:
  static constexpr int Renders = 8;

  /// Writes the model as GRF, with the author's surfaces, on a floor under a light. Returns the scene.
  std::string set_stage() {
    convert(GetParam().file, path("original.grf"));
    text_ = edited(test::bytes_of(path("original.grf")), GetParam().surfaces);
    return stage("model.grf", text_);
  }

  /// Writes the same stage with another value of one parameter.
  std::string set_changed_stage() { return stage("changed.grf", edited(text_, GetParam().change)); }

  static void convert(const std::string& from, const std::string& to) {
    const test::Outcome outcome = test::grfconvert({from, "-o", to});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  /// Computes statistics of renders with seeds that no other image has.
  BlockStatistics pictures_of(const std::string& scene) {
    BlockStatistics statistics;
    const std::string options = write(
        "view.op", fmt::format("BPT_Scene {}\nBPT_Viewer 1.5 1.5 3\nBPT_VLook 0 0.6 0\nBPT_FieldOfView 35\n"
                               "BPT_Background 0.2 0.22 0.25\n",
                               scene));
    const std::string image = path("image.exr");
    for (int i = 0; i < Renders; ++i) {
      const test::Outcome outcome = bpt({"render", options, "--size", "48x40", "--samples", "24", "--depth",
                                         "3", "--seed", std::to_string(++seed_), "--output", image});
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      grf::Diagnostics diagnostics;
      const auto picture = image::read_image(image, diagnostics);
      EXPECT_TRUE(picture.has_value()) << diagnostics.to_text();
      if (picture) statistics.add(*picture);
    }
    return statistics;
  }

  static double significance() { return statistics::significance(BlockStatistics::Tests * 12); }

 private:
  // The floor's BRDF is one that glTF has.
  std::string stage(const std::string& name, const std::string& model) {
    write(name, model);
    return write("stage_" + name, fmt::format(R"(
def floor = brdf gltf baseColor=(0.6, 0.6, 0.55) roughness=1
begin
  light begin rgb (12, 11, 10) (-2, 3, 1) (1, 0, 0) (0, 0.4, 1.2) end
  transform {} begin include "{}" end
  begin mesh "floor" brdf floor
    begin vertexs (-9, 0, 9) (9, 0, 9) (9, 0, -9) (-9, 0, -9) end vertexs
    begin faces (0, 1, 2, 3) end faces
  end mesh
end
)",
                                              GetParam().placement, name));
  }

  std::string text_;
  int seed_ = 0;
};

// A change of one parameter is detected: the test can fail.
TEST_P(ConversionPictures, AreTheSameByWayOfGltf) {
  const std::string scene = set_stage();
  const BlockStatistics pictures = pictures_of(scene);
  for (const std::string kind : {"gltf", "glb"}) {
    convert(scene, path("stage." + kind));
    convert(path("stage." + kind), path(kind + ".grf"));
    EXPECT_GT(least_p_value(pictures_of(path(kind + ".grf")), pictures), significance()) << kind;
  }
  EXPECT_LT(least_p_value(pictures_of(set_changed_stage()), pictures), significance());
}

INSTANTIATE_TEST_SUITE_P(Models, ConversionPictures, testing::Values(Horse, Duck, Engine),
                         testing::PrintToStringParamName());

using PicturesWithoutExtras = ConversionPictures;

// The glTF material alone reproduces metallic-roughness BRDFs, up to noise.
TEST_P(PicturesWithoutExtras, AreTheSameIfGltfHasTheBrdfs) {
  const std::string scene = set_stage();
  const BlockStatistics pictures = pictures_of(scene);
  convert(scene, path("stage.gltf"));
  nlohmann::json gltf = nlohmann::json::parse(test::bytes_of(path("stage.gltf")));
  remove_extras(gltf);
  convert(write("plain.gltf", gltf.dump()), path("plain.grf"));
  EXPECT_GT(least_p_value(pictures_of(path("plain.grf")), pictures), significance());
  EXPECT_LT(least_p_value(pictures_of(set_changed_stage()), pictures), significance());
}

INSTANTIATE_TEST_SUITE_P(Models, PicturesWithoutExtras, testing::Values(Engine, PlainDuck),
                         testing::PrintToStringParamName());

}  // namespace
