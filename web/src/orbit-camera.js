// A camera on an orbit, eased towards its goal: what mouse, touch, keys and attributes all steer.

const TAU = 2 * Math.PI;
const POLE = 0.01; // rad kept from straight above and below, where azimuth means nothing
const EASE = 0.05; // s: time in which the distance to the goal falls to 1/e

export class OrbitCamera {
  framing = { theta: 0, phi: 1.326, radius: 4, target: [0, 0, 0], size: 1 };
  goal = { ...this.framing, fov: (40 * Math.PI) / 180 };
  now = { ...this.goal, target: [0, 0, 0] };

  /** Takes the engine's camera that shows the whole model as what `auto` means. */
  frame({ eye, target, size }) {
    const offset = eye.map((x, i) => x - target[i]);
    const radius = Math.hypot(...offset);
    this.framing = { theta: Math.atan2(offset[0], offset[2]), phi: Math.acos(offset[1] / radius), radius, target, size };
  }

  /** Eye, target and vertical field of view in radians, as the engine takes them. */
  view() {
    const { theta, phi, radius, target, fov } = this.now;
    const s = Math.sin(phi);
    return {
      eye: [target[0] + radius * s * Math.sin(theta), target[1] + radius * Math.cos(phi), target[2] + radius * s * Math.cos(theta)],
      target,
      fov,
    };
  }

  rotate(dTheta, dPhi) {
    this.goal.theta += dTheta;
    this.goal.phi = clamp(this.goal.phi + dPhi, POLE, Math.PI - POLE);
  }

  zoom(factor) {
    this.goal.radius = clamp(this.goal.radius * factor, 1e-3 * this.framing.size, 100 * this.framing.size);
  }

  /** Moves the target in the picture plane by fractions of the picture's height, right and up. */
  pan(right, up) {
    const { theta, phi, radius, target, fov } = this.goal;
    const scale = 2 * radius * Math.tan(fov / 2);
    const r = [Math.cos(theta), 0, -Math.sin(theta)];
    const u = [-Math.cos(phi) * Math.sin(theta), Math.sin(phi), -Math.cos(phi) * Math.cos(theta)];
    for (let i = 0; i < 3; i++) target[i] += scale * (right * r[i] + up * u[i]);
  }

  set(goal) {
    Object.assign(this.goal, goal);
    this.goal.phi = clamp(this.goal.phi, POLE, Math.PI - POLE);
  }

  jump() {
    this.goal.theta -= TAU * Math.round(this.goal.theta / TAU);
    this.now = { ...this.goal, target: this.goal.target.slice() };
  }

  /** Eases for `seconds`; true while the view still changes visibly. */
  step(seconds) {
    const { now, goal } = this;
    const t = 1 - Math.exp(-seconds / EASE);
    const gap =
      Math.abs(goal.theta - now.theta) + Math.abs(goal.phi - now.phi) + Math.abs(Math.log(goal.radius / now.radius)) +
      Math.abs(goal.fov - now.fov) + distance(goal.target, now.target) / this.framing.size;
    if (gap === 0) return false;
    if (gap < 2e-4) { // a fifth of a pixel at a thousand pixels
      this.now = { ...goal, target: goal.target.slice() };
      return true;
    }
    now.theta += t * (goal.theta - now.theta);
    now.phi += t * (goal.phi - now.phi);
    now.radius *= (goal.radius / now.radius) ** t;
    now.fov += t * (goal.fov - now.fov);
    for (let i = 0; i < 3; i++) now.target[i] += t * (goal.target[i] - now.target[i]);
    return true;
  }
}

function clamp(x, least, most) {
  return Math.min(Math.max(x, least), most);
}

function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
