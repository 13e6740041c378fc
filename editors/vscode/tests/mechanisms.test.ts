import assert from "node:assert/strict";
import test from "node:test";

import { mechanismAt } from "../src/page/mechanisms.ts";

const TWO = `
// struct Comment {
pub struct Bar { unit mm; /* struct Inner { } */ }
impl Bar { }
struct Former { part bar: Bar { phi = shaft }; }
impl Former { }
`;

test("a text with one mechanism has no choice", () => {
  assert.equal(mechanismAt("struct A { } impl A { }", 5, false), undefined);
  assert.equal(mechanismAt("", 0, false), undefined);
});

test("the mechanism is that of the block at the cursor", () => {
  for (const [word, name] of [["// struct", "Bar"], ["unit mm", "Bar"], ["impl Bar", "Bar"], ["part bar", "Former"], ["impl Former", "Former"]]) {
    assert.equal(mechanismAt(TWO, TWO.indexOf(word ?? ""), false), name, word);
  }
  assert.equal(mechanismAt(TWO, TWO.length, false), "Former");
});

test("types of Rust before the macro are no mechanisms", () => {
  const rust = `struct Other { a: f64 }\nmechanism! {${TWO}}`;
  assert.equal(mechanismAt(rust, 0, true), "Bar");
  assert.equal(mechanismAt(rust, rust.indexOf("impl Former"), true), "Former");
  assert.equal(mechanismAt("struct A { } struct B { }", 3, true), undefined);
});
