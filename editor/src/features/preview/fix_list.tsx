/// List of the fixes of a problem: each with a picture of the path that it gives and what happens there, the best first. As long as the service gives no previews,
/// plain buttons in their own order.

import type {RefObject, VNode} from "preact"
import {useEffect, useId, useLayoutEffect, useRef, useState} from "preact/hooks"
import {type Fix, fixChanges} from "../../program/program.ts"
import {applyChanges} from "../../program/text_changes.ts"
import {previewsFixes} from "../../reducers/fix_preview_requests.ts"
import type {Preview} from "../../state/messages/preview.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {drawThumbnail} from "../../views/room/world_drawing.ts"
import {measures, words} from "../../words/index.ts"
import {type DecidedOrder, decideOrder, type KnownOutcome, orderedFixes} from "./fix_order.ts"
import {isBetter, outcomeOf} from "./outcome.ts"
import {outcomeSentence} from "./outcome_sentence.ts"

/// Milliseconds after which the order no longer changes: a pointer may be on its way.
const firstMoment = 1000

/// `drops`: fixes whose run is no better than that of the program are not offered.
export function FixList({fixes, drops}: {readonly fixes: readonly Fix[]; readonly drops: boolean}): VNode {
  const controller = useController()
  const {store} = controller
  const program = usePageState(s => s.document.program.text)
  const isTried = usePageState(previewsFixes)
  const {answers} = usePageState(s => s.room.fixPreviews)
  const start = usePageState(s => s.room.world?.start.theta ?? 0)
  const list = useRef<HTMLUListElement>(null)
  const id = useId()
  const isSeen = useIsSeen(list)
  const [isPointedAt, setPointedAt] = useState(false)
  const [late, setLate] = useState<string | null>(null)
  const decided = useRef<DecidedOrder | null>(null)
  const isWide = useRef(false)

  const texts = fixes.map(fix => applyChanges(program, fixChanges(fix, program.length)))
  const key = JSON.stringify([program, texts])
  const isAsked = isTried && isSeen
  useEffect(() => {
    if (!isAsked) return
    store.dispatch({kind: "fixes-offered", offered: {list: id, of: program, texts}})
    const timer = setTimeout(() => setLate(key), firstMoment)
    return () => {
      clearTimeout(timer)
      store.dispatch({kind: "fixes-offered", offered: {list: id, of: program, texts: []}})
    }
  }, [key, isAsked])

  const outcomeAt = (text: string): KnownOutcome => {
    const preview = answers.get(text)
    return preview === undefined || preview === null ? preview : outcomeOf(preview, start)
  }
  const now = outcomeAt(program)
  const outcomes = texts.map(outcomeAt)
  if (isTried) {
    const order = orderedFixes(now, outcomes, drops)
    decided.current = decideOrder(decided.current, key, fixes.length, order, isPointedAt || late === key)
  }
  const order = decided.current?.key === key ? decided.current.order : fixes.map((_, i) => i)
  // What is pointed at stays where it is.
  if (!isPointedAt) isWide.current = isTried && now !== null
  if (order.length === 0) return <p class="quiet none-better">{words.preview.noneBetter}</p>
  return (
    <ul
      class={isWide.current ? "fixes tried" : "fixes"}
      ref={list}
      aria-label={words.preview.fixes}
      onPointerEnter={() => setPointedAt(true)}
      onPointerLeave={() => setPointedAt(false)}
      onFocusIn={() => setPointedAt(true)}
      onFocusOut={() => setPointedAt(false)}
    >
      {order.map(i => {
        const [fix, text, outcome] = [fixes[i], texts[i], outcomes[i]]
        if (fix === undefined || text === undefined) return null
        const describedBy = `${id}-${i}`
        return (
          <li key={fix.title}>
            {isWide.current && <PathPicture preview={answers.get(text) ?? null} />}
            <button
              type="button"
              class="fix"
              aria-describedby={describedBy}
              onClick={() => controller.applyFix(fix)}
            >
              {fix.title}
            </button>
            {isWide.current && (
              <span class="quiet" id={describedBy}>
                {sentence(outcome, drops ? now : undefined)}
              </span>
            )}
          </li>
        )
      })}
    </ul>
  )
}

/// What happens; of a fix that had to be offered although it is no better, this as well.
function sentence(outcome: KnownOutcome, program: KnownOutcome): string {
  if (outcome === undefined) return words.preview.outcome.trying
  if (outcome === null) return ""
  const text = outcomeSentence(outcome, words.preview, measures)
  const isUseful = program === undefined || program === null || isBetter(outcome, program)
  return isUseful ? text : `${text} (${words.preview.outcome.noBetter})`
}

/// The path in the room; an empty place of the same size as long as there is none.
function PathPicture({preview}: {readonly preview: Preview | null}): VNode {
  const canvas = useRef<HTMLCanvasElement>(null)
  const world = usePageState(s => s.room.world)
  useLayoutEffect(() => {
    if (canvas.current === null || world === null || preview === null) return
    const places = (points: Preview["path"]) => points.map(({x, y}) => [x, y] as const)
    drawThumbnail(canvas.current, world, places(preview.path), places(preview.collisions))
  }, [preview, world])
  return <canvas ref={canvas} />
}

/// Whether a part of the element can be seen.
function useIsSeen(element: RefObject<Element>): boolean {
  const [isSeen, setSeen] = useState(false)
  useEffect(() => {
    if (element.current === null) return
    const observer = new IntersectionObserver(entries => setSeen(entries.at(-1)?.isIntersecting === true))
    observer.observe(element.current)
    return () => observer.disconnect()
  }, [])
  return isSeen
}
