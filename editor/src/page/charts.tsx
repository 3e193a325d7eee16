/// Curves of the run's values over time, one strip each, with one cursor through all of them.

import type {VNode} from "preact"
import {useMemo, useState} from "preact/hooks"
import {openCurves, windowOf} from "../room/chart.ts"
import type {ChartSpan} from "../state/page.ts"
import {quantitiesOf} from "../state/values.ts"
import {words} from "../words/index.ts"
import {useDesk, usePage} from "./pick.ts"
import {Segments} from "./segments.tsx"
import {quantityName} from "./sentences.ts"
import {Strip} from "./strip.tsx"

const spans: readonly ChartSpan[] = [20, 60, "all"]

export function ChartsPanel(): VNode {
  const empty = usePage(s => s.room.recording.length === 0)
  return <div class="charts">{empty ? <p class="quiet">{words.noRun}</p> : <Charts />}</div>
}

function Charts(): VNode {
  const desk = useDesk()
  const {store} = desk
  const chosen = usePage(s => s.charts)
  const span = usePage(s => s.chartSpan)
  const recording = usePage(s => s.room.recording)
  const lookedAt = usePage(s => s.room.lookedAt)
  const there = usePage(s => quantitiesOf(s.room.frame))
  const [hover, setHover] = useState<number | null>(null)
  const curves = useMemo(openCurves, [])
  const shown = windowOf(recording, lookedAt, span)
  const at = hover ?? lookedAt
  const toggle = (key: string) =>
    store.dispatch({
      kind: "charted",
      quantities: chosen.includes(key) ? chosen.filter(k => k !== key) : [...chosen, key],
    })
  return (
    <>
      <div class="charts-bar">
        <Segments
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
      {there
        .filter(q => chosen.includes(q.key))
        .map(q => (
          <Strip
            key={q.key}
            quantity={q}
            curve={curves.of(recording, q, shown)}
            at={at}
            pointed={setHover}
            chosen={time => store.dispatch({kind: "looked-back", time})}
          />
        ))}
      <fieldset class="chips" aria-label={words.chartedValues}>
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
        <button type="button" class="link" onClick={() => desk.saveTable()}>
          {words.saveTable}
        </button>
      </p>
    </>
  )
}
