#include "converters/renderers/renderer_materials.h"

#include <array>

namespace convert {
namespace {

constexpr std::string_view TableLoss = "a table in place of its BRDF's formula";

constexpr std::array PbrtMaterials = {
    MaterialRule{"`diffuse`, if no channel is over 1",
                 "`diffuse`; `reflectance` is `kd` times the colour. It is a spectrum in pbrt, whose light "
                 "after several reflections is of more saturated colour than that of RGB",
                 "rgb (0.5, 1, 1) brdf diffuse kd=0.5", R"("diffuse" ] "rgb reflectance" [ 0.25 0.5 0.5 ])",
                 ""},
    MaterialRule{
        "`ggx` with `scattering=single`, one `alpha`, the same `nreal` and `nimag` in all channels, "
        "`ks` and the colour 1",
        "`conductor`; `eta` is `nreal`, `k` is `nimag`, `roughness` is `alpha`, and `remaproughness` is "
        "false. It is the same formula",
        "brdf ggx alpha=0.25 nreal=1.5 nimag=2 scattering=single",
        R"("spectrum eta" [ 300 1.5 900 1.5 ] "spectrum k" [ 300 2 900 2 ])", ""},
    MaterialRule{"`glass`",
                 "`dielectric`, and `thindielectric` for a pane; `eta` is `ior`, and the colour is lost",
                 "brdf glass ior=1.25 colour=0.5 thin=true", R"([ "thindielectric" ] "float eta" [ 1.25 ])",
                 "colour of its glass"},
    MaterialRule{
        "`specular`, and delta parts of one reflectance at all angles",
        "`mix` with a smooth `conductor`; `amount` is the largest channel of the reflectance, which is "
        "exact for grey ones. A coloured one has Fresnel's rise near grazing in pbrt",
        "brdf specular ks=0.75", R"("float amount" [ 0.75 ])", ""},
    MaterialRule{"delta parts that depend on the angle, as of `coupled`",
                 "the same with the mean reflectance over the hemisphere, weighted by the cosine",
                 "brdf coupled Rm=0.5 R0=0.05", R"("string type" [ "mix" ])", "specular (delta) part"},
    MaterialRule{
        "all others, and weighted sums, layers and measured data",
        "`measured`, with a table of spectra that includes the colour; a mean error of up to 1 % of the "
        "mean value is sought",
        "brdf ward sx=0.2 sy=0.2 ks=0.3 kd=0.2", R"("measured" ] "string filename")", TableLoss},
    MaterialRule{"faces that emit and have no BRDF", "`diffuse` with `reflectance` 0", "light rgb (4, 2, 1)",
                 R"("rgb reflectance" [ 0 0 0 ])", ""},
    MaterialRule{"`light rgb` of a face, lights",
                 "`AreaLightSource \"diffuse\"`; `L` is the radiance as RGB, of which pbrt's default sensor "
                 "makes the same RGB",
                 "light rgb (4, 2, 1)", R"(AreaLightSource "diffuse" "rgb L" [ 4 2 1 ])", ""},
    MaterialRule{"`texture` of a diffuse face",
                 "`reflectance` is an `imagemap`, an image in linear RGB that includes `kd` and the colour",
                 R"(brdf diffuse kd=0.5 texture "wood.png")", R"("texture reflectance")", ""},
    MaterialRule{"`texture` of other faces", "the mean colour of the image",
                 R"(brdf lewis n=20 texture "wood.png")", R"("measured" ])", "mean colour of its texture"},
    MaterialRule{"`opacity` with a number", "`alpha` of the shape", "brdf diffuse kd=0.5 opacity 0.25",
                 R"("float alpha" [ 0.25 ])", ""},
    MaterialRule{"`opacity` with `mask` or `blend`", "`alpha` of the shape is an `imagemap` of the opacity",
                 R"(brdf diffuse kd=0.5 texture "wood.png" opacity mask 0.5)", R"("texture alpha")", ""},
};

constexpr std::array MitsubaMaterials = {
    MaterialRule{"all of these", "within `twosided`, since reflection is that of both sides in GRF",
                 "brdf diffuse kd=0.5", R"(<bsdf type="twosided" id="material_1">)", ""},
    MaterialRule{"`diffuse`, if no channel is over 1",
                 "`diffuse`; `reflectance` is `kd` times the colour. It is the same formula",
                 "rgb (0.5, 1, 1) brdf diffuse kd=0.5", R"(<rgb name="reflectance" value="0.25 0.5 0.5"/>)",
                 ""},
    MaterialRule{"`glass`",
                 "`dielectric`, and `thindielectric` for a pane, without `twosided`; `int_ior` is `ior`, and "
                 "`specular_transmittance` the colour of a pane; that of a solid is lost",
                 "brdf glass ior=1.25 colour=0.5 thin=true",
                 R"(<rgb name="specular_transmittance" value="0.5 0.5 0.5"/>)", ""},
    MaterialRule{"`specular`",
                 "`conductor` with `material` `none`; `specular_reflectance` is `ks` times the colour",
                 "brdf specular ks=(0.75, 0.5, 0.25)",
                 R"(<rgb name="specular_reflectance" value="0.75 0.5 0.25"/>)", ""},
    MaterialRule{"`specular` in a sum, and delta parts that depend on the angle, as of `coupled`",
                 "`blendbsdf` of the rest and such a `conductor`; `weight` is the largest channel of the "
                 "reflectance, or of its mean over the hemisphere, weighted by the cosine, and the rest is "
                 "tabulated over 1 - `weight`",
                 "brdf coupled Rm=0.5 R0=0.05", R"(<bsdf type="blendbsdf">)", "specular (delta) part"},
    MaterialRule{"all others, and weighted sums, layers and measured data",
                 "`measured`, with a table in RGB, which the RGB variants of Mitsuba read, that includes the "
                 "colour; a mean error of up to 1 % of the mean value is sought",
                 "brdf ward sx=0.2 sy=0.2 ks=0.3 kd=0.2", R"(<bsdf type="measured">)", TableLoss},
    MaterialRule{
        "`ggx`", "`measured`, since shadowing and masking of `roughconductor` are not correlated in Mitsuba",
        "brdf ggx alpha=0.25 nreal=1.5 nimag=2 scattering=single", R"(<bsdf type="measured">)", TableLoss},
    MaterialRule{"faces that emit and have no BRDF", "`diffuse` with `reflectance` 0", "light rgb (4, 2, 1)",
                 R"(<rgb name="reflectance" value="0 0 0"/>)", ""},
    MaterialRule{"`light rgb` of a face, lights", "`area`; `radiance` is the radiance", "light rgb (4, 2, 1)",
                 R"(<rgb name="radiance" value="4 2 1"/>)", ""},
    MaterialRule{"`texture` of a diffuse face",
                 "`reflectance` is a `bitmap`, an image in linear RGB that includes `kd` and the colour",
                 R"(brdf diffuse kd=0.5 texture "wood.png")", R"(<texture type="bitmap" name="reflectance">)",
                 ""},
    MaterialRule{"`texture` of other faces", "the mean colour of the image",
                 R"(brdf lewis n=20 texture "wood.png")", R"(<bsdf type="measured">)",
                 "mean colour of its texture"},
    MaterialRule{"`opacity` with a number", "`mask`", "brdf diffuse kd=0.5 opacity 0.25",
                 R"(<float name="opacity" value="0.25"/>)", ""},
    MaterialRule{"`opacity` with `mask` or `blend`", "`mask`; `opacity` is a `bitmap` of the opacity",
                 R"(brdf diffuse kd=0.5 texture "wood.png" opacity mask 0.5)",
                 R"(<texture type="bitmap" name="opacity">)", ""},
    MaterialRule{"`opacity` of a face that emits", "`mask`, which does not change the emission",
                 "light rgb (4, 2, 1) opacity 0.5", R"(<bsdf type="mask">)", "its opacity"},
};

}  // namespace

std::span<const MaterialRule> pbrt_materials() { return PbrtMaterials; }
std::span<const MaterialRule> mitsuba_materials() { return MitsubaMaterials; }

}  // namespace convert
