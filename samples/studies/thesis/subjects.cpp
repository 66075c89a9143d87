#include "samples/studies/thesis/subjects.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "samples/studies/sampling/cases.h"

namespace study {
namespace {

constexpr const char* Reject = "adaptive mode=reject nQT=60";
constexpr const char* QuickReject = "adaptive mode=reject nQT=20 res=200";

/// Makes the groups of one scene.
class Maker {
 public:
  Maker(const Choice& choice, std::string scene) : choice_(choice), scene_(std::move(scene)) {}

  bool is_quick() const { return choice_.effort.is_quick; }
  std::string part(std::string_view name) const {
    return fmt::format("{}/parts/{}.grf", choice_.folder, name);
  }

  std::string size(int width, int height) const {
    const auto scaled = [&](int pixels) { return std::lround(pixels * choice_.effort.scale()); };
    return fmt::format("BPT_Image_Resolution {} {}\n", scaled(width), scaled(height));
  }

  /// Returns the lines of techniques that need no manual adjustment.
  std::vector<Line> plain_lines() const {
    return {{"uniform", "diffuse"},
            {"reject", is_quick() ? QuickReject : Reject},
            {"warp", "adaptive"},
            {"own", "own"}};
  }

  /// Returns the sample counts of the tables between two.
  static std::vector<int> counts(int first, int last) {
    std::vector<int> some;
    for (const int count : {1, 25, 100, 225, 400, 900, 1600, 2500}) {
      if (count >= first && count <= last) some.push_back(count);
    }
    return some;
  }

  /// Adds a group per integrator, with the sample counts of each.
  void add(Group group, const std::vector<int>& naive, const std::vector<int>& path, int reference_samples) {
    group.scene = scene_;
    const std::string file = group.file.empty() ? scene_ + '_' + group.brdf : group.file;
    for (const bool is_naive : {true, false}) {
      group.integrator = is_naive ? "naive" : "path";
      group.file = file + '_' + group.integrator;
      group.samples = is_naive ? naive : path;
      group.reference_samples = is_quick() ? reference_samples / 4 : reference_samples;
      if (!group.samples.empty()) groups.push_back(group);
    }
  }

  std::vector<Group> groups;

