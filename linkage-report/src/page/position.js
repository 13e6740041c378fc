// The position of the mechanism: one row, and the listeners to its changes.

const position = { row: 0, listeners: [] };

function onMove(listener) {
  position.listeners.push(listener);
}

function moveTo(row) {
  const within = Math.min(rowCount - 1, Math.max(0, Math.round(row)));
  if (within === position.row) return;
  position.row = within;
  announcePosition();
}

function announcePosition() {
  for (const listener of position.listeners) listener(position.row);
}
