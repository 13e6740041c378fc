;;; eglot.el --- Opens a text with a mistake  -*- lexical-binding: t; -*-

;;; Commentary:

;; Prints the messages and the hover of a name, and mends the text. The folder of the text is in FOLDER, the command in LINKAGE.

;;; Code:

(require 'package)
(package-initialize)
(unless (require 'eglot nil t)
  (princ "no eglot\n")
  (kill-emacs))
(add-to-list 'load-path (expand-file-name "emacs" (getenv "EDITORS")))
(defvar linkage-command (getenv "LINKAGE"))
(require 'linkage-mode)
(setq eglot-sync-connect 60)

(defun wait-until (condition)
  "Wait for a minute at most, until CONDITION returns non-nil."
  (let ((turns 600))
    (while (and (> turns 0) (not (funcall condition)))
      (accept-process-output nil 0.1)
      (flymake-start)
      (setq turns (1- turns)))))

(find-file (expand-file-name "broken.mech" (getenv "FOLDER")))
(princ (format "type: %s\n" major-mode))
(apply #'eglot (eglot--guess-contact))
(wait-until #'flymake-diagnostics)
(dolist (found (flymake-diagnostics))
  (princ (format "message: %d %s\n"
                 (line-number-at-pos (flymake-diagnostic-beg found)) (flymake-diagnostic-text found))))
(goto-char (point-min))
(search-forward "let pin")
(let ((hover (jsonrpc-request (eglot-current-server) :textDocument/hover (eglot--TextDocumentPositionParams))))
  (princ (format "hover: %s\n" (car (split-string (plist-get (plist-get hover :contents) :value) "\n")))))
(search-forward "rodx")
(delete-char -1)
(eglot--signal-textDocument/didChange)
(wait-until (lambda () (null (flymake-diagnostics))))
(princ (format "left: %d\n" (length (flymake-diagnostics))))

;;; eglot.el ends here
