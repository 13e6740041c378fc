/**
 * @file The text language of linkage: struct blocks with items, and `impl` blocks with functions.
 *
 * Words of the language are no reserved names. The parser reads them as words only where a word can
 * be, so that `param link = 42mm` has a parameter with the name `link`.
 *
 * @license MIT OR Apache-2.0
 */
/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

const { listedOrNone } = require("./rules/lists");

module.exports = grammar({
  name: "linkage",

  word: ($) => $.identifier,

  externals: ($) => [$.block_comment],

  extras: ($) => [/\s/, $.line_comment, $.doc_comment, $.block_comment],

  supertypes: ($) => [$._item, $._expression],

  conflicts: ($) => [[$._expression, $.line_of_joints]],

  rules: {
    // In a Rust file the parser gets the braces of the macro, too.
    source_file: ($) => choice(repeat($._block), $.macro_body),

    macro_body: ($) => seq("{", repeat($._block), "}"),

    _block: ($) => choice($.struct_block, $.impl_block),

    struct_block: ($) => seq(
      repeat($.attribute),
      optional($.visibility),
      "struct",
      field("name", $._type_name),
      field("body", $.item_list),
    ),

    // The last item may lack its semicolon.
    item_list: ($) => seq(
      "{",
      repeat(choice(";", seq(repeat($.attribute), $._item, ";"))),
      optional(seq(repeat($.attribute), $._item)),
      "}",
    ),

    impl_block: ($) => seq(
      repeat($.attribute),
      "impl",
      field("name", $._type_name),
      field("body", $.function_list),
    ),

    function_list: ($) => seq("{", repeat($.function), "}"),

    function: ($) => seq(
      repeat($.attribute),
      optional($.visibility),
      "fn",
      field("name", $.identifier),
      field("inputs", $.inputs),
      "->",
      field("result", $._type_name),
      field("body", $.quantity_list),
    ),

    inputs: ($) => seq("(", listedOrNone($.identifier), ")"),

    quantity_list: ($) => seq("{", listedOrNone(seq(repeat($.attribute), $.quantity)), "}"),

    quantity: ($) => choice(
      seq(field("field", $.identifier), ":", field("value", $._expression)),
      field("value", $.identifier),
    ),

    visibility: ($) => seq("pub", optional(seq("(", choice("crate", "super", "self", seq("in", $.path)), ")"))),

    path: ($) => seq($._segment, repeat(seq("::", $._segment))),

    _segment: ($) => choice($.identifier, "crate", "super", "self"),

    attribute: ($) => seq("#", "[", repeat($._token), "]"),

    token_tree: ($) => choice(
      seq("(", repeat($._token), ")"),
      seq("[", repeat($._token), "]"),
      seq("{", repeat($._token), "}"),
    ),

    _token: ($) => choice($.identifier, $.string, /\d[\w.]*/, /[^\s\w"()\[\]{}]/, $.token_tree),

    string: () => /"([^"\\]|\\.)*"/,

    ...require("./rules/items"),
    ...require("./rules/mechanics"),
    ...require("./rules/expressions"),
  },
});
