// Values next to names: of derived quantities, and solutions that differ from their estimates. Names that are words of the language elsewhere.

import { StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, WidgetType } from "@codemirror/view";
import { element } from "./dom.js";

const setHints = StateEffect.define();

class Hint extends WidgetType {
  constructor(label, isSolution) {
    super();
    Object.assign(this, { label, isSolution });
  }

  eq({ label, isSolution }) {
    return label === this.label && isSolution === this.isSolution;
  }

  toDOM() {
    return element("span", { class: "hint", title: this.isSolution ? "the solution, which differs from the estimate" : "the value at the reference position" }, this.label);
  }
}

const name = Decoration.mark({ class: "declared" });

function decorations({ values, names }) {
  const hints = values.map(({ at, label, isSolution }) => Decoration.widget({ widget: new Hint(label, isSolution), side: 1 }).range(at));
  return Decoration.set([...hints, ...names.map(([from, to]) => name.range(from, to))], true);
}

// Values follow their names while the text changes, until others are shown.
export const hints = StateField.define({
  create: () => Decoration.none,
  update: (shown, { effects, changes }) => {
    const set = effects.find((effect) => effect.is(setHints));
    return set === undefined ? shown.map(changes) : decorations(set.value);
  },
  provide: (field) => EditorView.decorations.from(field),
});

export function showHints(view, found) {
  view.dispatch({ effects: setHints.of(found) });
}
