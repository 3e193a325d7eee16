/// Reader of the service's messages (`protocol/README.md` §4): the generated decoder, and the values that the page makes of what it reads: rooms, graphs, texts in its language.

import {ownTopics, programParts} from "../../program/program_graph.ts"
import {Mismatch, mapped, readerOf} from "../../wire/decode.ts"
import {type Answer, answer} from "../../wire/page/page.generated.ts"
import type {RunState, Frame as ShownFrame} from "../../wire/page/runs.generated.ts"
import {worded} from "../../words/worker_sentences.ts"
import {worldAt} from "../../worlds/world_decoder.ts"
import type {Frame, ServiceMessage} from "./messages.ts"
import {previewOf} from "./preview.ts"

export function pageFrame(shown: ShownFrame): Frame {
  const {pose, run, step, time, channels, fired, sensed, times, boxes, others, ghost, memory, firings} = shown
  const {x, y, theta} = pose
  return {run, step, time, x, y, theta, channels, fired, sensed, times, boxes, others, ghost, memory, firings}
}

function runState({op, run, state, place, branches, ended, problems}: RunState): ServiceMessage {
  switch (state) {
    case "queued":
      if (place === null) throw new Mismatch("place", "a whole number")
      return {op, run, state, place}
    case "compiling":
      return {op, run, state}
    case "running":
      return {op, run, state, branches}
    case "ended":
      if (ended === null) throw new Mismatch("ended", "why it ended")
      return {op, run, state, ended, problems}
  }
}

function pageMessage(message: Answer): ServiceMessage {
  switch (message.op) {
    case "worker": {
      const {op, state, sentences} = message
      return {op, state, fault: worded(sentences?.message ?? null, message.message)}
    }
    case "world":
      return {op: "world", world: worldAt("world", message.world)}
    case "checked": {
      const {graph, ...checked} = message
      return {...checked, parts: programParts(graph, "graph"), topics: ownTopics(graph, "graph")}
    }
    case "state":
      return runState(message)
    case "frame":
      return {op: "frame", frame: pageFrame(message)}
    case "previewed":
      return {op: "previewed", preview: previewOf(message)}
    case "checks": {
      const {op, ...checks} = message
      return {op, checks}
    }
    case "because": {
      const {op, ...explained} = message
      return {op, answer: explained}
    }
    case "robot": {
      const {op, sentence, ...robot} = message
      return {op, robot: {...robot, why: worded(sentence, robot.why)}}
    }
    case "safety": {
      const {op, on, run, since} = message
      return {op, on, override: run === null || since === null ? null : {run, since}}
    }
    case "refusal": {
      const {op, sentences, hint} = message
      return {
        op,
        message: worded(sentences?.message ?? null, message.message),
        hint: worded(sentences?.hint ?? null, hint),
      }
    }
    default:
      return message
  }
}

/// Reads one message of the service.
export const readServiceMessage = readerOf(mapped(answer, pageMessage))
