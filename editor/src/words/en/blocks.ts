/// The words around the blocks in English: toolbox, menus, buttons. What stands on blocks is codegen's.

import {measuresOf} from "../number_formats.ts"

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
  referenceLeft: (name: string) => `${name} is used here now`,
  notFound: "No block has these words",
  found: (n: number) => count(n, {one: "1 block found", other: n => `${n} blocks found`}),
  lookInside: "Look inside",
  noLookInside: "First put a function into the empty place. What is inside depends on its type.",
  undo: "Undo",
  redo: "Redo",
  copy: "Copy",
  paste: "Paste",
  showAll: "Show all blocks",
  strays: "Bring stray blocks home",
  nextEmpty: "Next empty place",
  noneEmpty: "No empty place is left",
  fill: "Fill the empty place",
  fillNext: "Fill the next empty place",
  runOneMore: "Run one more",
  nextNumber: "Next number",
  noNumber: "No number is there",
  typeNumber: "Write a number",
  searchKeys:
    "Enter puts the first one into the chosen place. Shift and Enter then search for the next empty place.",
  dropToDelete: "Drop here to delete",
  deleted: "Deleted blocks",
  zoom: "Zoom",
  zoomOut: "Zoom out",
  zoomIn: "Zoom in",
} as const
