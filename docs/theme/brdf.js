// The live part of a BRDF model's page: a lobe, a lit sphere, and the parameters with sliders.
"use strict";

class BrdfPage {
  static passes = 24; // of the sphere
  static samples = 16;

  constructor(place, model) {
    this.place = place;
    this.model = model;
    this.values = model.parameters.map((parameter) => BrdfPage.default_of(parameter));
    this.is_set = model.parameters.map(() => false);
    this.take_example();
    this.view_angle = 45;
    this.light = BrdfPage.unit([-0.55, 0.62, 0.56]);
    place.innerHTML = `
      <div class="brdf-figures">
        <figure><canvas class="brdf-lobe" width="640" height="640" aria-label="Lobe of the BRDF"></canvas>
          <figcaption>Lobe: <i>f</i> cos <i>&theta;<sub>v</sub></i> for the view <i>u</i>. Drag to turn.</figcaption></figure>
        <figure><canvas class="brdf-sphere" width="512" height="512" aria-label="Sphere of the BRDF"></canvas>
          <figcaption>Sphere in a studio. Drag to move the light.</figcaption></figure>
      </div>
      <output class="brdf-value">Values appear under the pointer.</output>
      <div class="brdf-controls"></div>
      <div class="brdf-instance"><code></code><button type="button">Copy</button></div>`;
    this.lobe = new BrdfLobe(place.querySelector(".brdf-lobe"));
    this.sphere = place.querySelector(".brdf-sphere");
    this.shaders = new BrdfShaders(this.sphere, model);
    this.output = place.querySelector("output");
    this.add_controls();
    this.add_pointer();
    place.querySelector("button").onclick = () => navigator.clipboard?.writeText(this.instance());
    this.update();
  }

  static unit(direction) {
    const length = Math.hypot(...direction);
    return direction.map((x) => x / length);
  }

  static default_of(parameter) {
    return parameter.default_rgb || [parameter.default, parameter.default, parameter.default];
  }

