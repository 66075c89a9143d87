// The table of render options, and the lookup of keys.
#include <algorithm>
#include <array>
#include <limits>

#include "grf/keywords.h"
#include "renderer/options/render_options.h"

namespace options {
namespace {

constexpr float Largest = std::numeric_limits<float>::max();

/// Normalises a key: `BPT_Pixel_SampleRes`, `BPT Pixel SampleRes` and `Pixel_SampleRes` are the same.
std::string canonical(std::string_view key) {
  std::string plain = grf::lower_case(key);
  std::replace(plain.begin(), plain.end(), ' ', '_');
  return plain.starts_with("bpt_") ? plain.substr(4) : plain;
}

/// Options of the scene and its image.
std::vector<OptionInfo> image_options() {
  using Options = RenderOptions;
  constexpr float MostStops = 100;
  return {
      {"BPT_Scene", "", PathOption{&Options::scene, false, {"grf", "igrf"}}, "path", "required",
       "the GRF or IGRF scene"},
      {"BPT_Image_Resolution", "--size", SizeOption{&Options::size}, "int int", "500 400",
       "width and height in pixels"},
      {"BPT_Output_Image", "--output",
       PathOption{&Options::output, false, {"exr", "hdr", "pfm", "raw", "png", "jpg", "tga"}, true}, "path",
       "the scene's name with .exr",
       "output image; its extension selects the type: exr, hdr, pfm and raw store linear radiance, png, jpg "
       "and tga 8-bit sRGB"},
      {"BPT_Exposure", "--exposure", NumberOption<float>{&Options::exposure, -MostStops, MostStops}, "float",
       "0", "exposure compensation of 8-bit outputs, in stops; the other types store radiance"},
      {"BPT_Layers", "--layers",
       ListOption{&Options::layers, {"albedo", "normal", "depth", "variance", "error", "samples"}}, "list",
       "none",
       "layers (AOVs) of an exr output, comma-separated: albedo, normal, depth (of the first hit), variance "
       "(of the pixel's mean), error (relative standard error), samples (per pixel); or all, or none"},
  };
}

/// Options of the camera, the environment and baked light.
std::vector<OptionInfo> view_options() {
  using Options = RenderOptions;
  return {
      {"BPT_Viewer", "", PointOption{&Options::eye}, "x y z", "framed to the scene",
       "camera position (eye), in world coordinates"},
      {"BPT_VLook", "", PointOption{&Options::target}, "x y z", "the scene's centre",
       "look-at point of the camera, in world coordinates"},
      {"BPT_Up", "", VectorOption{&Options::up, -Largest}, "x y z", "0 1 0",
       "up vector of the camera; the z axis is used if it is parallel to the view direction"},
      {"BPT_FieldOfView", "", NumberOption<float>{&Options::field_of_view, 0, 180, true}, "float", "45",
       "vertical field of view in degrees"},
      {"BPT_LensRadius", "--lens-radius", NumberOption<float>{&Options::lens_radius, 0, Largest}, "float",
       "0",
       "depth of field: the radius of a thin lens (half its aperture), in world units; 0: a pinhole camera"},
      {"BPT_FocusDistance", "--focus-distance",
       NumberOption<float, std::optional<float>>{&Options::focus_distance, 0, Largest, true}, "float",
       "the distance to BPT_VLook",
       "distance from the camera to the plane in focus, along the view direction, in world units"},
      {"BPT_Cameras", "", CamerasOption{&Options::cameras}, "name x y z x y z x y z float float float",
       "none",
       "cameras with names, one a line: the position, the look-at point, the up vector, the field of view, "
       "the lens "
       "radius and the focus distance (0: to the look-at point), as in the options above"},
      {"BPT_Camera", "--camera", NameOption{&Options::camera}, "name", "none",
       "render by this one of BPT_Cameras; none: by the options above"},
      {"BPT_Frames", "--frames", NumberOption<int>{&Options::frames, 1, 1'000'000}, "int", "1",
       "render an animation of so many images, with the frame's number before the extension: image_0001.exr; "
       "1: a "
       "still image"},
      {"BPT_CameraPath", "--camera-path",
       WordOption{&Options::camera_path, {"turntable", "linear", "smooth"}}, "word", "turntable",
       "camera of an animation: turntable, around the look-at point; linear or smooth (a Catmull-Rom "
       "spline), from "
       "the first of BPT_Cameras through all of them to the last one"},
      {"BPT_Frame", "--frame", NumberOption<int>{&Options::frame, 0, 1'000'000}, "int", "0",
       "render only this frame of an animation, from 1; 0: all frames"},
      {"BPT_Background", "", VectorOption{&Options::background, 0}, "r g b", "0 0 0",
       "constant background radiance where rays leave the scene, W/(sr m2)"},
      {"BPT_EM_Background", "--environment",
       PathOption{&Options::environment, true, {"exr", "hdr", "pfm", "raw", "png", "jpg", "tga", "webp"}},
       "path", "none",
       "environment map or backplate image: exr, hdr, pfm, raw, png, jpg, tga or webp, the 8-bit ones in "
       "sRGB"},
      {"BPT_EM_Projection", "", WordOption{&Options::projection, {"latlong", "backplate"}}, "word", "latlong",
       "latlong: equirectangular environment map that lights the scene, y up, the image's centre looks down "
       "-z, its right is +x; backplate: background image that lights nothing"},
      {"BPT_EM_Rotation", "--environment-rotation",
       NumberOption<float>{&Options::environment_rotation, -360, 360}, "float", "0",
       "rotation of the environment map about the y axis in degrees, counter-clockwise seen from above"},
      {"BPT_EM_Scale", "--environment-scale", NumberOption<float>{&Options::environment_scale, 0, Largest},
       "float", "1", "brightness: a factor of the radiance of the environment map or backplate"},
      {"BPT_RIS", "--ris", PairOption<std::optional<IntegerPair>>{&Options::resampling, 1, 65536, true},
       "int int", "off",
       "M and N of resampled importance sampling (RIS) with an environment map: of M directions sampled from "
       "the BRDF, N are resampled by the radiance of the map"},
      {"BPT_Irradiance", "--irradiance", BooleanOption<bool>{&Options::uses_irradiance}, "bool", "false",
       "use the baked irradiance of an IGRF scene as the light at a path's first diffuse hit"},
  };
}

/// Options of the integrator and its samples.
std::vector<OptionInfo> estimator_options() {
  using Options = RenderOptions;
  constexpr int LargestInt = std::numeric_limits<int>::max();
  constexpr std::uint32_t LargestSeed = std::numeric_limits<std::uint32_t>::max();
  return {
      {"BPT_Integrator", "--integrator", WordOption{&Options::integrator, {"naive", "path"}}, "word", "path",
       "path: path tracing with next-event estimation, lights and BRDFs combined by multiple importance "
       "sampling (MIS); naive: the thesis' estimator, secondary rays by the sampling scheme only, without "
       "light sampling"},
      {"BPT_Depth", "--depth", NumberOption<int>{&Options::depth, 0, LargestInt}, "int", "5",
       "maximum number of bounces (scattering events) of a path: 0 emission only, 1 direct light only"},
      {"BPT_Branches", "--branches", NumberOption<int>{&Options::split_count, 1, 1024}, "int", "2",
       "split count: directions in which a path continues from its first hit that is not purely specular, "
       "for path; 1: no splitting"},
      {"BPT_Samples", "--samples", NumberOption<int, std::optional<int>>{&Options::samples, 1, LargestInt},
       "int", "Pixel_SampleRes product x NSecRaysRoot^2", "samples per pixel, for path"},
      {"BPT_Pixel_SampleRes", "", PairOption<IntegerPair>{&Options::pixel_samples, 1, 4096}, "int int", "1 1",
       "primary rays per pixel, across and down, for naive"},
      {"BPT_Pixel_Random", "", BooleanOption<bool>{&Options::pixel_random}, "bool", "true",
       "jitter primary rays within their cell of the pixel, for naive; if this and BPT_Pixel_Radial are "
       "false, they go through the pixel's centre"},
      {"BPT_Pixel_Radial", "", BooleanOption<bool>{&Options::pixel_radial}, "bool", "false",
       "primary rays on a regular grid in the pixel, for naive; overrides BPT_Pixel_Random"},
      {"BPT_RE_NSecRaysRoot", "", NumberOption<int>{&Options::secondary_rays_root, 1, 10000}, "int", "10",
       "square root of the number of secondary rays per primary hit, for naive"},
      {"BPT_RayCasting", "", BooleanOption<bool>{&Options::ray_casting}, "bool", "false",
       "ray casting: one ray per pixel, coloured by the normal at the nearest hit"},
      {"BPT_Points", "--points", WordOption{&Options::points, {"sobol", "independent"}}, "word", "sobol",
       "sampler: sobol, low-discrepancy points, so that errors are smaller; independent, uniform random "
       "numbers, for comparison"},
      {"BPT_Precision", "--precision", WordOption{&Options::precision, {"float", "double"}}, "word", "float",
       "floating-point precision of BRDF evaluation: double shows the rounding error of float, which is "
       "negligible, and is slower"},
      {"BPT_Seed", "--seed", NumberOption<std::uint32_t>{&Options::seed, 0, LargestSeed}, "int", "0",
       "random seed; the same seed gives the same image, bit for bit"},
  };
}

/// Options that switch effects on and off.
std::vector<OptionInfo> effect_options() {
  using Options = RenderOptions;
  return {
      {"BPT_Only", "--only", ListOption{&Options::only, transport::effect_words()}, "list", "all",
       "effects to render, comma-separated: names of renderer/EFFECTS.md, or groups of them, such as direct"},
      {"BPT_Without", "--without", ListOption{&Options::without, transport::effect_words()}, "list", "none",
       "effects to leave out of these, comma-separated"},
      {"BPT_Kernel", "--kernel", WordOption{&Options::kernel, {"auto", "full"}}, "word", "auto",
       "auto: build, load and run only what the scene, the options and the view need, as `bpt plan` shows; "
       "full: everything, for the same image in more time, also with a target error"},
  };
}

/// Options of termination, checkpoints, threads and display.
std::vector<OptionInfo> running_options() {
  using Options = RenderOptions;
  using Limit = NumberOption<float, std::optional<float>>;
  return {
      {"BPT_TargetError", "--target-error", Limit{&Options::target_error, 0, 1000, true}, "float", "none",
       "stop when the estimated error, sqrt(relMSE) of the image, is at most this: 0.02 is 2 %; without "
       "BPT_Samples, the number of samples is unlimited; bounces that the error does not call for are left "
       "out, "
       "see `bpt plan`"},
      {"BPT_Adaptive", "--adaptive", BooleanOption<bool>{&Options::adaptive}, "bool", "false",
       "adaptive sampling, without bias: more samples where the error is larger; BPT_Samples is then the "
       "mean "
       "over pixels"},
      {"BPT_MaxTime", "--time", Limit{&Options::max_seconds, 0, 1e9F, true}, "float", "none",
       "time limit: stop after this many seconds of rendering and keep the image so far; without "
       "BPT_Samples, "
       "the number of samples is unlimited"},
      {"BPT_Checkpoint", "--checkpoint", PathOption{&Options::checkpoint, true, {}, true}, "path", "none",
       "checkpoint file, written every minute and at the end: the same command resumes from it, and with "
       "more samples also continues a finished render"},
      {"BPT_Threads", "--threads", NumberOption<int>{&Options::threads, 0, 4096}, "int", "0",
       "number of threads; 0: all"},
      {"BPT_DisplayWindow", "", BooleanOption<bool>{&Options::shows_window}, "bool", "false",
       "show the image while it renders, in the editor or the image viewer of this user; if none is open, "
       "start `wannabe --tool image`"},
      {"BPT_DisplayServer", "--display-server", AddressOption{&Options::display_server}, "HOST:PORT", "none",
       "show the image while it renders, in the image viewer at this address or socket, by tev's network "
       "protocol; none is started"},
  };
}

/// Options of the sampling schemes.
std::vector<OptionInfo> scheme_options() {
  using Options = RenderOptions;
  using Real = NumberOption<float, std::optional<float>>;
  using Whole = NumberOption<int, std::optional<int>>;
  using Flag = BooleanOption<std::optional<bool>>;
  using Pair = PairOption<std::optional<IntegerPair>>;
  constexpr float LargestExponent = 1e6F;
  return {
      {"BPT_Pdf_Name", "--pdf",
       WordOption{&Options::scheme,
                  {"Diffuse", "Specular", "Hemisphere", "Sphere", "Anisotropic", "Disk", "Adaptive",
                   "Factored", "CascadeCDF", "Reject", "Own", "Auto"}},
       "word", "the scene's, else Auto",
       "sampling scheme of all BRDFs, overriding the scene's: Diffuse, Specular, Hemisphere, Sphere, "
       "Anisotropic, Disk (or Adaptive), Factored, CascadeCDF, Reject, Own (the BRDF's sampler) or Auto"},
      {"BPT_Pdf_LobeExponent", "", Real{&Options::lobe_exponent, 0, LargestExponent}, "float",
       "the BRDF's own", "exponent of the cosine lobe, for Hemisphere and Sphere"},
      {"BPT_Pdf_AnisoNu", "", Real{&Options::anisotropic_nu, 0, LargestExponent}, "float", "the BRDF's own",
       "exponent along x, for Anisotropic"},
      {"BPT_Pdf_AnisoNv", "", Real{&Options::anisotropic_nv, 0, LargestExponent}, "float", "the BRDF's own",
       "exponent along y, for Anisotropic"},
      {"BPT_Pdf_memstat", "", BooleanOption<bool>{&Options::writes_memory}, "bool", "false",
       "write the memory of the schemes' tables, in bytes, to `mem.op` beside the image"},
      {"BPT_QT_Precomputed", "", Whole{&Options::trees_over_theta, 1, 1000}, "int", "90",
       "number of quadtrees over theta, for Disk"},
      {"BPT_QT_Anisotropic", "", Whole{&Options::trees_over_phi, 0, 1000}, "int", "0",
       "number of quadtrees over phi, for Disk; 0: as many as the BRDF needs"},
      {"BPT_QT_avgnmax", "", Real{&Options::mean_tries, 1, 100, true}, "float", "2",
       "mean number of rejection-sampling tries allowed in a quadtree leaf, for Disk"},
      {"BPT_QT_ImgRes", "", Whole{&Options::tree_resolution, 2, 8192}, "int", "800",
       "resolution of the dense sampling of the disc, for Disk"},
      {"BPT_QT_release", "", Flag{&Options::releases_table}, "bool", "false",
       "free the table of BRDF values once the quadtrees are built, for Disk"},
      {"BPT_Pdf_Factors_ResU", "", Pair{&Options::factors_u, 1, 256}, "int int", "16 16",
       "table resolution over u, theta and phi, for Factored"},
      {"BPT_Pdf_Factors_ResP", "", Pair{&Options::factors_p, 1, 1024}, "int int", "32 16",
       "table resolution over the other direction, theta and phi, for Factored"},
      {"BPT_Pdf_Factors_JK", "", Pair{&Options::factors, 1, 8}, "int int", "2 1",
       "numbers of factors J and K, for Factored"},
      {"BPT_Pdf_Factors_Half", "", Flag{&Options::factors_by_half_vector}, "bool", "false",
       "half-vector parametrisation, for Factored"},
      {"BPT_Pdf_Factors_File", "", PathOption{&Options::factors_file, true, {"txt"}, false, true}, "path",
       "none", "load NAME.txt and NAME_cdf.txt instead of factoring, for Factored"},
      {"BPT_Pdf_CDF_Res", "", Pair{&Options::cdf_resolution, 1, 4096}, "int int", "256 32",
       "table resolution over the half vector, theta and phi, for CascadeCDF"},
      {"BPT_Pdf_CDF_Compress", "", Flag{&Options::compresses_cdf}, "bool", "false",
       "compress the tables, for CascadeCDF"},
  };
}

/// Options that write timings to files.
std::vector<OptionInfo> time_options() {
  using Options = RenderOptions;
  return {
      {"BPT_Chrono_Sampling", "", BooleanOption<bool>{&Options::writes_sampling_time}, "bool", "false",
       "append the seconds that all threads spent sampling directions to `samplingTime` beside the image"},
      {"BPT_Chrono_Rendering", "", BooleanOption<bool>{&Options::writes_rendering_time}, "bool", "false",
       "append the render time in seconds to `renderingTime` beside the image"},
      {"BPT_Chrono_Prebuild", "", BooleanOption<bool>{&Options::writes_prebuild_time}, "bool", "false",
       "append the build time of the tables in seconds to `prebuildTime` beside the image"},
  };
}

}  // namespace

const std::vector<OptionInfo>& option_table() {
  static const std::vector<OptionInfo> table = [] {
    std::vector<OptionInfo> options;
    const auto add = [&](OptionGroup group, const std::vector<OptionInfo>& infos) {
      for (OptionInfo info : infos) {
        info.group = group;
        options.push_back(std::move(info));
      }
    };
    add(OptionGroup::Image, image_options());
    add(OptionGroup::View, view_options());
    add(OptionGroup::Estimator, estimator_options());
    add(OptionGroup::Effects, effect_options());
    add(OptionGroup::Running, running_options());
    add(OptionGroup::Scheme, scheme_options());
    add(OptionGroup::Times, time_options());
    return options;
  }();
  return table;
}

std::string_view title_of(OptionGroup group) {
  static constexpr std::array<std::string_view, 7> Titles = {
      "Scene and image",         "Camera and environment", "Integrator", "Effects",
      "Termination and display", "Sampling scheme",        "Timings"};
  return Titles[static_cast<std::size_t>(group)];
}

const OptionInfo* find_option(std::string_view key) {
  const std::string wanted = canonical(key);
  const auto& table = option_table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const OptionInfo& option) { return canonical(option.key) == wanted; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace options
