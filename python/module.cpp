#include "python/module.h"

#include "python/messages.h"

PYBIND11_MODULE(_granada, module) {
  module.doc() = "Granada's libraries for Python; `import granada` has all of it.";
  module.attr("__version__") = GRANADA_VERSION;
  python::define_messages(module);
  python::define_brdfs(module);
  python::define_scenes(module);
  python::define_renders(module);
}
