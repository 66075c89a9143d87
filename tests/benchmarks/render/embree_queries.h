// What libraries that are preloaded into a renderer (LD_PRELOAD) need to stand before Embree's queries. The
// signatures are Embree 3's with void in place of its types.
#pragma once

#include <cstdlib>

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

}  // namespace embree_queries
