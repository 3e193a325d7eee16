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
  Session,
  Span,
  ToolboxCategory,
  ToolboxItem,
  TypeInfo,
  Verdict,
} from "./api.ts"
export {socketKey} from "./api.ts"
export {blockTypes, blockView} from "./blocks/language.ts"
export {readWorkspace} from "./blocks/read.ts"
export {isConstructorName, isVariableName, reservedWords} from "./haskell/lexemes.ts"
export {printProgram} from "./haskell/print.ts"
export {hashOf, splitDeclarations} from "./haskell/split.ts"
export type {BlockId, Extra, Json, Place, SavedBlock, SavedInput, SavedWorkspace} from "./saved.ts"
export type {Connects, Family, Item, MenuEntry, Row, Shape, Sort, StackSort} from "./shape.ts"
export {setIn} from "./shape.ts"
export {homeOf} from "./types/haddock.ts"
export type {KnownName} from "./types/known.ts"
export {knownNames, preludeNames} from "./types/known.ts"
export {checker, fits} from "./workspace/check.ts"
export type {Haskell, PieceOfCode} from "./workspace/haskell.ts"
export {blockAt, codeOf, spanOf, spanOfSocket, toHaskell} from "./workspace/haskell.ts"
export {infer} from "./workspace/infer.ts"
export {find, plug, without} from "./workspace/plug.ts"
export type {Opened} from "./workspace/project.ts"
export {
  closeProject,
  newProject,
  newWorkspace,
  openProject,
  parseProject,
  saveProject,
} from "./workspace/project.ts"
export {session} from "./workspace/questions.ts"
export {namesInScope, rename, renameNamed} from "./workspace/scope.ts"
export {libraryItems, toolbox, typedItems} from "./workspace/toolbox.ts"
