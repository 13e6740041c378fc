; Append this to `queries/rust/injections.scm` of the runtime of Helix: the macro of linkage in Rust files.
((macro_invocation
  macro: [
    (identifier) @_macro
    (scoped_identifier name: (identifier) @_macro)
  ]
  (token_tree) @injection.content)
  (#eq? @_macro "mechanism")
  (#set! injection.language "linkage")
  (#set! injection.include-children))
