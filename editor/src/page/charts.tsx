/// Curves of the run's values over time, one strip each, with a cursor that reads them.

import type {VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {type Curve, curveOf, windowOf} from "../room/chart.ts"
import {type Quantity, quantities} from "../state/recording.ts"
import {useDesk, usePage} from "./pick.ts"
import {words} from "./words.ts"

export function ChartsPanel(): VNode {
  const desk = useDesk()
  const {store} = desk
  const chosen = usePage(s => s.charts)
  const empty = usePage(s => s.room.recording.length === 0)
  const toggle = (key: string) =>
    store.dispatch({
      kind: "charted",
      quantities: chosen.includes(key) ? chosen.filter(k => k !== key) : [...chosen, key],
    })
  return (
    <div class="charts">
      {empty ? (
        <p class="quiet">{words.noRun}</p>
      ) : (
        <>
          {quantities
            .filter(q => chosen.includes(q.key))
            .map(q => (
              <Strip key={q.key} quantity={q} />
            ))}
          <fieldset class="chips" aria-label={words.chartedValues}>
            {quantities.map(q => (
              <button
                type="button"
                key={q.key}
                aria-pressed={chosen.includes(q.key)}
                style={{"--curve": `var(--${q.family})`}}
                onClick={() => toggle(q.key)}
              >
                {words.quantities[q.key]}
              </button>
            ))}
          </fieldset>
          <p>
            <button type="button" class="link" onClick={() => desk.saveTable()}>
              {words.saveTable}
            </button>
          </p>
        </>
      )}
    </div>
  )
}

function Strip({quantity}: {quantity: Quantity}): VNode {
  const {store} = useDesk()
  const canvas = useRef<HTMLCanvasElement>(null)
  const recording = usePage(s => s.room.recording)
  const lookedAt = usePage(s => s.room.lookedAt)
  const theme = usePage(s => s.theme)
  const [hover, setHover] = useState<number | null>(null)
  const shown = windowOf(recording, lookedAt)
  const curve = curveOf(recording, quantity, shown)
  const at = hover ?? lookedAt
  const value = curve.at(at ?? shown.to)
  useLayoutEffect(() => {
    if (canvas.current !== null) draw(canvas.current, curve, at)
  }, [curve, at, theme])

  const timeUnder = (event: {clientX: number; currentTarget: Element}) => {
    const box = event.currentTarget.getBoundingClientRect()
    return shown.from + ((event.clientX - box.left) / box.width) * (shown.to - shown.from)
  }
  const name = words.quantities[quantity.key] ?? quantity.key
  const text = value === null ? "" : `${value.toFixed(quantity.unit === "" ? 0 : 3)} ${quantity.unit}`
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
        onPointerMove={event => setHover(timeUnder(event))}
        onPointerLeave={() => setHover(null)}
        onClick={event => store.dispatch({kind: "looked-back", time: timeUnder(event)})}
      />
    </figure>
  )
}

function draw(canvas: HTMLCanvasElement, curve: Curve, at: number | null): void {
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
  ctx.strokeStyle = style.getPropertyValue("--line")
  ctx.lineWidth = 1
  ctx.beginPath()
  for (let second = Math.ceil(curve.from / 5) * 5; second < curve.to; second += 5) {
    ctx.moveTo(x(second), 0)
    ctx.lineTo(x(second), h)
  }
  if (curve.low < 0 && curve.high > 0) {
    ctx.moveTo(0, y(0))
    ctx.lineTo(w, y(0))
  }
  ctx.stroke()
  ctx.strokeStyle = style.color
  ctx.lineWidth = 1.75
  ctx.lineJoin = "round"
  ctx.beginPath()
  for (const [i, point] of curve.points.entries()) {
    if (i === 0) ctx.moveTo(x(point.time), y(point.value))
    else ctx.lineTo(x(point.time), y(point.value))
  }
  ctx.stroke()
  if (at === null) return
  ctx.strokeStyle = style.getPropertyValue("--ink-2")
  ctx.lineWidth = 1
  ctx.beginPath()
  ctx.moveTo(x(at), 0)
  ctx.lineTo(x(at), h)
  ctx.stroke()
}
