#include "renderer/reflectance/measurements/bsdf_interchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "grf/cie_colour.h"
#include "grf/wording.h"
#include "renderer/reflectance/measurements/text_tokens.h"

namespace reflectance {
namespace {

constexpr double HalfTurnDegrees = 180;

/// The values of one angle of incidence in one channel, with the angle from the pole fastest.
using Block = std::vector<float>;
using ChannelBlocks = std::array<Block, 3>;

bool is_key(std::string_view word) {
  constexpr std::array<std::string_view, 8> Keys = {"Source",         "Symmetry",       "SpectralContent",
                                                    "ScatterType",    "SampleRotation", "AngleOfIncidence",
                                                    "ScatterAzimuth", "ScatterRadial"};
  return std::find(Keys.begin(), Keys.end(), word) != Keys.end();
}

/// What both formats have before their data.
struct Header {
  bool is_plane_symmetrical = false;
  bool has_tristimulus = false;
  std::vector<double> rotation, incidence, azimuth, polar;

  std::size_t block_size() const { return azimuth.size() * polar.size(); }
};

/// Reads the words of both formats.
class InterchangeReader {
 public:
  InterchangeReader(std::string_view text, const std::string& path, grf::Diagnostics& diagnostics)
      : path_(path), diagnostics_(diagnostics), tokens_(text, path, diagnostics) {}

  std::shared_ptr<const AngleGrid> read_zemax() {
    if (!read_header() || !check_header()) return nullptr;
    if (header_.rotation.size() > 1) {
      tokens_.fail(fmt::format("the sample has {} rotations: data of more than one are not read",
                               header_.rotation.size()));
      return nullptr;
    }
    if (header_.incidence.empty()) return failed("'AngleOfIncidence' is missing");
    blocks_.resize(header_.incidence.size());
    if (!read_zemax_data()) return nullptr;
    GridAxes axes;
    axes.incidence = header_.incidence;
    axes.azimuth = header_.azimuth;
    axes.pole = GridAxes::Pole::Mirror;
    axes.is_mirrored = header_.is_plane_symmetrical;
    return grid_of(std::move(axes));
  }

  std::shared_ptr<const AngleGrid> read_lighttools() {
    if (!read_header() || !check_header() || !read_lighttools_data()) return nullptr;
    GridAxes axes;
    for (auto& [degrees, blocks] : by_incidence_) {
      axes.incidence.push_back(degrees * std::numbers::pi / HalfTurnDegrees);
      blocks_.push_back(std::move(blocks));
    }
    for (const double azimuth : header_.azimuth) axes.azimuth.push_back(azimuth - std::numbers::pi / 2);
    axes.is_mirrored = false;
    return grid_of(std::move(axes));
  }

 private:
  std::nullptr_t failed(const std::string& message) {
    tokens_.fail(message);
    return nullptr;
  }

  bool read_header();
  bool read_key(std::string_view key);
  bool read_symmetry();
  bool check_header();
  bool read_zemax_data();
  bool read_lighttools_data();
  bool read_lighttools_block(std::string_view first);
  bool read_block(Block& block);
  std::optional<std::size_t> channel_of(std::string_view word, std::string_view prefix);
  std::shared_ptr<const AngleGrid> grid_of(GridAxes axes);

