#include "tests/converters/usd/usda_stage.h"

#include <cctype>
#include <charconv>
#include <functional>
#include <set>
#include <stdexcept>

#include "tests/converters/usd/usda_schemas.h"

namespace test {
namespace {

[[noreturn]] void fail(const std::string& why) { throw std::runtime_error(why); }
void require(bool holds, const std::string& why) {
  if (!holds) fail(why);
}

bool is_identifier(std::string_view name) {
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) != 0) return false;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') return false;
  }
  return true;
}

/// Reads the text, a token at a time.
class UsdaParser {
 public:
  explicit UsdaParser(std::string_view text) : rest_(text) {}

  UsdaStage stage() {
    require(take("#usda 1.0\n"), "no header of usda 1.0");
    std::map<std::string, std::string> layer;
    expect("(");
    while (!take(")")) {
      const std::string key = word();
      expect("=");
      require(layer.emplace(key, value_text()).second, "metadata is given twice: " + key);
    }
    require(layer["metersPerUnit"] == "1" && layer["upAxis"] == "Y", "no unit or up axis");
    UsdaStage stage;
    stage.root = prim("");
    require(stage.root.name == layer["defaultPrim"], "the default prim does not exist");
    skip();
    require(rest_.empty(), "there is text after the last prim");
    return stage;
  }

