#pragma once

#include "renderer/reflectance/model.h"
#include "renderer/studies/environment/sampling.h"

namespace studies {

/// The settings of the tool `emviewer`; angles are in degrees, see the table for the others.
struct EnvironmentSettings {
  enum class Show { Map, FCos, Light, Warps, Product, Scheme, Lost };

  float theta = 50;
  float phi = -140;
  float tilt = 0;
  float heading = 90;
  float candidates = 256;
  float samples = 32;
  float seed = 1;
  int show = 0;
  int channel = 0;
  int dots = 0;
  float exposure = 0;
  float azimuth = 50;
  float elevation = 30;
  int visibility = 1;
  bool deviations = true;

  static reflectance::ModelTable<EnvironmentSettings> table();

  Show shown() const { return static_cast<Show>(show); }
  bool is_luminance() const { return channel == 1; }
  bool has_candidates() const { return dots <= 1; }
  bool has_samples() const { return dots % 2 == 0; }
  reflectance::Resampling counts() const;
  Visibility visible_directions() const;
};

}  // namespace studies
