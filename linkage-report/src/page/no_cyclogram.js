// A page without a cyclogram has no code for it, only what other scripts call.

const cycle = { view: null };

function fadeOrgans() {}

function startCyclogram() {}

function startMoments() {}
