/// The words around the blocks in English: toolbox, menus, buttons. What stands on blocks is codegen's.

import {measuresOf} from "../measures.ts"

const {count} = measuresOf("en")

export const blocks = {
  toolbox: "Toolbox",
  search: "Search blocks",
  searchHint: "Search blocks  /",
  level: "Level:",
  levels: {tasks: "Tasks", reactions: "Reactions", haskell: "All of Haskell"},
  namesInScope: "Names in scope",
  otherNames: "Other names here",
  noNames: "No names can be used here yet",
  chooseFirst: "Choose a block or an empty place first",
  fitsHere: "Fits here. Enter takes the first",
  nothingFits: "Nothing in the toolbox fits here",
  typeToFind: "Type to find a block",
  notFound: "No block has these words",
  found: (n: number) => count(n, {one: "1 block found", other: n => `${n} blocks found`}),
  undo: "Undo",
  redo: "Redo",
  copy: "Copy",
  paste: "Paste",
  showAll: "Show all blocks",
  strays: "Bring stray blocks home",
  nextEmpty: "Next empty place",
  noneEmpty: "No empty place is left",
  fill: "Fill the empty place",
  zoom: "Zoom",
  zoomOut: "Zoom out",
  zoomIn: "Zoom in",
  /// Why a name in the text cannot be changed.
  broken: "Mend this definition first. Then its names can be changed.",
  unfinished: "Something in the program is not finished. Mend it first, so that no place is forgotten.",
} as const
