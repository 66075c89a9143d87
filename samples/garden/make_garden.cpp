// Writes the garden: its scene, of meshes that are defined once and used many times, and the picture of its
// paving. The same on every machine.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "grf/read.h"
#include "grf/write.h"
#include "renderer/image/image_file.h"
#include "samples/shapes/scene_text.h"

namespace {

using shape::MeshText;
using shape::Random;
using shape::V3d;

constexpr double Pi = std::numbers::pi;

/// Horizontally, from the angle about the y axis.
V3d towards(double angle) { return {std::cos(angle), 0, std::sin(angle)}; }

constexpr V3d Up = {0, 1, 0};

/// About evenly over a disc's area where it begins at 0.
V3d horizontal(Random& random, double nearest, double farthest) {
  const double share = std::sqrt(random(0, 1));
  return towards(random(0, 2 * Pi)) * (nearest + (farthest - nearest) * share);
}

V3d in_cube(Random& random) {
  const double x = random(-1, 1);
  const double y = random(-1, 1);
  return {x, y, random(-1, 1)};
}

constexpr double Thousandths = 1000;

std::string text_of(const V3d& v) { return shape::text_of(v, Thousandths); }

/// A mesh whose vertices have colours.
class Plant : public MeshText {
 public:
  Plant() : MeshText(Thousandths) {}
  int add(const V3d& position, const V3d& colour) { return add_vertex(position, "rgb " + text_of(colour)); }
  std::string definition(const std::string& name) const { return "def " + name + " = " + block("brdf leaf"); }
};

Plant tuft() {
  Random random(1);
  Plant plant;
  for (int i = 0; i < 34; ++i) {
    const V3d root = horizontal(random, 0, 0.26);
    const V3d lean = horizontal(random, 0.03, 0.16);
    const V3d side = horizontal(random, 0.008, 0.014);
    const double height = random(0.13, 0.34);
    const double dry = random(0, 1);
    const V3d low(0.03, 0.07, 0.015);
    const V3d high = V3d(0.17, 0.36, 0.05) * (1 - dry) + V3d(0.38, 0.46, 0.1) * dry;
    const V3d middle = root + lean * 0.35 + Up * (0.6 * height);
    const int first = plant.add(root - side, low);
    plant.add(root + side, low);
    plant.add(middle + side * 0.8, high * 0.7);
    plant.add(middle - side * 0.8, high * 0.7);
    plant.add(root + lean + Up * height, high);
    plant.add_face({first, first + 1, first + 2, first + 3});
    plant.add_face({first + 3, first + 2, first + 4});
  }
  return plant;
}

void add_stem(Plant& plant, double height) {
  const V3d green(0.1, 0.22, 0.04);
  for (int i = 0; i < 6; ++i)
    plant.add(towards(2 * Pi * (i % 3) / 3) * 0.009 + Up * (i < 3 ? 0.0 : height), green);
  for (int i = 0; i < 3; ++i) plant.add_face({i, i + 3, (i + 1) % 3 + 3, (i + 1) % 3});
}

/// Petals around a button, with the stem's foot in the origin.
Plant flower(int petals, double length, double rise, const V3d& inner, const V3d& outer, const V3d& button) {
  constexpr double Height = 0.42;
  Plant plant;
  add_stem(plant, Height);
  for (int i = 0; i < petals; ++i) {
    const double angle = 2 * Pi * i / petals;
    const V3d out = towards(angle) * length;
    const V3d side = towards(angle + Pi / 2) * (length * std::sin(Pi / petals) * 0.95);
    const V3d centre = Up * (Height + 0.004 * (i % 2));
    const int first = plant.add(centre, inner);
    plant.add(centre + out * 0.65 - side + Up * (rise * 0.5), outer);
    plant.add(centre + out + Up * rise, outer);
    plant.add(centre + out * 0.65 + side + Up * (rise * 0.5), outer);
    plant.add_face({first, first + 3, first + 2, first + 1});
  }
  const int top = plant.add(Up * (Height + 0.04), button);
  for (int i = 0; i < 6; ++i)
    plant.add(towards(Pi * i / 3) * (length * 0.28) + Up * (Height + 0.012), button * 0.7);
  for (int i = 0; i < 6; ++i) plant.add_face({top, top + 1 + (i + 1) % 6, top + 1 + i});
  return plant;
}

/// What lets no light through a tree: a dark ball.
void add_core(Plant& plant) {
  constexpr int Rows = 8;
  constexpr int Columns = 16;
  for (int i = 0; i <= Rows; ++i) {
    const double theta = Pi * i / Rows;
    for (int k = 0; k < Columns; ++k) {
      plant.add((towards(-2 * Pi * k / Columns) * std::sin(theta) + Up * std::cos(theta)) * 0.86,
                {0.02, 0.05, 0.012});
    }
  }
  for (int i = 0; i < Rows; ++i) {
    for (int k = 0; k < Columns; ++k) {
      const int beside = (k + 1) % Columns;
      std::vector<int> corners = {i * Columns + k, (i + 1) * Columns + k};
      if (i + 1 < Rows) corners.push_back((i + 1) * Columns + beside);
      if (i > 0) corners.push_back(i * Columns + beside);
      plant.add_face(corners);
    }
  }
}

/// A ball of leaves of radius 1, clipped to shape, about the origin.
Plant box_tree() {
  Random random(2);
  Plant plant;
  add_core(plant);
  constexpr int Leaves = 1700;
  for (int i = 0; i < Leaves; ++i) {
    const double y = 1 - 2 * (i + 0.5) / Leaves;
    const V3d out = (towards(i * 2.399963) * std::sqrt(1 - y * y) + Up * y).normalized();
    const V3d centre = out * random(0.86, 1);
    const V3d tilt = in_cube(random);
    const double length = random(0.05, 0.085);
    const V3d along = (out * 0.5 + tilt).normalized() * length;
    const V3d across = along.cross(in_cube(random)).normalized() * 0.036;
    const double young = random(0, 1);
    const V3d base = V3d(0.03, 0.08, 0.02);
    const V3d tip = V3d(0.1, 0.24, 0.04) * (1 - young) + V3d(0.26, 0.4, 0.08) * young;
    const int first = plant.add(centre - along, base);
    plant.add(centre + across, tip * 0.8);
    plant.add(centre + along, tip);
    plant.add(centre - across, tip * 0.8);
    plant.add_face({first, first + 1, first + 2, first + 3});
  }
  return plant;
}

/// A turned pot of radius 1 at its rim that stands on the ground, with the picture once around it.
std::string pot() {
  constexpr std::array<std::array<double, 2>, 12> Profile = {{{0.5, 0},
                                                              {0.62, 0},
                                                              {0.66, 0.06},
                                                              {0.74, 0.4},
                                                              {0.84, 0.8},
                                                              {0.9, 1.1},
                                                              {0.92, 1.14},
                                                              {1, 1.16},
                                                              {1, 1.34},
                                                              {0.9, 1.36},
                                                              {0.86, 1.3},
                                                              {0.8, 1.1}}};
  constexpr int Sides = 48;
  MeshText mesh(Thousandths);
  for (int i = 0; i <= Sides; ++i) {
    for (std::size_t k = 0; k < Profile.size(); ++k) {
      const V3d position = towards(-2 * Pi * i / Sides) * Profile[k][0] + Up * Profile[k][1];
      const auto& before = Profile[k == 0 ? 0 : k - 1];
      const auto& after = Profile[std::min(k + 1, Profile.size() - 1)];
      const V3d normal =
          (towards(-2 * Pi * i / Sides) * (after[1] - before[1]) - Up * (after[0] - before[0]));
      mesh.add_vertex(position, "normal " + text_of(normal.normalized()));
    }
  }
  const int rows = static_cast<int>(Profile.size());
  for (int i = 0; i < Sides; ++i) {
    for (int k = 0; k + 1 < rows; ++k) {
      const int at = i * rows + k;
      mesh.add_face({at, at + rows, at + rows + 1, at + 1});
    }
  }
  return mesh.block("\"pot\" brdf glaze");
}

std::string quad(const std::string& attributes, double left, double back, double right, double front,
                 double y, double repeats) {
  MeshText mesh(Thousandths);
  const auto add_corner = [&](double x, double z) {
    mesh.add_vertex({x, y, z}, fmt::format("uv ({:g}, {:g})", x * repeats, -z * repeats));
  };
  add_corner(left, front);
  add_corner(right, front);
  add_corner(right, back);
  add_corner(left, back);
  mesh.add_face({0, 1, 2, 3});
  return mesh.block(attributes);
}

std::string use(const std::string& name, double scale, double turn, const V3d& place) {
  return fmt::format("transform scale {} rotation {} translation {} begin use {} end\n", text_of(V3d(scale)),
                     text_of({0, turn, 0}), text_of(place), name);
}

/// The paved path runs from the viewer to the back.
bool is_lawn(const V3d& place) { return std::abs(place.x) > 1.62; }

/// Uses of some of these in places of the lawn by lot.
std::string strewn(const std::vector<std::string>& names, int count, Random& random) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double x = random(-8, 8);
    const V3d place(x, 0, random(-11, 3.2));
    const double scale = random(0.75, 1.25);
    const double turn = random(0, 2 * Pi);
    const auto kind = static_cast<std::size_t>(random(0, static_cast<double>(names.size())));
    if (is_lawn(place)) text += use(names.at(kind), scale, turn, place);
  }
  return text;
}

