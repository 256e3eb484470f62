// Shows one scene on a canvas, and says what is picked. Draws only when something has changed.
import {
  Color, Group, Mesh, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, Scene, Vector3,
  WebGLRenderer,
} from 'three';
import { Batches } from './batches.js';
import { Cutaway } from './cutaway.js';
import { farObjects, hasManyTriangles } from './far.js';
import { fitted, threeQuarterView } from './fit.js';
import { disposeOfLighting, lightingFor, surroundings } from './lighting.js';
import { Mats } from './mats.js';
import { Orbit } from './orbit.js';
import { Picker } from './picker.js';
import { selectionMaterial, styleOf } from './styles.js';
import { Walk } from './walk.js';

const kBackground = { orbit: [0xeceae6, 0x24272c], walk: [0xdbe6ef, 0x1d2733] };  // light, dark
const kMostPixels = 2;  // for each pixel of the page
const kRest = 200;      // milliseconds without a movement, after which things that came nearer are drawn in full

export class Stage {
  /** `picked(object or null)` is called when somebody clicks, `moved()` whenever the camera has moved. Throws where
   * the browser has no WebGL. */
  constructor(canvas, { picked, moved }) {
    this.canvas = canvas;
    this.moved = moved;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.localClippingEnabled = true;
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.scene = new Scene();
    this.renderer.shadowMap.autoUpdate = false;
    this.scene.environment = surroundings();
    this.scene.environmentIntensity = 0.35;
    this.camera = new PerspectiveCamera(30, 1, 0.1, 100);
    this.batches = new Batches();
    this.selection = new Group();
    this.mats = new Mats();
    this.scene.add(this.batches.group, this.mats.group, this.selection);
    this.selectionMaterial = selectionMaterial();
    this.orbit = new Orbit(this.camera, canvas, () => this.#cameraMoved());
    this.walk = new Walk(this.camera, canvas, this.batches.group, (hit) => this.#isPassable(hit),
                         () => this.#cameraMoved());
    this.picker = new Picker(canvas, this.camera, this.batches, { picked, focused: (object) => this.focus(object) });
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(canvas);
    this.resize();
  }

  /** Shows a scene whose walls have these addresses. `kindOf(object)` gives the style of each: "plain", "faded",
   * "moved", "changed" or "only". */
  show(model, walls, kindOf = () => 'plain') {
    this.model = model;
    this.kindOf = kindOf;
    this.cutaway = new Cutaway(model.objects, walls);
    this.cut = new Map();
    this.far = new Set();
    this.hasManyTriangles = hasManyTriangles(model.objects);
    this.batches.show(model.objects, (object) => this.#style(object));
    const moved = model.objects.filter((object) => kindOf(object) === 'moved');
    this.mats.lay(moved.map(({ box }) => box), this.#extent());
    if (this.lighting) this.#removeLighting();
    this.lighting = lightingFor(model.box);
    this.scene.add(this.lighting);
    this.renderer.shadowMap.needsUpdate = true;
    this.select(null);
    this.reset();
    this.#findFar();
  }

  /** Goes back to where the whole scene is seen. */
  reset() {
    if (this.walk.active) {
      this.walk.enter(this.model.objects, this.model.box);
      return;
    }
    this.#fitCamera();
    const view = fitted(this.model.objects.map((object) => object.box), threeQuarterView(), this.camera);
    this.orbit.look(view.position, view.target, this.#extent());
    this.#cameraMoved();
    this.isUnmoved = true;
  }

  /** "orbit" or "walk". */
  set mode(mode) {
    const walking = mode === 'walk';
    if (walking === this.walk.active) return;
    this.orbit.enabled = !walking;
    this.camera.fov = walking ? 60 : 30;
    if (walking) this.walk.enter(this.model.objects, this.model.box);
    else this.walk.leave(), this.reset();
    this.#colourBackground();
  }

  get mode() {
    return this.walk.active ? 'walk' : 'orbit';
  }

  /** Marks an object as the selected one, or none. */
  select(object) {
    this.selection.clear();
    for (const { geometry, matrix } of object?.parts ?? []) {
      const mesh = new Mesh(geometry, this.selectionMaterial);
      mesh.matrixAutoUpdate = false;
      mesh.matrix.copy(matrix);
      this.selection.add(mesh);
    }
    this.selected = object;
    this.invalidate();
  }

  focus(object) {
    if (!this.walk.active) this.orbit.focus(object.box);
  }

  /** Returns true if the key means something to the camera. */
  key(key, isDown) {
    if (this.walk.active) return this.walk.press(key, isDown);
    return isDown && this.orbit.press(key);
  }

  /** Looks as another stage does. */
  follow(other) {
    this.camera.fov = other.camera.fov;
    this.camera.position.copy(other.camera.position);
    this.camera.quaternion.copy(other.camera.quaternion);
    this.orbit.target.copy(other.orbit.target);
    this.#update();
  }

  /** How the scene's surroundings are coloured. */
  set dark(dark) {
    this.isDark = dark;
    this.#colourBackground();
  }

  /** Draws soon. */
  invalidate() {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = null;
      this.render();
    });
  }

  render() {
    this.renderer.render(this.scene, this.camera);
  }

  /** Fits the picture to the canvas, if that has another size than before: to draw a large scene twice takes long. */
  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const size = `${width} ${height} ${devicePixelRatio}`;
    if (width === 0 || height === 0 || size === this.size) return;
    this.size = size;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, kMostPixels));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    if (this.isUnmoved && !this.walk.active) this.reset();
    else this.#update();
  }

