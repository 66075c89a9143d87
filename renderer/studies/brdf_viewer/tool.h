#pragma once

#include "renderer/studies/brdf_viewer/lit_object.h"
#include "renderer/studies/study.h"

namespace studies {

/// The settings of the BRDF viewer. Angles are in degrees; azimuths are about the y axis, from the z axis
/// towards the x axis, and elevations over the horizontal plane.
struct BrdfViewerSettings {
  enum Shape { Sphere, Teapot, Knot, Model };
  enum Sky { Black, Constant, Studio, Map };

  int shape = Sphere;
  float azimuth = 0;
  float elevation = 15;
  float distance = 1;
  float split = 1;      ///< fraction of the width that shows the first BRDF
  Rgb light1 = Rgb(1);  ///< radiance of a white diffuse surface that faces the light
  float azimuth1 = 30;
  float elevation1 = 40;
  Rgb light2 = Rgb(0);
  float azimuth2 = -60;
  float elevation2 = 20;
  Rgb light3 = Rgb(0);
  float azimuth3 = 160;
  float elevation3 = 30;
  int sky = Studio;
  Rgb radiance = Rgb(1);
  float turned = 0;
  float diffuseness = 1;
  float specularity = 1;
  bool backdrop = false;
  float exposure = 0;
  float samples = 128;

  static reflectance::ModelTable<BrdfViewerSettings> table();

  /// The lights that are on.
  std::vector<reflectance::DistantLight> lights() const;
  int sample_count() const;  ///< a multiple of 4
  /// The view of an object in an image of this aspect.
  transport::View view(const grf::Box3d& bounds, double aspect) const;
};

/// Returns the direction at an azimuth and an elevation, as of the settings, and back.
Vec3f direction_at(double azimuth, double elevation);
struct Heading {
  double azimuth = 0;
  double elevation = 0;
};
Heading heading_of(const Vec3f& direction);

/// Returns whether a file is an image, and so an environment map, by its extension.
bool is_environment_map(const std::string& path);
/// The files of a state: by their extensions, an environment map (EXR, HDR, PFM) and a model.
struct ViewerFiles {
  const ToolState::File* model = nullptr;        ///< null: none
  const ToolState::File* environment = nullptr;  ///< null: none
};
/// Sorts the files of a state; returns nothing after an error, such as a second model.
std::optional<ViewerFiles> files_of(const ToolState& state, grf::Diagnostics& diagnostics);

/// Returns the object of a shape that is not a model's.
grf::Scene scene_of_shape(int shape);

/// The tool `brdfviewer`: BRDFs on an object under lights and an environment (the thesis' section 6.2.2). Its
/// window draws them with GLSL; the figure is shaded on the CPU, with the same formulas.
StudyTool brdf_viewer_tool();

}  // namespace studies
