// Draws the lobe of a BRDF for one view: a surface whose distance from the centre is f cos(theta_v).
"use strict";

class BrdfLobe {
  static rows = 60; // of the light's angle from the normal
  static columns = 120; // of its azimuth

  constructor(canvas) {
    this.canvas = canvas;
    this.azimuth = 1.15;
    this.elevation = 0.3;
    this.angles = [];
    for (let i = 0; i <= BrdfLobe.rows; ++i) {
      for (let k = 0; k < BrdfLobe.columns; ++k) {
        this.angles.push([(i / BrdfLobe.rows) * 0.4999 * Math.PI, (k / BrdfLobe.columns) * 2 * Math.PI]);
      }
    }
    this.lights = this.angles.map(([theta, phi]) => brdfDirection(theta, phi));
    this.radii = new Array(this.lights.length).fill(0);
  }

  /** Takes f for each of `lights`; compressed, the distance is the cube root. */
  set(values, view, isCompressed) {
    this.values = values;
    this.view = view;
    const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
    const radii = values.map((value, i) => Math.max(0, luminance(value) * this.lights[i][2]));
    this.largest = radii.reduce((a, b) => Math.max(a, b), 0);
    this.radii = radii.map((radius) => {
      const part = this.largest > 0 ? radius / this.largest : 0;
      return isCompressed ? Math.cbrt(part) : part;
    });
  }

  /** Where a point is on the canvas, and its distance from the front. */
  project([x, y, z]) {
    const size = this.canvas.width;
    const c = Math.cos(this.azimuth);
    const s = Math.sin(this.azimuth);
    const right = s * x + c * y;
    const back = c * x - s * y;
    const up = z * Math.cos(this.elevation) + back * Math.sin(this.elevation);
    const depth = back * Math.cos(this.elevation) - z * Math.sin(this.elevation);
    return [size * (0.5 + 0.43 * right), size * (0.72 - 0.58 * up), depth];
  }

  draw() {
    const context = this.canvas.getContext("2d");
    const style = getComputedStyle(this.canvas);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.points = this.lights.map((light, i) => this.project(light.map((x) => x * this.radii[i])));
    this.draw_ground(context, style.color);
    const quads = [];
    for (let i = 0; i < BrdfLobe.rows; ++i) {
      for (let k = 0; k < BrdfLobe.columns; ++k) {
        const next = (k + 1) % BrdfLobe.columns;
        const corners = [i * BrdfLobe.columns + k, i * BrdfLobe.columns + next, (i + 1) * BrdfLobe.columns + next,
          (i + 1) * BrdfLobe.columns + k];
        quads.push({ corners, depth: corners.reduce((sum, c) => sum + this.points[c][2], 0) });
      }
    }
    quads.sort((a, b) => b.depth - a.depth);
    for (const { corners } of quads) this.draw_quad(context, corners);
    this.draw_arrow(context, this.view, style.color);
  }

  draw_quad(context, corners) {
    const position = (c) => this.lights[c].map((x) => x * this.radii[c]);
    const [a, b, c, d] = corners.map(position);
    const minus = (p, q) => p.map((x, i) => x - q[i]);
    const [p, q] = [minus(c, a), minus(d, b)];
    const normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const length = Math.hypot(...normal);
    if (length < 1e-9) return;
    // A light over the shoulder of the reader, whatever side of the surface is seen.
    const turned = this.azimuth + 0.6;
    const light = [-Math.cos(turned) * 0.6, Math.sin(turned) * 0.6, 0.53];
    const lit = 0.35 + 0.65 * Math.abs(normal.reduce((sum, x, i) => sum + x * light[i], 0)) / length;
    const colour = this.colour(this.values[corners[0]]);
    context.fillStyle = context.strokeStyle = `rgb(${colour.map((x) => Math.round(255 * Math.min(1, x * lit))).join(" ")})`;
    context.lineWidth = 0.7;
    context.beginPath();
    corners.forEach((corner) => context.lineTo(this.points[corner][0], this.points[corner][1]));
    context.closePath();
    context.fill();
    context.stroke();
  }

  /** The hue of a value, without its brightness; values without one have the colour of the site. */
  colour(value) {
    const brightest = Math.max(...value);
    const spread = brightest > 0 ? 1 - Math.min(...value) / brightest : 0;
    const own = value.map((x) => (brightest > 0 ? Math.pow(x / brightest, 1 / 2.2) : 0));
    const plain = [0.93, 0.56, 0.36];
    const part = Math.min(1, 4 * spread);
    return own.map((x, i) => part * x + (1 - part) * plain[i]);
  }

  draw_ground(context, colour) {
    context.strokeStyle = colour;
    context.globalAlpha = 0.25;
    context.lineWidth = this.canvas.width / 400;
    for (const radius of [0.5, 1]) {
      context.beginPath();
      for (let i = 0; i <= 72; ++i) {
        const angle = (i / 72) * 2 * Math.PI;
        context.lineTo(...this.project([radius * Math.cos(angle), radius * Math.sin(angle), 0]));
      }
      context.stroke();
    }
    context.globalAlpha = 1;
    this.draw_arrow(context, [0, 0, 1], colour, "n", 0.35);
  }

  draw_arrow(context, direction, colour, name = "u", alpha = 1) {
    const [x, y] = this.project([0, 0, 0]);
    const [end_x, end_y] = this.project(direction.map((part) => 1.05 * part));
    context.globalAlpha = alpha;
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = this.canvas.width / 220;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(end_x, end_y);
    context.stroke();
    context.beginPath();
    context.arc(end_x, end_y, this.canvas.width / 110, 0, 2 * Math.PI);
    context.fill();
    context.font = `italic ${this.canvas.width / 22}px serif`;
    context.fillText(name, end_x + this.canvas.width / 60, end_y);
    context.globalAlpha = 1;
  }

  /** The index of the light whose point of the surface is at a place of the canvas and nearest to the reader. */
  pick(x, y) {
    const reach = this.canvas.width / 25;
    let best = -1;
    this.points?.forEach(([px, py, depth], i) => {
      const is_near = Math.hypot(px - x, py - y) < reach && this.radii[i] > 1e-3;
      if (is_near && (best < 0 || depth < this.points[best][2])) best = i;
    });
    return best;
  }
}