  dispose() {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.rest);
    this.resizing.disconnect();
    this.picker.dispose();
    this.walk.dispose();
    this.orbit.dispose();
    this.batches.clear();
    this.mats.dispose();
    if (this.lighting) this.#removeLighting();
    this.selectionMaterial.dispose();
    this.scene.environment.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  #cameraMoved() {
    this.isUnmoved = false;
    this.#update();
    this.moved();
  }

  /** Brings what depends on the camera up to date. */
  #update() {
    if (!this.model) return;
    this.#fitCamera();
    this.#cutWalls();
    this.#waitForRest();
    this.invalidate();
  }

  /** Sets the depth that the camera sees, by how large the scene is and how far away. */
  #fitCamera() {
    const extent = this.#extent();
    const away = this.model.box.distanceToPoint(this.camera.position);
    this.camera.near = Math.max(away * 0.5, extent * 5e-4);
    this.camera.far = away + extent * 8;
    this.camera.updateProjectionMatrix();
  }

  #colourBackground() {
    this.scene.background = new Color(kBackground[this.mode][this.isDark ? 1 : 0]);
    this.invalidate();
  }

  #extent() {
    return Math.max(this.model.box.getSize(new Vector3()).length(), 1e-3);
  }

  #cutWalls() {
    const toCamera = this.camera.position.clone().sub(this.orbit.target).normalize();
    this.cut = this.walk.active ? new Map() : this.cutaway.heights(toCamera);
    this.#restyle();
  }

  #waitForRest() {
    if (!this.hasManyTriangles) return;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.#findFar(), kRest);
  }

  #findFar() {
    clearTimeout(this.rest);
    if (!this.hasManyTriangles) return;
    this.far = farObjects(this.model.objects, this.camera, this.canvas.clientHeight);
    this.#restyle();
  }

  #restyle() {
    if (!this.batches.restyle((object) => this.#style(object))) return;
    this.renderer.shadowMap.needsUpdate = true;
    this.invalidate();
  }

  #style(object) {
    return styleOf(this.kindOf(object), this.cut.get(object), this.far.has(object));
  }

  #isPassable(hit) {
    return /\bdoor/i.test(this.batches.objectAt(hit).name);
  }

  #removeLighting() {
    this.scene.remove(this.lighting);
    disposeOfLighting(this.lighting);
  }
}
