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

/** The units of literals, in every spelling. */
const UNITS = [
  "m", "mm", "cm", "um", "\u00b5m", "\u03bcm", "nm", "inch", "ft",
  "deg", "rad", "arcmin", "arcsec", "turn",
  "kg", "g", "mg", "t", "lb",
  "N", "mN", "kN", "lbf",
  "s", "ms", "min", "rpm",
  "J", "mJ", "kJ", "W", "mW", "kW",
  "Pa", "kPa", "MPa", "psi",
];

const PRECEDENCE = { sum: 1, product: 2, sign: 3, postfix: 4 };

/** Rules between commas, at least one. */
const listed = (rule) => seq(rule, repeat(seq(",", rule)));

/** Rules between commas with an optional comma at the end, or nothing. */
const listedOrNone = (rule) => optional(seq(listed(rule), optional(",")));

/** Clauses in any order, with commas between them or not. */
const clauses = (rule) => seq(repeat(seq(optional(","), rule)), optional(","));

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

    // Items of the struct block.

    _item: ($) => choice(
      $.unit_item,
      $.const_item,
      $.param_item,
      $.input_item,
      $.unknown_item,
      $.let_item,
      $.argument_item,
      $.loop_item,
      $.part_item,
      $.gravity_item,
      $.body_item,
      $.pair_item,
      $.load_item,
      $.element_item,
      $.joints_item,
      $.link_item,
      $.slider_item,
      $.wheels_item,
      $.weld_item,
    ),

    unit_item: ($) => seq("unit", alias($.identifier, $.unit)),

    const_item: ($) => seq("const", field("name", $.identifier), "=", field("value", $._expression)),

    param_item: ($) => seq("param", $._item_name, "=", field("value", $._value)),

    input_item: ($) => seq(
      "input",
      field("name", $.identifier),
      "=",
      field("value", $._expression),
      repeat(choice($.range, $.rates)),
    ),

    range: ($) => seq("in", field("low", $._expression), "..", optional("="), field("high", $._expression)),

    rates: ($) => seq("at", field("speed", $.identifier), optional(seq(",", field("acceleration", $.identifier)))),

    unknown_item: ($) => seq("unknown", $._item_name, optional(seq("=", field("value", $._expression)))),

    let_item: ($) => seq("let", $._item_name, "=", field("value", $._expression)),

    argument_item: ($) => seq("argument", field("name", $.identifier), "=", field("value", $._expression)),

    loop_item: ($) => seq(
      "loop",
      field("left", $._expression),
      "=",
      field("right", $._expression),
      optional("redundant"),
    ),

    part_item: ($) => seq(
      "part",
      field("name", $.identifier),
      ":",
      field("mechanism", $._type_name),
      field("given", $.given_list),
      clauses(choice($.on_clause, $.at_clause, $.turned_clause)),
    ),

    given_list: ($) => seq("{", listedOrNone($.given), "}"),

    given: ($) => seq(field("name", $.identifier), "=", field("value", $._expression)),

    // `crank`, or `crank.length` for a quantity of a link.
    _item_name: ($) => seq(
      field("name", $.identifier),
      optional(seq(".", field("quantity", alias($.identifier, $.field_identifier)))),
    ),

    // Bodies and loads.

    gravity_item: ($) => seq("gravity", "=", field("value", $._expression)),

    body_item: ($) => seq(
      "body",
      field("name", $.identifier),
      "=",
      $.pair_kind,
      optional(field("joint", $.identifier)),
      clauses(choice(
        $.on_clause,
        $.at_clause,
        $.along_clause,
        $.about_clause,
        $.turns_clause,
        $.mass_clause,
        $.inertia_clause,
      )),
    ),

    pair_item: ($) => seq(
      $.pair_kind,
      field("name", $.identifier),
      "=",
      field("body", $.member),
      clauses(choice($.on_clause, $.at_clause, $.along_clause, $.about_clause)),
    ),

    pair_kind: () => choice("pin", "slide", "roller", "ball", "cylinder", "fixed"),

    load_item: ($) => seq(
      choice("force", "torque"),
      field("value", $._expression),
      clauses(choice($.on_clause, $.from_clause, $.at_clause)),
    ),

    element_item: ($) => seq(
      choice("spring", "damper"),
      field("value", $._expression),
      clauses(choice($.on_clause, $.end_clause, $.free_clause)),
    ),

    // Joints and links.

    joints_item: ($) => seq("joint", listed($.drawn_joint)),

    drawn_joint: ($) => seq(field("name", $.identifier), "=", field("position", $._value)),

    link_item: ($) => seq(
      "link",
      field("name", $.identifier),
      ":",
      $.link_joint,
      repeat(choice(
        seq(",", $.link_joint),
        seq(
          optional(","),
          choice($.at_clause, $.length_clause, $.about_clause, $.mass_clause, $.inertia_clause),
        ),
      )),
      optional(","),
    ),

    link_joint: ($) => seq(field("name", $.identifier), optional(seq("=", field("position", $._value)))),

    slider_item: ($) => seq(
      "slider",
      field("name", $.identifier),
      ":",
      field("joint", $.identifier),
      "on",
      field("link", $.identifier),
      choice($.line_of_joints, $.line_of_direction, $.arc),
      clauses(choice($.radius_clause, $.block_clause, $.at_clause)),
    ),

    line_of_joints: ($) => seq("along", $.identifier, ",", $.identifier),

    line_of_direction: ($) => seq("along", $._expression, optional(seq("through", $.identifier))),

    arc: ($) => seq("around", $.identifier),

    wheels_item: ($) => seq(
      choice("gears", "belt"),
      field("wheel", $.identifier),
      ",",
      field("wheel", $.identifier),
      optional(seq("on", field("link", $.identifier))),
      optional(","),
      choice("teeth", "radii"),
      $._expression,
      ",",
      $._expression,
    ),

    weld_item: ($) => seq("weld", field("link", $.identifier), repeat1(seq(",", field("link", $.identifier)))),

    // Clauses.

    on_clause: ($) => seq("on", $.member),
    from_clause: ($) => seq("from", $.member),
    end_clause: ($) => seq(choice("from", "to"), $.member, "at", $._expression),
    at_clause: ($) => seq("at", $._expression),
    along_clause: ($) => seq("along", $._expression),
    about_clause: ($) => seq("about", $._expression),
    turns_clause: ($) => seq("turns", $._expression),
    turned_clause: ($) => seq("turned", optional("by"), $._expression),
    mass_clause: ($) => prec.right(seq("mass", $._expression, optional(seq("at", $._expression)))),
    inertia_clause: ($) => prec.right(seq("inertia", $._expression, optional(seq("at", $._expression)))),
    free_clause: ($) => seq("free", $._expression),
    length_clause: ($) => seq("length", $._value),
    radius_clause: ($) => seq("radius", $._value),
    block_clause: ($) => seq("block", $.identifier),

    // `rod`, `hook.rod`
    member: ($) => seq($.identifier, repeat(seq(".", alias($.identifier, $.field_identifier)))),

    // Expressions.

    // A nominal value, with a tolerance or without.
    _value: ($) => choice($._expression, $.tolerance),

    tolerance: ($) => seq(field("nominal", $._expression), choice("+-", "+/-"), field("tolerance", $._expression)),

    _expression: ($) => choice(
      $.binary_expression,
      $.negation,
      $.component,
      $.entry,
      $.call,
      $.power,
      $.vector,
      $.parenthesis,
      $.list,
      $.number,
      $.identifier,
    ),

    binary_expression: ($) => choice(
      prec.left(PRECEDENCE.sum, seq(
        field("left", $._expression),
        field("operator", choice("+", "-")),
        field("right", $._expression),
      )),
      prec.left(PRECEDENCE.product, seq(
        field("left", $._expression),
        field("operator", choice("*", "/")),
        field("right", $._expression),
      )),
    ),

    negation: ($) => prec(PRECEDENCE.sign, seq("-", $._expression)),

    component: ($) => prec(PRECEDENCE.postfix, seq(
      field("value", $._expression),
      ".",
      field("field", alias($.identifier, $.field_identifier)),
    )),

    entry: ($) => prec(PRECEDENCE.postfix, seq(field("value", $._expression), "[", field("index", $._expression), "]")),

    call: ($) => prec(PRECEDENCE.postfix, seq(
      field("function", $.identifier),
      "(",
      listedOrNone($._expression),
      ")",
    )),

    // Only units have powers: `mm^2`, `s^-1`.
    power: ($) => prec(PRECEDENCE.postfix, seq(
      field("base", alias($.identifier, $.unit)),
      "^",
      field("exponent", $.exponent),
    )),

    exponent: () => seq(optional("-"), /\d+/),

    vector: ($) => seq("(", $._value, choice(",", seq(repeat1(seq(",", $._value)), optional(","))), ")"),

    parenthesis: ($) => seq("(", $._value, ")"),

    list: ($) => seq("[", listedOrNone($._expression), "]"),

    number: ($) => seq($._digits, optional(token.immediate(".")), optional($.unit)),

    _digits: () => /\d[\d_]*(\.\d[\d_]*)?([eE][+-]?_*\d[\d_]*)?/,

    unit: () => choice(...UNITS),

    // Names.

    _type_name: ($) => alias($.identifier, $.type_identifier),

    identifier: () => /[_\p{XID_Start}][\p{XID_Continue}]*/u,

    // Comments. Four strokes are no doc comment.

    line_comment: () => token(seq("//", choice(seq("//", /[^\n]*/), /([^\/\n][^\n]*)?/))),

    doc_comment: () => token(seq("///", /([^\/\n][^\n]*)?/)),
  },
});