std::string lawn() {
  Random random(3);
  const std::string grass = strewn({"tuft"}, 2600, random);
  return grass + strewn({"poppy", "daisy", "cornflower"}, 420, random);
}

std::string trees() {
  std::string text;
  for (const double z : {1.2, -2.2, -5.6, -9.0}) {
    for (const double x : {-2.25, 2.25}) {
      text += "transform scale (0.42, 0.46, 0.42) translation " + text_of({x, 0, z}) + " begin use pot end\n";
      text += use("box_tree", 0.6, 1.3 * z + x, {x, 1.08, z});
    }
  }
  for (int i = 0; i < 15; ++i)
    text += use("box_tree", 1.5, 0.7 * i, {1.5 * (i - 7), 0.9 + 0.1 * (i % 3), -13});
  return text;
}

std::string scene() {
  const V3d white(0.85, 0.83, 0.78);
  std::string text =
      "// A garden in the sun: made by make_garden. Grass, flowers, pots and trees are meshes that are "
      "defined\n"
      "// once, with colours at their vertices, and used many times; the path has a texture.\n"
      "def leaf = brdf diffuse kd=1\n"
      "def glaze = brdf ashikhmin ex=120 Rs=0.05 Rd=(0.08, 0.2, 0.4)\n"
      "def stone = brdf lewis n=30 ks=0.06 kd=0.9\n"
      "def soil = brdf diffuse kd=(0.09, 0.11, 0.04)\n";
  text += tuft().definition("tuft");
  text += flower(5, 0.11, 0.07, {0.3, 0.02, 0.01}, {0.8, 0.07, 0.03}, {0.06, 0.05, 0.04}).definition("poppy");
  text += flower(11, 0.1, 0.015, white, white, {0.8, 0.5, 0.05}).definition("daisy");
  text +=
      flower(8, 0.085, 0.04, {0.12, 0.1, 0.5}, {0.16, 0.24, 0.8}, {0.2, 0.06, 0.4}).definition("cornflower");
  text += box_tree().definition("box_tree");
  text += "def pot = " + pot() + "begin\n";
  text += quad("\"ground\" brdf soil", -60, -60, 60, 20, 0, 0);
  text += quad("\"path\" brdf stone texture \"paving.png\"", -1.5, -11, 1.5, 6, 0.02, 1 / 1.5);
  return text + lawn() + trees() + "end\n";
}

