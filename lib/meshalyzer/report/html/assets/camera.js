// The eye: turned by mouse, fingers and keys, and flying to places. The mesh has radius 1 about 0.
(function (page) {
  "use strict";

  const kFieldOfView = 35;
  const kNearest = 2e-4;
  const kMargin = 1.12;
  const kFarthest = 60;
  const kFlight = 450;  // milliseconds
  const kTurn = Math.PI / 24;

  function prefersStillness() {
    return window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  class Camera {
    constructor(canvas, changed) {
      this.changed = changed;
      this.three = new THREE.PerspectiveCamera(kFieldOfView, 1, 0.01, 10);
      this.controls = new THREE.OrbitControls(this.three, canvas);
      this.controls.enableKeys = false;
      this.controls.screenSpacePanning = true;
      this.controls.minDistance = kNearest;
      this.controls.maxDistance = kFarthest;
      this.flight = null;
      this.content = [];
      this.noticeUpdates(canvas);
      this.place(this.wholeView(new THREE.Vector3(0, 0, 1)));
    }

    // The controls report changes above a threshold that is too coarse for a close look.
    noticeUpdates(canvas) {
      const update = this.controls.update;
      this.controls.update = () => {
        const isChanged = update();
        this.changed();
        return isChanged;
      };
      for (const type of ["mousedown", "wheel", "touchstart"]) {
        canvas.addEventListener(type, () => { this.flight = null; }, { passive: true });
      }
    }

    setAspect(aspect) {
      this.three.aspect = aspect;
      this.three.updateProjectionMatrix();
    }

    // arrays: of the coordinates of what is to fit into the picture when the whole is shown.
    setContent(arrays) { this.content = arrays; }

    // How far off a ball of this radius fills the picture.
    distanceFor(radius) {
      const half = kFieldOfView * Math.PI / 360;
      const narrow = Math.min(half, Math.atan(Math.tan(half) * this.three.aspect));
      return radius / Math.sin(narrow);
    }

    wholeView(direction) {
      const way = besidePole(direction);
      return { target: new THREE.Vector3(), direction: way, distance: this.distanceForContent(way) || this.distanceFor(1.02) };
    }

    // How far off, in a direction from the middle, all of the content is within the picture.
    distanceForContent(way) {
      const right = new THREE.Vector3(0, 1, 0).cross(way).normalize();
      const up = way.clone().cross(right);
      const slopeUp = Math.tan(kFieldOfView * Math.PI / 360);
      const slopeAside = slopeUp * this.three.aspect;
      let distance = 0;
      for (const p of this.content) {
        for (let i = 0; i < p.length; i += 3) {
          const x = p[i], y = p[i + 1], z = p[i + 2];
          const aside = Math.abs(x * right.x + y * right.y + z * right.z) / slopeAside;
          const above = Math.abs(x * up.x + y * up.y + z * up.z) / slopeUp;
          const need = x * way.x + y * way.y + z * way.z + kMargin * Math.max(aside, above);
          if (need > distance) {
            distance = need;
          }
        }
      }
      return distance;
    }

    view() {
      const offset = this.three.position.clone().sub(this.controls.target);
      return { target: this.controls.target.clone(), direction: offset.clone().normalize(), distance: offset.length() };
    }

    place(view) {
      this.controls.target.copy(view.target);
      this.three.position.copy(view.direction).multiplyScalar(view.distance).add(view.target);
      this.controls.update();
    }

    // Near and far as tight as the mesh allows: depth is precise then.
    prepare() {
      const distance = this.three.position.length();
      const toTarget = this.three.position.distanceTo(this.controls.target);
      this.three.near = Math.max(distance - 1.6, 0.02 * toTarget);
      this.three.far = Math.max(distance + 1.6, 2 * this.three.near);
      this.three.updateProjectionMatrix();
      this.three.updateMatrixWorld();
    }

    showWhole() { this.fly(this.wholeView(this.view().direction)); }

    // To a view, in a moment's flight or at once.
    fly(goal, isAtOnce) {
      goal.distance = Math.max(kNearest, Math.min(kFarthest, goal.distance));
      if (isAtOnce || prefersStillness()) {
        this.flight = null;
        this.place(goal);
        return;
      }
      const flight = { from: this.view(), to: goal, start: performance.now() };
      this.flight = flight;
      const step = (now) => {
        if (this.flight === flight && this.stepFlight(flight, now)) {
          requestAnimationFrame(step);
        }
      };
      requestAnimationFrame(step);
    }

    // Whether there is more of it.
    stepFlight(flight, now) {
      const t = Math.max(0, Math.min(1, (now - flight.start) / kFlight));
      const share = t * t * (3 - 2 * t);
      this.place({
        target: flight.from.target.clone().lerp(flight.to.target, share),
        direction: turned(flight.from.direction, flight.to.direction, share),
        distance: flight.from.distance * Math.pow(flight.to.distance / flight.from.distance, share),
      });
      if (t === 1) {
        this.flight = null;
      }
      return t < 1;
    }

    turn(aside, up) {
      this.flight = null;
      const view = this.view();
      const spherical = new THREE.Spherical().setFromVector3(view.direction);
      spherical.theta += aside * kTurn;
      spherical.phi += up * kTurn;
      spherical.makeSafe();
      view.direction.setFromSpherical(spherical);
      this.place(view);
    }

    move(aside, up) {
      this.flight = null;
      const view = this.view();
      const length = 0.05 * view.distance;
      const axes = this.three.matrixWorld.elements;
      for (const [column, amount] of [[0, aside], [4, up]]) {
        view.target.x += axes[column] * amount * length;
        view.target.y += axes[column + 1] * amount * length;
        view.target.z += axes[column + 2] * amount * length;
      }
      this.place(view);
    }

    zoom(factor) {
      this.flight = null;
      const view = this.view();
      view.distance = Math.max(kNearest, Math.min(kFarthest, view.distance * factor));
      this.place(view);
    }
  }

  // A unit vector that is not quite up or down, where no side would be to the right.
  function besidePole(direction) {
    const spherical = new THREE.Spherical().setFromVector3(direction);
    spherical.radius = 1;
    spherical.makeSafe();
    return new THREE.Vector3().setFromSpherical(spherical);
  }

  function turned(from, to, share) {
    const whole = new THREE.Quaternion().setFromUnitVectors(from, to);
    const part = new THREE.Quaternion().slerp(whole, share);
    return from.clone().applyQuaternion(part).normalize();
  }

  page.Camera = Camera;
})(window.meshPage = window.meshPage || {});
