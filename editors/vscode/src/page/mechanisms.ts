// The mechanisms of a text, as far as the page has to know them.

/** A mechanism: its name, and the offset of its struct block. */
interface Found {
  readonly name: string;
  readonly start: number;
}

const IGNORED = /\/\/[^\n]*|\/\*[\s\S]*?\*\//g;
const STRUCT = /\b(struct|impl)\s+([_\p{L}][_\p{L}\p{N}]*)\s*\{/gu;
const MACRO = /\bmechanism!\s*\{/g;

/** Returns the blocks of mechanisms in the order of the text; in Rust those after the first call of the macro. */
function blocks(text: string, isRust: boolean): { readonly isStruct: boolean; readonly found: Found }[] {
  const plain = text.replace(IGNORED, (comment) => comment.replace(/[^\n]/g, " "));
  const macro = isRust ? plain.search(MACRO) : 0;
  if (macro < 0) return [];
  return [...plain.matchAll(STRUCT)]
    .filter((match) => match.index >= macro)
    .map((match) => ({ isStruct: match[1] === "struct", found: { name: match[2] ?? "", start: match.index } }));
}

/**
 * Returns the name of the mechanism whose block contains an offset, or that has the last block before it. The result
 * is `undefined` if a text has fewer than two mechanisms: there is nothing to choose.
 */
export function mechanismAt(text: string, offset: number, isRust: boolean): string | undefined {
  const all = blocks(text, isRust);
  const names = new Set(all.filter(({ isStruct }) => isStruct).map(({ found }) => found.name));
  if (names.size < 2) return undefined;
  const known = all.filter(({ found }) => names.has(found.name));
  const before = known.filter(({ found }) => found.start <= offset);
  return (before.at(-1) ?? known[0])?.found.name;
}
