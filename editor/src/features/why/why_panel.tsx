/// Panel of the answer to a question about the run: its sentences, of which every cause is a question that goes one step further back.

import type {ComponentChildren, VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {type MemoryName, memoryNames} from "../../program/written_memories.ts"
import {
  type Explanation,
  isAsking,
  motionQuestion,
  noCommandQuestion,
  otherQuestion,
  type Question,
} from "../../state/messages/why_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {IconButton} from "../../ui/controls.tsx"
import {CloseIcon} from "../../ui/icons.tsx"
import {fill, type Piece, pieces, shortFractions} from "../../values/sentence_words.ts"
import {caseQuestion, caseQuestionAt} from "../../values/untaken_case.ts"
import {causalPath} from "../../views/diagram/network/causal_path.ts"
import {measures, words} from "../../words/index.ts"
import {commandsToAsk} from "./commands_of.ts"

export function WhyPanel(): VNode | null {
  const {store} = useController()
  const open = usePageState(s => s.why.open)
  const waits = usePageState(s => isAsking(s.why))
  const section = useRef<HTMLElement>(null)
  // Whether the keyboard was last on something in the panel.
  const hadFocus = useRef(false)
  const nameOf = usePageState(s => memoryNames(s.network))
  useLayoutEffect(() => {
    // The link that was followed is gone: the keyboard stays in the panel.
    if (hadFocus.current && document.activeElement === document.body) section.current?.focus()
  }, [open])
  if (open === null) return null
  const {answer, before, question} = open
  const send = (event: "went-back" | "closed") => store.dispatch({kind: "why", event: {kind: event}})
  return (
    <section
      class="why"
      ref={section}
      tabIndex={-1}
      aria-label={words.why.title}
      onFocusIn={() => {
        hadFocus.current = true
      }}
      onFocusOut={event => {
        // Without a next element the one with the focus was removed.
        hadFocus.current = event.relatedTarget === null
      }}
      data-testid="why"
      onKeyDown={event => {
        if (event.key !== "Escape") return
        event.stopPropagation()
        send("closed")
      }}
    >
      <header>
        <h3>
          <Pieces all={questionPieces(question, nameOf)} />
        </h3>
        {before.length > 0 && (
          <button type="button" class="link" title={words.why.backHint} onClick={() => send("went-back")}>
            {words.why.back}
          </button>
        )}
        <IconButton label={words.why.close} onClick={() => send("closed")}>
          <CloseIcon />
        </IconButton>
      </header>
      <div aria-live="polite" aria-busy={waits} data-testid="why-answer">
        {answer === null ? (
          <p class="quiet">{words.why.asking}</p>
        ) : (
          answer.sentences.map((sentence, i) => (
            <p key={`${answer.id} ${i}`}>
              <Pieces all={pieces(sentence.said, words.why, measures)} />
            </p>
          ))
        )}
      </div>
      {question.kind === "not" && question.command === "" && <NotSent question={question} />}
      <NoneSent question={question} answer={answer} />
      <GraphLink question={question} />
      <AboutRobot question={question} />
    </section>
  )
}

/// Link to another question, from which a button leads back.
function QuestionLink({question, children}: {question: Question; children: ComponentChildren}): VNode {
  const {store} = useController()
  return (
    <button
      type="button"
      class="link not-sent"
      onClick={() => store.dispatch({kind: "why", event: {kind: "followed", question}})}
    >
      {children}
    </button>
  )
}

/// The commands that the function may give, then the others, each as a question of its own.
function NotSent({question}: {question: Question & {kind: "not"}}): VNode {
  const parts = usePageState(s => s.network?.parts ?? null)
  const commands = commandsToAsk(parts ?? [], question.function)
  return (
    <p>
      {commands.map(command => (
        <QuestionLink key={command} question={{...question, command}}>
          {words.why.noCommand(command)}
        </QuestionLink>
      ))}
    </p>
  )
}

/// Why no command of a type was sent, when the answer is that there was none.
function NoneSent({question, answer}: {question: Question; answer: Explanation | null}): VNode | null {
  const now = usePageState(s => s.room.lookedAt ?? s.room.frame?.time ?? null)
  const other = noCommandQuestion(question, answer, now)
  if (other === null) return null
  return (
    <p>
      <QuestionLink question={other}>{words.why.noCommand(other.command)}</QuestionLink>
    </p>
  )
}

/// Opens the graph of the function that the question is about.
function GraphLink({question}: {question: Question}): VNode | null {
  const {store} = useController()
  if (question.kind !== "run" && question.kind !== "firing") return null
  const name = question.function
  return (
    <p>
      <button
        type="button"
        class="link"
        onClick={() => store.dispatch({kind: "function-graphed", function: name})}
      >
        {words.graph.of(name)}
      </button>
    </p>
  )
}

/// From the motion of the robot to its place at that time, and back.
function AboutRobot({question}: {question: Question}): VNode | null {
  const now = usePageState(s => s.room.lookedAt ?? s.why.open?.answer?.time ?? null)
  const other = otherQuestion(question, now)
  if (other === null) return null
  return (
    <p>
      <QuestionLink question={other}>
        {other.kind === "position" ? words.why.place : words.why.asked.motion}
      </QuestionLink>
    </p>
  )
}

function Pieces({all}: {all: readonly Piece[]}): VNode {
  return (
    <>
      {all.map((piece, i) => (
        <PieceShown key={i} piece={piece} />
      ))}
    </>
  )
}

function PieceShown({piece}: {piece: Piece}): VNode {
  const {store} = useController()
  switch (piece.kind) {
    case "text":
      return <>{piece.text}</>
    case "code":
      return <code title={piece.text}>{shortFractions(piece.text)}</code>
    case "function":
      return <b>{piece.text}</b>
    case "command": {
      const question: Question = {
        kind: "command",
        command: piece.type,
        value: piece.text,
        time: piece.time,
      }
      return (
        <button
          type="button"
          class="link cause"
          title={words.why.of(piece.text)}
          onClick={() => store.dispatch({kind: "why", event: {kind: "followed", question}})}
        >
          <code>{shortFractions(piece.text)}</code>
        </button>
      )
    }
    case "cause": {
      const question: Question = {kind: "firing", firing: piece.firing, function: piece.text}
      return (
        <button
          type="button"
          class="link cause"
          title={words.why.of(piece.text)}
          onClick={() => store.dispatch({kind: "why", event: {kind: "followed", question}})}
        >
          {piece.text}
        </button>
      )
    }
  }
}

function questionPieces(question: Question, nameOf: MemoryName): readonly Piece[] {
  const {asked} = words.why
  switch (question.kind) {
    case "command":
      return question.command === "Velocity" && question.value === ""
        ? fill(asked.motion, {})
        : fill(asked.command, {value: [{kind: "code", text: question.value || question.command}]})
    case "firing":
    case "run":
      return fill(asked.firing, {function: [{kind: "function", text: question.function}]})
    case "memory":
      return fill(asked.memory, {type: [{kind: "code", text: nameOf(question.type)}]})
    case "event":
      return fill(asked.event, {value: [{kind: "code", text: question.value}]})
    case "position":
      return fill(asked.place, {time: [{kind: "text", text: measures.seconds(question.time, 2)}]})
    case "not": {
      const name: Piece = {kind: "function", text: question.function}
      return question.command === ""
        ? fill(asked.notRun, {function: [name]})
        : fill(asked.notSent, {function: [name], type: [{kind: "code", text: question.command}]})
    }
    case "not-taken":
      return fill(asked.notTaken, {value: [{kind: "code", text: question.text}]})
    case "no-command":
      return fill(asked.noCommand, {type: [{kind: "code", text: question.command}]})
    case "not-received":
      return fill(asked.notReceived, {type: [{kind: "code", text: question.type}]})
  }
}

/// Buttons that ask questions, each labelled with its question.
export function QuestionButtons({all}: {all: readonly Question[]}): VNode {
  const {store} = useController()
  const nameOf = usePageState(s => memoryNames(s.network))
  return (
    <>
      {all.map((question, i) => (
        <button
          key={i}
          type="button"
          class="plain small question"
          onClick={() => store.dispatch({kind: "why", event: {kind: "asked", question}})}
        >
          <span>
            <Pieces all={questionPieces(question, nameOf)} />
          </span>
        </button>
      ))}
    </>
  )
}

/// Asks why the case around the chosen block, or around the cursor in the text, was not taken.
export function CaseWhy(): VNode | null {
  const {store} = useController()
  const selected = usePageState(s => s.selected)
  const cursor = usePageState(s => s.cursor)
  const document = usePageState(s => s.document)
  const room = usePageState(s => s.room)
  const inBlock = () => (selected === null ? null : caseQuestion({document, room}, selected))
  const question = cursor === null ? inBlock() : caseQuestionAt({document, room}, cursor)
  if (question === null) return null
  return (
    <button
      type="button"
      class="link case-why"
      onClick={() => store.dispatch({kind: "why", event: {kind: "asked", question}})}
    >
      {words.why.notTaken}
    </button>
  )
}

/// A small button that asks a question.
export function WhyButton({question, about}: {question: () => Question; about: string}): VNode {
  const {store} = useController()
  return (
    <button
      type="button"
      class="link why-link"
      aria-label={words.why.of(about)}
      title={words.why.of(about)}
      onClick={() => store.dispatch({kind: "why", event: {kind: "asked", question: question()}})}
    >
      {words.why.short}
    </button>
  )
}

/// Asks about the motion of the robot at the displayed moment.
export function RobotWhy(): VNode | null {
  const {store} = useController()
  const there = usePageState(s => s.room.run !== null && s.room.frame !== null)
  if (!there) return null
  return (
    <button
      type="button"
      class="hand robot-why"
      title={words.why.robot}
      aria-label={words.why.robot}
      onClick={() => {
        const {room} = store.now
        const time = room.lookedAt ?? room.frame?.time ?? null
        store.dispatch({kind: "why", event: {kind: "asked", question: motionQuestion(time)}})
      }}
    >
      {words.why.short}
    </button>
  )
}

/// Where the moments of the answer lie on the time line.
export function WhyMarks({from, to}: {from: number; to: number}): VNode | null {
  const answer = usePageState(s => s.why.open?.answer ?? null)
  if (answer === null || to <= from) return null
  return (
    <span class="why-marks" aria-hidden="true">
      {causalPath(answer)
        .moments.filter(time => time >= from && time <= to)
        .map(time => (
          <i key={time} style={{insetInlineStart: `${(100 * (time - from)) / (to - from)}%`}} />
        ))}
    </span>
  )
}
