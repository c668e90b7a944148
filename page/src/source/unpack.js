// Numbers of a recording, unpacked: what src/ropewalk/live/packing.py packs.

/** @typedef {{name: string, columns: number, low: number[], step: number[], order: number, planes: number,
 *   bytes: number}} Stream */

/** A stream with its multiples, column after column.
 * @typedef {{columns: number, rows: number, low: number[], step: number[], whole: Int32Array}} Numbers */

/** The bytes of base64 text. @param {string} text */
export function fromBase64(text) {
  const raw = atob(text.trim());
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

/** @param {Uint8Array<ArrayBuffer>} bytes */
export async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** @param {Stream} stream @param {number} rows @param {Uint8Array} bytes inflated @returns {Numbers} */
export function unpack({ columns, low, step, order, planes }, rows, bytes) {
  const count = rows * columns;
  if (bytes.length !== count * planes) throw new Error("the recording is damaged");
  const whole = new Int32Array(count);
  for (let column = 0; column < columns; column++) {
    let value = 0;
    let change = 0;
    for (let at = column * rows; at < (column + 1) * rows; at++) {
      let zigzag = bytes[at];
      for (let plane = 1; plane < planes; plane++)
        zigzag |= bytes[plane * count + at] << (8 * plane);
      const difference = (zigzag >>> 1) ^ -(zigzag & 1);
      if (order === 2) value += change += difference;
      else value += difference;
      whole[at] = value;
    }
  }
  return { columns, rows, low, step, whole };
}

/** One row of numbers. @template {Float32Array | Float64Array} T @param {Numbers} numbers
 * @param {number} row @param {T} out @returns {T} */
export function rowOf({ columns, rows, low, step, whole }, row, out) {
  for (let column = 0; column < columns; column++) {
    out[column] = low[column] + step[column] * whole[column * rows + row];
  }
  return out;
}
