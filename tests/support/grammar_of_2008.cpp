#include "tests/support/grammar_of_2008.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <regex>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace test {
namespace {

enum class Kind { Word, Number, String, Sign, End };

struct Token {
  Kind kind = Kind::End;
  std::string text;  ///< of a word in lower case
};

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

/// The length of the number that a text begins with; 0 if it begins with none.
std::size_t number_length(std::string_view text) {
  static const std::regex number(R"(^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?[fFdD]?)");
  std::cmatch match;
  constexpr std::size_t Longest = 64;
  const std::string_view part = text.substr(0, Longest);
  return std::regex_search(part.data(), part.data() + part.size(), match, number)
             ? static_cast<std::size_t>(match.length())
             : 0;
}

/// The length of the string that a text begins with, in the quotes of a keyboard or in typographic ones; 0 if
/// it begins with none.
std::size_t string_length(std::string_view text) {
  constexpr std::string_view Opening = "\u201C";
  constexpr std::string_view Closing = "\u201D";
  const bool is_plain = text.starts_with('"');
  if (!is_plain && !text.starts_with(Opening) && !text.starts_with(Closing)) return 0;
  const std::string_view quote = is_plain ? std::string_view("\"") : Closing;
  const std::size_t end = text.find(quote, is_plain ? 1 : Closing.size());
  if (end == std::string_view::npos) throw std::runtime_error("a string without its end");
  return end + quote.size();
}

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  while (!text.empty()) {
    std::size_t length = 1;
    const char first = text.front();
    const bool is_blank = std::isspace(static_cast<unsigned char>(first)) != 0;
    if (text.starts_with("//")) {
      length = std::min(text.find('\n'), text.size());
    } else if (const std::size_t characters = string_length(text); characters > 0) {
      length = characters;
      tokens.push_back({Kind::String, std::string(text.substr(0, length))});
    } else if (const std::size_t digits = number_length(text); digits > 0) {
      length = digits;
      tokens.push_back({Kind::Number, std::string(text.substr(0, length))});
    } else if (is_word_character(first)) {
      length = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_word_character) -
                                        text.begin());
      std::string word(text.substr(0, length));
      std::transform(word.begin(), word.end(), word.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      tokens.push_back({Kind::Word, std::move(word)});
    } else if (!is_blank) {
      tokens.push_back({Kind::Sign, std::string(1, first)});
    }
    text.remove_prefix(length);
  }
  tokens.emplace_back();
  return tokens;
}

