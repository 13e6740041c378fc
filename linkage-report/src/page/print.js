// Paper cannot be opened: while the page is printed, all folds of the tables are.

const printed = { opened: [] };

function startPrint() {
  listen(window, "beforeprint", openFolds);
  listen(window, "afterprint", closeFolds);
}

function openFolds() {
  // A second command before the first print has ended must not forget the elements that the reader
  // had closed.
  closeFolds();
  printed.opened = [...byId("tables").querySelectorAll("details:not([open])")];
  for (const closed of printed.opened) closed.open = true;
  // Folds tell that they were opened only when the sheets are done.
  showAllValues(position.row);
  for (const own of contributions.folds) own.refresh();
}

function closeFolds() {
  for (const opened of printed.opened) opened.open = false;
  printed.opened = [];
}
