// The call around the caret, above the line: its arguments, and the one that is being written.

import { StateEffect, StateField } from "@codemirror/state";
import { keymap, showTooltip, ViewPlugin } from "@codemirror/view";
import { element } from "./dom.js";
import { shownMarkdown } from "./markdown.js";

// Milliseconds without a key or a move of the caret.
const PAUSE = 150;

const setSignature = StateEffect.define();

const signatureField = StateField.define({
  create: () => null,
  update: (tooltip, { effects, changes, docChanged }) => {
    const set = effects.find((effect) => effect.is(setSignature));
    if (set !== undefined) return set.value;
    return tooltip !== null && docChanged ? { ...tooltip, pos: changes.mapPos(tooltip.pos) } : tooltip;
  },
  provide: (field) => showTooltip.from(field),
});

// The active argument is strong, for readers who do not see it, too.
function shown({ label, arguments: all, active, documentation }) {
  const [from, to] = all[active] ?? [label.length, label.length];
  const call = element("code", {}, label.slice(0, from), element("strong", {}, label.slice(from, to)), label.slice(to));
  return element("div", { class: "hover signature", role: "status" }, element("p", {}, call), ...shownMarkdown(documentation));
}

function isWithinCall({ doc, selection: { main } }) {
  return main.empty && doc.lineAt(main.head).text.slice(0, main.head - doc.lineAt(main.head).from).includes("(");
}

// `ask` gives the call around a place, or null.
export function signatureWith(ask) {
  const asking = ViewPlugin.define((view) => {
    let timer = null;
    const put = (tooltip) => {
      if (tooltip !== null || view.state.field(signatureField) !== null) view.dispatch({ effects: setSignature.of(tooltip) });
    };
    const look = async () => {
      const { state } = view;
      const found = view.hasFocus && isWithinCall(state) ? await ask(state.selection.main.head) : null;
      if (view.state.doc !== state.doc || !view.state.selection.eq(state.selection)) return;
      put(found === null ? null : { pos: state.selection.main.head, above: true, create: () => ({ dom: shown(found) }) });
    };
    return {
      update: ({ docChanged, selectionSet, focusChanged, transactions }) => {
        if (!docChanged && !selectionSet && !focusChanged) return;
        if (transactions.some((transaction) => transaction.isUserEvent("drag"))) return;
        clearTimeout(timer);
        timer = setTimeout(look, PAUSE);
      },
      destroy: () => clearTimeout(timer),
    };
  });
  const close = (view) => {
    if (view.state.field(signatureField) === null) return false;
    view.dispatch({ effects: setSignature.of(null) });
    return true;
  };
  return [signatureField, asking, keymap.of([{ key: "Escape", run: close }])];
}
