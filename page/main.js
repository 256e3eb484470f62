// The page of a run: its gallery, and the viewer that opens from it.
import { Gallery } from './gallery/gallery.js';
import { ScriptFiles } from './source/script_files.js';
import { applyStoredTheme } from './theme.js';
import { Viewer } from './viewer/viewer.js';

const source = new ScriptFiles(document);
globalThis.solitaire = { deliver: (key, value) => source.deliver(key, value) };

applyStoredTheme();
const gallery = new Gallery(document, source);
new Viewer(document, source, gallery).followAddress();
