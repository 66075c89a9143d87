// The table, and what a key means in it.
#include <algorithm>
#include <array>
#include <limits>

#include "grf/keywords.h"
#include "renderer/options/render_options.h"

namespace options {
namespace {

constexpr float Largest = std::numeric_limits<float>::max();

/// `BPT_Pixel_SampleRes`, `BPT Pixel SampleRes` and `Pixel_SampleRes` are the same key.
std::string canonical(std::string_view key) {
  std::string plain = grf::lower_case(key);
  std::replace(plain.begin(), plain.end(), ' ', '_');
  return plain.starts_with("bpt_") ? plain.substr(4) : plain;
}

/// Of the scene and its image.
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
       "the image; the extension says the type: exr, hdr, pfm or raw keep radiance, png, jpg or tga have 8 "
       "bits and are encoded in sRGB"},
      {"BPT_Exposure", "--exposure", NumberOption<float>{&Options::exposure, -MostStops, MostStops}, "float",
       "0", "stops by which 8-bit outputs are brightened; the others stay radiance"},
      {"BPT_Layers", "--layers",
       ListOption{&Options::layers, {"albedo", "normal", "depth", "variance", "samples"}}, "list", "none",
       "what an exr output holds besides, with commas between: albedo, normal, depth (of the first hit), "
       "variance (of the pixel's mean), samples (how many it has); or all, or none"},
  };
}

/// Of the eye and the light.
std::vector<OptionInfo> view_options() {
  using Options = RenderOptions;
  return {
      {"BPT_Viewer", "", PlaceOption{&Options::viewer}, "x y z", "framed to the scene",
       "the eye, in world coordinates"},
      {"BPT_VLook", "", PlaceOption{&Options::target}, "x y z", "the scene's centre", "the point looked at"},
      {"BPT_Up", "", VectorOption{&Options::up, -Largest}, "x y z", "0 1 0",
       "the direction up; where it is parallel to the view, the z axis"},
      {"BPT_FieldOfView", "", NumberOption<float>{&Options::field_of_view, 0, 180, true}, "float", "45",
       "vertical field of view in degrees"},
      {"BPT_Background", "", VectorOption{&Options::background, 0}, "r g b", "0 0 0",
       "radiance that comes from where nothing is, W/(sr m2)"},
      {"BPT_EM_Background", "--environment",
       PathOption{&Options::environment, true, {"exr", "hdr", "pfm", "raw", "png", "jpg", "tga"}}, "path",
       "none",
       "environment map or background image: exr, hdr, pfm, raw, png, jpg or tga, the 8-bit ones in sRGB"},
      {"BPT_EM_Projection", "", WordOption{&Options::projection, {"latlong", "backplate"}}, "word", "latlong",
       "latlong: light from all around, y up, the image's centre looks down -z, its right is +x; backplate: "
       "a plain image behind the scene that lights nothing"},
      {"BPT_RIS", "--ris", PairOption<std::optional<IntegerPair>>{&Options::resampling, 1, 65536, true},
       "int int", "off",
       "M and N of resampled importance sampling with an environment map: N of M directions that follow the "
       "BRDF are chosen by the light from them"},
      {"BPT_Irradiance", "--irradiance", BooleanOption<bool>{&Options::uses_irradiance}, "bool", "false",
       "take the irradiance that an IGRF scene carries as the light at a path's first diffuse hit"},
  };
}

