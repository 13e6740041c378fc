/** @file Lists of rules. */
/// <reference types="tree-sitter-cli/dsl" />

/** Rules between commas, at least one. */
const listed = (rule) => seq(rule, repeat(seq(",", rule)));

/** Rules between commas with an optional comma at the end, or nothing. */
const listedOrNone = (rule) => optional(seq(listed(rule), optional(",")));

/** Clauses in any order, with commas between them or not. */
const clauses = (rule) => seq(repeat(seq(optional(","), rule)), optional(","));

module.exports = { listed, listedOrNone, clauses };
