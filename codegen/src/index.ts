/// The public face of codegen: blocks, program model, types, Haskell.

export type {
  BlockProblem,
  BlockView,
  Checker,
  ConflictNames,
  Inference,
  InScope,
  LaidOut,
  Level,
  NodePlaces,
  OverriddenReaction,
  PrintedProgram,
  Project,
  ProjectOutcome,
  Reference,
  Renaming,
  Session,
  Span,
  ToolboxCategory,
  ToolboxItem,
  TypeInfo,
  Verdict,
} from "./api.ts"
export {socketKey} from "./api.ts"
export type {Connects, Family, Item, MenuEntry, Row, Shape, Sort, StackSort} from "./block_shape.ts"
export {setIn} from "./block_shape.ts"
export {readWorkspace} from "./blocks/block_reader.ts"
export {blockTypes, blockView} from "./blocks/block_registry.ts"
export {isConstructorName, isNumberLiteral, isVariableName, reservedWords} from "./haskell/lexemes.ts"
export {printProgram} from "./haskell/printer.ts"
export {uniqueName} from "./model/unique_name.ts"
export type {
  BlockId,
  Extra,
  Json,
  Place,
  SavedBlock,
  SavedInput,
  SavedWorkspace,
} from "./serialized_blocks.ts"
export type {Call} from "./source/call_at_cursor.ts"
export {callAt, inputsOf} from "./source/call_at_cursor.ts"
export {type Confusable, confusablesIn} from "./source/confusable_characters.ts"
export {hashOf, splitDeclarations} from "./source/declaration_splitter.ts"
export {firstWith, type Token, tokens, tokensAfter} from "./source/lexer.ts"
export {homeOf} from "./types/environment/documentation_links.ts"
export type {Haskell, PieceOfCode} from "./workspace/inference/code_generation.ts"
export {blockAt, codeOf, spanOf, spanOfSocket, toHaskell} from "./workspace/inference/code_generation.ts"
export {conflictMerge} from "./workspace/inference/conflict_merge.ts"
export type {ConflictFix} from "./workspace/inference/conflict_resolutions.ts"
export {conflictFix, conflictShown} from "./workspace/inference/conflict_resolutions.ts"
export type {KnownName} from "./workspace/inference/name_catalog.ts"
export {knownNames, preludeNames} from "./workspace/inference/name_catalog.ts"
export {infer} from "./workspace/inference/workspace_inference.ts"
export type {LookInside} from "./workspace/library_definitions.ts"
export {lookInside, ownDefinition} from "./workspace/library_definitions.ts"
export {find, plug, without} from "./workspace/moves/block_moves.ts"
export {asTask, referenceTo} from "./workspace/moves/definition_references.ts"
export {checker, fits} from "./workspace/moves/drop_checker.ts"
export {namesInScope} from "./workspace/moves/names_in_scope.ts"
export type {Opened} from "./workspace/project_file.ts"
export {
  closeProject,
  newProject,
  newWorkspace,
  openProject,
  parseProject,
  saveProject,
} from "./workspace/project_file.ts"
export {rename, renameNamed} from "./workspace/renaming/renaming.ts"
export {usableItems, withoutMissingParts} from "./workspace/toolbox/missing_parts.ts"
export {withOnlyEvent} from "./workspace/toolbox/own_events.ts"
export {toolbox} from "./workspace/toolbox/toolbox.ts"
export {libraryItems, typedItems} from "./workspace/toolbox/toolbox_search.ts"
export {session} from "./workspace/workspace_session.ts"
