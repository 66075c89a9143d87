# cmake -D OUTPUT=file.cpp -D "FILES=a;b" -P embed_texts.cmake
# Writes the contents of files as the table that glsl_texts.h declares, keyed by file name without extension.
set(rows "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND rows "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"renderer/reflectance/glsl_texts.h\"

namespace reflectance {

const std::vector<GlslText>& glsl_texts() {
  static const std::vector<GlslText> texts = {
${rows}  };
  return texts;
}

}  // namespace reflectance
")
