#include "renderer/studies/reflector_cache.h"

#include <filesystem>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"

namespace studies {
namespace {

std::string text_of(const grf::BrdfModel& model) {
  if (model.data_file.empty()) return grf::to_text(model) + '\n';
  const std::string path =
      model.location.file ? grf::path_beside(model.location.file->path, model.data_file) : model.data_file;
  std::error_code error;
  const auto time = std::filesystem::last_write_time(path, error);
  return fmt::format("{}\n{}\n{}\n", grf::to_text(model), path, time.time_since_epoch().count());
}

}  // namespace

std::string identity_of(const grf::BrdfModel& model, std::span<const grf::Definition> definitions) {
  std::string text = text_of(model);
  for (const grf::Definition& definition : definitions)
    text += definition.name + '=' + text_of(std::get<grf::BrdfModel>(definition.body));
  return text;
}

std::shared_ptr<const reflectance::Reflector> cached_reflector(StudyCache* cache, const std::string& identity,
                                                               const reflectance::Brdf& brdf,
                                                               const grf::PdfModel& pdf) {
  const std::string key = "reflector " + identity + grf::to_text(pdf);
  if (auto known = cache != nullptr ? cache->find<reflectance::Reflector>(key) : nullptr) return known;
  auto reflector =
      std::make_shared<const reflectance::Reflector>(brdf, reflectance::make_scheme(pdf).value());
  if (cache != nullptr) cache->keep(key, reflector, reflector->bytes());
  return reflector;
}

}  // namespace studies
