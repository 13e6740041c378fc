import assert from "node:assert/strict";
import test from "node:test";

import { framed, newNonce, panelDocument, policy } from "../src/page/frame.ts";

test("each panel has its nonce", () => {
  assert.match(newNonce(), /^[\w-]{24}$/);
  assert.notEqual(newNonce(), newNonce());
});

test("the policy allows scripts with the nonce and nothing from elsewhere", () => {
  const rules = policy("abc").split("; ");
  assert.ok(rules.includes("default-src 'none'"));
  assert.deepEqual(rules.filter((rule) => rule.startsWith("script-src")), ["script-src 'nonce-abc'"]);
  assert.ok(!/https?:|\*|'self'|eval/.test(policy("abc")));
});

test("each script of a page gets the nonce", () => {
  const page = '<script>\na()</script><script type="application/json" id="report">{"a": "\\u003cscript>"}</script>';
  const expected = '<script nonce="n">\na()</script><script nonce="n" type="application/json" id="report">{"a": "\\u003cscript>"}</script>';
  assert.equal(framed(page, "n"), expected);
});

test("a script cannot end its element", () => {
  const text = panelDocument("n", 'a("</script>")');
  assert.equal(text.match(/<\/script/g)?.length, 1);
  assert.ok(text.includes("nonce-n"));
});