class Recognizer {
 public:
  explicit Recognizer(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  void scene() {
    blocks();
    if (peek().kind != Kind::End) fail("a block");
  }

 private:
  const Token& peek(std::size_t ahead = 0) const {
    return tokens_[std::min(position_ + ahead, tokens_.size() - 1)];
  }
  [[noreturn]] void fail(const std::string& expected) const {
    const std::size_t from = position_ - std::min<std::size_t>(position_, 6);
    std::string before;
    for (std::size_t i = from; i < position_; ++i) before += tokens_[i].text + ' ';
    throw std::runtime_error(
        fmt::format("expected {} after '{}', found '{}'", expected, before, peek().text));
  }
  bool is(std::string_view text, std::size_t ahead = 0) const {
    const Token& token = peek(ahead);
    return token.kind != Kind::String && token.kind != Kind::End && token.text == text;
  }
  bool is_one_of(std::initializer_list<std::string_view> texts, std::size_t ahead = 0) const {
    return std::any_of(texts.begin(), texts.end(), [&](std::string_view text) { return is(text, ahead); });
  }
  bool is_colour() const { return is_one_of({"rgb", "colour", "color"}); }
  bool take(std::string_view text) {
    const bool is_there = is(text);
    if (is_there) ++position_;
    return is_there;
  }
  void expect(std::initializer_list<std::string_view> texts) {
    for (const std::string_view text : texts) {
      if (!take(text)) fail(fmt::format("'{}'", text));
    }
  }
  void expect(Kind kind, const char* what) {
    if (peek().kind != kind) fail(what);
    ++position_;
  }

  void numbers(int count) {
    expect({"("});
    for (int i = 0; i < count; ++i) {
      if (i > 0) expect({","});
      expect(Kind::Number, "a number");
    }
    expect({")"});
  }
  void vector3() { numbers(3); }

  void blocks() {
    while (block()) {
    }
  }
  bool block() {
    if (is("begin") && is("mesh", 1)) {
      mesh();
    } else if (is("mesh") && is("light", 1)) {
      mesh_light();
    } else if (take("light")) {
      area_light();
    } else if (take("include")) {
      expect(Kind::String, "a file's name");
    } else if (take("transform")) {
      transform();
    } else if (take("def")) {
      definitions();
    } else if (take("params")) {
      params();
    } else if (take("use")) {
      expect(Kind::Word, "a name");
    } else {
      return false;
    }
    return true;
  }
  void body() {
    expect({"begin"});
    blocks();
    expect({"end"});
  }
  void area_light() {
    expect({"begin"});
    for (int i = 0; i < 3; ++i) vector3();
    if (is_colour()) colour();
    expect({"end"});
  }
  void transform() {
    if (!is_one_of({"scale", "rotation", "translation"})) fail("a transform");
    while (take("scale") || take("rotation") || take("translation")) vector3();
    body();
  }
  void params() {
    expect({"begin"});
    while (take("dependent")) {
      expect({"view"});
      vector3();
    }
    expect({"end"});
  }
  void definitions() {
    do {
      expect(Kind::Word, "a name");
      expect({"="});
      definition();
      take("def");
    } while (!is("begin"));
    body();
  }
  void definition() {
    if (is("begin")) return mesh();
    if (take("texture")) return expect(Kind::String, "an image file's name");
    if (is_colour()) {
      ++position_;
      return vector3();
    }
    if (take("brdf")) return brdf();
    expect({"pdf"});
    instance();
  }

  void colour() {
    ++position_;
    if (peek().kind == Kind::Word) return expect(Kind::Word, "a name");
    vector3();
  }
  void brdf() {
    if (peek().kind == Kind::String) return expect(Kind::String, "");
    if (is("combine") && peek(1).kind == Kind::Number) {
      ++position_;
      while (peek().kind == Kind::Number && peek(1).kind == Kind::Word) {
        expect(Kind::Number, "");
        expect(Kind::Word, "a name");
        take(",");
      }
      return parameters();
    }
    instance();
  }
  /// A name, a model with its file of data, or one with its parameters: numbers and truth values alone.
  void instance() {
    if (is("none")) fail("a model, which 'none' is not yet");
    expect(Kind::Word, "a model");
    if (peek().kind == Kind::String) return expect(Kind::String, "");
    parameters();
  }
  void parameters() {
    while (peek().kind == Kind::Word && is("=", 1) && !begins_definition()) {
      position_ += 2;
      if (!take("true") && !take("false")) expect(Kind::Number, "a number or a truth value");
    }
  }
  /// Tells the next of a list of definitions from one more parameter.
  bool begins_definition() const {
    return is_one_of({"texture", "rgb", "colour", "color", "brdf", "pdf", "begin"}, 2);
  }
  void texture() {
    if (peek().kind == Kind::String) return expect(Kind::String, "");
    if (is("none")) fail("a texture, which 'none' is not yet");
    expect(Kind::Word, "a texture");
  }
  bool attribute() {
    if (is_colour()) {
      colour();
    } else if (take("brdf")) {
      brdf();
    } else if (take("pdf")) {
      instance();
    } else if (take("texture")) {
      texture();
    } else {
      return false;
    }
    return true;
  }

  void mesh() {
    expect({"begin", "mesh"});
    while (attribute()) {
    }
    vertices();
    expect({"end", "vertexs", "begin", "faces"});
    do {
      faces();
    } while (attribute());
    expect({"end", "faces", "end", "mesh"});
  }
  void mesh_light() {
    expect({"mesh", "light", "begin"});
    vertices();
    expect({"end", "vertexs", "begin", "faces"});
    faces();
    expect({"end", "faces", "end"});
  }
  void vertices() {
    expect({"begin", "vertexs"});
    while (!is("end")) vertex();
  }
  void vertex() {
    for (;;) {
      if (take("normal") || take("irad")) {
        vector3();
      } else if (is_colour()) {
        ++position_;
        vector3();
      } else if (take("uv")) {
        numbers(2);
      } else if (take("begin")) {
        expect({"list"});
        while (take("ray")) {
          vector3();
          expect({"irad"});
          vector3();
        }
        expect({"end", "list"});
      } else {
        return vector3();
      }
    }
  }
  void faces() {
    while (peek().kind == Kind::Number || is("(")) {
      const bool is_counted = peek().kind == Kind::Number;
      if (is_counted) ++position_;
      if (!take("(")) {
        while (peek().kind == Kind::Number) ++position_;
        continue;
      }
      do expect(Kind::Number, "an index");
      while (take(","));
      expect({")"});
    }
  }

  std::vector<Token> tokens_;
  std::size_t position_ = 0;
};

}  // namespace

std::string difference_from_grammar_of_2008(std::string_view text) {
  try {
    Recognizer(tokens_of(text)).scene();
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace test
