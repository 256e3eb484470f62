// What shows scenes, as the page loads it: everything that needs three.js.
import { readScene } from './read_scene.js';
import { Stage } from './stage.js';

globalThis.solitaire.deliver('stage', { readScene, Stage });
