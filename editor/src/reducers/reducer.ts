/// Reducer of the page's state: an event turns one state into the next and lists the effects to perform. Pure.

import {reduceLesson} from "../state/lesson_state.ts"
import type {PageEvent} from "../state/page_events.ts"
import type {PageState} from "../state/page_state.ts"
import {reduceRobotEvent} from "../state/robot_ownership.ts"
import {still, type Transition} from "../state/transition.ts"
import {loseConnection, reduceServiceMessage} from "./connection_reducer.ts"
import {reduceDocumentEvent} from "./document_reducer.ts"
import {withFixPreviews} from "./fix_preview_requests.ts"
import {withPreview} from "./preview_requests.ts"
import {reduceRecording} from "./recording_reducer.ts"
import {explain, withDraftRoom, withLessons} from "./request_reducer.ts"
import {reduceRunEvent} from "./run_reducer.ts"
import {reduceRunTree} from "./run_tree_reducer.ts"
import {reduceViewEvent} from "./view_reducer.ts"
import {reduceWorldEvent} from "./world_reducer.ts"

export function reduce(state: PageState, event: PageEvent): Transition {
  return withFixPreviews(state, withPreview(state, next(state, event)))
}

/// Hands the event to the reducer of its topic.
function next(state: PageState, event: PageEvent): Transition {
  switch (event.kind) {
    case "link-lost":
      return still(loseConnection(state))
    case "heard":
      return reduceServiceMessage(state, event.message)
    case "run-pressed":
    case "stop-pressed":
    case "reset-pressed":
    case "pause-pressed":
    case "resume-pressed":
    case "forward-pressed":
    case "speed-chosen":
    case "looked-back":
    case "continue-pressed":
    case "hand":
    case "safety-switched":
    case "values-shown":
    case "diagram-pointed":
    case "function-graphed":
      return reduceRunEvent(state, event)
    case "run-shown":
    case "run-compared":
      return reduceRunTree(state, event)
    case "recording-wanted":
      return reduceRecording(state, event)
    case "robots-unlocked":
    case "robot-taken":
    case "robot-left":
    case "estop-pressed":
    case "free-pressed":
    case "twin-switched":
    case "out-of-sight":
      return reduceRobotEvent(state, event)
    case "opened":
    case "followed":
    case "text-typed":
    case "program-changed":
    case "analysed":
    case "undo-pressed":
    case "redo-pressed":
    case "number-drag":
    case "nodes-moved":
    case "renamed":
    case "stored":
      return reduceDocumentEvent(state, event)
    case "world-chosen":
    case "world-taken":
    case "test-room-opened":
    case "own-room-restored":
    case "companions-chosen":
    case "companions-stored":
    case "companion-placed":
    case "world-editor-opened":
    case "world-edited":
    case "world-file-wanted":
    case "world-file-made":
    case "world-file-read":
      return reduceWorldEvent(state, event)
    case "world-editor-closed":
      return withDraftRoom(state, reduceWorldEvent(state, event))
    case "lesson":
      return withLessons(state, reduceLesson(state.lessons, event.event))
    case "why":
      return explain(state, event.event)
    default:
      return still(reduceViewEvent(state, event))
  }
}
