#pragma once

#include <random>
#include <string>
#include <vector>

#include "grf/read.h"
#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/presets.h"

namespace test {

using reflectance::Brdf;
using reflectance::Vec3f;

/// Makes a BRDF from a text such as `ward sx=0.1`; `0.5 ward sx=0.1 + 0.2 specular` is a weighted sum, and
/// `table of ward sx=0.1` a measured table of its values, `utia of ward sx=0.1` those of a file of the UTIA
/// data base, `rgl matte` the file of that name in tests/reflectance/rgl, `measured zemax.bsdf` that in
/// tests/reflectance/measured, and `coat alpha=0.1 over diffuse` or `phong over diffuse` a BRDF below a
/// layer.
Brdf brdf_of(const std::string& text);

/// Reads a scene of definitions and a mesh with this BRDF. `last_end` ends what the definitions begin.
std::optional<grf::Scene> scene_with(const std::string& definitions, const std::string& brdf,
                                     grf::Diagnostics& diagnostics, const std::string& last_end = "end");

/// Makes the BRDF of the only mesh of a scene, or returns nothing after an error.
std::optional<Brdf> brdf_in(const grf::Scene& scene, grf::Diagnostics& diagnostics);

inline grf::ModelInfo info_of(const Brdf& brdf) {
  return std::visit([](const auto& model) { return reflectance::info_of<std::decay_t<decltype(model)>>(); },
                    brdf);
}

/// A BRDF of the thesis' table 5.5, used for its measurements, with the kilobytes of its trees there (table
/// 5.3).
struct ThesisCase {
  std::string brdf;
  double kilobytes = 0;
};
inline const std::vector<ThesisCase>& thesis_cases() {
  static const std::vector<ThesisCase> cases = {
      {reflectance::thesis_model("ashikhmin"), 6.25},   {reflectance::thesis_model("beardmaxwell"), 1713.25},
      {reflectance::thesis_model("blinn"), 582.25},     {reflectance::thesis_model("coupled"), 6.25},
      {reflectance::thesis_model("he"), 2407.25},       {reflectance::thesis_model("lafortune"), 1275.25},
      {reflectance::thesis_model("lewis"), 1279.25},    {reflectance::thesis_model("minnaert"), 1461.25},
      {reflectance::thesis_model("oren"), 6.25},        {reflectance::thesis_model("phong"), 1279.25},
      {reflectance::thesis_model("poulin"), 297.25},    {reflectance::thesis_model("schlick-d"), 342.25},
      {reflectance::thesis_model("schlick-s"), 780.25}, {reflectance::thesis_model("strauss"), 727.25},
      {reflectance::thesis_model("torrance"), 631.25},  {reflectance::thesis_model("ward"), 483.25},
  };
  return cases;
}

/// Returns instances whose lobes a grid can resolve, with those of the thesis' table 5.5.
inline const std::vector<std::string>& plain_cases() {
  static const std::vector<std::string> cases = {
      "diffuse kd=1",
      "phong n=50 ks=0.8 kd=0.5",
      "phong n=100 ks=0.4 kd=0.6",
      "blinn n=100 ks=1 kd=0.67",
      "blinn n=10 ks=0.3 kd=(0.1, 0.5, 0.2)",
      "lewis n=100 ks=1 kd=0",
      "lewis n=20 ks=(0.5, 0.2, 0.1) kd=0.4",
      "ward sx=0.2 ks=0.5 kd=0.5",
      "ward sx=0.15 sy=0.4 ks=0.6 kd=0.3",
      "ward sx=1 ks=1 kd=0",
      "minnaert k=0.8 kd=1",
      "minnaert k=4 kd=(0.9, 0.5, 0.7)",
      "lafortune n=100 kp=0.96",
      "lafortune n=10 kp=(0.2, 0.1, 0.3) Cx=-0.9 Cy=-0.6 Cz=0.8",
      "lafortune n=3 kp=0 Cx=1 Cy=1 Cz=0.9",
      "lafortune n=4 kp=0 Cx=-1 Cy=-1 Cz=-0.5",
      "oren s=0.3 r=1",
      "oren s=0 r=1",
      "oren s=1 r=(0.9, 0.5, 0.2)",
      "eon rough=0.5 kd=1",
      "eon rough=1 kd=(0.9, 0.5, 0.2)",
      "ggx alpha=0.3 nreal=0.617 nimag=2.63",
      "ggx alpha=0.2 ay=0.5 rotation=0.6 F0=(0.9, 0.6, 0.3) F82=0.8",
      "ggx alpha=0.5 scattering=scaled F0=(1, 0.7, 0.4)",
      "ggx alpha=1 scattering=single F0=1",
      "gltf baseColor=(0.8, 0.25, 0.1) roughness=0.35 clearcoat=0.5 clearcoatRoughness=0.3",
      "gltf baseColor=(0.9, 0.5, 0.2) metallic=0.6 roughness=0.7 anisotropy=0.5 rotation=0.4",
      "gltf roughness=1 sheenColor=(0.2, 0.5, 0.9) clearcoat=1 clearcoatRoughness=0.5",
      "gltf roughness=0.2 ior=1.8 specular=0.7 specularColor=(0.5, 1, 2)",
      "gltf baseColor=(0.7, 0.5, 0.3) metallic=0.4 roughness=0.4 iridescence=0.8 filmThickness=300",
      "openpbr baseColor=(0.8, 0.25, 0.1) roughness=0.35 diffuseRough=0.6 coatWeight=0.6 coatRoughness=0.3 "
      "coatColor=(0.9, 0.7, 0.5)",
      "openpbr baseColor=(0.9, 0.5, 0.2) metalness=0.6 specularColor=(0.8, 0.9, 1) roughness=0.7 "
      "anisotropy=0.5 rotation=0.4",
      "openpbr roughness=0.6 fuzzWeight=0.8 fuzzColor=(0.2, 0.5, 0.9) coatWeight=1 coatRoughness=0.5 "
      "coatDarkening=0.5",
      "openpbr baseColor=0.3 metalness=0.4 roughness=0.4 filmWeight=0.7 filmThickness=0.3 specularWeight=0.8",
      "thinfilm alpha=0.1 thickness=350 film=1.5 nreal=2.5 nimag=3.4",
      "thinfilm alpha=0.4 ay=0.2 thickness=500 nreal=1 ks=(1, 0.8, 0.9)",
      "sheen rough=0.3",
      "sheen rough=0.8 ks=(0.9, 0.3, 0.5)",
      "torrance rough=0.35 nreal=0.617 nimag=2.63 ks=0.7 kd=0.3",
      "torrance rough=0.05 nreal=1.5 ks=1 kd=0.2",
      "torrance rough=0.2 nreal=0.37 nimag=2.82 ks=(1, 0.8, 0.4) kd=0",
      "torrance rough=1.5 nreal=2.485 nimag=3.433 ks=1 kd=0",
      "coupled Rm=1 R0=0.05",
      "coupled Rm=(0.9, 0.5, 0.1) R0=(0.3, 0.2, 0.1)",
      "ashikhmin ex=25 Rs=0.39 Rd=0.6",
      "ashikhmin ex=10 ey=100 Rs=(0.5, 0.2, 0.1) Rd=0.5",
      "ashikhmin ex=0 Rs=1 Rd=0",
      "schlick SC=0.7 Sr=0.31",
      "schlick SC=(0.7, 0.3, 0.1) Sr=0.1 Sp=0.4",
      "schlick SC=0.7 Sr=0.31 Ly=true DC=0.5 Dr=0",
      "schlick SC=0.7 Sr=0.31 Sp=1 Ly=true DC=1 Dr=0 Dp=1",
      "schlick SC=0.1 Sr=0 Ly=true DC=(0.9, 0.6, 0.3) Dr=1 Dp=0.7",
      "schlick SC=0.3 Sr=0.05 Ly=true DC=0.8 Dr=0.6",
      "strauss s=0.5 ks=0.5 kd=0.5",
      "strauss s=0.76 m=0.91 ks=0.64 kd=0.5",
      "strauss s=0.9 m=1 ks=1 kd=(0.9, 0.6, 0.3)",
      "strauss s=0 ks=1 kd=0",
      "beardmaxwell omega=1 tau=0 nreal=0.37 nimag=2.82 Rs=0.4 Rd=0.75 Rv=0.5",
      "beardmaxwell omega=0.5 tau=0.4 sigma=1 Rs=1 Rd=0 Rv=0",
      "beardmaxwell Rs=0 Rd=0 Rv=1",
      "kajiya",
      "kajiya sigma=0.1 taux=1 tauy=1 nreal=2.485 nimag=3.433 ks=(0.7, 0.5, 0.3) kd=0.2",
      "hanrahan",
      "hanrahan nreal=1 g=0 albedo=1 depth=1 ks=0 kd=0",
      "hanrahan nreal=1.3 g=-0.7 albedo=(1, 0.6, 0.3) depth=0.2 rough=0.5 ks=0.8 kd=0.1",
      "westin",
      "westin sigma=0.1 tau=3 lambda=500 nreal=1.5 ks=1 kd=0.3",
      "granier",
      "granier nreal=1.4 d=1500 n=40 m=60 tilt=0.2 kd=0.1",
      "poulin d=2 h=0.01 n=100 ks=0.8 kd=0.2",
      "poulin d=3 h=0.3 n=20 ks=(0.5, 0.3, 0.7) kd=0.3",
      "poulin d=0.5 h=0 n=0 ks=1 kd=0",
      "he sigma=0.5 tau=3 lambda=800",
      "he",
      "he sigma=0.05 tau=1 lambda=(700, 500, 400) nreal=0.617 nimag=2.63 kd=0.2",
      "he sigma=4 tau=4 lambda=400",
      "0.5 diffuse kd=0.8 + 0.4 lewis n=60 ks=1 kd=0 + 0.1 specular",
      "0.3 ward sx=0.3 sy=0.15 + 0 phong + 0.7 torrance rough=0.2",
      "coat alpha=0.3 tint=(0.9, 0.5, 0.2) over diffuse kd=0.8",
      "coat alpha=0.2 over ggx alpha=0.4 F0=(0.9, 0.6, 0.3)",
      "ward sx=0.2 sy=0.4 ks=0.5 kd=0 over lewis n=20 ks=0.4 kd=0.4",
  };
  return cases;
}

/// Returns instances with steps that a quadrature may miss.
inline const std::vector<std::string>& stepped_cases() {
  static const std::vector<std::string> cases = {
      "phong n=0 ks=0.2 kd=0",
      "lafortune n=0 kp=0.2 Cx=-1 Cy=-1 Cz=0.3",
      "neumann r=0.3 ry=1.5 ks=0.7 kd=(0.1, 0.2, 0.3)",
      "neumann r=0.5 retro=true",
      "neumann r=2 ks=0.8",
      "table of blinn n=40 ks=0.3 kd=0.3",
      "table of lewis n=400 ks=0.7 kd=(0.1, 0.2, 0.3)",
      "rgl copper",
      "rgl brushed_half",
      "utia of ward sx=0.4 sy=0.7 ks=0.3 kd=0.3",
      "measured zemax.bsdf",
      "measured lighttools.bsdf",
      "measured degrees.astm",
      "measured scattered.csv",
  };
  return cases;
}

/// Returns numerically hard instances.
inline const std::vector<std::string>& hard_cases() {
  static const std::vector<std::string> cases = {
      "phong n=100000",
      "blinn n=100000",
      "lewis n=100000",
      "ward sx=0.001 sy=1",
      "minnaert k=0.5 kd=1",
      "lafortune n=1000000 kp=0 Cx=-1.00006 Cy=-1.00003 Cz=1.00005",
      "lafortune n=1000000 kp=0 Cx=-1 Cy=-0.9 Cz=0.5",
      "lafortune n=29 kp=0 Cx=-10 Cy=-10 Cz=10",
      "lafortune n=69 kp=0 Cx=2.7 Cy=-1 Cz=2",
      "oren s=0.05 r=1",
      "oren s=1 r=1",
      "eon rough=0.001 kd=1",
      "eon rough=1 kd=1",
      "ggx alpha=0.0001 F0=1",
      "gltf roughness=0 metallic=1 anisotropy=1 clearcoat=1",
      "gltf roughness=0 ior=1 sheenColor=1 sheenRoughness=0.01",
      "gltf roughness=1 ior=10 specularColor=25",
      "gltf roughness=0 metallic=0.5 iridescence=1 iridescenceIor=3 filmThickness=1000",
      "openpbr metalness=1 baseColor=1 roughness=0 anisotropy=1 coatWeight=1",
      "openpbr roughness=0 ior=1 fuzzWeight=1 fuzzRoughness=0.01",
      "openpbr roughness=1 ior=10 specularWeight=25 coatWeight=0.5 coatIor=3 coatColor=0",
      "openpbr roughness=0 metalness=0.5 baseColor=1 specularColor=0 filmWeight=1 filmThickness=1 filmIor=3",
      "thinfilm alpha=0.0001 thickness=1000 film=3 nreal=0.001 nimag=100",
      "thinfilm alpha=1 thickness=1 film=1 nreal=1.00001",
      "sheen rough=0.01",
      "ggx alpha=1 ay=0.0001 nreal=0.001 nimag=100",
      "ggx alpha=0.3 anisotropy=1 rotation=3 F0=1",
      "torrance rough=0.0001 nreal=0.177 nimag=3.638 kd=0",
      "torrance rough=0.1 nreal=1.00001 kd=0",
      "torrance rough=1 nreal=0.001 nimag=100 ks=1 kd=0",
      "torrance rough=10 nreal=0.9 ks=1 kd=0",
      "coupled Rm=1 R0=0.999",
      "ashikhmin ex=1000000 ey=0 Rs=0 Rd=0",
      "ashikhmin ex=100000 Rs=1",
      "schlick SC=1 Sr=1e-20 Sp=0",
      "schlick SC=0 Sr=0.0001 Sp=0.001 Ly=true DC=1 Dr=1 Dp=0",
      "strauss s=0.99999 m=1 ks=1 kd=(1, 0, 0)",
      "strauss s=0.001 ks=1 kd=0",
      "neumann r=0.0001 ry=2",
      "neumann r=1.0001 ry=0.9999",
  };
  return cases;
}

/// Returns instances with every parameter at both ends of its range, one at a time, and all at once.
std::vector<std::string> extreme_cases();

/// Returns the direction at an angle from the normal, in degrees.
inline Imath::V3d direction_in_double(double theta_degrees, double phi_degrees) {
  const double theta = theta_degrees * std::numbers::pi / 180;
  const double phi = phi_degrees * std::numbers::pi / 180;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
inline Vec3f direction(double theta_degrees, double phi_degrees) {
  return Vec3f(direction_in_double(theta_degrees, phi_degrees));
}

/// A pair of directions: random, or hard (grazing, equal, mirrored, nearly so, below the horizon).
struct Pair {
  Vec3f u, v;
};
std::vector<Pair> direction_pairs(int count, std::uint32_t seed);

/// Returns pairs for which textbook forms are accurate.
inline std::vector<Pair> easy_pairs() {
  std::vector<Pair> pairs;
  for (const double theta_u : {5.0, 40.0, 75.0}) {
    for (const double theta_v : {10.0, 35.0, 80.0}) {
      for (const double phi : {0.0, 50.0, 130.0, 200.0, 300.0}) {
        pairs.push_back({direction(theta_u, 20), direction(theta_v, phi)});
      }
    }
  }
  return pairs;
}

}  // namespace test
