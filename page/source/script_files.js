// Where the page's parts come from: scripts beside it. A page that is opened from a disk may neither fetch files nor
// load modules, but it may load scripts, each of which delivers one value under a key.
//
// Another source, such as a server, takes the place of this class by having stage(), solution() and choices().
import { inflated, inflatedJson } from './packed.js';

export class ScriptFiles {
  constructor(document) {
    this.document = document;
    this.waiting = new Map();  // resolve functions by key
    this.loads = new Map();    // promises by file, of what is loading or kept
  }

  /** Called by the scripts. */
  deliver(key, value) {
    this.waiting.get(key)?.(value);
  }

  /** Returns what shows scenes, with three.js in it. */
  stage() {
    return this.#kept('page/stage.js', 'stage');
  }

  /** Returns the choices of all solutions. */
  choices() {
    return this.#kept('page/choices.js', 'choices');
  }

  /** Returns what there is to say about a solution, and the bytes of its .glb or null. */
  async solution({ name, facts }) {
    const packed = await this.#loaded(facts.script, name);
    const [about, glb] = await Promise.all([
      inflatedJson(packed.about),
      packed.glb ? inflated(packed.glb) : null,
    ]);
    return { about, glb };
  }

  #kept(file, key) {
    if (!this.loads.has(file)) {
      const load = this.#load(file, key);
      this.loads.set(file, load);
      load.catch(() => this.loads.delete(file));
    }
    return this.loads.get(file);
  }

  /** Two that ask for the same file at the same time share it; afterwards it is forgotten. */
  #loaded(file, key) {
    const load = this.#kept(file, key);
    const forget = () => this.loads.delete(file);
    load.then(forget, forget);
    return load;
  }

  async #load(file, key) {
    const script = this.document.createElement('script');
    try {
      return await new Promise((resolve, reject) => {
        this.waiting.set(key, resolve);
        script.onload = () => reject(new Error(`${file} does not hold what it should`));
        script.onerror = () => reject(new Error(`${file} is missing beside the page`));
        script.src = './' + file.split('/').map(encodeURIComponent).join('/');
        this.document.head.append(script);
      });
    } finally {
      this.waiting.delete(key);
      script.remove();
    }
  }
}
