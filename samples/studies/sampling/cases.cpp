#include "samples/studies/sampling/cases.h"

#include <fmt/format.h>

#include "renderer/reflectance/presets.h"

namespace study {

std::string scheme_text(const FactorParameters& p) {
  return fmt::format("factored uTh=16 uPh=16 pTh={} pPh={} J={} K={} half={}", p.rows, p.columns, p.j, p.k,
                     p.half);
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"ashikhmin",
       reflectance::thesis_model("ashikhmin"),
       {57.61, 83.46, 3.12, {1188.3, 0.103, 0.103, 0.103}, 6.25, 1031, {32, 16, 1, 2, false}}},
      {"beardmaxwell",
       reflectance::thesis_model("beardmaxwell"),
       {49.08, 74.75, 102.9, {1412.8, 28.710, 12.360, 230.332}, 1713.25, 6454, {100, 32, 2, 3, false}}},
      {"blinn",
       reflectance::thesis_model("blinn"),
       {32.12, 45.08, 565.7, {522.410, 6.914, 0.103, 0.103}, 582.25, 6481, {100, 32, 3, 3, true}}},
      {"coupled",
       reflectance::thesis_model("coupled"),
       {51.25, 76.17, 3.21, {322.969, 0.103, 0.103, 0.103}, 6.25, 1033, {32, 16, 1, 3, false}}},
      {"he",
       reflectance::thesis_model("he"),
       {300.8, 452.7, 8.00, {1346.3, 28.711, 10.184, 0.103}, 2407.25, 1034, {32, 16, 2, 1, false}}},
      {"lafortune",
       reflectance::thesis_model("lafortune"),
       {32.33, 40.34, 312.5, {2344.6, 30.891, 11.273, 111.539}, 1275.25, 6445, {100, 32, 2, 2, true}}},
      {"lewis",
       reflectance::thesis_model("lewis"),
       {32.49, 48.86, 312.4, {4701.9, 40.699, 12.363, 304.441}, 1279.25, 6445, {100, 32, 2, 2, true}}},
      {"minnaert",
       reflectance::thesis_model("minnaert"),
       {35.33, 54.28, 3.17, {974.695, 28.711, 9.094, 8.549}, 1461.25, 1031, {32, 16, 1, 2, false}}},
      {"oren",
       reflectance::thesis_model("oren"),
       {28.99, 40.99, 3.08, {0.103, 0.103, 0.103, 0.103}, 6.25, 1033, {32, 16, 1, 3, false}}},
      {"phong",
       reflectance::thesis_model("phong"),
       {29.99, 45.69, 312.3, {2455.7, 21.082, 6.914, 115.898}, 1279.25, 6445, {100, 32, 2, 2, true}}},
      {"poulin",
       reflectance::thesis_model("poulin"),
       {112.7, 160.9, 8.09, {308.801, 6.914, 0.103, 0.103}, 297.25, 1038, {32, 16, 2, 2, false}}},
      {"schlick-d",
       reflectance::thesis_model("schlick-d"),
       {55.17, 82.49, 3.24, {522.410, 9.094, 0.103, 0.103}, 342.25, 1033, {32, 16, 1, 3, true}}},
      {"schlick-s",
       reflectance::thesis_model("schlick-s"),
       {41.65, 63.03, 8.30, {522.410, 9.094, 0.103, 0.103}, 780.25, 1043, {32, 16, 2, 3, false}}},
      {"strauss",
       reflectance::thesis_model("strauss"),
       {38.82, 56.86, 15.36, {380.730, 13.453, 6.914, 15.633}, 727.25, 1052, {32, 16, 3, 3, false}}},
      {"torrance",
       reflectance::thesis_model("torrance"),
       {38.84, 58.43, 2.97, {728.391, 0.103, 0.103, 0.103}, 631.25, 1029, {32, 16, 1, 1, false}}},
      {"ward",
       reflectance::thesis_model("ward"),
       {33.57, 48.99, 26.62, {340.406, 8.004, 4.734, 13.453}, 483.25, 1038, {32, 16, 2, 2, true}}},
  };
  return all;
}

}  // namespace study
