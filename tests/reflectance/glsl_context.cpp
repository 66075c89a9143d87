#include "tests/reflectance/glsl_context.h"

#define GL_GLEXT_PROTOTYPES
#include <stdexcept>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

namespace test {
namespace {

using reflectance::Rgb;
using reflectance::Vec3f;

constexpr int Width = 256;

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("OpenGL: " + what);
}

GLuint compile(GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  require(compiled != 0, log);
  return shader;
}

GLuint link(const std::string& fragment_source) {
  const GLuint program = glCreateProgram();
  // One triangle covers the image.
  glAttachShader(program, compile(GL_VERTEX_SHADER,
                                  "#version 330 core\n"
                                  "void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1,"
                                  " 2 * (gl_VertexID & 2) - 1, 0, 1); }\n"));
  glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment_source));
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  require(linked != 0, "the program does not link");
  return program;
}

GLuint texture_of(GLenum unit, GLint format, int width, int height, const Vec3f* values) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGB, GL_FLOAT, values);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

/// Makes a texture of three floats per texel, as high as needed.
GLuint input_texture(GLenum unit, int width, std::vector<Vec3f> values) {
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t height = (values.size() + columns - 1) / columns;
  values.resize(columns * height);
  return texture_of(unit, GL_RGB32F, width, static_cast<int>(height), values.data());
}

std::string fragment_shader(const std::string& functions, const std::string& expression) {
  return "#version 330 core\n" + functions +
         "uniform sampler2D u_directions;\n"
         "uniform sampler2D v_directions;\n"
         "uniform sampler2D parameters;\n"
         "uniform int pairs_each;\n"
         "out vec4 result;\n"
         "int row;\n"
         "vec3 parameter(int k) { return texelFetch(parameters, ivec2(k, row), 0).xyz; }\n"
         "void main() {\n"
         "  ivec2 place = ivec2(gl_FragCoord.xy);\n"
         "  row = (place.x + " +
         std::to_string(Width) +
         " * place.y) / pairs_each;\n"
         "  vec3 u = texelFetch(u_directions, place, 0).xyz;\n"
         "  vec3 v = texelFetch(v_directions, place, 0).xyz;\n"
         "  result = vec4(" +
         expression +
         ", 1);\n"
         "}\n";
}

}  // namespace

struct GlslContext::Display {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

GlslContext::GlslContext() : display_(std::make_unique<Display>()) {
  display_->display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  require(eglInitialize(display_->display, nullptr, nullptr) != 0, "no surfaceless EGL");
  require(eglBindAPI(EGL_OPENGL_API) != 0, "no desktop OpenGL");
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_NONE};
  display_->context = eglCreateContext(display_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  require(display_->context != EGL_NO_CONTEXT, "no OpenGL 3.3 context");
  require(eglMakeCurrent(display_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, display_->context) != 0,
          "the context cannot be made current");
}

GlslContext::~GlslContext() {
  eglMakeCurrent(display_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_->display, display_->context);
  eglTerminate(display_->display);
}

std::string GlslContext::renderer() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

std::vector<Rgb> GlslContext::run(const std::string& functions, const std::string& expression,
                                  const std::vector<Vec3f>& u, const std::vector<Vec3f>& v,
                                  const ShaderParameters& parameters) {
  const int height = static_cast<int>((u.size() + Width - 1) / Width);
  const GLuint program = link(fragment_shader(functions, expression));
  // Renderable formats have four channels.
  const GLuint target = texture_of(GL_TEXTURE3, GL_RGBA32F, Width, height, nullptr);
  const GLuint textures[] = {input_texture(GL_TEXTURE0, Width, u), input_texture(GL_TEXTURE1, Width, v),
                             input_texture(GL_TEXTURE2, parameters.width, parameters.values), target};
  GLuint framebuffer = 0;
  GLuint vertices = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
  require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "no float framebuffer");
  glGenVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  glViewport(0, 0, Width, height);
  glUseProgram(program);
  glUniform1i(glGetUniformLocation(program, "u_directions"), 0);
  glUniform1i(glGetUniformLocation(program, "v_directions"), 1);
  glUniform1i(glGetUniformLocation(program, "parameters"), 2);
  glUniform1i(glGetUniformLocation(program, "pairs_each"), parameters.pairs_each);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<Rgb> result(static_cast<std::size_t>(Width) * static_cast<std::size_t>(height));
  glReadPixels(0, 0, Width, height, GL_RGB, GL_FLOAT, result.data());
  require(glGetError() == GL_NO_ERROR, "drawing failed");
  glDeleteVertexArrays(1, &vertices);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(4, textures);
  glDeleteProgram(program);
  result.resize(u.size());
  return result;
}

}  // namespace test
