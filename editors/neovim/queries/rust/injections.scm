; extends

; The macro of linkage in Rust files: a query for the parser of Rust.
((macro_invocation
  macro: [
    (identifier) @_macro
    (scoped_identifier name: (identifier) @_macro)
  ]
  (token_tree) @injection.content)
  (#eq? @_macro "mechanism")
  (#set! injection.language "linkage")
  (#set! injection.include-children))
