/// Graph of a function of the program in the charts: the points of the run, a shape and a colour for each case, and the points as a table.

import {words as robotWords} from "@rosy/codegen/words"
import type {VNode} from "preact"
import {useMemo, useState} from "preact/hooks"
import {isActive} from "../../state/runs/run_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {
  type Axis,
  axisKey,
  type ChosenAxes,
  type FunctionGraph,
  functionGraph,
  type GraphPoint,
  graphedFunctions,
} from "../../values/function_graph.ts"
import {functionNames} from "../../values/value_labels.ts"
import {measures, words} from "../../words/index.ts"
import {PlotPicture, plotOf, rangeOf} from "./plot.tsx"

/// Drawings a second while a run goes on.
const rate = 5
/// Rows of the table of one case; the first and the last point are among them.
const mostRows = 12
const height = 160

/// Buttons for the functions that have a graph, and the graph of the chosen one.
export function FunctionGraphs(): VNode | null {
  const {store} = useController()
  const parts = usePageState(s => s.network?.parts ?? null)
  const graphed = usePageState(s => s.graphed)
  const firings = usePageState(s => (s.clock === "going" && isActive(s.run) ? null : s.room.firings))
  const names = graphedFunctions(firings ?? store.now.room.firings, functionNames(parts ?? []))
  // The graph of a function that turned out to have none says so.
  const offered = graphed === null || names.includes(graphed) ? names : [...names, graphed]
  if (offered.length === 0) return null
  return (
    <>
      <fieldset class="chips" aria-label={words.graph.functions}>
        {offered.map(name => (
          <button
            type="button"
            key={name}
            aria-pressed={name === graphed}
            style={{"--curve": "var(--state)"}}
            onClick={() =>
              store.dispatch({kind: "function-graphed", function: name === graphed ? null : name})
            }
          >
            {words.graph.of(name)}
          </button>
        ))}
      </fieldset>
      {graphed !== null && <Graph key={graphed} name={graphed} />}
    </>
  )
}

function Graph({name}: {readonly name: string}): VNode {
  const {store} = useController()
  const [chosen, choose] = useState<ChosenAxes>({})
  const run = usePageState(s => s.room.run)
  const isWhole = usePageState(s => s.room.firings.isWhole)
  const isStill = usePageState(s => s.clock === "standing" || !isActive(s.run))
  // What the graph is drawn anew for: the displayed moment, in steps while the run goes on.
  const beat = usePageState(s =>
    isStill || s.room.lookedAt !== null ? s.room.lookedAt : Math.floor((s.room.frame?.time ?? 0) * rate),
  )
  const stillFirings = usePageState(s => (isStill ? s.room.firings : null))
  const graph = useMemo(() => {
    const {room} = store.now
    return functionGraph(
      room.firings,
      name,
      room.lookedAt ?? room.frame?.time ?? Number.POSITIVE_INFINITY,
      chosen,
    )
  }, [store, name, chosen, run, beat, stillFirings])
  const hasRun = usePageState(s => s.room.fired[name] !== undefined)
  const {x, y} = graph
  if (x === null || y === null || graph.now === null)
    return (
      <p class="quiet" data-testid="no-graph">
        {hasRun && (graph.inputs.length > 0 || graph.outputs.length > 0)
          ? words.graph.noNumbers
          : words.graph.notRun}
      </p>
    )
  return (
    <figure class="function-graph" data-testid="function-graph">
      <figcaption>
        <AxisChoice
          label={words.graph.input}
          axis={x}
          all={graph.inputs}
          chosen={key => choose({...chosen, x: key})}
        />
        <span aria-hidden="true">→</span>
        <AxisChoice
          label={words.graph.output}
          axis={y}
          all={graph.outputs}
          chosen={key => choose({...chosen, y: key})}
        />
        <span class="value">{pointText(graph.now)}</span>
      </figcaption>
      <GraphPicture name={name} graph={graph} x={x} y={y} />
      <CaseLegend graph={graph} />
      {!isWhole && <p class="quiet">{words.graph.partial}</p>}
      <PointTable graph={graph} x={x} y={y} />
    </figure>
  )
}

/// A number that goes in or out, or a choice where there are several.
function AxisChoice(props: {
  readonly label: string
  readonly axis: Axis
  readonly all: readonly Axis[]
  chosen(key: string): void
}): VNode {
  const {label, axis, all} = props
  if (all.length === 1) return <span title={label}>{axisName(axis)}</span>
  return (
    <select
      aria-label={label}
      title={label}
      value={axisKey(axis)}
      onChange={event => props.chosen(event.currentTarget.value)}
    >
      {all.map(one => (
        <option key={axisKey(one)} value={axisKey(one)}>
          {axisName(one)}
        </option>
      ))}
    </select>
  )
}

