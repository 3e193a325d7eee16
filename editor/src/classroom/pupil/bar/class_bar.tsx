/// Class bar, card to join, card with the three words, and the eyes-up message.

import type {Signal} from "@preact/signals"
import type {VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {privacyPage} from "../../../help/help_links.ts"
import type {Program} from "../../../program/program.ts"
import {TextEntry} from "../../../ui/text_entry.tsx"
import type {OwnComment, OwnTask} from "../../../wire/classroom/pupil_messages.generated.ts"
import {words} from "../../../words/index.ts"
import type {ClassState} from "../class_state.ts"
import type {SharingCommands} from "../pupil_sharing.ts"
import {CommentLines} from "./comment_lines.tsx"
import {SharingLine} from "./sharing_lines.tsx"
import {StudyLine} from "./study_line.tsx"
import {TaskLines} from "./task_lines.tsx"

/// What the card and the bar show, and their commands.
export interface ClassCommands extends SharingCommands {
  readonly state: Signal<ClassState>
  readonly code: string
  readonly isTeacher: boolean
  join(code: string, nickname: string): void
  resume(code: string, typedWords: string): void
  showCard(card: ClassState["card"]): void
  raiseHand(up: boolean): void
  openHandout(): void
  foldHandout(folded: boolean): void
  handIn(task: number): void
  closeComment(task: OwnTask): void
  answerStudy(agrees: boolean): void
  leave(): void
  /// The open program with its entry in the program store.
  readonly open: {readonly value: {readonly program: Program; readonly id: string | null}}
  nameOf(program: string): string | null
  showComment(comment: OwnComment): void
  openProgram(program: string): void
  setDone(comment: OwnComment, done: boolean): void
}

interface Props {
  readonly commands: ClassCommands
}

export function ClassBar({commands}: Props): VNode {
  const w = words.classroom
  const {member, link, saved, hand, handout, isHandoutFolded, blockComments, sharing, study} =
    commands.state.value
  const isSaved = link === "open" && (saved === "saved" || saved === "saving")
  return (
    <section class="class-bar" aria-label={w.bar} data-testid="class-bar">
      {member === null ? (
        commands.isTeacher ? (
          <a href="board">{w.openBoard}</a>
        ) : (
          <button type="button" class="plain" onClick={() => commands.showCard("join")}>
            {w.join}
          </button>
        )
      ) : (
        <>
          <div class={isSaved ? "class-who" : "class-who is-long"}>
            <b class="class-nickname">
              <bdi>{member.nickname}</bdi>
            </b>
            <span class="quiet" role="status" data-testid="class-saved">
              {link === "open" ? w.saved[saved] : w.saved.offline}
            </span>
          </div>
          {handout !== null && isHandoutFolded && (
            <button type="button" class="plain" onClick={() => commands.foldHandout(false)}>
              {w.fromTeacher}
            </button>
          )}
          <button type="button" class="plain" aria-pressed={hand} onClick={() => commands.raiseHand(!hand)}>
            {hand ? w.lowerHand : w.raiseHand}
          </button>
          <button type="button" class="plain" onClick={() => commands.showCard("words")}>
            {w.myWords}
          </button>
        </>
      )}
      {member !== null && (
        <TaskLines
          state={commands.state.value}
          handIn={commands.handIn}
          closeComment={commands.closeComment}
        />
      )}
      {member !== null && blockComments.length > 0 && (
        <CommentLines
          comments={blockComments}
          {...commands.open.value}
          nameOf={commands.nameOf}
          show={commands.showComment}
          open={commands.openProgram}
          setDone={commands.setDone}
        />
      )}
      {member !== null && sharing !== null && (
        <SharingLine
          sharing={sharing}
          allowSharing={commands.allowSharing}
          declineSharing={commands.declineSharing}
          endSharing={commands.endSharing}
        />
      )}
      {member !== null && study !== null && <StudyLine {...study} answer={commands.answerStudy} />}
      {member !== null && handout !== null && !isHandoutFolded && (
        <p class="class-handout" role="status">
          <span>{w.handouts[handout.what](handout.name)}</span>
          <button type="button" class="plain" onClick={commands.openHandout}>
            {w.openHandout}
          </button>
          <button type="button" class="plain" onClick={() => commands.foldHandout(true)}>
            {w.later}
          </button>
        </p>
      )}
    </section>
  )
}

export function ClassDialogs({commands}: Props): VNode {
  const {card, attention} = commands.state.value
  return (
    <>
      {card !== null && (
        <Modal
          label={card === "join" ? words.classroom.title : words.classroom.wordsTitle}
          close={() => commands.showCard(null)}
        >
          {card === "join" ? <JoinCard commands={commands} /> : <WordsCard commands={commands} />}
        </Modal>
      )}
      {attention !== null && (
        <Modal label={words.classroom.eyesUp} close={null}>
          <p class="class-attention" role="alert" data-testid="eyes-up">
            {attention === "" ? words.classroom.eyesUp : attention}
          </p>
        </Modal>
      )}
    </>
  )
}

interface ModalProps {
  readonly label: string
  /// `null` for a dialog that only the teacher ends.
  readonly close: (() => void) | null
  readonly children: VNode | VNode[]
}

function Modal({label, close, children}: ModalProps): VNode {
  const dialog = useRef<HTMLDialogElement>(null)
  useLayoutEffect(() => {
    const element = dialog.current
    element?.showModal()
    return () => element?.close()
  }, [])
  return (
    <dialog
      class="class-card"
      ref={dialog}
      aria-label={label}
      onCancel={event => {
        event.preventDefault()
        close?.()
      }}
      onKeyDown={event => event.stopPropagation()}
    >
      {children}
    </dialog>
  )
}

function JoinCard({commands}: Props): VNode {
  const w = words.classroom
  const {asked, refused, link} = commands.state.value
  const [returns, setReturns] = useState(false)
  const [code, setCode] = useState(commands.code)
  const [nickname, setNickname] = useState("")
  const [typedWords, setTypedWords] = useState("")
  const fault =
    link !== "open"
      ? w.noConnection
      : refused === null
        ? null
        : (w.refused as Record<string, string>)[refused]
  return (
    <form
      class="class-form"
      onSubmit={event => {
        event.preventDefault()
        if (returns) commands.resume(code, typedWords)
        else commands.join(code, nickname)
      }}
    >
      <h2>{w.title}</h2>
      <p class="quiet">{returns ? w.leadReturn : w.lead}</p>
      <TextEntry
        label={w.code}
        value={code}
        required
        maxLength={20}
        autocomplete="off"
        autocapitalize="none"
        spellcheck={false}
        set={setCode}
      />
      {returns ? (
        <TextEntry
          label={w.threeWords}
          value={typedWords}
          required
          maxLength={60}
          autocomplete="off"
          autocapitalize="none"
          spellcheck={false}
          set={setTypedWords}
        />
      ) : (
        <TextEntry
          label={w.nickname}
          value={nickname}
          required
          maxLength={24}
          autocomplete="off"
          spellcheck={false}
          set={setNickname}
        />
      )}
      {fault !== null && (
        <p class="refused" role="alert">
          {fault}
        </p>
      )}
      <button type="submit" class="primary" disabled={asked}>
        {returns ? w.goOn : w.join}
      </button>
      <p class="class-others">
        <button type="button" class="plain" onClick={() => setReturns(!returns)}>
          {returns ? w.iAmNew : w.wasHere}
        </button>
        <button type="button" class="plain" onClick={() => commands.showCard(null)}>
          {w.without}
        </button>
      </p>
      <p class="quiet class-privacy">
        {w.privacy}{" "}
        <a href={privacyPage} target="_blank" rel="noreferrer">
          {words.readMore}
        </a>
      </p>
    </form>
  )
}

function WordsCard({commands}: Props): VNode {
  const w = words.classroom
  const {member, saved, link} = commands.state.value
  return (
    <div class="class-form">
      <h2>{w.wordsTitle}</h2>
      <p class="class-words" lang="mul" data-testid="three-words">
        {member?.words}
      </p>
      <p class="quiet">{w.wordsLead}</p>
      <button type="button" class="primary" onClick={() => commands.showCard(null)}>
        {w.wordsDone}
      </button>
      <p class="class-others">
        <button
          type="button"
          class="plain"
          disabled={saved !== "saved" || link !== "open"}
          title={w.leaveHint}
          onClick={commands.leave}
        >
          {w.leave}
        </button>
      </p>
    </div>
  )
}
