/// Questions about a run and their answers: the part of the page's state, and the events that change it. Pure.

import type {Place} from "../../wire/firing.generated.ts"
import type {Because, Why, WhyNot} from "../../wire/page/explanations.generated.ts"

/// The answer to a question.
export type Explanation = Omit<Because, "op">

/// Times are seconds of the run; `null` is now.
export type Question =
  /// The latest command of a type until then, `Velocity` for the motion of the robot.
  | {readonly kind: "command"; readonly command: string; readonly value: string; readonly time: number | null}
  | {readonly kind: "firing"; readonly firing: number; readonly function: string}
  /// The latest run of a function until then.
  | {readonly kind: "run"; readonly function: string; readonly time: number | null}
  | {readonly kind: "memory"; readonly type: string; readonly time: number | null}
  /// As Haskell shows it, or its constructor: the latest one.
  | {readonly kind: "event"; readonly value: string; readonly time: number | null}
  /// How the robot came to the place where it was then.
  | {readonly kind: "position"; readonly time: number}
  /// A function that did not run, or did not send a command of a type, between two times.
  | {
      readonly kind: "not"
      readonly function: string
      readonly command: string
      readonly since: number
      readonly until: number
    }
  /// A case of a function that was not taken: what it is told by, and its place in the text that runs.
  | {
      readonly kind: "not-taken"
      readonly text: string
      readonly start: Place
      readonly end: Place
      readonly since: number
      readonly until: number
    }
  /// A command of a type that shows no effect between two times.
  | {readonly kind: "no-command"; readonly command: string; readonly since: number; readonly until: number}
  /// An event of the program that no function received.
  | {readonly kind: "not-received"; readonly type: string; readonly since: number; readonly until: number}

/// About the motion of the robot.
export const motionQuestion = (time: number | null): Question => ({
  kind: "command",
  command: "Velocity",
  value: "",
  time,
})

/// About the robot as well, after an answer to a question about its motion or its place; `null` for other questions.
export function otherQuestion(question: Question, now: number | null): Question | null {
  if (question.kind === "position") return motionQuestion(question.time)
  if (question.kind !== "command" || question.command !== "Velocity" || question.value !== "") return null
  const time = question.time ?? now
  return time === null ? null : {kind: "position", time}
}

/// Why there was no command of the type, after the answer that none had been sent; `null` otherwise.
export function noCommandQuestion(
  question: Question,
  answer: Explanation | null,
  now: number | null,
): (Question & {readonly kind: "no-command"}) | null {
  const until = question.kind === "command" ? (question.time ?? now) : null
  if (question.kind !== "command" || until === null) return null
  if (answer?.sentences[0]?.said.id !== "nothing-sent-yet") return null
  const since = Math.max(0, until - lookedBackFor)
  return {kind: "no-command", command: question.command, since, until}
}

export interface WhyState {
  /// Questions so far: the newest one's number.
  readonly asked: number
  /// `null` while no answer is to be seen.
  readonly open: {
    readonly question: Question
    /// `null` until the service has answered.
    readonly answer: Explanation | null
    /// The questions that led here, oldest first.
    readonly before: readonly Question[]
  } | null
}

export const noQuestion: WhyState = {asked: 0, open: null}

export type WhyEvent =
  | {readonly kind: "asked"; readonly question: Question}
  /// A cause in the answer was chosen.
  | {readonly kind: "followed"; readonly question: Question}
  | {readonly kind: "went-back"}
  | {readonly kind: "closed"}
  | {readonly kind: "answered"; readonly answer: Explanation}

export interface WhyTransition {
  readonly state: WhyState
  /// To be sent.
  readonly request: WhyRequest | null
}

type WhyRequest = Why | WhyNot

export function reduceWhy(state: WhyState, event: WhyEvent): WhyTransition {
  const {open} = state
  switch (event.kind) {
    case "asked":
      return ask(state, event.question, [])
    case "followed":
      return ask(state, event.question, open === null ? [] : [...open.before, open.question])
    case "went-back": {
      const last = open?.before.at(-1)
      return last === undefined
        ? {state: {...state, open: null}, request: null}
        : ask(state, last, open?.before.slice(0, -1) ?? [])
    }
    case "closed":
      return {state: {...state, open: null}, request: null}
    case "answered":
      return event.answer.id !== state.asked || open === null
        ? {state, request: null}
        : {state: {...state, open: {...open, answer: event.answer}}, request: null}
  }
}

/// The answer before stays in sight until the new one is there.
function ask(state: WhyState, question: Question, before: readonly Question[]): WhyTransition {
  const id = state.asked + 1
  const answer = state.open?.answer ?? null
  return {state: {asked: id, open: {question, answer, before}}, request: requestOf(question, id)}
}

function requestOf(question: Question, id: number): WhyRequest {
  switch (question.kind) {
    case "command":
      return {op: "why", id, command: question.command, ...at(question.time)}
    case "firing":
      return {op: "why", id, firing: question.firing}
    case "run":
      return {op: "why", id, function: question.function, ...at(question.time)}
    case "memory":
      return {op: "why", id, memory: question.type, ...at(question.time)}
    case "event":
      return {op: "why", id, event: question.value, ...at(question.time)}
    case "position":
      return {op: "why", id, position: true, time: question.time}
    case "not": {
      const {function: name, command, since, until} = question
      return {op: "whyNot", id, function: name, ...(command === "" ? {} : {command}), since, until}
    }
    case "not-taken": {
      const {start, end, since, until} = question
      return {op: "whyNot", id, branch: {start, end}, since, until}
    }
    case "no-command": {
      const {command, since, until} = question
      return {op: "whyNot", id, command, since, until}
    }
    case "not-received": {
      const {type, since, until} = question
      return {op: "whyNot", id, event: type, since, until}
    }
  }
}

const at = (time: number | null) => (time === null ? {} : {time})

/// Whether the newest question still has no answer.
export const isAsking = ({asked, open}: WhyState): boolean => open !== null && open.answer?.id !== asked

/// Seconds before the displayed moment that "why did it not run" is about.
export const lookedBackFor = 2