  /** The picture of the model shows its example, with which the page begins, too. */
  take_example() {
    for (const [, name, value] of this.model.example.matchAll(/(\w+)=(\([^)]*\)|\S+)/g)) {
      const k = this.model.parameters.findIndex((parameter) => parameter.name === name);
      if (k < 0) continue;
      const { choices } = this.model.parameters[k];
      const number = (word) => (word === "true" ? 1 : word === "false" ? 0 : choices ? choices.indexOf(word) : Number(word));
      const rgb = value.startsWith("(") ? value.slice(1, -1).split(",").map(Number) : Array(3).fill(number(value));
      this.values[k] = rgb;
      this.is_set[k] = true;
    }
  }

  /** The values that shaders take: a parameter that was not set may follow another one. */
  current() {
    return this.values.map((value, k) => {
      const from = this.model.parameters[k].default_from;
      if (!from || this.is_set[k]) return value;
      return this.values[this.model.parameters.findIndex((parameter) => parameter.name === from)];
    });
  }

  /** The BRDF as it is written in scenes and on command lines. */
  instance() {
    const short = (x) => String(Number(x.toPrecision(6)));
    const text_of = (value, { kind, choices }) => {
      if (kind === "boolean") return value[0] ? "true" : "false";
      if (kind === "word") return choices[value[0]];
      return value.every((x) => x === value[0]) ? short(value[0]) : `(${value.map(short).join(", ")})`;
    };
    const parts = this.model.parameters
      .map((parameter, k) => (this.is_set[k] ? `${parameter.name}=${text_of(this.values[k], parameter)}` : ""))
      .filter((part) => part);
    return [this.model.keyword, ...parts].join(" ");
  }

  add_controls() {
    const view = { name: "view", help: "angle of the view u from the normal, of the lobe", min: 0, max: 89, unit: "degrees" };
    this.add_slider(view, () => this.view_angle, (x) => { this.view_angle = x; });
    this.model.parameters.forEach((parameter, k) => {
      const set = (value) => { this.values[k] = value; this.is_set[k] = true; };
      if (parameter.kind === "boolean" || parameter.kind === "word") {
        this.add_choice(parameter, k, set);
      } else {
        this.add_slider(parameter, () => this.current()[k][0], (x) => set(this.scaled(k, x)));
        if (parameter.kind === "reflectance") this.add_colour(parameter, k, set);
      }
    });
    const label = this.row("compress", "show the cube root of the lobe, so that weak parts are seen");
    const box = Object.assign(document.createElement("input"), { type: "checkbox" });
    box.onchange = () => { this.is_compressed = box.checked; this.update_lobe(); };
    label.append(box);
  }

  row(name, help) {
    const label = document.createElement("label");
    label.title = help;
    label.innerHTML = `<span class="brdf-name"></span>`;
    label.firstChild.textContent = name;
    this.place.querySelector(".brdf-controls").append(label);
    return label;
  }

  /** A colour keeps its hue if its slider moves. */
  scaled(k, x) {
    const brightest = Math.max(...this.current()[k]);
    return this.model.parameters[k].kind === "reflectance" && brightest > 0
      ? this.current()[k].map((part) => (part / brightest) * x) : [x, x, x];
  }

  add_slider(parameter, get, set) {
    const label = this.row(parameter.name, `${parameter.help}${parameter.unit ? `, in ${parameter.unit}` : ""}`);
    const slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: 1, step: "any" });
    const field = Object.assign(document.createElement("input"), { type: "number", min: parameter.min, max: parameter.max, step: "any" });
    const { min, max } = parameter;
    // Wide ranges are logarithmic, too, with a step at 0.
    const is_log = parameter.logarithmic || max > 1000;
    const low = min > 0 ? min : Math.min(1, max) / 1000;
    const to_value = (part) => (!is_log ? min + part * (max - min)
      : part === 0 ? min : low * Math.pow(max / low, part));
    const to_part = (value) => (!is_log ? (value - min) / (max - min)
      : value <= low ? 0 : Math.log(value / low) / Math.log(max / low));
    const show = () => {
      slider.value = to_part(get());
      field.value = Number(get().toPrecision(4));
    };
    slider.oninput = () => { set(Number(to_value(Number(slider.value)).toPrecision(4))); this.update(); };
    field.onchange = () => {
      if (field.value !== "") set(Math.min(max, Math.max(min, Number(field.value))));
      this.update();
    };
    label.append(slider, field);
    (this.shown ||= []).push(show);
    show();
  }

  add_choice(parameter, k, set) {
    const label = this.row(parameter.name, parameter.help);
    const list = document.createElement("select");
    (parameter.choices || ["false", "true"]).forEach((word, i) => list.add(new Option(word, i)));
    list.value = this.values[k][0];
    list.onchange = () => { set(Array(3).fill(Number(list.value))); this.update(); };
    label.append(list);
  }

  add_colour(parameter, k, set) {
    const picker = Object.assign(document.createElement("input"), { type: "color", title: `colour of ${parameter.name}` });
    const encoded = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * Math.pow(x, 1 / 2.4) - 0.055);
    const linear = (x) => (x <= 0.04045 ? x / 12.92 : Math.pow((x + 0.055) / 1.055, 2.4));
    const hex = (value) => `#${value.map((x) => Math.round(255 * encoded(Math.min(1, x))).toString(16).padStart(2, "0")).join("")}`;
    picker.oninput = () => {
      const rgb = [1, 3, 5].map((i) => linear(parseInt(picker.value.slice(i, i + 2), 16) / 255));
      set(rgb.map((x) => Number(Math.min(parameter.max, Math.max(parameter.min, x)).toPrecision(4))));
      this.update();
    };
    this.place.querySelector(".brdf-controls").lastChild.append(picker);
    this.shown.push(() => { picker.value = hex(this.current()[k]); });
    this.shown.at(-1)();
  }

  add_pointer() {
    const place_in = (event, canvas) => {
      const box = canvas.getBoundingClientRect();
      return [((event.clientX - box.left) / box.width) * canvas.width, ((event.clientY - box.top) / box.height) * canvas.height];
    };
    this.lobe.canvas.onpointermove = (event) => {
      if (event.buttons) {
        this.lobe.azimuth += event.movementX / 120;
        this.lobe.elevation = Math.min(1.5, Math.max(-0.2, this.lobe.elevation + event.movementY / 120));
        this.lobe.draw();
      }
      const i = this.lobe.pick(...place_in(event, this.lobe.canvas));
      if (i >= 0) this.tell(...this.lobe.angles[i], this.view_angle, this.lobe.values[i]);
    };
    this.sphere.onpointermove = (event) => {
      const [x, y] = place_in(event, this.sphere).map((p) => (p / this.sphere.width - 0.5) / 0.47);
      const z2 = 1 - x * x - y * y;
      if (z2 <= 0) return;
      const normal = [x, -y, Math.sqrt(z2)];
      if (event.buttons) {
        // The light is where its mirror direction is towards the reader.
        this.light = BrdfPage.unit([2 * normal[2] * normal[0], 2 * normal[2] * normal[1], 2 * normal[2] * normal[2] - 1]);
        this.restart_sphere();
      }
      this.tell_at(normal);
    };
    for (const canvas of [this.lobe.canvas, this.sphere]) {
      canvas.onpointerdown = (event) => { canvas.setPointerCapture(event.pointerId); canvas.onpointermove(event); };
    }
  }

  /** Says the value at a point of the sphere, for the reader and the light. */
  tell_at([x, y, z]) {
    const length = Math.hypot(x, z);
    const tangent = length > 0 ? [z / length, 0, -x / length] : [1, 0, 0];
    const bitangent = [y * tangent[2] - z * tangent[1], z * tangent[0] - x * tangent[2], x * tangent[1] - y * tangent[0]];
    const local = (d) => [tangent, bitangent, [x, y, z]].map((axis) => axis.reduce((sum, a, i) => sum + a * d[i], 0));
    const [u, v] = [local([0, 0, 1]), local(this.light)];
    const [value] = this.shaders.evaluate(this.current(), [u], [v]);
    const angle = Math.acos(Math.min(1, u[2])) * (180 / Math.PI);
    this.tell(Math.acos(Math.max(-1, Math.min(1, v[2]))), Math.atan2(v[1], v[0]) - Math.atan2(u[1], u[0]), angle, value);
  }

  tell(theta, phi, view_angle, value) {
    const degrees = (x) => `${((x * 180) / Math.PI).toFixed(1)}°`;
    const turned = ((phi % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
    const is_grey = value.every((x) => Math.abs(x - value[0]) <= 1e-6 * Math.abs(value[0]));
    const text = (is_grey ? value.slice(0, 1) : value).map((x) => x.toPrecision(4)).join(", ");
    this.output.innerHTML = `<i>&theta;<sub>u</sub></i> = ${view_angle.toFixed(1)}°, <i>&theta;<sub>v</sub></i> = ${degrees(theta)},
      <i>&phi;<sub>v</sub></i> = ${degrees(turned)}: <b><i>f</i> = ${text} / sr</b>`;
  }

  update() {
    this.shown?.forEach((show) => show());
    this.place.querySelector(".brdf-instance code").textContent = `brdf ${this.instance()}`;
    this.update_lobe();
    this.restart_sphere();
  }

  update_lobe() {
    const view = brdfDirection((this.view_angle * Math.PI) / 180, 0);
    const views = this.lobe.lights.map(() => view);
    this.lobe.set(this.shaders.evaluate(this.current(), views, this.lobe.lights), view, this.is_compressed);
    this.lobe.draw();
  }

  restart_sphere() {
    this.pass = 0;
    if (!this.is_shading) this.shade();
  }

  /** A pass each time that the browser draws, until there are enough. */
  shade() {
    // The test is about values; a sphere takes software minutes.
    const most = location.hash === "#check" ? 0 : this.shaders.canAdd ? BrdfPage.passes : 1;
    this.is_shading = this.pass < most;
    if (!this.is_shading) return;
    this.shaders.shade(this.current(), this.light, this.pass++, BrdfPage.samples);
    requestAnimationFrame(() => this.shade());
  }

  /** Sets a parameter somewhere in its range, for the test. */
  vary(parameter, k, fraction, step) {
    const { min, max, kind, choices, logarithmic } = parameter;
    const low = min > 0 ? min : Math.min(max, 1) / 100;
    const number = (x) => (logarithmic || max > 100 ? low * Math.pow(max / low, x) : min + x * (max - min));
    const at = (x) => Number(number(x).toPrecision(5));
    this.is_set[k] = true;
    if (kind === "boolean") this.values[k] = Array(3).fill((k + step) % 2);
    else if (kind === "word") this.values[k] = Array(3).fill((k + step) % choices.length);
    else if (kind === "reflectance") this.values[k] = [fraction, 0.8 * fraction, 1 - fraction].map(at);
    else this.values[k] = Array(3).fill(at((fraction + 0.13 * k) % 1));
  }
}

/** Values for the test that compares them with those of bpt: of the example and others, for many directions. */
function brdfCheck(page) {
  const count = 200;
  const part = (i, step) => (0.5 + i * step) % 1;
  const angles = Array.from({ length: count }, (_, i) => [
    1.5 * part(i, 0.754877666), 2 * Math.PI * part(i, 0.569840291), 1.5 * part(i, 0.438579021), 2 * Math.PI * part(i, 0.850650808)]);
  const rounded = angles.map((four) => four.map((x) => Number(x.toFixed(7))));
  return [null, 0.25, 0.5, 0.75].map((fraction, step) => {
    if (fraction !== null) page.model.parameters.forEach((parameter, k) => page.vary(parameter, k, fraction, step));
    const u = rounded.map(([theta, phi]) => brdfDirection(theta, phi));
    const v = rounded.map(([, , theta, phi]) => brdfDirection(theta, phi));
    return { instance: page.instance(), angles: rounded, values: page.shaders.evaluate(page.current(), u, v) };
  });
}

document.addEventListener("DOMContentLoaded", () => {
  const place = document.getElementById("brdf-live");
  try {
    const page = new BrdfPage(place, brdfModel);
    place.hidden = false;
    if (location.hash === "#check") {
      const result = document.createElement("pre");
      result.id = "brdf-check";
      result.textContent = JSON.stringify(brdfCheck(page));
      document.body.append(result);
    }
  } catch (error) {
    // The pictures remain.
    console.warn(`The live BRDF is not shown: ${error.message}`);
    place.dataset.error = error.message;
    place.hidden = true;
  }
});
