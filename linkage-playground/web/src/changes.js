// Changes that are offered at the caret, in a list: computed estimates, declarations of unknown words, a picture.

import { byId, element } from "./dom.js";

export async function offerChanges(compiler, editor, say) {
  const { doc, selection } = editor.view.state;
  const { from, to } = selection.main;
  const answer = await compiler.ask({ do: "actions", text: doc.toString(), from, to });
  const changes = answer === null ? [] : JSON.parse(answer);
  if (!Array.isArray(changes) || changes.length === 0) return say("There is no change to offer here.");
  const dialog = byId("changes");
  const take = ({ edits }) => {
    dialog.close();
    if (editor.view.state.doc.eq(doc)) editor.view.dispatch({ changes: edits, userEvent: "input.fix" });
    editor.view.focus();
  };
  dialog.replaceChildren(...changes.map((change) => {
    const button = element("button", { type: "button" }, change.title);
    button.addEventListener("click", () => take(change));
    return button;
  }));
  dialog.showModal();
}

// The text with other blanks, as one step of undo.
export async function format(compiler, editor, say) {
  const { doc } = editor.view.state;
  const { text } = JSON.parse((await compiler.ask({ do: "format", text: doc.toString() })) ?? "{}");
  if (text == null) return say("The text cannot be arranged: a bracket has no partner, or a character means nothing.");
  if (editor.view.state.doc.eq(doc)) editor.replace(text);
}