/// Slabs in rows that are shifted by half, with gaps, flecks and a shade of their own; it repeats.
image::Image paving() {
  constexpr int Size = 256;
  Random random(4);
  std::array<double, 16> shades = {};
  for (double& shade : shades) shade = random(0.75, 1.05);
  image::Image image{Size, Size, {}};
  for (int y = 0; y < Size; ++y) {
    const int row = y / 64;
    for (int x = 0; x < Size; ++x) {
      const int along = (x + 64 * (row % 2)) % Size;
      const int slab = row * 2 + along / 128;
      const int edge = std::min({along % 128, 127 - along % 128, y % 64, 63 - y % 64});
      const double joint = std::clamp((edge - 1) / 3.0, 0.0, 1.0);
      const double fleck = std::round(random(-3, 3)) * 0.012;
      const double shade = shades.at(static_cast<std::size_t>(slab)) + fleck;
      const V3d colour = V3d(0.52, 0.44, 0.35) * (shade * joint) + V3d(0.1, 0.1, 0.06) * (1 - joint);
      image.pixels.emplace_back(colour);
    }
  }
  return image;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: make_garden FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  grf::Diagnostics diagnostics;
  const auto garden = grf::read_text(scene(), folder + "/garden.grf", diagnostics);
  const bool is_written = garden && grf::write(*garden, folder + "/garden.grf", diagnostics) &&
                          image::write_image({paving()}, folder + "/paving.png", diagnostics);
  if (!is_written) fmt::print(stderr, "{}", diagnostics.to_text());
  return is_written ? 0 : 1;
}
