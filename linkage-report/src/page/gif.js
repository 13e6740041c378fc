// A GIF of moving pictures: one palette for all of them, and after the first only the pixels that change.

const GIF = { colours: 255, same: 255, bits: 8, codes: 4096 };

// Colours with five bits for each component.
function gifColour(pixel_) {
  return ((pixel_ & 0xf8) << 7) | ((pixel_ & 0xf800) >> 6) | ((pixel_ & 0xf80000) >> 19);
}

// The most frequent colours, each with the mean of its pixels, and the index of the nearest for every colour.
function gifPalette(samples) {
  const counts = new Map();
  for (const pixels of samples) {
    for (const own of pixels) {
      const key = gifColour(own);
      const sums = counts.get(key) ?? [0, 0, 0, 0];
      [1, own & 255, (own >> 8) & 255, (own >> 16) & 255].forEach((x, k) => (sums[k] += x));
      counts.set(key, sums);
    }
  }
  const common = [...counts.values()].sort((a, b) => b[0] - a[0]).slice(0, GIF.colours);
  const colours = common.map(([count, ...sums]) => sums.map((sum) => Math.round(sum / count)));
  const known = new Int16Array(1 << 15).fill(-1);
  const nearest = (own) => {
    const key = gifColour(own);
    if (known[key] < 0) {
      const here = [own & 255, (own >> 8) & 255, (own >> 16) & 255];
      const aside = colours.map((colour) => colour.reduce((sum, x, k) => sum + (x - here[k]) ** 2, 0));
      known[key] = aside.indexOf(Math.min(...aside));
    }
    return known[key];
  };
  return { colours, nearest };
}

function startGif(width, height, samples) {
  const { colours, nearest } = gifPalette(samples);
  const short_ = (x) => [x & 255, x >> 8];
  const letters = (text) => [...text].map((letter) => letter.charCodeAt(0));
  const table = [...colours.flat(), ...Array(3 * (1 << GIF.bits)).fill(0)].slice(0, 3 * (1 << GIF.bits));
  // Repeats without end.
  const chunks = [[...letters("GIF89a"), ...short_(width), ...short_(height), 0xf7, 0, 0, ...table, 0x21, 0xff, 11, ...letters("NETSCAPE2.0"), 3, 1, 0, 0, 0]];
  let before = null;
  const add = (pixels, hundredths) => {
    const indices = Uint8Array.from(pixels, (own, k) => (before !== null && own === before[k] ? GIF.same : nearest(own)));
    before = pixels;
    chunks.push([0x21, 0xf9, 4, 5, ...short_(hundredths), GIF.same, 0, 0x2c, 0, 0, 0, 0, ...short_(width), ...short_(height), 0, GIF.bits]);
    const bytes = gifCodes(indices);
    for (let at = 0; at < bytes.length; at += 255) {
      const block = bytes.slice(at, at + 255);
      chunks.push([block.length], block);
    }
    chunks.push([0]);
  };
  const end = () => new Blob([...chunks, [0x3b]].map((chunk) => Uint8Array.from(chunk)), { type: "image/gif" });
  return { add, end };
}

// Compressed after Lempel, Ziv and Welch: codes of strings, whose length grows with their number.
function gifCodes(indices) {
  const [clear, stop] = [1 << GIF.bits, (1 << GIF.bits) + 1];
  const table = new Int16Array(GIF.codes << GIF.bits);
  const bytes = [];
  let [next, size, held, count] = [stop + 1, GIF.bits + 1, 0, 0];
  const put = (code) => {
    held |= code << count;
    for (count += size; count >= 8; count -= 8) {
      bytes.push(held & 255);
      held >>>= 8;
    }
  };
  put(clear);
  let prefix = indices[0];
  for (let k = 1; k < indices.length; k += 1) {
    const key = (prefix << GIF.bits) | indices[k];
    if (table[key] !== 0) {
      prefix = table[key];
      continue;
    }
    put(prefix);
    prefix = indices[k];
    if (next === GIF.codes) {
      put(clear);
      table.fill(0);
      [next, size] = [stop + 1, GIF.bits + 1];
    } else {
      if (next >= 1 << size) size += 1;
      table[key] = next;
      next += 1;
    }
  }
  put(prefix);
  put(stop);
  if (count > 0) bytes.push(held & 255);
  return bytes;
}
