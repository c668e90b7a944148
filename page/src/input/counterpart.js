// Which node and segment of the first copy a hit on another one stands for: commands count in the first.

/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../source/protocol.js").Variant} Variant */
/** @typedef {import("./pick.js").Hit} Hit */

/** Node and segment in the first copy, as far along the rope of the same name. @param {Layout | null} layout
 * @param {Pick<Hit, "variant" | "node" | "segment">} hit @returns {{node: number, segment: number}} */
export function ofFirst(layout, { variant, node, segment }) {
  const own = layout?.variants[variant]?.ropes.find(
    ({ first, nodes }) => node >= first && node < first + nodes,
  );
  const there = layout?.variants[0].ropes.find(({ name }) => name === own?.name);
  if (!own || !there) return { node, segment };
  const scale = there.segments / Math.max(own.segments, 1);
  const along = Math.floor((segment - own.zero + 0.5) * scale); // where its middle lies
  return {
    node: there.zero + Math.round((node - own.zero) * scale),
    segment: there.zero + Math.min(Math.max(along, 0), there.segments - 1),
  };
}

/** Nodes as they are numbered once there are more or fewer: as far along the same ropes.
 * @param {Set<number>} nodes @param {Variant} before @param {Variant} now */
export function alike(nodes, before, now) {
  if (before.nodes === now.nodes) return nodes;
  const both = /** @type {Layout} */ ({ variants: [now, before] });
  const found = [...nodes].map((node) => ofFirst(both, { variant: 1, node, segment: node }).node);
  return new Set(found.filter((node) => node < now.nodes));
}
