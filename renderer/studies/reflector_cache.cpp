#include "renderer/studies/reflector_cache.h"

#include <deque>
#include <filesystem>
#include <mutex>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/write.h"

namespace studies {
namespace {

/// Two figures with six schemes each, of which some may have large tables.
constexpr std::size_t MostKept = 12;
constexpr std::size_t MostBytes = 1U << 28U;

std::string text_of(const grf::BrdfModel& model) {
  if (model.data_file.empty()) return grf::to_text(model) + '\n';
  const std::string path =
      model.location.file ? grf::path_beside(model.location.file->path, model.data_file) : model.data_file;
  std::error_code error;
  const auto time = std::filesystem::last_write_time(path, error);
  return fmt::format("{}\n{}\n{}\n", grf::to_text(model), path, time.time_since_epoch().count());
}

struct Entry {
  std::string key;
  std::shared_ptr<const reflectance::Reflector> reflector;
};

std::size_t bytes_of(const std::deque<Entry>& entries) {
  std::size_t sum = 0;
  for (const Entry& entry : entries) sum += entry.reflector->bytes();
  return sum;
}

}  // namespace

std::string identity_of(const grf::BrdfModel& model, std::span<const grf::Definition> definitions) {
  std::string text = text_of(model);
  for (const grf::Definition& definition : definitions)
    text += definition.name + '=' + text_of(std::get<grf::BrdfModel>(definition.body));
  return text;
}

std::shared_ptr<const reflectance::Reflector> cached_reflector(const std::string& identity,
                                                               const reflectance::Brdf& brdf,
                                                               const grf::PdfModel& pdf) {
  static std::mutex mutex;
  static std::deque<Entry> kept;
  const std::string key = identity + grf::to_text(pdf);
  {
    const std::lock_guard lock(mutex);
    for (const Entry& entry : kept) {
      if (entry.key == key) return entry.reflector;
    }
  }
  // It is built without the lock: other figures need not wait, and at worst it is built twice.
  auto reflector =
      std::make_shared<const reflectance::Reflector>(brdf, reflectance::make_scheme(pdf).value());
  const std::lock_guard lock(mutex);
  kept.push_back({key, reflector});
  while (kept.size() > MostKept || (kept.size() > 1 && bytes_of(kept) > MostBytes)) kept.pop_front();
  return reflector;
}

}  // namespace studies