 private:
  const Choice& choice_;
  std::string scene_;
};

std::string lobe(const Choice& choice, const std::string& brdf, std::string_view scheme) {
  return fmt::format("{} exp={:g}", scheme, choice.exponents.at(brdf));
}

std::vector<Line> adjusted_lines(const Choice& choice, const Case& subject) {
  return {{"sphere-best", lobe(choice, subject.name, "sphere")},
          {"hemisphere-best", lobe(choice, subject.name, "hemisphere")},
          {"factored-best", scheme_text(subject.thesis.factors)}};
}

/// Makes one group per BRDF of table 5.5.
std::vector<Group> cornell_boxes(const Choice& choice) {
  Maker maker(choice, "cornell_box");
  for (const Case& subject : cases()) {
    if (!choice.has_brdf(subject.name)) continue;
    Group group;
    group.brdf = subject.name;
    group.parts = {{maker.part("cornell_box"), subject.brdf}};
    group.options = maker.size(48, 48) +
                    "BPT_Viewer 278 273 -800\nBPT_VLook 278 273 0\nBPT_FieldOfView 39.3076\nBPT_Depth "
                    "5\nBPT_Background 0.02 0.02 0.02\n";
    group.lines = maker.plain_lines();
    for (Line& line : adjusted_lines(choice, subject)) group.lines.push_back(std::move(line));
    maker.add(group, Maker::counts(1, maker.is_quick() ? 100 : 225), Maker::counts(1, 100), 1024);
  }
  return maker.groups;
}

std::vector<Group> glossy_spheres(const Choice& choice) {
  Maker maker(choice, "glossy_sphere");
  for (const Case& subject : cases()) {
    if (!choice.has_brdf(subject.name)) continue;
    Group group;
    group.brdf = subject.name;
    group.parts = {{maker.part("glossy_sphere"), subject.brdf}};
    group.options = maker.size(64, 64) +
                    "BPT_Viewer -1.5 2.5 4\nBPT_VLook 0.065 1.64 0.767\nBPT_FieldOfView 9\nBPT_Depth "
                    "1\nBPT_Background 0.02 0.02 0.02\n";
    group.lines = maker.plain_lines();
    for (Line& line : adjusted_lines(choice, subject)) group.lines.push_back(std::move(line));
    const std::vector<Line> constant = {{"sphere", "sphere exp=50"},
                                        {"hemisphere", "hemisphere exp=50"},
                                        {"factored", "factored"},
                                        {"cascade", "cascadeCDF"}};
    group.lines.insert(group.lines.end(), constant.begin(), constant.end());
    maker.add(group, Maker::counts(1, maker.is_quick() ? 225 : 900), Maker::counts(1, 100), 1024);
  }
  return maker.groups;
}

std::vector<Group> dragons(const Choice& choice) {
  Maker maker(choice, "dragon");
  const FactorParameters matte = {32, 16, 1, 3, false};
  const FactorParameters strauss = {32, 16, 3, 3, false};
  const FactorParameters lafortune = {100, 32, 2, 2, true};
  Group group;
  group.brdf = "three";
  group.parts = {{maker.part("dragon_light"), ""},
                 {maker.part("dragon_floor"), "oren s=0.83 r=1"},
                 {maker.part("dragon_wall"), "strauss s=0.76 m=0.91 ks=0.64 kd=0.5"},
                 {choice.data + "/dragon.grf", "lafortune Cx=-1 Cy=-1 Cz=1 n=46 kp=0.96"}};
  group.options = maker.size(200, 200) +
                  "BPT_Viewer 0.9 1.5 4.3\nBPT_VLook 0.05 0.5 0\nBPT_FieldOfView 26\nBPT_Depth 3\n";
  const std::vector<int> naive = {25, 100};
  const std::vector<int> path = {4, 16, 64};
  group.lines = maker.plain_lines();
  maker.add(group, naive, path, 256);
  group.lines = {{"hemisphere-best", ""}};
  group.schemes = {"", "hemisphere exp=1", lobe(choice, "strauss", "hemisphere"),
                   lobe(choice, "lafortune", "hemisphere")};
  group.file = "dragon_hemisphere";
  maker.add(group, naive, path, 256);
  group.lines = {{"factored-best", ""}};
  group.schemes = {"", scheme_text(matte), scheme_text(strauss), scheme_text(lafortune)};
  group.file = "dragon_factored";
  maker.add(group, naive, path, 256);
  return maker.groups;
}

std::string pottery_view(int width, int height, const Maker& maker) {
  return maker.size(width, height) +
         "BPT_Viewer 0 2.4 9\nBPT_VLook 0 0.8 0\nBPT_FieldOfView 19\nBPT_Depth 3\n"
         "BPT_Background 0.1 0.1 0.1\n";
}

/// Returns the jugs with these BRDFs, from left to right.
std::vector<ScenePart> jugs(const Maker& maker, const std::array<std::string, 3>& brdfs) {
  return {{maker.part("pottery_light"), ""},
          {maker.part("left_jug"), brdfs[0]},
          {maker.part("middle_jug"), brdfs[1]},
          {maker.part("right_jug"), brdfs[2]}};
}

std::vector<Group> potteries(const Choice& choice) {
  Maker maker(choice, "pottery");
  Group group;
  group.brdf = "three";
  group.parts = jugs(maker, {"beardmaxwell omega=1 tau=0 nreal=0.37 nimag=2.82 Rs=0.7 Rd=0.5 Rv=0.2",
                             "he sigma=0.5 tau=3 lambda=800", "blinn n=100 ks=1 kd=0.67"});
  group.options = pottery_view(150, 66, maker);
  const std::vector<int> naive = Maker::counts(25, maker.is_quick() ? 225 : 900);
  const std::vector<int> path = Maker::counts(25, maker.is_quick() ? 100 : 225);
  group.lines = maker.plain_lines();
  group.lines.push_back({"hemisphere-best", "hemisphere exp=81"});  // the thesis' own
  group.lines.push_back({"cascade", "cascadeCDF"});
  maker.add(group, naive, path, 1024);
  const auto factored = [](int u_rows, int rows, int columns, int j, int k, bool half) {
    return fmt::format("factored uTh={} uPh=16 pTh={} pPh={} J={} K={} half={}", u_rows, rows, columns, j, k,
                       half);
  };
  group.lines = {{"factored-best", ""}};
  group.schemes = {"", factored(16, 32, 16, 2, 3, false), factored(16, 32, 32, 2, 1, false),
                   factored(16, 100, 32, 2, 2, true)};
  group.file = "pottery_factored";
  maker.add(group, naive, path, 1024);
  group.lines = {{"factored-fine", ""}};
  group.schemes = {"", factored(32, 64, 32, 2, 3, false), factored(32, 64, 32, 2, 1, false),
                   factored(32, 64, 32, 3, 3, true)};
  group.file = "pottery_factored_fine";
  maker.add(group, naive, path, 1024);
  return maker.groups;
}

std::vector<Group> single_jugs(const Choice& choice) {
  Maker maker(choice, "jug");
  const auto found =
      std::find_if(cases().begin(), cases().end(), [](const Case& one) { return one.name == "torrance"; });
  Group group;
  group.brdf = found->name;
  group.parts = {{maker.part("jug"), found->brdf}};
  const std::string view =
      fmt::format("BPT_EM_Background {}/../../environments/studio.exr\n", choice.folder) +
      maker.size(120, 120) +
      "BPT_Viewer 0.4 1.9 4.6\nBPT_VLook 0.02 0.8 0\nBPT_FieldOfView 33\nBPT_Depth 2\n";
  const std::vector<int> counts = Maker::counts(25, maker.is_quick() ? 100 : 225);
  group.options = view;
  group.lines = maker.plain_lines();
  group.lines.push_back({"factored", "factored"});
  group.lines.push_back({"cascade", "cascadeCDF"});
  maker.add(group, counts, counts, 1024);
  group.options = view + "BPT_RIS 8 1\n";
  for (Line& line : group.lines) line.technique += "-ris";
  group.file = "jug_ris";
  maker.add(group, {}, counts, 1024);
  return maker.groups;
}

std::vector<Group> measured_jugs(const Choice& choice) {
  Maker maker(choice, "measured");
  for (const Material& material : materials()) {
    if (!choice.has_brdf(material.name)) continue;
    Group group;
    group.brdf = material.name;
    const std::string brdf = fmt::format("measured \"{}/{}.binary\"", choice.data, material.name);
    group.parts = jugs(maker, {brdf, brdf, brdf});
    group.options = pottery_view(150, 73, maker);
    group.lines = maker.plain_lines();
    // The thesis' memory figures exclude tables of BRDF values.
    for (Line& line : group.lines) {
      if (line.technique == "reject") line.pdf += " release=true";
    }
    group.lines.push_back({"cascade", "cascadeCDF nTh=256 nPh=32"});
    group.lines.push_back({"compressed", maker.is_quick() ? "cascadeCDF nTh=256 nPh=32 compress=true"
                                                          : "cascadeCDF nTh=1024 nPh=256 compress=true"});
    maker.add(group, {25}, {25}, 256);
  }
  return maker.groups;
}

}  // namespace

const std::vector<Material>& materials() {
  static const std::vector<Material> all = {
      {"alum-bronze", "torrance rough=0.2 nreal=1.1 nimag=6 ks=(0.9, 0.75, 0.5) kd=0"},
      {"alumina-oxide", "ashikhmin ex=40 ey=40 Rs=0.05 Rd=0.8"},
      {"beige-fabric", "oren s=0.6 r=(0.62, 0.52, 0.4)"},
      {"blue-metallic-paint2", "torrance rough=0.12 nreal=1.2 nimag=5 ks=0.45 kd=(0.02, 0.05, 0.2)"},
      {"blue-metallic-paint", "torrance rough=0.2 nreal=1.2 nimag=5 ks=0.3 kd=(0.02, 0.06, 0.22)"},
      {"nickel", "torrance rough=0.1 nreal=1.9 nimag=3.6 ks=1 kd=0"},
      {"red-plastic", "ward sx=0.12 sy=0.12 ks=0.06 kd=(0.5, 0.05, 0.04)"},
      {"teflon", "oren s=0.1 r=0.85"},
      {"violet-acrylic", "phong n=300 ks=0.05 kd=(0.18, 0.04, 0.25)"},
      {"white-marble", "ashikhmin ex=300 ey=300 Rs=0.05 Rd=(0.75, 0.73, 0.7)"},
      {"yellow-paint", "oren s=0.25 r=(0.8, 0.6, 0.06)"},
  };
  return all;
}

bool Choice::has_scene(std::string_view name) const {
  return scenes.empty() || std::find(scenes.begin(), scenes.end(), name) != scenes.end();
}

bool Choice::has_brdf(std::string_view name) const {
  return brdfs.empty() || std::find(brdfs.begin(), brdfs.end(), name) != brdfs.end();
}

std::vector<Group> groups(const Choice& choice) {
  using GroupsOf = std::vector<Group> (*)(const Choice&);
  constexpr GroupsOf Makers[] = {cornell_boxes, glossy_spheres, dragons,
                                 potteries,     single_jugs,    measured_jugs};
  std::vector<Group> all;
  for (std::size_t i = 0; i < std::size(SceneNames); ++i) {
    if (!choice.has_scene(SceneNames[i])) continue;
    for (Group& group : Makers[i](choice)) all.push_back(std::move(group));
  }
  return all;
}

std::string scene_text(const Group& group) {
  std::string text;
  for (std::size_t i = 0; i < group.parts.size(); ++i) {
    const ScenePart& piece = group.parts[i];
    if (piece.brdf.empty()) {
      text += fmt::format("include \"{}\"\n", piece.part);
      continue;
    }
    text += fmt::format("def material = brdf {}\ndef scheme = pdf {}\nbegin\n  include \"{}\"\nend\n",
                        piece.brdf, group.schemes.empty() ? "auto" : group.schemes[i], piece.part);
  }
  return text;
}

}  // namespace study