/// Of the estimator and its samples.
std::vector<OptionInfo> estimator_options() {
  using Options = RenderOptions;
  constexpr int LargestInt = std::numeric_limits<int>::max();
  constexpr std::uint32_t LargestSeed = std::numeric_limits<std::uint32_t>::max();
  return {
      {"BPT_Integrator", "--integrator", WordOption{&Options::integrator, {"naive", "path"}}, "word", "path",
       "path: lights and BRDFs are sampled and combined by multiple importance sampling; naive: the thesis' "
       "estimator, secondary rays by the scheme alone and no light sampling"},
      {"BPT_Depth", "--depth", NumberOption<int>{&Options::depth, 0, LargestInt}, "int", "5",
       "the most scattering events on a path: 0 emission only, 1 direct light only"},
      {"BPT_Branches", "--branches", NumberOption<int>{&Options::branches, 1, 1024}, "int", "2",
       "directions in which a path goes on from its first hit that does more than mirror, for path; 1: paths "
       "do not split"},
      {"BPT_Samples", "--samples", NumberOption<int, std::optional<int>>{&Options::samples, 1, LargestInt},
       "int", "Pixel_SampleRes product x NSecRaysRoot^2", "samples a pixel, for path"},
      {"BPT_Pixel_SampleRes", "", PairOption<IntegerPair>{&Options::pixel_samples, 1, 4096}, "int int", "1 1",
       "primary rays a pixel, across and down, for naive"},
      {"BPT_Pixel_Random", "", BooleanOption<bool>{&Options::pixel_random}, "bool", "true",
       "naive places primary rays at random in their part of the pixel; if this and BPT_Pixel_Radial are "
       "false, in the pixel's centre"},
      {"BPT_Pixel_Radial", "", BooleanOption<bool>{&Options::pixel_radial}, "bool", "false",
       "naive places primary rays regularly; wins over BPT_Pixel_Random"},
      {"BPT_RE_NSecRaysRoot", "", NumberOption<int>{&Options::secondary_rays_root, 1, 10000}, "int", "10",
       "square root of the number of secondary rays for each primary hit, for naive"},
      {"BPT_RayCasting", "", BooleanOption<bool>{&Options::ray_casting}, "bool", "false",
       "one ray a pixel, its colour the normal at the nearest hit"},
      {"BPT_Points", "--points", WordOption{&Options::points, {"sobol", "independent"}}, "word", "sobol",
       "random numbers of a pixel's samples: sobol, well spread together, so that errors are smaller; "
       "independent, which studies compare with"},
      {"BPT_Precision", "--precision", WordOption{&Options::precision, {"float", "double"}}, "word", "float",
       "of the BRDFs' formulas: double shows what float loses, which is next to nothing, and takes longer"},
      {"BPT_Seed", "--seed", NumberOption<std::uint32_t>{&Options::seed, 0, LargestSeed}, "int", "0",
       "the same seed gives the same image, bit for bit"},
  };
}

/// Of what is in the image, and what of the program makes it.
std::vector<OptionInfo> effect_options() {
  using Options = RenderOptions;
  return {
      {"BPT_Only", "--only", ListOption{&Options::only, transport::effect_words()}, "list", "all",
       "the effects that may be in the image, with commas between: names of renderer/EFFECTS.md, or groups "
       "of "
       "them, such as direct"},
      {"BPT_Without", "--without", ListOption{&Options::without, transport::effect_words()}, "list", "none",
       "those of them that are left out all the same"},
      {"BPT_Kernel", "--kernel", WordOption{&Options::kernel, {"auto", "full"}}, "word", "auto",
       "auto: build, load and run only what the scene, the options and the view call for, as `bpt plan` "
       "tells; full: all, for the same image in more time"},
  };
}

/// Of how long a render goes on, and who sees it.
std::vector<OptionInfo> running_options() {
  using Options = RenderOptions;
  using Limit = NumberOption<float, std::optional<float>>;
  return {
      {"BPT_TargetError", "--target-error", Limit{&Options::target_error, 0, 1000, true}, "float", "none",
       "stop once the estimated error, sqrt(relMSE) of the image, is no more than this: 0.02 is 2 %; without "
       "BPT_Samples, after as many samples as that takes"},
      {"BPT_Adaptive", "--adaptive", BooleanOption<bool>{&Options::adaptive}, "bool", "false",
       "more samples where the error is, without bias: BPT_Samples is then the mean over pixels"},
      {"BPT_MaxTime", "--time", Limit{&Options::max_seconds, 0, 1e9F, true}, "float", "none",
       "stop after so many seconds of rendering, with what there is; without BPT_Samples, not before"},
      {"BPT_Checkpoint", "--checkpoint", PathOption{&Options::checkpoint, true, {}, true}, "path", "none",
       "where to keep what a render resumes from, every minute and at its end: the same command goes on from "
       "it, "
       "and with more samples from a finished one too"},
      {"BPT_Threads", "--threads", NumberOption<int>{&Options::threads, 0, 4096}, "int", "0",
       "threads to use; 0: all"},
      {"BPT_DisplayWindow", "", BooleanOption<bool>{&Options::shows_window}, "bool", "false",
       "show the image as it forms, in the viewer that listens at 127.0.0.1:14158; if none does, `wannabe "
       "--tool image` is started"},
      {"BPT_DisplayServer", "--display-server", AddressOption{&Options::display_server}, "HOST:PORT", "none",
       "show the image as it forms in that viewer, which speaks tev's network protocol; none is started"},
  };
}

