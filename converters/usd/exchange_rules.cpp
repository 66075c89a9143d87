#include "converters/usd/exchange_rules.h"

#include <array>

namespace convert {
namespace {

constexpr std::string_view NearestLoss = "the nearest material in place of its BRDF's formula";

constexpr std::array UsdMaterials = {
    MaterialRule{
        "all BRDFs",
        "a `UsdPreviewSurface` with the values that glTF gets, which is the nearest one, and the nodes "
        "of MaterialX in `outputs:mtlx:surface`",
        "brdf diffuse kd=0.5", "color3f inputs:diffuseColor = (0.5, 0.5, 0.5)", ""},
    MaterialRule{"the same, without a glossy lobe", "`useSpecularWorkflow` 1 with `specularColor` 0",
                 "brdf eon kd=0.5", "color3f inputs:specularColor = (0, 0, 0)", ""},
    MaterialRule{"the same, with a metallic part", "`metallic` and `roughness`",
                 "brdf gltf metallic=0.5 roughness=0.25", "float inputs:metallic = 0.5", ""},
    MaterialRule{"`gltf` with a clear coat", "`clearcoat` and `clearcoatRoughness`",
                 "brdf gltf clearcoat=0.5 coatRoughness=0.25", "float inputs:clearcoat = 0.5", ""},
    MaterialRule{"`glass`", "`opacity` 0 with `opacityMode` `transparent`, and `ior`", "brdf glass ior=1.25",
                 "float inputs:opacity = 0", NearestLoss},
    MaterialRule{"models that MaterialX lacks", "as in MaterialX, with its loss",
                 "brdf ward sx=0.2 sy=0.2 ks=0.3 kd=0.2", "info:id = \"ND_open_pbr_surface_surfaceshader\"",
                 NearestLoss},
    MaterialRule{"`light rgb` of a face, lights that are no rectangles", "`emissiveColor`, the radiance",
                 "light rgb (4, 2, 1)", "color3f inputs:emissiveColor = (4, 2, 1)", ""},
    MaterialRule{"`texture`",
                 "`UsdUVTexture` as `diffuseColor`, with the base colour as its `scale`; `wrapS` and `wrapT` "
                 "are `repeat`. It does not multiply the highlight of a dielectric there",
                 R"(brdf diffuse kd=0.5 texture "wood.png")", "float4 inputs:scale = (0.5, 0.5, 0.5, 1)", ""},
    MaterialRule{"`opacity` with a number", "`opacity`, with `opacityMode` `presence`",
                 "brdf diffuse kd=0.5 opacity 0.25", "float inputs:opacity = 0.25", ""},
    MaterialRule{"`opacity` with `mask`", "`opacityThreshold`, and the texture's `outputs:a`",
                 R"(brdf diffuse kd=0.5 texture "wood.png" opacity mask 0.75)",
                 "float inputs:opacityThreshold = 0.75", ""},
    MaterialRule{"`opacity` with `blend`", "the texture's `outputs:a`, with the factor in its `scale`",
                 R"(brdf diffuse kd=0.5 texture "wood.png" opacity blend 0.25)",
                 "float4 inputs:scale = (0.5, 0.5, 0.5, 0.25)", ""},
};

constexpr std::array MaterialxMaterials = {
    MaterialRule{"`diffuse`", "`oren_nayar_diffuse_bsdf` with `roughness` 0, exactly", "brdf diffuse kd=0.5",
                 R"(<oren_nayar_diffuse_bsdf name="diffuse_node_1" type="BSDF">)", ""},
    MaterialRule{"`eon`", "the same with `energy_compensation`, exactly", "brdf eon rough=0.25 kd=0.5",
                 R"(<input name="energy_compensation" type="boolean" value="true"/>)", ""},
    MaterialRule{"`oren`", "the same without; the fit differs", "brdf oren s=0.25 r=0.5",
                 R"(<input name="roughness" type="float" value="0.25"/>)", NearestLoss},
    MaterialRule{"`sheen`", "`sheen_bsdf` with `mode` `zeltner`, exactly", "brdf sheen rough=0.25 ks=0.5",
                 R"(<input name="mode" type="string" value="zeltner"/>)", ""},
    MaterialRule{"`specular`", "`generalized_schlick_bsdf` of the same reflectance at all angles",
                 "brdf specular ks=0.5", R"(<input name="color90" type="color3" value="0.5, 0.5, 0.5"/>)",
                 ""},
    MaterialRule{"`ggx` with `nreal` and `nimag`, without `anisotropy` and `rotation`",
                 "`conductor_bsdf`; exactly with `scattering=scaled`, as MaterialX has it, and else with "
                 "another lobe of light between facets",
                 "brdf ggx alpha=0.25 nreal=1.5 nimag=2 scattering=scaled",
                 R"(<input name="extinction" type="color3" value="2, 2, 2"/>)", ""},
    MaterialRule{"`ggx` with `F0`", "`generalized_schlick_bsdf` with `color82`, likewise",
                 "brdf ggx alpha=0.25 F0=0.5",
                 R"(<input name="color0" type="color3" value="0.5, 0.5, 0.5"/>)", NearestLoss},
    MaterialRule{"`combine` of these", "`multiply` by the weights, and `add`",
                 "brdf combine 1 soft, 0.5 shiny", R"(<add name="combine_node_4" type="BSDF">)", ""},
    MaterialRule{"`openpbr`", "`open_pbr_surface` with all its values; `rotation` is lost",
                 "brdf openpbr baseColor=0.5 coatWeight=0.25",
                 R"(<input name="coat_weight" type="float" value="0.25"/>)", ""},
    MaterialRule{"`gltf`", "`gltf_pbr` with all its values; fibres have another lobe",
                 "brdf gltf baseColor=0.5 metallic=0.25",
                 R"(<input name="metallic" type="float" value="0.25"/>)", ""},
    MaterialRule{
        "`glass`",
        "`open_pbr_surface` with `transmission_weight` 1 and, of a solid, `transmission_depth`; a pane is "
        "`geometry_thin_walled`",
        "brdf glass ior=1.25 thin=true",
        R"(<input name="geometry_thin_walled" type="boolean" value="true"/>)", NearestLoss},
    MaterialRule{"all others, also layers, and sums with one",
                 "`open_pbr_surface` with the diffuse and the glossy lobe, as for glTF",
                 "brdf ashikhmin ex=30 Rs=0.04 Rd=0.5",
                 R"(<input name="specular_roughness" type="float" value="0.5"/>)", NearestLoss},
    MaterialRule{"`rgb` and `texture` of a face, colours of vertices",
                 "`multiply` of the BSDF by the colour, by an `image`, and by the property `vertexColor`; in "
                 "`open_pbr_surface` and `gltf_pbr` only of the base's colour, with a loss",
                 R"(brdf diffuse kd=0.5 texture "wood.png")",
                 R"(<input name="file" type="filename" value="wood.png" colorspace="srgb_texture"/>)", ""},
    MaterialRule{"`light rgb` of a face, lights",
                 "`uniform_edf`, or `emission_luminance` times `emission_color`, or `emissive`: the radiance",
                 "light rgb (4, 2, 1)", R"(<input name="color" type="color3" value="4, 2, 1"/>)", ""},
    MaterialRule{"`opacity` with a number", "`opacity`, `geometry_opacity` or `alpha`",
                 "brdf diffuse kd=0.5 opacity 0.25", R"(<input name="opacity" type="float" value="0.25"/>)",
                 ""},
    MaterialRule{"`opacity` with `mask`", "`ifgreatereq` of the alpha and the cutoff",
                 R"(brdf diffuse kd=0.5 texture "wood.png" opacity mask 0.75)",
                 R"(<input name="value2" type="float" value="0.75"/>)", ""},
    MaterialRule{"`opacity` with `blend`", "`multiply` of the alpha by the factor",
                 R"(brdf diffuse kd=0.5 texture "wood.png" opacity blend 0.25)",
                 R"(<input name="in2" type="float" value="0.25"/>)", ""},
};

}  // namespace

std::span<const MaterialRule> usd_materials() { return UsdMaterials; }
std::span<const MaterialRule> materialx_materials() { return MaterialxMaterials; }

}  // namespace convert
