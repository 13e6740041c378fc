;;; linkage-mode.el --- Mechanisms by their loop equations  -*- lexical-binding: t; -*-

;; SPDX-License-Identifier: MIT OR Apache-2.0
;; Package-Requires: ((emacs "28.1"))

;;; Commentary:

;; Colours of text files of linkage (`.mech'), and the language server for Eglot, which Emacs has from version 29 on.

;;; Code:

(defgroup linkage nil
  "Mechanisms by their loop equations."
  :group 'languages)

(defcustom linkage-command "linkage"
  "The command of linkage: a name in `exec-path', or a file."
  :type 'string)

(defconst linkage-mode--items
  '("unit" "const" "param" "input" "unknown" "let" "loop" "argument" "part" "gravity" "body" "arc"
    "pin" "slide" "roller" "ball" "cylinder" "fixed" "force" "torque" "spring" "damper" "friction"
    "joint" "link" "slider" "gears" "belt" "weld")
  "Words that items begin with.")

(defconst linkage-mode--functions
  '("polar" "dir" "rotate" "turn" "dot" "cross" "norm" "distance" "unit" "angle" "triangle_angle"
    "sin" "cos" "tan" "asin" "acos" "atan" "atan2" "sqrt" "hypot" "abs" "min" "max"
    "frame" "point_in" "coordinates_in" "rise" "piecewise" "spline" "slope"
    "true_velocity" "true_acceleration" "true_jerk"
    "d" "velocity" "acceleration" "jerk" "omega" "alpha" "screw_point" "screw_direction" "screw_pitch"
    "sensitivity" "margin" "picture" "reaction" "moment" "torque" "force" "power"
    "kinetic_energy" "potential_energy" "shaking_force" "shaking_moment"
    "inertia" "bias" "generalised_force" "driven_acceleration" "friction_power" "efficiency")
  "Words that can be called in expressions.")

(defconst linkage-mode--number
  "\\_<[0-9][0-9_]*\\(?:\\.[0-9][0-9_]*\\)?\\(?:[eE][-+]?[0-9]+\\)?[[:alpha:]]*"
  "A number with its unit.")

(defconst linkage-mode--font-lock
  `(("\\_<\\(struct\\|impl\\)[ \t]+\\(\\(?:\\sw\\|\\s_\\)+\\)" (1 font-lock-keyword-face) (2 font-lock-type-face))
    ("\\_<\\(fn\\)[ \t]+\\(\\(?:\\sw\\|\\s_\\)+\\)" (1 font-lock-keyword-face) (2 font-lock-function-name-face))
    ("->[ \t]*\\(\\(?:\\sw\\|\\s_\\)+\\)" 1 font-lock-type-face)
    ("\\_<pub\\_>" . font-lock-keyword-face)
    ;; Words of the language are names elsewhere: an item begins a line, or follows another one.
    (,(concat "\\(?:^\\|[;{}]\\)[ \t]*" (regexp-opt linkage-mode--items 'symbols) "[ \t]+\\(\\(?:\\sw\\|\\s_\\)+\\)?")
     (1 font-lock-keyword-face) (2 font-lock-variable-name-face nil t))
    (,(concat (regexp-opt linkage-mode--functions 'symbols) "(") 1 font-lock-builtin-face)
    ("\\_<PI\\_>" . font-lock-constant-face)
    (,linkage-mode--number . font-lock-constant-face))
  "Colours of `linkage-mode'.")

(defvar linkage-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?_ "_" table)
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23n" table)
    (modify-syntax-entry ?\n "> b" table)
    table)
  "Comments of `linkage-mode': to the end of a line, and blocks within each other.")

;;;###autoload
(define-derived-mode linkage-mode prog-mode "linkage"
  "Major mode for mechanisms in the language of linkage."
  (setq-local comment-start "// ")
  (setq-local comment-start-skip "//+[ \t]*")
  (setq-local font-lock-defaults '(linkage-mode--font-lock))
  (setq-local indent-line-function #'linkage-mode-indent-line)
  (setq-local tab-width 4))

(defun linkage-mode-indent-line ()
  "Indent the line by four columns more than the line with the bracket around it."
  (interactive)
  (let ((column (save-excursion
                  (back-to-indentation)
                  (let ((open (nth 1 (syntax-ppss)))
                        (step (if (looking-at "[]})]") 0 4)))
                    (if (null open) 0
                      (goto-char open)
                      (+ (current-indentation) step))))))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.mech\\'" . linkage-mode))

(with-eval-after-load 'eglot
  (defvar eglot-server-programs)
  (add-to-list 'eglot-server-programs `(linkage-mode . (,linkage-command "lsp"))))

(provide 'linkage-mode)
;;; linkage-mode.el ends here
