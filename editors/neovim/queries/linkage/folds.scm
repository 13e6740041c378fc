[
  (item_list)
  (function_list)
  (quantity_list)
  (given_list)
  (list)
  (block_comment)
] @fold

((doc_comment)+) @fold