 private:
  void skip() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\n')) rest_.remove_prefix(1);
  }
  bool take(std::string_view token) {
    skip();
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  void expect(std::string_view token) {
    require(take(token), "expected " + std::string(token) + " before " + std::string(rest_.substr(0, 60)));
  }
  std::string word() {
    skip();
    std::size_t end = 0;
    while (end < rest_.size() && (std::isalnum(static_cast<unsigned char>(rest_[end])) != 0 ||
                                  rest_[end] == '_' || rest_[end] == ':'))
      ++end;
    require(end > 0, "expected a name before " + std::string(rest_.substr(0, 60)));
    std::string result(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return result;
  }
  bool is_at_word(std::string_view wanted) {
    skip();
    return rest_.starts_with(wanted) && rest_.size() > wanted.size() && rest_[wanted.size()] == ' ';
  }
  bool takes_word(std::string_view wanted) { return is_at_word(wanted) && take(wanted); }
  std::string quoted() {
    expect("\"");
    std::string result;
    while (!rest_.starts_with('"')) {
      require(!rest_.empty() && rest_[0] != '\n', "a string has no end");
      if (rest_[0] == '\\') {
        rest_.remove_prefix(1);
        require(rest_.starts_with('"') || rest_.starts_with('\\') || rest_.starts_with('n'),
                "unknown escape");
        result += rest_[0] == 'n' ? '\n' : rest_[0];
      } else {
        result += rest_[0];
      }
      rest_.remove_prefix(1);
    }
    rest_.remove_prefix(1);
    return result;
  }
  std::string between(std::string_view begin, std::string_view end) {
    expect(begin);
    const std::size_t at = rest_.find(end);
    require(at != std::string_view::npos && at > 0, "an asset or path has no end");
    std::string result(rest_.substr(0, at));
    require(result.find('\n') == std::string::npos, "a line end in an asset or path");
    rest_.remove_prefix(at + end.size());
    return result;
  }
  std::string path() { return between("<", ">"); }
  double number() {
    skip();
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    require(error == std::errc() && value == value && value * 0 == 0,
            "expected a number before " + std::string(rest_.substr(0, 60)));
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  std::string value_text() {
    skip();
    if (rest_.starts_with('"')) return quoted();
    return std::to_string(number()).substr(0, 1);
  }

  void tuple(const UsdaType& type, UsdaValue& value) {
    if (type.rows > 1) expect("(");
    for (std::size_t row = 0; row < type.rows; ++row) {
      if (row > 0) expect(",");
      if (type.columns > 1) expect("(");
      for (std::size_t column = 0; column < type.columns; ++column) {
        if (column > 0) expect(",");
        const double x = number();
        require(!type.is_integer || x == static_cast<double>(static_cast<long long>(x)),
                "expected an integer");
        value.numbers.push_back(x);
      }
      if (type.columns > 1) expect(")");
    }
    if (type.rows > 1) expect(")");
  }
  void element(const UsdaType& type, UsdaValue& value) {
    ++value.elements;
    if (type.kind == UsdaType::Kind::String) {
      value.strings.push_back(quoted());
    } else if (type.kind == UsdaType::Kind::Asset) {
      skip();
      const std::string_view mark = rest_.starts_with("@@@") ? "@@@" : "@";
      value.strings.push_back(between(mark, mark));
    } else {
      tuple(type, value);
    }
  }

  void dictionary(UsdaPrim& prim) {
    expect("{");
    while (!take("}")) {
      const std::string type = word();
      const std::string key = word();
      expect("=");
      if (type == "dictionary") {
        dictionary(prim);
      } else if (type == "string") {
        prim.custom[key] = quoted();
      } else {
        require(type == "int", "unknown type in customData: " + type);
        prim.custom[key] = std::to_string(static_cast<long long>(number()));
      }
    }
  }
  void metadata(UsdaPrim& prim) {
    if (!take("(")) return;
    while (!take(")")) {
      const bool is_prepended = takes_word("prepend");
      const std::string key = word();
      expect("=");
      if (key == "customData") {
        dictionary(prim);
      } else if (key == "instanceable") {
        require(take("true"), "instanceable is a boolean");
        prim.is_instanceable = true;
      } else if (key == "references" && is_prepended) {
        prim.reference = path();
      } else if (key == "apiSchemas" && is_prepended) {
        expect("[");
        do prim.schemas.push_back(quoted());
        while (take(","));
        expect("]");
      } else {
        fail("unknown metadata: " + key);
      }
    }
  }

  void attribute_metadata(UsdaValue& value) {
    if (!take("(")) return;
    const std::string key = word();
    expect("=");
    const std::string text = quoted();
    if (key == "interpolation") {
      value.interpolation = text;
    } else {
      require(key == "colorSpace" && value.type == "asset", "unknown metadata of an attribute: " + key);
    }
    expect(")");
  }
  void property(UsdaPrim& prim) {
    UsdaValue value;
    value.is_uniform = takes_word("uniform");
    value.type = word();
    const bool is_array = take("[]");
    std::string name = word();
    const UsdaType& type = usda_type(value.type);
    if (is_array) value.type += "[]";
    if (take(".connect")) {
      expect("=");
      value.connection = path();
    } else if (value.type == "rel") {
      expect("=");
      value.strings = {path()};
    } else if (take("=")) {
      if (is_array) expect("[");
      if (!is_array || !take("]")) {
        do element(type, value);
        while (is_array && take(","));
        if (is_array) expect("]");
      }
      attribute_metadata(value);
    } else {
      require(name.starts_with("outputs:"), "an attribute has no value: " + name);
    }
    require(prim.attributes.emplace(name, std::move(value)).second, "an attribute is given twice: " + name);
  }
  UsdaPrim prim(const std::string& parent) {
    UsdaPrim prim;
    prim.specifier = word();
    require(prim.specifier == "def" || prim.specifier == "class", "expected a prim");
    skip();
    if (!rest_.starts_with('"')) prim.type = word();
    prim.name = quoted();
    require(is_identifier(prim.name), "no identifier: " + prim.name);
    prim.path = parent + "/" + prim.name;
    metadata(prim);
    expect("{");
    std::set<std::string> names;
    while (!take("}")) {
      if (is_at_word("def") || is_at_word("class")) {
        prim.children.push_back(this->prim(prim.path));
        require(names.insert(prim.children.back().name).second, "two prims have one name: " + prim.name);
      } else {
        property(prim);
      }
    }
    return prim;
  }

  std::string_view rest_;
};

void collect(const UsdaPrim& prim, const std::string& type, std::vector<const UsdaPrim*>& found) {
  if (prim.type == type) found.push_back(&prim);
  for (const UsdaPrim& child : prim.children) collect(child, type, found);
}

const UsdaPrim* find_below(const UsdaPrim& prim, const std::string& path) {
  if (prim.path == path) return &prim;
  for (const UsdaPrim& child : prim.children) {
    if (path == child.path || path.starts_with(child.path + "/")) return find_below(child, path);
  }
  return nullptr;
}

}  // namespace

const UsdaPrim& UsdaPrim::child(const std::string& key) const {
  for (const UsdaPrim& candidate : children) {
    if (candidate.name == key) return candidate;
  }
  throw std::out_of_range("no prim " + path + "/" + key);
}

std::vector<const UsdaPrim*> UsdaPrim::all(const std::string& type_of_prims) const {
  std::vector<const UsdaPrim*> found;
  collect(*this, type_of_prims, found);
  return found;
}

grf::Matrix44d UsdaPrim::to_parent() const {
  grf::Matrix44d matrix;
  const auto found = attributes.find("xformOp:transform");
  if (found == attributes.end()) return matrix;
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = found->second.numbers[static_cast<std::size_t>(i)];
  return matrix;
}

const UsdaPrim* UsdaStage::find(const std::string& path) const { return find_below(root, path); }

UsdaStage parse_usda(std::string_view text, const std::string& folder) {
  UsdaStage stage = UsdaParser(text).stage();
  check_usda(stage, folder);
  return stage;
}

}  // namespace test
