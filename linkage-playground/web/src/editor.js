// The editor of the text, with messages under the words, hover and completion.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyField, historyKeymap, isolateHistory, redo, redoDepth, undo, undoDepth } from "@codemirror/commands";
import { bracketMatching, indentOnInput, indentUnit } from "@codemirror/language";
import { diagnosticCount, lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { EditorState, Transaction } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, hoverTooltip, keymap, lineNumbers } from "@codemirror/view";
import { difference } from "./difference.js";
import { fileField, fileHistory, setFile } from "./file_state.js";
import { hints } from "./hints.js";
import { colouredWith } from "./language.js";
import { signatureWith } from "./signature.js";

// `changed` hears of every change of the text; `assist` asks the compiler; `words` are those of the language.
export function makeEditor(parent, { changed, assist, words }) {
  const view = new EditorView({ parent, root: parent.getRootNode() });
  const extensions = [
    lineNumbers(), lintGutter(), highlightActiveLineGutter(), history(), fileHistory, drawSelection(), indentOnInput(), bracketMatching(), closeBrackets(),
    autocompletion({ override: [assist.complete] }), highlightActiveLine(), highlightSelectionMatches(), search({ top: true }), indentUnit.of("    "),
    keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...completionKeymap, ...lintKeymap]),
    hoverTooltip(assist.hover), signatureWith(assist.signature), hints, colouredWith(words), theme, EditorView.lineWrapping,
    EditorView.contentAttributes.of({ "aria-label": "Text of the mechanism", spellcheck: "false", autocapitalize: "off" }),
    EditorView.updateListener.of((update) => update.docChanged && changed(update)),
  ];
  const stored = { history: historyField, file: fileField };
  return {
    view,
    // The first text of the page: there is nothing to undo before it.
    begin: (text, file) => view.setState(EditorState.create({ doc: text, extensions: [extensions, fileField.init(() => file)] })),
    // The state of an earlier page with its steps of undo.
    resume: (json) => view.setState(EditorState.fromJSON(json, { extensions }, stored)),
    state: () => view.state.toJSON(stored),
    // Another text in the place of this one, as one step of undo.
    open: (text, file) => {
      const changes = { from: 0, to: view.state.doc.length, insert: text };
      view.dispatch({ changes, effects: setFile.of(file), selection: { anchor: 0 }, scrollIntoView: true, annotations: isolateHistory.of("full"), userEvent: "input.open" });
    },
    file: () => view.state.field(fileField),
    text: () => view.state.doc.toString(),
    // The numbers of steps that can be undone and done again.
    steps: () => ({ undo: undoDepth(view.state), redo: redoDepth(view.state) }),
    tell: (messages) => {
      // Each change of the view takes its time.
      if (messages.length > 0 || diagnosticCount(view.state) > 0) view.dispatch(setDiagnostics(view.state, messages.map((message) => diagnostic(view.state, message))));
    },
    replace: (text) => {
      const changes = difference(view.state.doc.toString(), text);
      if (changes !== null) view.dispatch({ changes, annotations: isolateHistory.of("full"), userEvent: "input.format" });
    },
    undo: () => undo(view),
    redo: () => redo(view),
    go: (place) => {
      const at = Math.min(place, view.state.doc.length);
      view.dispatch({ selection: { anchor: at }, effects: EditorView.scrollIntoView(at, { y: "center" }) });
      view.focus();
    },
    // Changes that a drag makes: none of them is a step of undo.
    preview: (changes) => view.dispatch({ changes, annotations: [Transaction.addToHistory.of(false), Transaction.userEvent.of("drag")] }),
    // All changes of a drag as one step.
    commit: (changes) => view.dispatch({ changes, annotations: [isolateHistory.of("full"), Transaction.userEvent.of("drag")] }),
  };
}

function diagnostic({ doc }, { from, to, severity, text, fixes }) {
  const [begin, end] = [Math.min(from, doc.length), Math.min(Math.max(to, from), doc.length)];
  // The places of a change are those of the text that was analysed.
  const actions = fixes.map(({ title, edits }) => ({ name: title, apply: (view) => view.state.doc.eq(doc) && view.dispatch({ changes: edits, userEvent: "input.fix" }) }));
  return { from: begin, to: end, severity, message: text, actions };
}

const theme = EditorView.theme({
  "&": { height: "100%", backgroundColor: "var(--paper)", color: "var(--ink)" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "ui-monospace, 'Cascadia Mono', 'DejaVu Sans Mono', Menlo, monospace", fontSize: "13.5px", lineHeight: "1.5" },
  ".cm-gutters": { backgroundColor: "var(--sheet)", color: "var(--faint)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--active)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "var(--selection)" },
  ".cm-tooltip, .cm-panels": { backgroundColor: "var(--sheet)", color: "var(--ink)", border: "1px solid var(--line)" },
  ".cm-tooltip": { maxWidth: "60ch", whiteSpace: "pre-wrap", borderRadius: "6px" },
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": { backgroundColor: "var(--accent)", color: "var(--paper)" },
  ".cm-tooltip.cm-tooltip-autocomplete": { maxWidth: "none" },
  ".cm-completionInfo": { whiteSpace: "pre-wrap" },
  ".cm-diagnostic": { whiteSpace: "pre-wrap" },
  ".hover": { padding: "6px 10px" },
  ".hover p, .hover pre": { margin: "2px 0" },
  ".hover hr": { margin: "4px 0", border: "solid var(--line)", borderWidth: "1px 0 0" },
  ".hover code, .hover pre": { fontFamily: "ui-monospace, 'Cascadia Mono', 'DejaVu Sans Mono', Menlo, monospace", fontSize: "13px" },
  ".declared, .declared span": { color: "var(--ink) !important", fontWeight: "400 !important" },
  ".hint": { color: "var(--faint)", fontSize: "12px", fontStyle: "italic" },
  ".cm-matchingBracket": { backgroundColor: "var(--selection) !important" },
});
