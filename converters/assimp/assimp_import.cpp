#include "converters/assimp/assimp_import.h"

#include <algorithm>
#include <array>
#include <exception>
#include <mutex>
#include <new>
#include <thread>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/NullLogger.hpp>
#include <assimp/config.h>

#include "converters/text_encoding.h"
#include "grf/write.h"

namespace convert {
namespace {

/// The maximum number of messages kept, since a corrupt file can cause one per byte.
constexpr std::size_t MostTexts = 20;

/// Prefixes of ignored messages: about Assimp itself, reported otherwise, or without a loss.
bool tells_nothing(std::string_view message) {
  constexpr std::array<std::string_view, 5> Beginnings = {
      "BlendDNA: Did not find a field", "<add reason>", "No hierarchy information",
      "3DS: Skipping TCB animation info", "FBX-DOM: unsupported, newer format version"};
  return std::any_of(Beginnings.begin(), Beginnings.end(),
                     [message](std::string_view beginning) { return message.starts_with(beginning); });
}

/// A log stream that records the messages of the importing thread.
class Listener final : public Assimp::NullLogger {
 public:
  explicit Listener(std::vector<AssimpMessage>& messages) : messages_(messages) {}

  void OnWarn(const char* message) override { add(message, false); }
  void OnError(const char* message) override { add(message, true); }

 private:
  void add(const char* message, bool is_error) {
    if (std::this_thread::get_id() != thread_) return;
    const std::string text = text_of(aiString(message));
    if (tells_nothing(text)) return;
    const auto known = std::find_if(messages_.begin(), messages_.end(),
                                    [&](const AssimpMessage& other) { return other.text == text; });
    if (known != messages_.end()) {
      ++known->count;
    } else if (messages_.size() < MostTexts) {
      messages_.push_back({text, 1, is_error});
    }
  }

  std::vector<AssimpMessage>& messages_;
  std::thread::id thread_ = std::this_thread::get_id();
};

/// Records Assimp's log during its lifetime. Assimp has one global logger, so concurrent imports are
/// serialized by a mutex.
class Listening {
 public:
  explicit Listening(std::vector<AssimpMessage>& messages) : lock_(one_at_a_time()) {
    Assimp::DefaultLogger::set(new Listener(messages));  // deleted when the next one is set
  }
  ~Listening() { Assimp::DefaultLogger::set(nullptr); }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

 private:
  static std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
  }
  std::lock_guard<std::mutex> lock_;
};

void configure(Assimp::Importer& importer) {
  // Only data of the file is imported: no meshes for bones, no subdivision of subdivision surfaces, no
  // generated normals.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_AC_EVAL_SUBDIVISION, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_ASE_RECONSTRUCT_NORMALS, false);
  // Use readable names instead of identifiers.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
}

template <class Read>
AssimpReading import_by(Read read) {
  AssimpReading reading;
  const Listening listening(reading.messages);
  Assimp::Importer importer;
  configure(importer);
  try {
    read(importer);
    // Assimp converts any exception to a text.
    if (importer.GetErrorString() == std::string_view(std::bad_alloc().what())) throw std::bad_alloc();
    reading.error = text_of(aiString(importer.GetErrorString()));
    reading.scene.reset(importer.GetOrphanedScene());
  } catch (const std::bad_alloc&) {
    throw;  // unrelated to the file
  } catch (const std::exception& exception) {
    reading.error = text_of(aiString(exception.what()));
  }
  return reading;
}

}  // namespace

AssimpReading import_bytes(std::string_view bytes, const std::string& extension) {
  return import_by([&](Assimp::Importer& importer) {
    importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, extension.c_str());
  });
}

AssimpReading import_file(const std::string& path) {
  return import_by([&](Assimp::Importer& importer) { importer.ReadFile(path.c_str(), 0); });
}

std::string text_of(const aiString& string) {
  const std::size_t size = std::min<std::size_t>(string.length, sizeof string.data - 1);
  std::string text = to_utf8(std::string_view(string.data, size));
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; };
  text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return grf::with_one_kind_of_quotes(std::move(text));
}

}  // namespace convert
