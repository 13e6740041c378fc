// Programs as data, for pages whose content policy allows no new code.

const STEP = 5;

// The function of a program: its values are kept from call to call, and each call computes all of them again.
function interpreted({ size, constants, steps, outputs }) {
  const v = new Float64Array(size);
  for (const [k, x] of constants) v[k] = x ?? NaN;
  const code = Int32Array.from(steps);
  return (own, x, states, out) => {
    const d = own.dimensions;
    const p = own.prepared;
    for (let at = 0; at < code.length; at += STEP) {
      const k = code[at + 1];
      const a = code[at + 2];
      const b = code[at + 3];
      const c = code[at + 4];
      switch (code[at]) {
        /* cases */
      }
    }
    for (let index = 0; index < outputs.length; index += 1) out[index] = v[outputs[index]];
  };
}

// The description of a mechanism from its data.
function revived(data) {
  const [prepare, bearings] = [data.prepare, data.bearings].map(interpreted);
  return {
    ...data,
    prepare: (own, out) => prepare(own, null, null, out),
    bearings: (own, out) => bearings(own, null, null, out),
    directions: interpreted(data.directions),
    gaps: interpreted(data.gaps),
    slacks: interpreted(data.slacks),
    coupled: data.coupled.map((group) => ({ ...group, correct: interpreted(group.correct) })),
    functions: data.functions.map((fn) => ({ ...fn, run: interpreted(fn.run) })),
  };
}
