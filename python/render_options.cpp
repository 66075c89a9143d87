#include "python/render_options.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "grf/keywords.h"
#include "renderer/options/op_file.h"

namespace python {
namespace {

using options::OptionInfo;
using options::RenderOptions;

/// Whether an option says what becomes of an image that `bpt` writes or shows: there is none here.
bool is_about_files(const OptionInfo& option) {
  constexpr std::array<std::string_view, 7> Keys = {
      "BPT_Scene",         "BPT_Output_Image",  "BPT_Exposure",   "BPT_Checkpoint",
      "BPT_DisplayWindow", "BPT_DisplayServer", "BPT_Pdf_memstat"};
  return option.group == options::OptionGroup::Times ||
         std::find(Keys.begin(), Keys.end(), option.key) != Keys.end();
}

/// Returns the name of an option as an argument: its flag, or else its key without BPT_.
std::string name_of(const OptionInfo& option) {
  constexpr std::size_t Prefix = 4;
  std::string name =
      option.flag.empty() ? grf::lower_case(option.key.substr(Prefix)) : std::string(option.flag.substr(2));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

const OptionInfo& option_of(const std::string& name) {
  std::vector<std::string> names;
  for (const OptionInfo& option : options::option_table()) {
    if (is_about_files(option)) continue;
    names.push_back(name_of(option));
    if (names.back() == name) return option;
  }
  const std::string advice = grf::did_you_mean(name, names);
  throw py::type_error("render() has no option '" + name + "'" + (advice.empty() ? "" : ": " + advice));
}

std::string word_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  return py::str(value);
}

/// Returns the words of a value as in an OP file.
std::vector<std::string> words_of(const OptionInfo& option, const py::handle& value) {
  if (py::isinstance<py::str>(value) || !py::isinstance<py::iterable>(value)) return {word_of(value)};
  std::vector<std::string> words;
  for (const py::handle item : value) words.push_back(word_of(item));
  if (!std::holds_alternative<options::ListOption>(option.value)) return words;
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ",") + word;
  return {list.empty() ? "none" : list};
}

}  // namespace

std::optional<RenderOptions> render_options_of(const std::string& path, const py::kwargs& arguments,
                                               grf::Diagnostics& diagnostics) {
  RenderOptions render_options;
  render_options.scene = path;
  if (grf::lower_case(std::filesystem::path(path).extension().string()) == ".op") {
    auto from_file = options::read_op_file(path, diagnostics);
    if (!from_file) return std::nullopt;
    render_options = *std::move(from_file);
  }
  for (const auto& [key, value] : arguments) {
    const std::string name = key.cast<std::string>();
    const OptionInfo& option = option_of(name);
    const auto words = words_of(option, value);
    const bool has_words = words.size() == options::word_count(option) || options::is_repeated(option);
    const auto problem = has_words ? set_option(render_options, option, words)
                                   : std::optional("expected " + std::string(option.values));
    if (problem) throw py::value_error(name + ": " + *problem);
    render_options.locations.erase(option.key);  // the value is no longer that of the file
  }
  if (render_options.frames > 1 && render_options.frame == 0)
    throw py::value_error("the options are those of an animation: choose its image by frame=1");
  return render_options;
}

}  // namespace python
