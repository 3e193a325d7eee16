/// Speed and position of the run, one above the other on one time axis: the speed is how steeply the position rises.

import type {VNode} from "preact"
import {useMemo} from "preact/hooks"
import {usePageState} from "../../ui/app_context.ts"
import {type MotionCurve, type MotionPoint, motionCurve} from "../../values/motion_curve.ts"
import {measures, words} from "../../words/index.ts"
import {type Plot, PlotPicture, plotOf, rangeOf} from "./plot.tsx"

/// The key of this chart among the chosen ones.
export const motionKey = "motion"

const height = 110
/// Half the length of the dashed line, s.
const tangentHalf = 1

export function MotionChart(): VNode | null {
  const recording = usePageState(s => s.room.recording)
  const lookedAt = usePageState(s => s.room.lookedAt)
  const curve = useMemo(() => motionCurve(recording, lookedAt), [recording, lookedAt])
  if (curve === null) return null
  const {now} = curve
  return (
    <section class="motion" aria-label={words.graph.motion} data-testid="motion-chart">
      <Line
        name={words.graph.position}
        curve={curve}
        of={point => point.position}
        text={`${measures.fixed(now.position, 2)} m`}
        colour="number"
        tangent
      />
      <Line
        name={words.graph.speed}
        curve={curve}
        of={point => point.rate}
        text={`${measures.fixed(now.rate, 2)} m/s`}
        colour="state"
      />
      <p class="quiet">{words.graph.tangent}</p>
    </section>
  )
}

function Line(props: {
  readonly name: string
  readonly curve: MotionCurve
  of(point: MotionPoint): number
  readonly text: string
  readonly colour: string
  /// Draws how it would go on with the speed of the displayed moment.
  readonly tangent?: boolean
}): VNode {
  const {curve, of, name, text} = props
  const plot = plotOf({low: curve.from, high: curve.to}, rangeOf(curve.points.map(of)), height)
  const {now} = curve
  return (
    <figure class="strip" style={{"--curve": `var(--${props.colour})`}}>
      <figcaption>
        <span>{name}</span>
        <span class="value">{text}</span>
      </figcaption>
      <PlotPicture plot={plot} text={`${name}, ${measures.seconds(now.time, 2)}: ${text}`}>
        <path class="curve" d={pathOf(plot, curve.points, of)} />
        {props.tangent && <path class="tangent" d={tangentAt(plot, now)} />}
        <circle class="now" cx={plot.x(now.time)} cy={plot.y(of(now))} r={5} />
      </PlotPicture>
    </figure>
  )
}

const short = (value: number) => +value.toFixed(1)

const pathOf = (plot: Plot, points: readonly MotionPoint[], of: (point: MotionPoint) => number) =>
  points.map((p, i) => `${i === 0 ? "M" : "L"}${short(plot.x(p.time))} ${short(plot.y(of(p)))}`).join("")

function tangentAt(plot: Plot, {time, position, rate}: MotionPoint): string {
  const at = (seconds: number) =>
    `${short(plot.x(time + seconds))} ${short(plot.y(position + rate * seconds))}`
  return `M${at(-tangentHalf)}L${at(tangentHalf)}`
}
