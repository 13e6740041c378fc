/** @file Bodies and loads, joints and links, and their clauses. */
/// <reference types="tree-sitter-cli/dsl" />

const { listed, clauses } = require("./lists");

module.exports = {
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

  friction_item: ($) => seq(
    "friction",
    field("value", $._expression),
    clauses(choice($.on_clause, $.radius_clause, $.length_clause)),
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
};
