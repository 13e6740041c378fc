/** @file Items of the struct block that declare something. */
/// <reference types="tree-sitter-cli/dsl" />

const { listedOrNone, clauses } = require("./lists");

module.exports = {
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
    $.arc_item,
    $.gravity_item,
    $.body_item,
    $.pair_item,
    $.load_item,
    $.element_item,
    $.friction_item,
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

  // A curved slot.
  arc_item: ($) => seq(
    "arc",
    field("name", $.identifier),
    ":",
    field("point", $._expression),
    "around",
    field("centre", $._expression),
    clauses($.turned_clause),
  ),

  given_list: ($) => seq("{", listedOrNone($.given), "}"),

  given: ($) => seq(field("name", $.identifier), "=", field("value", $._expression)),

  // `crank`, or `crank.length` for a quantity of a link.
  _item_name: ($) => seq(
    field("name", $.identifier),
    optional(seq(".", field("quantity", alias($.identifier, $.field_identifier)))),
  ),
};
