#include <array>

#include "converters/gltf/gltf_materials.h"

namespace convert {
namespace {

/// The table of conversions by `GltfMaterials`.
constexpr std::array<MaterialRule, 29> GltfRules = {{
    {"metallic-roughness", "`gltf` with its values, without those that are defaults of the BRDF",
     "\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 0.5, 0.25, 1], \"metallicFactor\": 0.5, "
     "\"roughnessFactor\": 0.25}",
     "gltf baseColor=(1, 0.5, 0.25) metallic=0.5 roughness=0.25", ""},
    {"absent values", "the defaults of glTF, `metallic=1 roughness=1`", "\"name\": \"plain\"",
     "gltf metallic=1 roughness=1", ""},
    {"`roughnessFactor` = 0", "`roughness=0`, a highlight that is blurred by 0.01 degrees",
     "\"pbrMetallicRoughness\": {\"roughnessFactor\": 0}", "gltf metallic=1 roughness=0", ""},
    {"`KHR_materials_ior`", "`ior`",
     "\"extensions\": {\"KHR_materials_ior\": {\"ior\": 3}}, \"pbrMetallicRoughness\": "
     "{\"metallicFactor\": 0}",
     "gltf roughness=1 ior=3", ""},
    {"the same, `ior` = 0 or over 10", "a factor of `specularColor`",
     "\"extensions\": {\"KHR_materials_ior\": {\"ior\": 0}, \"KHR_materials_specular\": "
     "{\"specularColorFactor\": [0.5, 0.5, 0.5]}}, \"pbrMetallicRoughness\": {\"metallicFactor\": 0}",
     "gltf roughness=1 specularColor=12.5", ""},
    {"`KHR_materials_specular`", "`specular` and `specularColor`",
     "\"extensions\": {\"KHR_materials_specular\": {\"specularFactor\": 0.5, \"specularColorFactor\": "
     "[1, 2, 4]}}, \"pbrMetallicRoughness\": {\"metallicFactor\": 0}",
     "gltf roughness=1 specular=0.5 specularColor=(1, 2, 4)", ""},
    {"the same, `specularFactor` = 0 and metallic = 0, without coat and sheen",
     "`diffuse kd=baseColor`, which is the same",
     "\"extensions\": {\"KHR_materials_specular\": {\"specularFactor\": 0}}, \"pbrMetallicRoughness\": "
     "{\"metallicFactor\": 0}",
     "diffuse kd=1", ""},
    {"`KHR_materials_anisotropy`",
     "`anisotropy` and `rotation`, about the direction in which u of the texture coordinates grows",
     "\"extensions\": {\"KHR_materials_anisotropy\": {\"anisotropyStrength\": 0.5, "
     "\"anisotropyRotation\": -0.25}}",
     "gltf metallic=1 roughness=1 anisotropy=0.5 rotation=-0.25", ""},
    {"`KHR_materials_clearcoat`", "`clearcoat` and `coatRoughness`",
     "\"extensions\": {\"KHR_materials_clearcoat\": {\"clearcoatFactor\": 0.5, "
     "\"clearcoatRoughnessFactor\": 0.25}}",
     "gltf metallic=1 roughness=1 clearcoat=0.5 coatRoughness=0.25", ""},
    {"`KHR_materials_sheen`",
     "`sheenColor` and `sheenRoughness`, at least 0.01; the shape of its lobe differs",
     "\"extensions\": {\"KHR_materials_sheen\": {\"sheenColorFactor\": [0.5, 0.25, 0], "
     "\"sheenRoughnessFactor\": 0.75}}",
     "gltf metallic=1 roughness=1 sheenColor=(0.5, 0.25, 0) sheenRoughness=0.75", ""},
    {"`KHR_materials_iridescence`",
     "`iridescence`, `iridescenceIor` to 3, and `filmThickness`, which is the largest one, from 10 to 1000 "
     "nm",
     "\"extensions\": {\"KHR_materials_iridescence\": {\"iridescenceFactor\": 0.5, \"iridescenceIor\": "
     "1.5, \"iridescenceThicknessMaximum\": 250}}",
     "gltf metallic=1 roughness=1 iridescence=0.5 iridescenceIor=1.5 filmThickness=250", ""},
    {"`KHR_materials_pbrSpecularGlossiness`",
     "read instead of metallic-roughness: `gltf baseColor=D specularColor=25*F0 roughness=1-glossiness`",
     "\"extensions\": {\"KHR_materials_pbrSpecularGlossiness\": {\"diffuseFactor\": [0.5, 0.5, 0.5, 1], "
     "\"specularFactor\": [0.25, 0.25, 0.25], \"glossinessFactor\": 0.75}}",
     "gltf baseColor=0.5 roughness=0.25 specularColor=6.25", ""},
    {"`KHR_materials_unlit`", "`diffuse kd=baseColor`, lost",
     "\"extensions\": {\"KHR_materials_unlit\": {}}, \"pbrMetallicRoughness\": {\"baseColorFactor\": "
     "[0.5, 0.5, 0.5, 1]}",
     "diffuse kd=0.5", "unlit shading"},
    {"`baseColorTexture`", "`texture`, which multiplies all of the BRDF",
     "\"pbrMetallicRoughness\": {\"metallicFactor\": 0, \"baseColorTexture\": {\"index\": 0}}",
     "gltf roughness=1 texture \"wood.png\"", ""},
    {"`emissiveFactor` times `emissiveStrength` > 0", "`light rgb` on the faces",
     "\"emissiveFactor\": [1, 0.5, 0], \"extensions\": {\"KHR_materials_emissive_strength\": "
     "{\"emissiveStrength\": 8}}",
     "gltf metallic=1 roughness=1 light rgb (8, 4, 0)", ""},
    {"`emissiveTexture`", "lost, and the emission with it",
     "\"emissiveFactor\": [1, 1, 1], \"emissiveTexture\": {\"index\": 0}", "gltf metallic=1 roughness=1",
     "map of emission"},
    {"`alphaMode` `BLEND`, a base colour of alpha a", "`opacity a`",
     "\"alphaMode\": \"BLEND\", \"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 1, 1, 0.25]}",
     "gltf metallic=1 roughness=1 opacity 0.25", ""},
    {"the same with `baseColorTexture`", "`opacity blend a`",
     "\"alphaMode\": \"BLEND\", \"pbrMetallicRoughness\": {\"baseColorTexture\": {\"index\": 0}}",
     "gltf metallic=1 roughness=1 texture \"wood.png\" opacity blend 1", ""},
    {"`alphaMode` `MASK` with `baseColorTexture`", "`opacity mask alphaCutoff/a`; without it all or nothing",
     "\"alphaMode\": \"MASK\", \"alphaCutoff\": 0.25, \"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 1, "
     "1, "
     "0.5], \"baseColorTexture\": {\"index\": 0}}",
     "gltf metallic=1 roughness=1 texture \"wood.png\" opacity mask 0.5", ""},
    {"`metallicRoughnessTexture`", "the images of `metallic`, its blue, and of `roughness`, its green",
     "\"pbrMetallicRoughness\": {\"roughnessFactor\": 0.5, \"metallicRoughnessTexture\": {\"index\": 0}}",
     "gltf metallic=texture \"wood.png\" b roughness=texture \"wood.png\" g * 0.5", ""},
    {"textures of specular, clearcoat, sheen and iridescence", "images of their parameters",
     "\"extensions\": {\"KHR_materials_clearcoat\": {\"clearcoatFactor\": 0.5, \"clearcoatTexture\": "
     "{\"index\": 0}}}",
     "gltf metallic=1 roughness=1 clearcoat=texture \"wood.png\" r * 0.5", ""},
    {"the same with another `texCoord` or transform than the first one, `anisotropyTexture`, a thickness of "
     "films from a minimum above 0",
     "lost",
     "\"extensions\": {\"KHR_materials_anisotropy\": {\"anisotropyStrength\": 0.5, \"anisotropyTexture\": "
     "{\"index\": 0}}}",
     "gltf metallic=1 roughness=1 anisotropy=0.5", "map of a parameter"},
    {"other maps, also of extensions", "lost", "\"normalTexture\": {\"index\": 0}",
     "gltf metallic=1 roughness=1", "normal map"},
    {"`KHR_materials_transmission`, `transmissionFactor` > 0.5",
     "`glass thin=true`, a pane of the base colour; `transmissionFactor` below 1 and `roughnessFactor` are "
     "lost",
     "\"extensions\": {\"KHR_materials_transmission\": {\"transmissionFactor\": 1}}, "
     "\"pbrMetallicRoughness\": "
     "{\"baseColorFactor\": [1, 0.5, 0.25, 1], \"metallicFactor\": 0, \"roughnessFactor\": 0}",
     "glass colour=(1, 0.5, 0.25) thin=true", ""},
    {"the same with `KHR_materials_volume`, `thicknessFactor` > 0",
     "`glass`, a solid; the base colour is lost",
     "\"extensions\": {\"KHR_materials_transmission\": {\"transmissionFactor\": 1}, "
     "\"KHR_materials_volume\": "
     "{\"thicknessFactor\": 1, \"attenuationColor\": [0.5, 1, 1], \"attenuationDistance\": 0.25}}, "
     "\"pbrMetallicRoughness\": {\"metallicFactor\": 0, \"roughnessFactor\": 0}",
     "glass colour=(0.5, 1, 1) distance=0.25", ""},
    {"less transmission", "lost",
     "\"extensions\": {\"KHR_materials_transmission\": {\"transmissionFactor\": 0.25}}",
     "gltf metallic=1 roughness=1", "some of how glass transmits"},
    {"other extensions", "lost", "\"extensions\": {\"KHR_materials_dispersion\": {}}",
     "gltf metallic=1 roughness=1", "what KHR_materials_dispersion says"},
    {"values out of range", "clamped", "\"pbrMetallicRoughness\": {\"roughnessFactor\": 1.5}",
     "gltf metallic=1 roughness=1", "out of range"},
    {"`extras` with a BRDF, and the values that were written with it", "exactly that BRDF",
     "\"extras\": {\"grf\": {\"brdf\": \"oren r=0.5\"}}, \"extensions\": {\"KHR_materials_specular\": "
     "{\"specularFactor\": 0}}, \"pbrMetallicRoughness\": {\"baseColorFactor\": [0.5, 0.5, 0.5, 1], "
     "\"metallicFactor\": 0}",
     "oren r=0.5", ""},
}};

}  // namespace

std::span<const MaterialRule> gltf_material_rules() { return GltfRules; }

}  // namespace convert
