// Which scene an address names behind its #.

/** @param {string} text */
const plain = (text) => text.toLowerCase().replaceAll("-", " ");

/** The scene of that name, or the first whose name has it as a part; else the first.
 * @param {string[]} names @param {string} hash with its # */
export function named(names, hash) {
  const wanted = plain(decodeURIComponent(hash.slice(1)));
  if (!wanted) return 0;
  const known = names.map(plain);
  const exact = known.indexOf(wanted);
  return Math.max(exact >= 0 ? exact : known.findIndex((name) => name.includes(wanted)), 0);
}