  const std::string& path_;
  grf::Diagnostics& diagnostics_;
  TextTokens tokens_;
  Header header_;
  std::vector<ChannelBlocks> blocks_;             ///< by the angle of incidence
  std::map<double, ChannelBlocks> by_incidence_;  ///< in degrees, of LightTools
  std::optional<double> plane_of_incidence_;      ///< of LightTools, in degrees
  std::size_t skipped_ = 0;                       ///< blocks of the back or of transmission
};

bool InterchangeReader::read_symmetry() {
  const std::string_view word = tokens_.next();
  header_.is_plane_symmetrical = word == "PlaneSymmetrical";
  constexpr std::array<std::string_view, 5> Others = {"Asymmetrical", "ASymmetrical", "Asymmetric",
                                                      "Asymmetrical4D", "ASymmetrical4D"};
  return header_.is_plane_symmetrical || std::find(Others.begin(), Others.end(), word) != Others.end() ||
         tokens_.fail(fmt::format("unknown symmetry '{}'", word.substr(0, 40)));
}

bool InterchangeReader::read_key(std::string_view key) {
  if (key == "Source") return tokens_.next().empty() ? tokens_.fail("the file ends after 'Source'") : true;
  if (key == "Symmetry") return read_symmetry();
  if (key == "SampleRotation") return tokens_.angles(key, -360, 360, header_.rotation);
  if (key == "AngleOfIncidence") return tokens_.angles(key, 0, 90, header_.incidence);
  if (key == "ScatterAzimuth") return tokens_.angles(key, 0, 360, header_.azimuth);
  if (key == "ScatterRadial") return tokens_.angles(key, 0, 180, header_.polar);
  const std::string_view word = tokens_.next();
  if (key == "ScatterType") {
    return word == "BRDF" ||
           tokens_.fail(fmt::format("'{}' is no reflection: only BRDF is read", word.substr(0, 40)));
  }
  header_.has_tristimulus = word == "XYZ";
  return header_.has_tristimulus || word == "Monochrome" ||
         tokens_.fail(fmt::format("unknown SpectralContent '{}'", word.substr(0, 40)));
}

bool InterchangeReader::read_header() {
  while (is_key(tokens_.peek())) {
    if (!read_key(tokens_.next())) return false;
  }
  return true;
}

bool InterchangeReader::check_header() {
  for (const auto& [angles, name] :
       {std::pair(&header_.azimuth, "ScatterAzimuth"), std::pair(&header_.polar, "ScatterRadial")}) {
    if (angles->empty()) return tokens_.fail(fmt::format("'{}' is missing", name));
  }
  const double most = header_.is_plane_symmetrical ? std::numbers::pi : 2 * std::numbers::pi;
  if (header_.azimuth.back() > most + 1e-9)
    return tokens_.fail("azimuths of plane-symmetrical data are over 180 degrees");
  const std::size_t angles = std::max<std::size_t>(1, header_.incidence.size());
  return header_.block_size() <= TextTokens::MostValues / angles ||
         tokens_.fail(fmt::format("over {} values", TextTokens::MostValues));
}

bool InterchangeReader::read_block(Block& block) {
  for (std::size_t i = header_.block_size(); i > 0; --i) {
    const auto value = tokens_.number("a value");
    if (!value) return false;
    if (!(std::abs(*value) < 1e30)) return tokens_.fail(fmt::format("the value {} is too large", *value));
    block.push_back(static_cast<float>(*value));
  }
  return true;
}

/// Returns the channel of `Monochrome`, or of a prefix with X, Y or Z after it.
std::optional<std::size_t> InterchangeReader::channel_of(std::string_view word, std::string_view prefix) {
  if (!header_.has_tristimulus) return word == "Monochrome" ? std::optional<std::size_t>(0) : std::nullopt;
  if (!word.starts_with(prefix) || word.size() != prefix.size() + 1) return std::nullopt;
  const char letter = word.back();
  return letter >= 'X' && letter <= 'Z' ? std::optional(static_cast<std::size_t>(letter - 'X'))
                                        : std::nullopt;
}

bool InterchangeReader::read_zemax_data() {
  std::optional<std::size_t> channel;
  std::size_t incidence = 0;
  for (std::string_view word = tokens_.next(); !word.empty(); word = tokens_.next()) {
    if (word == "DataBegin" || word == "DataEnd") continue;
    if (const auto next = channel_of(word, "Tristimulus")) {
      channel = next;
      incidence = 0;
      continue;
    }
    if (word != "TIS") return tokens_.fail(fmt::format("unexpected '{}'", word.substr(0, 40)));
    if (!channel) return tokens_.fail("data precede Monochrome or Tristimulus");
    if (incidence == blocks_.size())
      return tokens_.fail("there are more blocks of values than angles of incidence");
    if (!tokens_.number("the total integrated scatter")) return false;
    Block& block = blocks_[incidence++][*channel];
    if (!block.empty()) return tokens_.fail("a channel is repeated");
    if (!read_block(block)) return false;
  }
  return true;
}

bool InterchangeReader::read_lighttools_block(std::string_view first) {
  double incidence = 0;
  bool is_front_reflection = true;
  std::size_t channel = 0;
  for (std::string_view word = first;; word = tokens_.next()) {
    if (word == "AOI" || word == "POI" || word == "Wavelength" || word == "TIS") {
      const auto number = tokens_.number(word);
      if (!number) return false;
      if (word == "TIS") break;
      if (word == "AOI") incidence = *number;
      if (word == "POI" && plane_of_incidence_.value_or(*number) != *number)
        return tokens_.fail("there are several planes of incidence: data of more than one are not read");
      if (word == "POI") plane_of_incidence_ = number;
    } else if (word == "Side" || word == "ScatterType") {
      const std::string_view side = tokens_.next();
      is_front_reflection = is_front_reflection && (side == "Front" || side == "BRDF");
    } else if (word == "TristimulusValue") {
      const auto found = channel_of(tokens_.next(), "Tris");
      if (!found) return tokens_.fail("expected TrisX, TrisY or TrisZ, of SpectralContent XYZ");
      channel = *found;
    } else {
      return tokens_.fail(word.empty() ? "the file ends within a block"
                                       : fmt::format("unexpected '{}'", word.substr(0, 40)));
    }
  }
  if (!is_front_reflection) {
    ++skipped_;
    Block ignored;
    return read_block(ignored);
  }
  if (!(incidence >= 0 && incidence <= 90))
    return tokens_.fail(fmt::format("the angle of incidence is {}, expected 0 to 90", incidence));
  Block& block = by_incidence_[incidence][channel];
  if (!block.empty()) return tokens_.fail(fmt::format("the angle of incidence {} is repeated", incidence));
  return read_block(block);
}

bool InterchangeReader::read_lighttools_data() {
  const std::string_view begin = tokens_.next();
  if (begin != "DataBegin") return tokens_.fail(fmt::format("unexpected '{}'", begin.substr(0, 40)));
  for (std::string_view word = tokens_.next(); !word.empty() && word != "DataEnd"; word = tokens_.next()) {
    if (!read_lighttools_block(word)) return false;
  }
  if (skipped_ > 0) {
    diagnostics_.warning(grf::whole_file(path_),
                         grf::counted(skipped_, "block", "blocks") +
                             " of transmission or of the back: only reflection of the front is read");
  }
  return !by_incidence_.empty() || tokens_.fail("there is no reflection of the front");
}

std::shared_ptr<const AngleGrid> InterchangeReader::grid_of(GridAxes axes) {
  const std::size_t channels = header_.has_tristimulus ? 3 : 1;
  std::vector<Rgb> values;
  axes.rotation = {0};
  axes.polar = header_.polar;
  const std::size_t azimuths = header_.azimuth.size();
  const std::size_t polars = header_.polar.size();
  for (const ChannelBlocks& blocks : blocks_) {
    for (std::size_t channel = 0; channel < channels; ++channel) {
      if (blocks[channel].size() != azimuths * polars)
        return failed("values of an angle of incidence are missing");
    }
    for (std::size_t i = 0; i < azimuths * polars; ++i) {
      const auto at = [&](std::size_t channel) { return double(blocks[channel][i]); };
      const Imath::V3d xyz(at(0), channels > 1 ? at(1) : 0, channels > 1 ? at(2) : 0);
      values.push_back(channels > 1 ? Rgb(grf::srgb_of_xyz(xyz)) : Rgb(blocks[0][i]));
    }
  }
  return std::make_shared<const AngleGrid>(std::move(axes), std::move(values));
}

/// Returns the word that decides between the formats: the first one after those that both have.
bool has_interchange_words(std::string_view text, bool& has_incidence) {
  grf::Diagnostics ignored;
  TextTokens tokens(text.substr(0, std::size_t(1) << 20U), "", ignored);
  if (!is_key(tokens.peek())) return false;
  for (std::string_view word = tokens.next(); !word.empty() && word != "DataBegin"; word = tokens.next())
    has_incidence = has_incidence || word == "AngleOfIncidence";
  return true;
}

}  // namespace

bool sniff_zemax(std::string_view text) {
  bool has_incidence = false;
  return has_interchange_words(text, has_incidence) && has_incidence;
}

std::shared_ptr<const AngleGrid> parse_zemax(std::string_view text, const std::string& path,
                                             grf::Diagnostics& diagnostics) {
  return InterchangeReader(text, path, diagnostics).read_zemax();
}

bool sniff_lighttools(std::string_view text) {
  bool has_incidence = false;
  return has_interchange_words(text, has_incidence) && !has_incidence;
}

std::shared_ptr<const AngleGrid> parse_lighttools(std::string_view text, const std::string& path,
                                                  grf::Diagnostics& diagnostics) {
  return InterchangeReader(text, path, diagnostics).read_lighttools();
}

}  // namespace reflectance
