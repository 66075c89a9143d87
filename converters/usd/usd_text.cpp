#include "converters/usd/usd_text.h"

#include <filesystem>

namespace convert {

std::string usd_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else if (c == '\r' || c == '\0') {
      result += ' ';
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string usd_asset(std::string_view path) {
  const bool is_relative = !std::filesystem::path(path).is_absolute() && !path.starts_with("./");
  const std::string whole = (is_relative ? "./" : "") + std::string(path);
  const std::string mark = whole.find('@') == std::string::npos ? "@" : "@@@";
  return mark + whole + mark;
}

std::string usd_number(float value) { return fmt::format("{}", value); }
std::string usd_number(double value) { return usd_number(static_cast<float>(value)); }

std::string usd_matrix(const grf::Matrix44d& matrix) {
  std::string text;
  for (int row = 0; row < 4; ++row) {
    text += fmt::format("{}({}, {}, {}, {})", row == 0 ? "" : ", ", matrix[row][0], matrix[row][1],
                        matrix[row][2], matrix[row][3]);
  }
  return "( " + text + " )";
}

std::vector<std::string> usd_custom_data(std::span<const std::string> declarations) {
  std::vector<std::string> metadata = {"customData = {", "    dictionary grf = {"};
  for (const std::string& declaration : declarations) metadata.push_back("        " + declaration);
  metadata.insert(metadata.end(), {"    }", "}"});
  return metadata;
}

void UsdText::line(std::string_view line) {
  text.append(4 * depth_, ' ');
  text += line;
  text += '\n';
}

void UsdText::begin(std::string_view header, std::span<const std::string> metadata) {
  if (metadata.empty()) {
    line(header);
  } else {
    line(std::string(header) + " (");
    ++depth_;
    for (const std::string& entry : metadata) line(entry);
    --depth_;
    line(")");
  }
  line("{");
  ++depth_;
}

void UsdText::end() {
  --depth_;
  line("}");
}

}  // namespace convert
