/// Session of questions about one workspace as it changes; results are cached between questions.

import type {Session as PublicSession} from "../api.ts"
import {referenceTo} from "./definition_references.ts"
import {checker} from "./drop_checker.ts"
import {InferenceSession} from "./inference_session.ts"
import {namesInScope} from "./names_in_scope.ts"
import {inferenceOf, type KnownGroups} from "./workspace_inference.ts"

export function session(): PublicSession {
  const remembered = new InferenceSession()
  const known: KnownGroups = new WeakMap()
  return {
    infer: workspace => inferenceOf(workspace, remembered.inferWorkspace(workspace), known),
    checker: workspace => checker(workspace, remembered),
    namesInScope: (workspace, place) => namesInScope(workspace, place, remembered),
    referenceTo: (workspace, place, definition) => referenceTo(workspace, place, definition, remembered),
  }
}
