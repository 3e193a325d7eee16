/// Roster on the teacher's board: a list of names beforehand, cards to print, the locked door, removed pupils, and how one pupil's entry is renamed, merged and removed.

import {withoutMark} from "@rosy/codegen/text-file"
import type {VNode} from "preact"
import {useState} from "preact/hooks"
import {contentOf} from "../../browser/local_files.ts"
import type {BoardRequest, PupilShown} from "../../wire/classroom/board_messages.generated.ts"
import {measures, words} from "../../words/index.ts"
import {printCards} from "./board_cards.tsx"
import {board, change} from "./board_state.ts"

type RosterRefusal = keyof typeof words.classroom.board.roster.refused

/// Whether a refusal is about a nickname or a place in the class.
export const isRosterRefusal = (reason: string): reason is RosterRefusal =>
  Object.hasOwn(words.classroom.board.roster.refused, reason)

interface SendProps {
  readonly send: (request: BoardRequest) => boolean
}

interface ToolProps extends SendProps {
  /// What the cards say beside the words.
  readonly invitation: {readonly code: string; readonly addresses: readonly string[]}
}

export function RosterTool({send, invitation}: ToolProps): VNode {
  const w = words.classroom.board.roster
  const {pupils, selected, door} = board.value
  const chosen = pupils.filter(pupil => selected.has(pupil.id))
  const printed = chosen.length === 0 ? pupils : chosen
  return (
    <section class="board-tool" aria-label={w.title} data-testid="roster">
      <h2>{w.title}</h2>
      <button
        type="button"
        class="plain"
        aria-pressed={door.locked}
        title={w.lockHint}
        onClick={() => send({op: "lock-door", locked: !door.locked})}
      >
        {door.locked ? w.unlock : w.lock}
      </button>
      {printed.length > 0 && (
        <button type="button" class="plain" onClick={() => printCards(printed, invitation)}>
          {chosen.length === 0 ? w.print : w.printSome(chosen.length)}
        </button>
      )}
      {chosen.length > 0 && <Removal pupils={chosen} label={w.removeSome(chosen.length)} send={send} />}
      <NameList send={send} />
      {door.removed.length > 0 && (
        <details>
          <summary>{w.removed}</summary>
          <ul class="board-removed">
            {door.removed.map(({id, nickname, until}) => (
              <li key={id}>
                <span>
                  <bdi>{nickname}</bdi>{" "}
                  <span class="quiet">{w.until(measures.moment(new Date(until * 1000)))}</span>
                </span>
                <button
                  type="button"
                  class="plain"
                  aria-label={w.restoreOf(nickname)}
                  onClick={() => send({op: "restore-pupil", pupil: id})}
                >
                  {w.restore}
                </button>
              </li>
            ))}
          </ul>
        </details>
      )}
      <Refused />
    </section>
  )
}

function Refused(): VNode | null {
  const {rosterRefused} = board.value
  return rosterRefused === null ? null : (
    <p class="refused" role="alert">
      {rosterRefused}
    </p>
  )
}

/// The names in a list that was pasted or read from a file: one a line, the first column of a table.
export const namesIn = (list: string): readonly string[] =>
  withoutMark(list)
    .split(/\r\n|[\n\r]/)
    .map(firstCell)
    .filter(name => name !== "")

/// In quotation marks a cell may hold what separates cells (RFC 4180, section 2).
function firstCell(line: string): string {
  const quoted = /^\s*"((?:[^"]|"")*)"/.exec(line)?.[1]?.replaceAll('""', '"')
  return (quoted ?? line.split(/[;\t,]/)[0] ?? "").trim()
}

