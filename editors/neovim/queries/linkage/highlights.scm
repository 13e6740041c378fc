; Later patterns override earlier ones.

(identifier) @variable
(field_identifier) @property
(type_identifier) @type

; Names where they are declared.
(const_item name: (identifier) @constant)
(param_item name: (identifier) @variable.parameter)
(argument_item name: (identifier) @variable.parameter)
(input_item name: (identifier) @variable.parameter)
(rates [speed: (identifier) acceleration: (identifier)] @variable.parameter)
(inputs (identifier) @variable.parameter)
(given name: (identifier) @variable.parameter)
(quantity field: (identifier) @property)
(quantity !field value: (identifier) @property)
(function name: (identifier) @function)

; Names with a meaning of their own.
((identifier) @constant.builtin (#eq? @constant.builtin "PI"))
((identifier) @variable.builtin (#eq? @variable.builtin "frame"))
(link_item name: (identifier) @variable.builtin (#eq? @variable.builtin "frame"))

; Functions of expressions.
(call function: (identifier) @function.call)
((call function: (identifier) @function.builtin)
  (#any-of? @function.builtin
    "polar" "dir" "rotate" "turn" "dot" "cross" "norm" "distance" "unit" "angle" "triangle_angle"
    "sin" "cos" "tan" "asin" "acos" "atan" "atan2" "sqrt" "hypot" "abs" "min" "max"
    "frame" "point_in" "coordinates_in" "rise" "piecewise" "spline" "slope"
    "true_velocity" "true_acceleration" "true_jerk"))

; Quantities of the functions of the `impl` block.
((call function: (identifier) @function.builtin)
  (#any-of? @function.builtin
    "d" "velocity" "acceleration" "jerk" "omega" "alpha" "screw_point" "screw_direction" "screw_pitch"
    "sensitivity" "margin" "picture" "reaction" "moment" "torque" "force" "power"
    "kinetic_energy" "potential_energy" "shaking_force" "shaking_moment"
    "inertia" "bias" "generalised_force" "driven_acceleration" "friction_power" "efficiency"))

; Laws of motion, ends of splines and marks of knots.
((call
  function: (identifier) @_course
  [
    (identifier) @constant.builtin
    (list (vector (identifier) @constant.builtin))
  ])
  (#any-of? @_course "rise" "piecewise" "spline")
  (#any-of? @constant.builtin
    "line" "cubic" "harmonic" "poly345" "poly4567" "cycloidal" "modified_sine" "modified_trapezoid"
    "natural" "clamped" "periodic" "quintic" "jump"))

; Numbers with their units, and units in products: `0.1N*s/m`, `6kg*mm^2`.
(number) @number
(exponent) @number
(unit) @type.builtin
((binary_expression left: (number (unit)) right: (identifier) @type.builtin)
  (#any-of? @type.builtin "m" "mm" "cm" "um" "g" "kg" "N" "kN" "s" "ms" "min" "rad" "deg"))
((binary_expression left: (binary_expression left: (number (unit))) right: (identifier) @type.builtin)
  (#any-of? @type.builtin "m" "mm" "cm" "um" "g" "kg" "N" "kN" "s" "ms" "min" "rad" "deg"))

; Words.
["struct" "impl" "fn" "pub" "crate" "super" "self"] @keyword
[
  "unit" "const" "param" "input" "unknown" "let" "loop" "argument" "part" "gravity" "body" "arc"
  "force" "torque" "spring" "damper" "friction"
  "joint" "link" "slider" "gears" "belt" "weld"
] @keyword
(pair_kind) @keyword
[
  "in" "at" "on" "along" "about" "turns" "turned" "by" "mass" "inertia" "from" "to" "free"
  "length" "block" "around" "through" "radius" "teeth" "radii" "redundant"
] @keyword

(attribute) @attribute

["+" "-" "*" "/" "^" "=" ".." "+-" "+/-" "->"] @operator
["(" ")" "[" "]" "{" "}"] @punctuation.bracket
["," ";" ":" "." "::"] @punctuation.delimiter

(string) @string
[(line_comment) (block_comment)] @comment
(doc_comment) @comment.documentation
