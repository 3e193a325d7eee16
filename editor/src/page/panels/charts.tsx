/// Charts panel: graphs of functions, speed and position, and one strip chart per quantity with a shared cursor.

import type {VNode} from "preact"
import {useLayoutEffect, useMemo, useRef, useState} from "preact/hooks"
import {memoryNames} from "../../program/written_memories.ts"
import type {ChartSpan} from "../../state/page_state.ts"
import {comparedRun, nodeOf, runName} from "../../state/runs/run_tree.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {SegmentedControl} from "../../ui/controls.tsx"
import {quantityName} from "../../ui/descriptions.ts"
import {type Quantity, quantitiesOf} from "../../values/quantities.ts"
import {measures, words} from "../../words/index.ts"
import {type Curve, openCurves, unitedWindow, windowOf, withSameScale} from "./chart_data.ts"
import {FunctionGraphs} from "./function_graph.tsx"
import {MotionChart, motionKey} from "./motion_chart.tsx"

const spans: readonly ChartSpan[] = [20, 60, "all"]

export function ChartsPanel(): VNode {
  const empty = usePageState(s => s.room.recording.length === 0)
  return (
    <div class="charts">
      <FunctionGraphs />
      {empty ? <p class="quiet">{words.noRun}</p> : <Charts />}
    </div>
  )
}

function Charts(): VNode {
  const controller = useController()
  const {store} = controller
  const chosen = usePageState(s => s.charts)
  const span = usePageState(s => s.chartSpan)
  const recording = usePageState(s => s.room.recording)
  const lookedAt = usePageState(s => s.room.lookedAt)
  const there = usePageState(s => quantitiesOf(s.room.frame, memoryNames(s.network)))
  const [hover, setHover] = useState<number | null>(null)
  const curves = useMemo(openCurves, [])
  const otherCurves = useMemo(openCurves, [])
  const tree = usePageState(s => s.runTree)
  const shownRun = usePageState(s => s.room.run)
  const own = nodeOf(tree, shownRun)
  const other = useMemo(() => comparedRun(tree), [tree])
  const otherRecording = other?.kept.room.recording ?? null
  const shown = unitedWindow(windowOf(recording, lookedAt, span), otherRecording, span)
  const at = hover ?? lookedAt
  const toggle = (key: string) =>
    store.dispatch({
      kind: "charted",
      quantities: chosen.includes(key) ? chosen.filter(k => k !== key) : [...chosen, key],
    })
  return (
    <>
      <div class="charts-bar">
        <SegmentedControl
          label={words.chartSpan}
          options={spans.map(s => [String(s), words.chartSpans[s]])}
          value={String(span)}
          choose={chosen => {
            const found = spans.find(s => String(s) === chosen)
            if (found !== undefined) store.dispatch({kind: "chart-span", span: found})
          }}
        />
        <span class="value" data-testid="cursor">
          {at === null ? "" : words.atTime(Math.min(Math.max(at, shown.from), shown.to))}
        </span>
      </div>
      {other !== null && own !== undefined && (
        <p class="quiet" data-testid="compared-charts">
          {runName(own, words)}: {words.runs.lines.shown} · {runName(other, words)}:{" "}
          {words.runs.lines.compared}
        </p>
      )}
      {chosen.includes(motionKey) && <MotionChart />}
      {there
        .filter(q => chosen.includes(q.key))
        .map(q => {
          const curve = curves.of(recording, q, shown)
          const [drawn, compared] =
            otherRecording === null
              ? [curve, null]
              : withSameScale(curve, otherCurves.of(otherRecording, q, shown))
          return (
            <StripChart
              key={q.key}
              quantity={q}
              curve={drawn}
              compared={compared}
              at={at}
              pointed={setHover}
              chosen={time => store.dispatch({kind: "looked-back", time})}
            />
          )
        })}
      <fieldset class="chips" aria-label={words.chartedValues}>
        <button
          type="button"
          aria-pressed={chosen.includes(motionKey)}
          style={{"--curve": "var(--number)"}}
          onClick={() => toggle(motionKey)}
        >
          {words.graph.motion}
        </button>
        {there.map(q => (
          <button
            type="button"
            key={q.key}
            aria-pressed={chosen.includes(q.key)}
            style={{"--curve": `var(--${q.family})`}}
            onClick={() => toggle(q.key)}
          >
            {q.name ?? quantityName(q.key)}
          </button>
        ))}
      </fieldset>
      <p>
        <button type="button" class="link" onClick={() => controller.saveTable()}>
          {words.saveTable}
        </button>
      </p>
    </>
  )
}