/// As the block of the type names it: `Position: x, metres`.
function axisName({type, part, parts}: Axis): string {
  const known: Readonly<Record<string, {readonly parts: readonly string[]}>> = robotWords.constructors
  const names = known[type]?.parts
  const name = names?.length === parts ? names[part] : parts > 1 ? String(part + 1) : undefined
  return [type, name].filter(Boolean).join(": ")
}

const pointText = ({x, y}: GraphPoint): string => `${measures.short(x, 2)} → ${measures.short(y, 2)}`

/// Colours and shapes of the cases, in the order of the program; then they begin again.
const colours = ["state", "command", "memory", "task", "event"] as const
const colourOf = (place: number) => `var(--${colours[place % colours.length]})`

const shapes: readonly ((x: number, y: number) => string)[] = [
  (x, y) => `M${x - 2.5} ${y}a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0-5 0`,
  (x, y) => `M${x - 2.2} ${y - 2.2}h4.4v4.4h-4.4z`,
  (x, y) => `M${x} ${y - 3}l3 5.2h-6z`,
  (x, y) => `M${x} ${y - 3.4}l3 3.4l-3 3.4l-3-3.4z`,
  (x, y) => `M${x - 2.6} ${y - 0.8}h1.8v-1.8h1.6v1.8h1.8v1.6h-1.8v1.8h-1.6v-1.8h-1.8z`,
]
const shapeOf = (place: number) => shapes[place % shapes.length] ?? (() => "")

const short = (value: number) => +value.toFixed(1)

function GraphPicture(props: {
  readonly name: string
  readonly graph: FunctionGraph
  readonly x: Axis
  readonly y: Axis
}): VNode {
  const {name, graph, x, y} = props
  const points = graph.cases.flatMap(one => one.points)
  const xs = rangeOf(points.map(point => point.x))
  const ys = rangeOf(points.map(point => point.y))
  const plot = plotOf(xs, ys, height)
  const spanText = (axis: Axis, low: number, high: number) =>
    `${axisName(axis)} ${words.graph.span(measures.short(low, 2), measures.short(high, 2))}`
  const text = `${words.graph.of(name)}: ${spanText(x, xs.low, xs.high)} → ${spanText(y, ys.low, ys.high)}`
  const {now} = graph
  return (
    <PlotPicture plot={plot} text={text}>
      {graph.cases.map((one, place) => (
        <path
          key={`${place} ${one.text}`}
          fill={colourOf(place)}
          d={one.points.map(p => shapeOf(place)(short(plot.x(p.x)), short(plot.y(p.y)))).join("")}
        />
      ))}
      {now !== null && <circle class="now" cx={plot.x(now.x)} cy={plot.y(now.y)} r={6} />}
    </PlotPicture>
  )
}

/// Which shape is which case; the one of the displayed moment is bold.
function CaseLegend({graph}: {readonly graph: FunctionGraph}): VNode | null {
  if (graph.cases.every(({text}) => text === "")) return null
  return (
    <ul class="cases" data-testid="graph-cases">
      {graph.cases.map(({text}, place) => (
        <li key={`${place} ${text}`} aria-current={graph.now?.of === place ? "true" : undefined}>
          <svg viewBox="0 0 12 12" aria-hidden="true">
            <path fill={colourOf(place)} d={shapeOf(place)(6, 6)} transform="translate(-3 -3) scale(1.5)" />
          </svg>
          <code>{text}</code>
          {graph.now?.of === place && <span class="quiet">{words.graph.now}</span>}
        </li>
      ))}
    </ul>
  )
}

function PointTable({
  graph,
  x,
  y,
}: {
  readonly graph: FunctionGraph
  readonly x: Axis
  readonly y: Axis
}): VNode {
  const hasCases = graph.cases.some(({text}) => text !== "")
  return (
    <details>
      <summary>{words.graph.table}</summary>
      <table class="sensors">
        <thead>
          <tr>
            <th scope="col">{axisName(x)}</th>
            <th scope="col">{axisName(y)}</th>
            {hasCases && <th scope="col">{words.graph.case}</th>}
          </tr>
        </thead>
        <tbody>
          {graph.cases.flatMap(({text, points}, place) =>
            rowsOf(points).map((point, row) => (
              <tr key={`${place} ${row}`}>
                <td>{measures.fixed(point.x, 2)}</td>
                <td>{measures.fixed(point.y, 2)}</td>
                {hasCases && (
                  <td>
                    <code>{text}</code>
                  </td>
                )}
              </tr>
            )),
          )}
        </tbody>
      </table>
    </details>
  )
}

function rowsOf(points: readonly GraphPoint[]): readonly GraphPoint[] {
  if (points.length <= mostRows) return points
  const step = (points.length - 1) / (mostRows - 1)
  return Array.from({length: mostRows}, (_, i) => points[Math.round(i * step)]).filter(
    one => one !== undefined,
  )
}
