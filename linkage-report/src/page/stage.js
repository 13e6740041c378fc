// The mechanism stays in sight while plots are scrolled. A stage that is taller than the window stays with its foot, where dimensions are changed.

const STAGE_AIR = 12;

function startStage() {
  const stage = byId("stage");
  const place = () => {
    stage.style.top = `${Math.min(STAGE_AIR, innerHeight - stage.offsetHeight - STAGE_AIR)}px`;
  };
  observeSize(stage, place);
  listen(window, "resize", place);
}
