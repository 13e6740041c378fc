// What a host uses of the page.

function pageHandle() {
  return {
    title: report.title,
    get source() { return report.live.source; },
    state: pageState,
    renew: renewed,
    edits: textEdits,
    isPlane: picture?.dimension === 2,
    unit: picture?.unit ?? "",
    goToReference,
    placeUnder: (event) => placeUnder(onDrawing(event)),
    pixel: () => 1 / cameraScale(),
    end: () => { setPlaying(false); life.abort(); },
  };
}

function goToReference() {
  const [unit] = engine.programs;
  setPlaying(false);
  moveTo(nearestRow(unit.reference[unit.inputs.findIndex(({ name }) => name === input.name)]));
}

// The rest of the script is that of the function that a host calls.
onChange(() => host.changed());
return pageHandle();