function NameList({send}: SendProps): VNode {
  const w = words.classroom.board.roster
  const [list, setList] = useState("")
  const [unreadable, setUnreadable] = useState<string | null>(null)
  const {added} = board.value
  const names = namesIn(list)
  return (
    <details>
      <summary>{w.list}</summary>
      <form
        class="board-name-list"
        onSubmit={event => {
          event.preventDefault()
          if (
            names.length > 0 &&
            send({op: "add-pupils", nicknames: names, language: document.documentElement.lang})
          )
            setList("")
        }}
      >
        <label class="field">
          <span>{w.names}</span>
          <textarea rows={5} value={list} onInput={event => setList(event.currentTarget.value)} />
        </label>
        <label class="field">
          <span>{w.file}</span>
          <input
            type="file"
            accept=".txt,.csv,text/plain,text/csv"
            onChange={async event => {
              const [file] = event.currentTarget.files ?? []
              setUnreadable(null)
              if (file === undefined) return
              const content = await contentOf(file)
              if (content.kind === "not-text") setUnreadable(file.name)
              else setList(content.text)
            }}
          />
        </label>
        {unreadable !== null && (
          <p class="refused" role="alert">
            {words.notices.notText.message(unreadable)}
          </p>
        )}
        {names.length > mostNames && (
          <p class="refused" role="alert">
            {w.tooMany(mostNames)}
          </p>
        )}
        <p class="quiet">{w.listHint}</p>
        <button type="submit" class="plain" disabled={names.length === 0 || names.length > mostNames}>
          {w.add(names.length)}
        </button>
      </form>
      {added !== null && (
        <div role="status">
          <p>{w.added(added.added)}</p>
          {added.refused.map(({nickname, reason}, place) => (
            <p key={place} class="refused">
              <bdi>{nickname}</bdi>: {isRosterRefusal(reason) ? w.refused[reason] : ""}
            </p>
          ))}
        </div>
      )}
    </details>
  )
}

/// Names that the service takes at once (protocol §11).
const mostNames = 400

/// How the entry of a pupil is changed, below the card.
export function ChangePupil({pupil, send}: {readonly pupil: PupilShown} & SendProps): VNode {
  const w = words.classroom.board.roster
  const {id, nickname} = pupil
  const [name, setName] = useState<string | null>(null)
  const [twin, setTwin] = useState<number | null>(null)
  const others = board.value.pupils.filter(one => one.id !== id)
  const into = others.find(one => one.id === twin)
  return (
    <details class="board-change">
      <summary aria-label={w.changeOf(nickname)}>{w.change}</summary>
      <form
        onSubmit={event => {
          event.preventDefault()
          if (send({op: "rename-pupil", pupil: id, nickname: name ?? nickname})) setName(null)
        }}
      >
        <input
          type="text"
          aria-label={w.nameOf(nickname)}
          value={name ?? nickname}
          maxLength={24}
          required
          onInput={event => setName(event.currentTarget.value)}
        />
        <button type="submit" class="plain" disabled={name === null || name.trim() === nickname}>
          {w.rename}
        </button>
      </form>
      {others.length > 0 && (
        <label class="field">
          <span>{w.sameAs}</span>
          <select
            value={twin ?? ""}
            aria-label={w.sameAsOf(nickname)}
            onChange={event => setTwin(Number(event.currentTarget.value) || null)}
          >
            <option value="">–</option>
            {others.map(one => (
              <option key={one.id} value={one.id}>
                {one.nickname}
              </option>
            ))}
          </select>
        </label>
      )}
      {into !== undefined && (
        <div class="board-question" role="alert">
          <p>{w.merging(nickname, into.nickname)}</p>
          <button
            type="button"
            class="plain"
            onClick={() => send({op: "merge-pupils", pupil: id, into: into.id})}
          >
            {w.merge}
          </button>
          <button type="button" class="plain" onClick={() => setTwin(null)}>
            {w.cancel}
          </button>
        </div>
      )}
      <Removal pupils={[pupil]} label={w.remove} send={send} />
      <Refused />
    </details>
  )
}

interface RemovalProps extends SendProps {
  readonly pupils: readonly PupilShown[]
  readonly label: string
}

/// Asks before it removes, and says what goes.
function Removal({pupils, label, send}: RemovalProps): VNode {
  const w = words.classroom.board.roster
  const [isAsking, setAsking] = useState(false)
  const names = pupils.map(({nickname}) => nickname).join(", ")
  if (!isAsking)
    return (
      <button type="button" class="plain" onClick={() => setAsking(true)}>
        {label}
      </button>
    )
  return (
    <div class="board-question" role="alert">
      <p>{w.removing(names)}</p>
      <button
        type="button"
        class="plain"
        onClick={() => {
          setAsking(false)
          if (send({op: "remove-pupils", pupils: pupils.map(({id}) => id)})) change({selected: new Set()})
        }}
      >
        {w.removeThem(pupils.length)}
      </button>
      <button type="button" class="plain" onClick={() => setAsking(false)}>
        {w.cancel}
      </button>
    </div>
  )
}
