// The module of the compiler: requests in, answers out.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

// A function from a request to its answer as text. A module that has panicked is of no use after that: the answer is the panic's message.
export async function started(module) {
  const { exports } = await WebAssembly.instantiate(module, {});
  const { memory, room, run, address, length } = exports;
  const read = (count) => decoder.decode(new Uint8Array(memory.buffer, address(), count));
  const ask = (request) => {
    const bytes = encoder.encode(JSON.stringify(request));
    // The memory may grow here, and has another buffer then.
    const at = room(bytes.length);
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
    try {
      return read(run());
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      return JSON.stringify({ panic: read(length()) });
    }
  };
  return { ask, bytes: () => memory.buffer.byteLength };
}

// The base64 of a compressed module as a module.
export async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