export function StripChart(props: {
  readonly quantity: Quantity
  readonly curve: Curve
  /// Of the run that is compared, in the same window and scale.
  readonly compared?: Curve | null
  /// Where the cursor stands, in seconds of the run.
  readonly at: number | null
  /// The pointer is over this time, or has left.
  pointed(time: number | null): void
  chosen(time: number): void
}): VNode {
  const {quantity, curve, at} = props
  const compared = props.compared ?? null
  const canvas = useRef<HTMLCanvasElement>(null)
  const theme = usePageState(s => s.theme)
  const value = curve.at(at ?? curve.to)
  useLayoutEffect(() => {
    if (canvas.current !== null) draw(canvas.current, curve, compared, at)
  }, [curve, compared, at, theme])

  const timeUnder = (event: {clientX: number; currentTarget: Element}) => {
    const box = event.currentTarget.getBoundingClientRect()
    return curve.from + ((event.clientX - box.left) / box.width) * (curve.to - curve.from)
  }
  const name = quantity.name ?? quantityName(quantity.key)
  const inWords = (value: number | null) =>
    value === null ? "" : `${told(value, quantity.unit === "" ? 0 : 3)} ${quantity.unit}`
  const other = compared === null ? "" : inWords(compared.at(at ?? compared.to))
  const text = other === "" ? inWords(value) : `${inWords(value)} ┊ ${other}`
  return (
    <figure class="strip" style={{"--curve": `var(--${quantity.family})`}}>
      <figcaption>
        <span>{name}</span>
        <span class="value">{text}</span>
      </figcaption>
      <canvas
        ref={canvas}
        role="img"
        aria-label={`${name}: ${text}`}
        onPointerMove={event => props.pointed(timeUnder(event))}
        onPointerLeave={() => props.pointed(null)}
        onClick={event => props.chosen(timeUnder(event))}
      />
    </figure>
  )
}

/// So many digits, or more where a whole number would hide what the value is.
function told(value: number, digits: number): string {
  return measures.fixed(value, Number.isInteger(value) ? digits : Math.max(digits, 3))
}

/// Seconds between two lines, the smallest that gives no more than eight.
function lineStep(seconds: number): number {
  return [5, 10, 30, 60, 120, 300, 600].find(step => seconds / step <= 8) ?? 1200
}

function draw(canvas: HTMLCanvasElement, curve: Curve, compared: Curve | null, at: number | null): void {
  const ctx = canvas.getContext("2d")
  if (ctx === null) return
  const ratio = window.devicePixelRatio || 1
  const {clientWidth: w, clientHeight: h} = canvas
  if (canvas.width !== Math.round(w * ratio)) canvas.width = Math.round(w * ratio)
  if (canvas.height !== Math.round(h * ratio)) canvas.height = Math.round(h * ratio)
  const style = getComputedStyle(canvas)
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0)
  ctx.clearRect(0, 0, w, h)
  const x = (time: number) => ((time - curve.from) / (curve.to - curve.from)) * w
  const y = (value: number) => h - 4 - ((value - curve.low) / (curve.high - curve.low)) * (h - 8)
  const quiet = style.getPropertyValue("--ink-2")
  ctx.strokeStyle = style.getPropertyValue("--line")
  ctx.lineWidth = 1
  ctx.beginPath()
  const step = lineStep(curve.to - curve.from)
  for (let second = Math.ceil(curve.from / step) * step; second < curve.to; second += step) {
    ctx.moveTo(x(second), 0)
    ctx.lineTo(x(second), h)
  }
  if (curve.low < 0 && curve.high > 0) {
    ctx.moveTo(0, y(0))
    ctx.lineTo(w, y(0))
  }
  ctx.stroke()
  ctx.lineJoin = "round"
  const line = (points: Curve["points"]) => {
    ctx.beginPath()
    for (const [i, point] of points.entries()) {
      if (i === 0) ctx.moveTo(x(point.time), y(point.value))
      else ctx.lineTo(x(point.time), y(point.value))
    }
    ctx.stroke()
  }
  if (compared !== null) {
    ctx.strokeStyle = style.getPropertyValue("--compared")
    ctx.lineWidth = 2.5
    ctx.lineCap = "round"
    // Dashes without a length are round dots, as on the path in the room.
    ctx.setLineDash([0, 5])
    line(compared.points)
    ctx.setLineDash([])
  }
  ctx.strokeStyle = style.color
  ctx.lineWidth = 1.75
  line(curve.points)
  if (at !== null) {
    ctx.strokeStyle = quiet
    ctx.lineWidth = 1
    ctx.beginPath()
    ctx.moveTo(x(at), 0)
    ctx.lineTo(x(at), h)
    ctx.stroke()
  }
  // Numbers last and with a rim, so that the curve never hides them.
  ctx.font = `12px ${style.getPropertyValue("--code")}`
  ctx.lineWidth = 3
  ctx.strokeStyle = style.getPropertyValue("--ground")
  ctx.fillStyle = quiet
  for (const [value, place] of [
    [curve.high, 12],
    [curve.low, h - 4],
  ] as const) {
    const text = measures.short(value, 2)
    ctx.strokeText(text, 4, place)
    ctx.fillText(text, 4, place)
  }
}
