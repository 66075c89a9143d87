#include "renderer/plot/fit_file.h"

#include <charconv>
#include <cmath>
#include <memory>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/lexer.h"
#include "grf/read.h"
#include "grf/write.h"

namespace plot {
namespace {

using grf::Token;
using grf::TokenKind;

std::string description(const Token& token) {
  if (token.kind == TokenKind::EndOfFile) return "the end of the file";
  constexpr std::size_t Longest = 40;
  return fmt::format("'{}'", token.text.substr(0, Longest));
}

/// Parses a float; false if it overflows. Underflow gives zero.
bool parse(std::string_view digits, float& number) {
  const auto error = std::from_chars(digits.data(), digits.data() + digits.size(), number).ec;
  if (error != std::errc::result_out_of_range) return error == std::errc();
  double value = 0;
  const auto beyond = std::from_chars(digits.data(), digits.data() + digits.size(), value).ec;
  number = 0;
  return beyond == std::errc() && std::abs(value) < 1;
}

/// Reads the text after the BRDF instance. Each function returns false after an error, which it reports.
class Reader {
 public:
  Reader(const std::string& text, const std::string& path, grf::Diagnostics& diagnostics)
      : text_(std::make_shared<const std::string>(text)),
        file_(std::make_shared<grf::SourceFile>(grf::SourceFile{path, {}, text_})),
        lexer_(text_, file_),
        diagnostics_(diagnostics) {}

  bool read(FitFile& file) {
    return read_brdf(file.brdf) && read_viewer(file) && read_points(file.points) &&
           (lexer_.peek().kind == TokenKind::EndOfFile || fail("nothing after 'end'"));
  }

 private:
  bool at(std::string_view keyword) const {
    return lexer_.peek().kind == TokenKind::Word && grf::same_keyword(lexer_.peek().text, keyword);
  }

  /// Returns true at the word `viewer`, unless it is the name of a parameter.
  bool at_viewer() { return at("viewer") && !lexer_.peek_second().is('='); }

  bool fail(std::string_view expected) {
    diagnostics_.error(lexer_.location(lexer_.peek()),
                       fmt::format("found {}, expected {}", description(lexer_.peek()), expected));
    return false;
  }

  // The instance's reader consumes all the text that it gets.
  bool read_brdf(grf::BrdfModel& brdf) {
    while (lexer_.peek().kind != TokenKind::EndOfFile && !at_viewer()) lexer_.next();
    if (lexer_.peek().kind == TokenKind::EndOfFile)
      return fail("'viewer' and the view direction after the BRDF");
    const std::string before(text_->data(), lexer_.peek().begin);
    auto instance = grf::read_brdf(before, file_->path, diagnostics_);
    if (!instance) return false;
    brdf = std::move(*instance);
    return true;
  }

  bool read_viewer(FitFile& file) {
    lexer_.next();
    if (!take('(', "'(' and the angles of the view") || !read_number(file.theta)) return false;
    if (!take(',', "',' and the second angle of the view")) return false;
    const grf::SourceLocation at_phi = lexer_.location(lexer_.peek());
    if (!read_number(file.phi) || !take(')', "')' after the two angles of the view")) return false;
    if (std::abs(file.phi) > 2 * std::numbers::pi) {
      diagnostics_.warning(
          at_phi,
          fmt::format("the view's phi, {}, is more than a full turn: angles are in radians", file.phi));
    }
    return true;
  }

  bool read_points(std::vector<FitPoint>& points) {
    if (!at("begin")) return fail("'begin' and directions with their values");
    lexer_.next();
    while (!at("end")) {
      if (!read_point(points.emplace_back())) return false;
    }
    lexer_.next();
    return true;
  }

  bool read_point(FitPoint& point) {
    return take('(', "'(' and a direction, or 'end'") && read_number(point.direction.x) &&
           take(',', "',' and two more numbers") && read_number(point.direction.y) &&
           take(',', "',' and one more number") && read_number(point.direction.z) &&
           take(')', "')' after three numbers") && read_number(point.value);
  }

  bool take(char punctuation, std::string_view expected) {
    if (!lexer_.peek().is(punctuation)) return fail(expected);
    lexer_.next();
    return true;
  }

  bool read_number(float& number) {
    const Token& token = lexer_.peek();
    if (token.kind != TokenKind::Number) return fail("a number");
    const std::string_view digits = token.text.substr(token.text.front() == '+' ? 1 : 0);
    if (!parse(digits, number)) return fail("a number in the range of a float");
    lexer_.next();
    return true;
  }

  std::shared_ptr<const std::string> text_;
  std::shared_ptr<const grf::SourceFile> file_;
  grf::Lexer lexer_;
  grf::Diagnostics& diagnostics_;
};

}  // namespace

std::string to_text(const FitFile& file) {
  std::string text =
      fmt::format("{}\nviewer ({}, {})\nbegin\n", grf::to_text(file.brdf), file.theta, file.phi);
  for (const FitPoint& point : file.points) {
    const grf::Vec3f& v = point.direction;
    text += fmt::format("({}, {}, {}) {}\n", v.x, v.y, v.z, point.value);
  }
  return text + "end\n";
}

std::optional<FitFile> read_fit(const std::string& text, const std::string& path,
                                grf::Diagnostics& diagnostics) {
  FitFile file;
  return Reader(text, path, diagnostics).read(file) ? std::optional(std::move(file)) : std::nullopt;
}

}  // namespace plot
