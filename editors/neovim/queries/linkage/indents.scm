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
] @indent.begin

["}" "]" ")"] @indent.branch @indent.end

[(line_comment) (doc_comment) (block_comment)] @indent.ignore
