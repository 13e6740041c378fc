/** @file Expressions, numbers and names. */
/// <reference types="tree-sitter-cli/dsl" />

const { listedOrNone } = require("./lists");

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

module.exports = {
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
};
