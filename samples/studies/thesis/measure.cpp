#include "samples/studies/thesis/measure.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/text_file.h"

namespace study {
namespace {

using nlohmann::json;

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void write(const std::string& path, const std::string& text) {
  grf::Diagnostics diagnostics;
  if (!grf::replace_file(path, text, diagnostics)) throw std::runtime_error(diagnostics.to_text());
}

Row row_of(const json& data, const Group& group) {
  Row row;
  row.scene = group.scene;
  row.brdf = group.brdf;
  row.integrator = group.integrator;
  for (const Line& line : group.lines) {
    if (line.pdf == data.at("pdf") || (line.pdf.empty() && data.at("pdf") == "scene"))
      row.technique = line.technique;
  }
  data.at("samples").get_to(row.samples);
  data.at("build_seconds").get_to(row.build);
  data.at("sampling_seconds").get_to(row.sampling);
  data.at("render_seconds").get_to(row.render);
  const json& error = data.at("average_relative_error");
  if (error.is_null()) throw std::runtime_error(group.file + ": the reference is black");
  error.get_to(row.error);
  data.at("relmse").get_to(row.relmse);
  data.at("bytes").get_to(row.bytes);
  return row;
}

}  // namespace

std::string Programs::run(const std::string& program, const std::vector<std::string>& arguments) const {
  std::string command = quoted(folder_ + "/" + program);
  for (const std::string& word : arguments) command += " " + quoted(word);
  const std::string logged = command + " 2>>" + quoted(log_);
  std::FILE* pipe = ::popen(logged.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string output;
  std::array<char, 4096> part = {};
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe)) {
    output.append(part.data(), count);
  }
  if (::pclose(pipe) != 0) throw std::runtime_error(fmt::format("{}\nfailed; {} says why", command, log_));
  return output;
}

std::string write_scene(const Group& group, const std::string& folder) {
  write(fmt::format("{}/{}.grf", folder, group.file), scene_text(group));
  std::string path = fmt::format("{}/{}.op", folder, group.file);
  write(path, fmt::format("BPT_Scene {}.grf\n{}", group.file, group.options));
  return path;
}

std::vector<Row> measure(const Group& group, const Programs& programs, const std::string& folder) {
  std::vector<std::string> arguments = {"cost", write_scene(group, folder)};
  std::vector<std::string> schemes;
  for (const Line& line : group.lines) {
    if (!line.pdf.empty()) schemes.push_back(line.pdf);
  }
  if (!schemes.empty())
    arguments.insert(arguments.end(), {"--pdf", fmt::format("{}", fmt::join(schemes, ","))});
  const bool is_naive = group.integrator == "naive";
  for (const std::string& word :
       {std::string("--integrator"), group.integrator, std::string("--points"),
        std::string(is_naive ? "independent" : "sobol"), std::string("--samples"),
        fmt::format("{}", fmt::join(group.samples, ",")), std::string("--reference-samples"),
        fmt::format("{}", group.reference_samples), std::string("--rounds"), std::string("1"),
        std::string("--progress"), std::string("none"), std::string("--output"),
        fmt::format("{}/{}-cost", folder, group.file), std::string("--json")}) {
    arguments.push_back(word);
  }
  std::vector<Row> rows;
  const json result = json::parse(programs.run("bpt", arguments));
  for (const json& data : result.at("rows")) rows.push_back(row_of(data, group));
  return rows;
}

void prepare(const Choice& choice, const Programs& programs, const std::string& merl) {
  namespace fs = std::filesystem;
  const std::string dragon = choice.data + "/dragon.grf";
  if (choice.has_scene("dragon") && !fs::exists(dragon)) {
    programs.run("make_shape", {"dragon", "200000", dragon, "material", "scheme"});
  }
  if (!choice.has_scene("measured")) return;
  for (const Material& material : materials()) {
    if (!choice.has_brdf(material.name)) continue;
    const fs::path table = fs::path(choice.data) / (material.name + ".binary");
    if (merl.empty()) {
      // Made only if missing; a symbolic link is to the data base of an earlier run.
      if (fs::is_symlink(table)) fs::remove(table);
      if (!fs::exists(table)) programs.run("bpt", {"brdf", "export", material.brdf, "-o", table.string()});
      continue;
    }
    fs::remove(table);
    fs::create_symlink(fs::absolute(fs::path(merl) / (material.name + ".binary")), table);
  }
}

}  // namespace study