/// Of the sampling schemes.
std::vector<OptionInfo> scheme_options() {
  using Options = RenderOptions;
  using Real = NumberOption<float, std::optional<float>>;
  using Whole = NumberOption<int, std::optional<int>>;
  using Flag = BooleanOption<std::optional<bool>>;
  using Pair = PairOption<std::optional<IntegerPair>>;
  constexpr float LargestExponent = 1e6F;
  return {
      {"BPT_Pdf_Name", "--pdf",
       WordOption{&Options::name,
                  {"Diffuse", "Specular", "Hemisphere", "Sphere", "Anisotropic", "Disk", "Adaptive",
                   "Factored", "CascadeCDF", "Reject", "Own", "Auto"}},
       "word", "the scene's, else Auto",
       "the sampling scheme of all BRDFs, in place of the scene's: Diffuse, Specular, Hemisphere, Sphere, "
       "Anisotropic, Disk (or Adaptive), Factored, CascadeCDF, Reject, Own (the BRDF's sampler) or Auto"},
      {"BPT_Pdf_LobeExponent", "", Real{&Options::lobe_exponent, 0, LargestExponent}, "float",
       "the BRDF's own", "exponent for Hemisphere and Sphere"},
      {"BPT_Pdf_AnisoNu", "", Real{&Options::anisotropic_nu, 0, LargestExponent}, "float", "the BRDF's own",
       "exponent along x for Anisotropic"},
      {"BPT_Pdf_AnisoNv", "", Real{&Options::anisotropic_nv, 0, LargestExponent}, "float", "the BRDF's own",
       "exponent along y for Anisotropic"},
      {"BPT_Pdf_memstat", "", BooleanOption<bool>{&Options::writes_memory}, "bool", "false",
       "write the bytes that the tables of the schemes hold to `mem.op` beside the image"},
      {"BPT_QT_Precomputed", "", Whole{&Options::trees_over_theta, 1, 1000}, "int", "90",
       "quadtrees over theta for Disk"},
      {"BPT_QT_Anisotropic", "", Whole{&Options::trees_over_phi, 0, 1000}, "int", "0",
       "quadtrees over phi for Disk; 0: as many as the BRDF needs"},
      {"BPT_QT_avgnmax", "", Real{&Options::mean_tries, 1, 100, true}, "float", "2",
       "the mean number of tries that a leaf of a quadtree may need, for Disk"},
      {"BPT_QT_ImgRes", "", Whole{&Options::tree_resolution, 2, 8192}, "int", "800",
       "resolution of the dense sampling of the disc for Disk"},
      {"BPT_QT_release", "", Flag{&Options::releases_table}, "bool", "false",
       "free the table of BRDF values once the trees stand, for Disk"},
      {"BPT_Pdf_Factors_ResU", "", Pair{&Options::factors_u, 1, 256}, "int int", "16 16",
       "resolution over u for Factored, theta and phi"},
      {"BPT_Pdf_Factors_ResP", "", Pair{&Options::factors_p, 1, 1024}, "int int", "32 16",
       "resolution over the other direction for Factored, theta and phi"},
      {"BPT_Pdf_Factors_JK", "", Pair{&Options::factors, 1, 8}, "int int", "2 1",
       "number of factors J and K for Factored"},
      {"BPT_Pdf_Factors_Half", "", Flag{&Options::factors_by_half_vector}, "bool", "false",
       "parametrise by the half vector, for Factored"},
      {"BPT_Pdf_Factors_File", "", PathOption{&Options::factors_file, true, {"txt"}, false, true}, "path",
       "none", "for Factored, load NAME.txt and NAME_cdf.txt instead of factoring"},
      {"BPT_Pdf_CDF_Res", "", Pair{&Options::cdf_resolution, 1, 4096}, "int int", "256 32",
       "resolution over the half vector for CascadeCDF, theta and phi"},
      {"BPT_Pdf_CDF_Compress", "", Flag{&Options::compresses_cdf}, "bool", "false",
       "compress the tables of CascadeCDF"},
  };
}

/// Of what is written down about the time that a render takes.
std::vector<OptionInfo> time_options() {
  using Options = RenderOptions;
  return {
      {"BPT_Chrono_Sampling", "", BooleanOption<bool>{&Options::writes_sampling_time}, "bool", "false",
       "append the seconds that all threads spent in drawing directions to `samplingTime` beside the image"},
      {"BPT_Chrono_Rendering", "", BooleanOption<bool>{&Options::writes_rendering_time}, "bool", "false",
       "append the seconds of the render to `renderingTime` beside the image"},
      {"BPT_Chrono_Prebuild", "", BooleanOption<bool>{&Options::writes_prebuild_time}, "bool", "false",
       "append the seconds that building the tables took to `prebuildTime` beside the image"},
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
      "Scene and image", "View and light", "Estimator", "Effects", "Running", "Sampling scheme", "Times"};
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
