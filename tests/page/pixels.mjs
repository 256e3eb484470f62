// What is seen on a screenshot.

/** Returns {width, height, data}, rows of red, green, blue, alpha, of a PNG: the browser itself reads it. */
async function decoded(page, png) {
  const { width, height, data } = await page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const bytes = context.getImageData(0, 0, canvas.width, canvas.height).data;
    let binary = '';
    for (let at = 0; at < bytes.length; at += 8192) binary += String.fromCharCode(...bytes.subarray(at, at + 8192));
    return { width: canvas.width, height: canvas.height, data: btoa(binary) };
  }, png.toString('base64'));
  return { width, height, data: Buffer.from(data, 'base64') };
}

/** Returns a picture of an element, without the frame that says that it has the focus. */
export async function seen(page, locator) {
  return decoded(page, await locator.screenshot({ style: ':focus-visible { outline: none !important; }' }));
}

export const kColours = {
  red: ([r, g, b]) => r > 1.6 * g && r > 1.6 * b && r > 60,
  green: ([r, g, b]) => g > 1.4 * r && g > 1.4 * b && g > 50,
  blue: ([r, g, b]) => b > 1.25 * r && b > 1.1 * g && b > 70,
  orange: ([r, g, b]) => r > 1.25 * g && g > 1.25 * b && r > 120,
};

/** Returns the connected areas {pixels, x, y} of a colour, largest first; x and y are in an area, near its middle. */
export function areas({ width, height, data }, isColour, least = 30) {
  const is = Uint8Array.from({ length: width * height }, (_, at) => isColour(data.subarray(4 * at, 4 * at + 3)) ? 1 : 0);
  const found = [];
  for (let start = 0; start < is.length; ++start) {
    if (is[start] !== 1) continue;
    const area = [start];
    is[start] = 2;
    for (let next = 0; next < area.length; ++next) {
      const at = area[next], x = at % width;
      const around = [x > 0 ? at - 1 : -1, x < width - 1 ? at + 1 : -1, at - width, at + width];
      for (const each of around) {
        if (is[each] === 1) is[each] = 2, area.push(each);
      }
    }
    if (area.length >= least) found.push({ pixels: area.length, ...middle(area, width) });
  }
  return found.sort((a, b) => b.pixels - a.pixels);
}

function middle(area, width) {
  const mean = (of) => area.reduce((sum, at) => sum + of(at), 0) / area.length;
  const [x, y] = [mean((at) => at % width), mean((at) => Math.floor(at / width))];
  const away = (at) => Math.hypot(at % width - x, Math.floor(at / width) - y);
  const nearest = area.reduce((best, at) => (away(at) < away(best) ? at : best));
  return { x: nearest % width, y: Math.floor(nearest / width) };
}

/** Returns the share of the pixels that are of a colour. */
export function share({ width, height, data }, isColour) {
  let count = 0;
  for (let at = 0; at < data.length; at += 4) count += isColour(data.subarray(at, at + 3)) ? 1 : 0;
  return count / (width * height);
}
