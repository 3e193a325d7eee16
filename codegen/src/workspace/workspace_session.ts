/// Session of questions about one workspace as it changes; results are cached between questions.

import type {Session as PublicSession} from "../api.ts"
import {overriddenReaction} from "./inference/command_conflicts.ts"
import {InferenceSession} from "./inference/inference_session.ts"
import {inferenceOf, type KnownGroups} from "./inference/workspace_inference.ts"
import {referenceTo} from "./moves/definition_references.ts"
import {checker} from "./moves/drop_checker.ts"
import {namesInScope} from "./moves/names_in_scope.ts"

export function session(): PublicSession {
  const remembered = new InferenceSession()
  const known: KnownGroups = new WeakMap()
  return {
    infer: workspace => inferenceOf(workspace, remembered.inferWorkspace(workspace), known),
    checker: workspace => checker(workspace, remembered),
    namesInScope: (workspace, place) => namesInScope(workspace, place, remembered),
    referenceTo: (workspace, place, definition) => referenceTo(workspace, place, definition, remembered),
    overriddenReaction: (workspace, definition) =>
      overriddenReaction(remembered.inferWorkspace(workspace), definition),
  }
}
