// This header helps libraries that are preloaded into a renderer (LD_PRELOAD) to wrap Embree's queries. The
// signatures are Embree 3's with void in place of its types.
#pragma once

#include <cstdlib>
#include <mutex>
#include <vector>

#include <dlfcn.h>

namespace embree_queries {

using Single = void(void* scene, void* context, void* ray);
using Packet = void(const int* valid, void* scene, void* context, void* rays);

/// Returns the function of this name of the library after this one: Embree's own.
template <class Function>
Function* next(const char* name) {
  void* found = dlsym(RTLD_NEXT, name);
  if (found == nullptr) std::abort();
  return reinterpret_cast<Function*>(found);
}

/// An object for each thread that asks Embree. Objects are never freed: threads may outlive this.
template <class Object>
class PerThread {
 public:
  Object& add() {
    const std::lock_guard lock(mutex_);
    objects_.push_back(new Object());  // NOLINT(cppcoreguidelines-owning-memory)
    return *objects_.back();
  }
  template <class Visit>
  void for_each(const Visit& visit) {
    const std::lock_guard lock(mutex_);
    for (Object* object : objects_) visit(*object);
  }

 private:
  std::mutex mutex_;
  std::vector<Object*> objects_;
};

}  // namespace embree_queries
