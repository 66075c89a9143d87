#include "renderer/reflectance/presets.h"

#include <algorithm>
#include <cassert>

namespace reflectance {

const PresetTable& thesis_models() {
  static const PresetTable table = {
      "Thesis, table 5.5",
      {{"ashikhmin", "ashikhmin ex=25 ey=25 Rs=0.39 Rd=0.6"},
       {"beardmaxwell", "beardmaxwell omega=1 tau=0 nreal=0.37 nimag=2.82 Rs=0.4 Rd=0.75 Rv=0.5"},
       {"blinn", "blinn n=100 ks=1 kd=0.67"},
       {"coupled", "coupled Rm=1 R0=0.05"},
       {"he", "he sigma=0.5 tau=3 lambda=800"},
       {"lafortune", "lafortune Cx=-1 Cy=-1 Cz=1 n=100 kp=0.96"},
       {"lewis", "lewis n=100 ks=1 kd=0"},
       {"minnaert", "minnaert k=0.8 kd=1"},
       {"oren", "oren s=0 r=1"},
       {"phong", "phong n=100 ks=0.4 kd=0.6"},
       {"poulin", "poulin d=2 h=0.01 n=100 ks=0.8 kd=0.2"},
       {"schlick-d", "schlick SC=0.7 Sr=0.31 Sp=1 Ly=true DC=1 Dr=0 Dp=1"},
       {"schlick-s", "schlick SC=0.7 Sr=0.31 Sp=1 Ly=false"},
       {"strauss", "strauss s=0.76 m=0.91 ks=0.64 kd=0.5"},
       {"torrance", "torrance rough=0.35 nreal=0.617 nimag=2.63 ks=0.7 kd=0.3"},
       {"ward", "ward sx=0.2 sy=0.2 ks=0.5 kd=0.5"}}};
  return table;
}

const std::vector<PresetTable>& preset_tables() {
  static const std::vector<PresetTable> tables = {
      thesis_models(),
      {"Thesis, table 2.1: dielectrics",
       {{"ice", "torrance rough=0.05 nreal=1.31 nimag=0 ks=1 kd=0"},
        {"water", "torrance rough=0.05 nreal=1.333 nimag=0 ks=1 kd=0"},
        {"quartz", "torrance rough=0.05 nreal=1.46 nimag=0 ks=1 kd=0"},
        {"crystal", "torrance rough=0.05 nreal=1.55 nimag=0 ks=1 kd=0"},
        {"diamond", "torrance rough=0.05 nreal=2.42 nimag=0 ks=1 kd=0"}}},
      {"Thesis, table 2.2: metals",
       {{"gold", "torrance rough=0.2 nreal=0.37 nimag=2.82 ks=(1, 0.78, 0.34) kd=0"},
        {"silver", "torrance rough=0.2 nreal=0.177 nimag=3.638 ks=(1, 0.98, 0.94) kd=0"},
        {"copper", "torrance rough=0.2 nreal=0.617 nimag=2.63 ks=(1, 0.68, 0.54) kd=0"},
        {"iron", "torrance rough=0.2 nreal=2.485 nimag=3.433 ks=(1, 0.99, 0.97) kd=0"}}},
      // Reflectances at normal incidence in linear sRGB: Akenine-Moller et al. 2018, "Real-Time Rendering",
      // table 9.2.
      {"Metals (GGX)",
       {{"polished aluminium", "ggx alpha=0.02 F0=(0.913, 0.922, 0.924)"},
        {"blasted aluminium", "ggx alpha=0.4 F0=(0.913, 0.922, 0.924)"},
        {"brushed steel", "ggx alpha=0.25 anisotropy=0.8 F0=(0.562, 0.565, 0.578)"},
        {"cast iron", "ggx alpha=0.5 F0=(0.562, 0.565, 0.578)"},
        {"chromium plate", "ggx alpha=0.005 F0=(0.549, 0.556, 0.554)"},
        {"polished copper", "ggx alpha=0.05 F0=(0.955, 0.638, 0.538)"},
        {"satin brass", "ggx alpha=0.15 F0=(0.91, 0.778, 0.423)"},
        {"satin gold", "ggx alpha=0.15 F0=(1, 0.782, 0.344)"},
        {"satin nickel", "ggx alpha=0.2 F0=(0.66, 0.609, 0.526)"},
        {"platinum", "ggx alpha=0.1 F0=(0.673, 0.637, 0.585)"},
        {"polished silver", "ggx alpha=0.03 F0=(0.972, 0.96, 0.915)"},
        {"titanium", "ggx alpha=0.25 F0=(0.542, 0.497, 0.449)"}}},
      // Oxides on titanium and iron (Diamanti, Del Curto and Pedeferri 2008), a film of soap or oil, and a
      // coat of magnesium fluoride on glass.
      {"Thin films",
       {{"titanium, anodised bronze",
         "thinfilm alpha=0.15 thickness=26 film=2.4 nreal=(2.74, 2.54, 2.2) "
         "nimag=(2.96, 2.9, 2.6)"},
        {"titanium, anodised blue",
         "thinfilm alpha=0.15 thickness=52 film=2.4 nreal=(2.74, 2.54, 2.2) "
         "nimag=(2.96, 2.9, 2.6)"},
        {"titanium, anodised gold",
         "thinfilm alpha=0.15 thickness=114 film=2.4 nreal=(2.74, 2.54, 2.2) "
         "nimag=(2.96, 2.9, 2.6)"},
        {"titanium, anodised magenta",
         "thinfilm alpha=0.15 thickness=142 film=2.4 nreal=(2.74, 2.54, 2.2) "
         "nimag=(2.96, 2.9, 2.6)"},
        {"steel, tempered straw",
         "thinfilm alpha=0.1 thickness=24 film=2.4 nreal=(2.9, 2.9, 2.6) "
         "nimag=(3, 2.95, 2.6)"},
        {"steel, tempered blue",
         "thinfilm alpha=0.1 thickness=54 film=2.4 nreal=(2.9, 2.9, 2.6) "
         "nimag=(3, 2.95, 2.6)"},
        {"soap bubble", "thinfilm alpha=0.001 thickness=380 film=1.33 nreal=1"},
        {"oil on water", "thinfilm alpha=0.01 thickness=300 film=1.47 nreal=1.33"},
        {"pearl",
         "0.6 diffuse kd=(0.95, 0.92, 0.9) + 0.4 thinfilm alpha=0.25 thickness=420 film=1.7 nreal=2.4"},
        {"coated lens", "thinfilm alpha=0.001 thickness=100 film=1.38 nreal=1.52"}}},
      {"Matt surfaces (EON)",
       {{"chalk", "eon rough=0.9 kd=0.9"},
        {"charcoal", "eon rough=0.9 kd=0.03"},
        {"concrete", "eon rough=0.9 kd=0.35"},
        {"fired clay", "eon rough=0.8 kd=(0.62, 0.25, 0.14)"},
        {"paper", "eon rough=0.2 kd=0.82"},
        {"plaster", "eon rough=0.6 kd=0.8"}}},
      // A coat over a matt base, in models that leave to the base what the coat does not reflect.
      {"Plastics and paints",
       {{"car paint, metallic red",
         "0.6 ashikhmin ex=2000 Rs=0.06 Rd=(0.5, 0.02, 0.02) + 0.4 ggx alpha=0.35 F0=(0.75, 0.06, 0.05)"},
        {"glazed ceramic", "coupled Rm=(0.85, 0.83, 0.78) R0=0.04"},
        {"matt plastic", "ashikhmin ex=12 Rs=0.04 Rd=(0.1, 0.25, 0.5)"},
        {"rubber", "ashikhmin ex=4 Rs=0.04 Rd=0.03"},
        {"varnished wood", "ashikhmin ex=300 Rs=0.04 Rd=(0.4, 0.2, 0.08)"}}},
      {"OpenPBR",
       {{"anodised aluminium, violet",
         "openpbr metalness=1 baseColor=(0.9, 0.9, 0.92) roughness=0.35 anisotropy=0.5 filmWeight=1 "
         "filmThickness=0.21 filmIor=1.77"},
        {"car paint, blue",
         "openpbr baseColor=(0.03, 0.12, 0.5) metalness=0.6 roughness=0.45 coatWeight=1 coatRoughness=0.02 "
         "coatIor=1.5"},
        {"lacquered copper",
         "openpbr metalness=1 baseColor=(0.955, 0.638, 0.538) specularColor=(0.9, 0.97, 1) roughness=0.3 "
         "coatWeight=1 coatColor=(1, 0.85, 0.6) coatRoughness=0.1"},
        {"velvet, black",
         "openpbr baseColor=0.02 diffuseRough=0.8 roughness=0.8 fuzzWeight=1 fuzzColor=0.4 "
         "fuzzRoughness=0.2"}}},
      // Colours are those of panes of some millimetres, and of solids by their thickness in the scene's unit.
      {"Glass",
       {{"window pane", "glass thin=true colour=0.98"},
        {"tinted pane", "glass thin=true colour=(0.45, 0.55, 0.52)"},
        {"clear solid", "glass"},
        {"green bottle", "glass ior=1.52 colour=(0.2, 0.6, 0.3) distance=0.1"},
        {"water, solid", "glass ior=1.333 colour=(0.7, 0.9, 0.95) distance=1"},
        {"diamond, solid", "glass ior=2.42"}}},
      // Cloth with a pile shines towards grazing over a dark base; satin has long threads on one side.
      {"Fabrics",
       {{"felt", "oren s=0.6 r=0.6"},
        {"velvet", "ashikhmin ex=1 ey=1 Rs=0.2 Rd=0.2"},
        {"velvet, crimson",
         "0.5 eon rough=0.8 kd=(0.22, 0.01, 0.02) + 0.5 sheen rough=0.35 ks=(0.9, 0.3, 0.35)"},
        {"satin, ivory",
         "0.6 diffuse kd=(0.8, 0.72, 0.6) + 0.4 ggx alpha=0.25 anisotropy=0.8 F0=(0.9, 0.85, 0.75)"},
        {"microfibre", "0.6 eon rough=0.7 kd=(0.35, 0.33, 0.3) + 0.4 sheen rough=0.6"}}}};
  return tables;
}

std::string thesis_model(std::string_view name) {
  const std::vector<Preset>& presets = thesis_models().presets;
  const auto found = std::find_if(presets.begin(), presets.end(),
                                  [name](const Preset& preset) { return preset.name == name; });
  assert(found != presets.end());
  return std::string(found->brdf);
}

}  // namespace reflectance
