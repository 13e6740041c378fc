[
  (item_list)
  (function_list)
  (quantity_list)
  (given_list)
  (list)
  (vector)
  (parenthesis)
  (inputs)
  (call)
] @indent

["}" "]" ")"] @outdent
