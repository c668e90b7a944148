// The size of the texture that holds the nodes.

const COLUMNS = 1024;

/** Width and height of the texture for so many nodes. @param {number} nodes @returns {[number, number]} */
export function textureSize(nodes) {
  const width = Math.max(1, Math.min(COLUMNS, nodes));
  return [width, Math.max(1, Math.ceil(nodes / width))];
}
