/// The public face of codegen: blocks, program model, types, Haskell.

export type {
  BlockProblem,
  BlockView,
  Checker,
  Inference,
  InScope,
  LaidOut,
  Level,
  PrintedProgram,
  Project,
  ProjectOutcome,
  Renaming,
  Span,
  ToolboxCategory,
  ToolboxItem,
  TypeInfo,
  Verdict,
} from "./api.ts"
export {socketKey} from "./api.ts"
export type {BlockId, Extra, Json, Place, SavedBlock, SavedInput, SavedWorkspace} from "./saved.ts"
export type {Connects, Family, Item, Row, Shape, Sort, StackSort} from "./shape.ts"
export {setIn} from "./shape.ts"
