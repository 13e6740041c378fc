// The file of the text as a part of the editor's state, so that undo leads back to the file as well.

import { invertedEffects } from "@codemirror/commands";
import { StateEffect, StateField } from "@codemirror/state";

// The file of a text that nobody has opened.
export const NEW_FILE = { name: "mechanism.mech", form: { hasMark: false, end: "\n" } };

export const setFile = StateEffect.define();

export const fileField = StateField.define({
  create: () => NEW_FILE,
  update: (file, { effects }) => effects.findLast((effect) => effect.is(setFile))?.value ?? file,
  toJSON: (file) => file,
  fromJSON: (file) => file,
});

export const fileHistory = [
  fileField,
  invertedEffects.of(({ effects, startState }) => (effects.some((effect) => effect.is(setFile)) ? [setFile.of(startState.field(fileField))] : [])),
];
