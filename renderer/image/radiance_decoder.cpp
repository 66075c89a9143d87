#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "renderer/image/decoders.h"

namespace image {
namespace {

using grf::Colour;
using Rgbe = std::array<std::uint8_t, 4>;

/// The order of rows and pixels, and the factor by which pixels were multiplied.
struct Header {
  int width = 0;
  int height = 0;
  bool from_bottom = false;
  bool from_right = false;
  float exposure = 1;
};

class RadianceDecoder {
 public:
  explicit RadianceDecoder(std::string_view bytes) : rest_(bytes) {}

  Image run() {
    const Header header = read_header();
    // Each row has at least one literal pixel. A corrupt size must not request gigabytes.
    if (header.height > 0 && rest_.size() / sizeof(Rgbe) < static_cast<std::size_t>(header.height)) {
      throw std::runtime_error("unexpected end of file");
    }
    Image image = blank_image(header.width, header.height);
    std::vector<Rgbe> row(static_cast<std::size_t>(header.width));
    for (int i = 0; i < header.height; ++i) {
      read_row(row);
      const int y = header.from_bottom ? header.height - 1 - i : i;
      if (header.from_right) std::reverse(row.begin(), row.end());
      Colour* pixel = &image.pixels[static_cast<std::size_t>(y) * row.size()];
      for (const Rgbe& rgbe : row) *pixel++ = to_rgb(rgbe) / header.exposure;
    }
    return image;
  }

 private:
  static Colour to_rgb(const Rgbe& rgbe) {
    if (rgbe[3] == 0) return Colour(0);
    return Colour(rgbe[0], rgbe[1], rgbe[2]) * std::ldexp(1.0F, int(rgbe[3]) - 136);
  }

  std::string_view next_line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) throw std::runtime_error("unexpected end of file");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }

  // Lines up to an empty one, then the size, such as `-Y 512 +X 1024`.
  Header read_header() {
    Header header;
    for (std::string_view line = next_line(); !line.empty(); line = next_line()) {
      if (line.starts_with("FORMAT=") && !line.starts_with("FORMAT=32-bit_rle_rgbe")) {
        throw std::runtime_error("its pixels are not RGBE");
      }
      if (line.starts_with("EXPOSURE=")) header.exposure *= number_in<float>(line.substr(9));
    }
    if (!(header.exposure > 0) || !std::isfinite(header.exposure)) {
      throw std::runtime_error("its exposure is not greater than 0");
    }
    const std::string_view size = next_line();
    const std::size_t second = size.find(' ', std::min<std::size_t>(3, size.size()));
    if (second == std::string_view::npos || size.size() < second + 4 || size[1] != 'Y' ||
        size[second + 2] != 'X') {
      throw std::runtime_error("its resolution is not given as rows and columns, such as -Y 512 +X 1024");
    }
    header.from_bottom = size[0] == '+';
    header.from_right = size[second + 1] == '-';
    header.height = number_in<int>(size.substr(2, second - 2));
    header.width = number_in<int>(size.substr(second + 3));
    return header;
  }

  template <class Number>
  static Number number_in(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    Number number = {};
    if (std::from_chars(text.data(), text.data() + text.size(), number).ec != std::errc()) {
      throw std::runtime_error("its header has an invalid number");
    }
    return number;
  }

  std::uint8_t next_byte() {
    if (rest_.empty()) throw std::runtime_error("unexpected end of file");
    const auto byte = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }
  Rgbe next_pixel() {
    Rgbe pixel;
    for (std::uint8_t& byte : pixel) byte = next_byte();
    return pixel;
  }

  void read_row(std::vector<Rgbe>& row) {
    constexpr std::size_t Fewest = 8;
    constexpr std::size_t Most = 32767;
    const Rgbe first = next_pixel();
    const bool is_by_component =
        row.size() >= Fewest && row.size() <= Most && first[0] == 2 && first[1] == 2 && first[2] < 128;
    if (!is_by_component) return read_pixels(row, first);
    if ((std::size_t(first[2]) << 8U | first[3]) != row.size()) {
      throw std::runtime_error("a row has the wrong length");
    }
    for (std::size_t component = 0; component < 4; ++component) read_component(row, component);
  }

  void read_component(std::vector<Rgbe>& row, std::size_t component) {
    for (std::size_t x = 0; x < row.size();) {
      const std::uint8_t code = next_byte();
      const bool is_run = code > 128;
      const std::size_t count = is_run ? code - 128U : code;
      if (count == 0 || count > row.size() - x) throw std::runtime_error("a run exceeds its row");
      const std::uint8_t value = is_run ? next_byte() : std::uint8_t(0);
      for (const std::size_t end = x + count; x < end; ++x) row[x][component] = is_run ? value : next_byte();
    }
  }

  // A pixel of three ones holds a repeat count of the previous pixel; several in a row hold the higher bytes
  // of the count.
  void read_pixels(std::vector<Rgbe>& row, Rgbe pixel) {
    unsigned shift = 0;
    for (std::size_t x = 0;;) {
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const std::size_t count = shift < 32 ? std::size_t(pixel[3]) << shift : row.size() + 1;
        if (x == 0 || count > row.size() - x) throw std::runtime_error("a run exceeds its row");
        std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
        x += count;
        shift += 8;
      } else {
        row[x++] = pixel;
        shift = 0;
      }
      if (x == row.size()) return;
      pixel = next_pixel();
    }
  }

  std::string_view rest_;
};

}  // namespace

Image decode_radiance(std::string_view bytes, Alpha) { return RadianceDecoder(bytes).run(); }

}  // namespace image
