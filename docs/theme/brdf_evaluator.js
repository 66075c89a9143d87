// Evaluates a BRDF model by WebGL 2, and shades a sphere with it, by the shaders that the page brings: `brdfModel`.
"use strict";

/** A unit vector in the local frame, z along the normal, from angles in radians. */
function brdfDirection(theta, phi) {
  return [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];
}

class BrdfShaders {
  /** Throws if the canvas has no WebGL 2, or its driver does not compile a shader. */
  constructor(canvas, model) {
    const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("WebGL 2 is missing");
    this.gl = gl;
    this.canvas = canvas;
    this.evaluator = this.program(model.evaluator);
    this.model = model;
    this.sphere = null; // compiled when it is shown
    this.shown = this.program(`#version 300 es
      precision highp float;
      uniform sampler2D sums;
      out vec4 result;
      void main() {
        vec4 sum = texelFetch(sums, ivec2(gl_FragCoord.xy), 0);
        vec3 radiance = 1.0 - exp(-1.1 * sum.rgb / max(sum.a, 1.0));
        vec3 encoded = mix(12.92 * radiance, 1.055 * pow(radiance, vec3(1.0 / 2.4)) - 0.055,
                           step(vec3(0.0031308), radiance));
        vec2 place = (gl_FragCoord.xy / float(textureSize(sums, 0).x) - 0.5) / 0.47;
        float edge = clamp((1.0 - length(place)) * 0.47 * float(textureSize(sums, 0).x), 0.0, 1.0);
        result = vec4(encoded * edge, edge);
      }`);
    this.canAdd = gl.getExtension("EXT_color_buffer_float") !== null;
    gl.getExtension("EXT_float_blend");
    this.sums = null;
    gl.bindVertexArray(gl.createVertexArray());
  }

  program(fragment) {
    const gl = this.gl;
    const vertex = `#version 300 es
      void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }`;
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      const logs = gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader));
      throw new Error(`${gl.getProgramInfoLog(program)} ${logs.join(" ")}`);
    }
    return program;
  }

  /** A texture without filtering; `data` may be null. */
  texture(format, width, height, layout, type, data) {
    const gl = this.gl;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, layout, type, data);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  setParameters(program, values) {
    const place = this.gl.getUniformLocation(program, "brdf_parameters[0]") ||
      this.gl.getUniformLocation(program, "brdf_parameters");
    if (place) this.gl.uniform3fv(place, new Float32Array(values.flat()));
  }

  /** f in 1/sr, RGB, of each pair of unit vectors, with a triple for each parameter of the model. */
  evaluate(values, views, lights) {
    const gl = this.gl;
    const width = Math.min(views.length, 1024);
    const height = Math.ceil(views.length / width);
    const texture_of = (directions) => {
      const data = new Float32Array(4 * width * height);
      directions.forEach((direction, i) => data.set(direction, 4 * i));
      return this.texture(gl.RGBA32F, width, height, gl.RGBA, gl.FLOAT, data);
    };
    const inputs = [texture_of(views), texture_of(lights)];
    const target = this.texture(gl.RGBA32UI, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, null);
    const buffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    gl.useProgram(this.evaluator);
    this.setParameters(this.evaluator, values);
    ["views", "lights"].forEach((name, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, inputs[unit]);
      gl.uniform1i(gl.getUniformLocation(this.evaluator, name), unit);
    });
    gl.viewport(0, 0, width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const bits = new Uint32Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, bits);
    gl.activeTexture(gl.TEXTURE0);
    gl.deleteFramebuffer(buffer);
    [...inputs, target].forEach((texture) => gl.deleteTexture(texture));
    const numbers = new Float32Array(bits.buffer);
    return views.map((_, i) => [numbers[4 * i], numbers[4 * i + 1], numbers[4 * i + 2]]);
  }

  /** Adds a pass of `count` directions to the image of the sphere, and shows it. The first pass clears it. */
  shade(values, light, pass, count) {
    const gl = this.gl;
    const side = this.canvas.width;
    if (!this.sums || this.sums.side !== side) {
      if (this.sums) gl.deleteTexture(this.sums.texture);
      const texture = this.canAdd
        ? this.texture(gl.RGBA16F, side, side, gl.RGBA, gl.HALF_FLOAT, null)
        : this.texture(gl.RGBA8, side, side, gl.RGBA, gl.UNSIGNED_BYTE, null);
      this.sums = { side, texture, buffer: gl.createFramebuffer() };
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.sums.buffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.sums.buffer);
    gl.viewport(0, 0, side, side);
    if (pass === 0) {
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT);
    }
    this.sphere ||= this.program(this.model.sphere);
    gl.useProgram(this.sphere);
    this.setParameters(this.sphere, values);
    const place = (name) => gl.getUniformLocation(this.sphere, name);
    gl.uniform3fv(place("light"), light);
    gl.uniform1f(place("side"), side);
    gl.uniform1i(place("first"), pass * count);
    gl.uniform1i(place("samples"), count);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.BLEND);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.useProgram(this.shown);
    gl.bindTexture(gl.TEXTURE_2D, this.sums.texture);
    gl.uniform1i(gl.getUniformLocation(this.shown, "sums"), 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
