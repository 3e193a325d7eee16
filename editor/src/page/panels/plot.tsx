/// Plot with two axes, as SVG: scales, axes with their ends, and the area of the points.

import type {ComponentChildren, VNode} from "preact"
import {measures} from "../../words/index.ts"

export interface Range {
  readonly low: number
  readonly high: number
}

/// The range of some values, with 0 in it.
export function rangeOf(values: Iterable<number>): Range {
  let low = 0
  let high = 0
  for (const value of values) {
    low = Math.min(low, value)
    high = Math.max(high, value)
  }
  // A range without length would have no scale.
  return high - low < 1e-6 ? {low, high: low + 1} : {low, high}
}

/// Units of the drawing; it is scaled to the width of the panel.
const width = 340
/// Left of the area are the numbers of the y axis, below it those of the x axis.
const margin = {left: 40, right: 12, top: 10, bottom: 20}

export interface Plot {
  readonly height: number
  readonly xs: Range
  readonly ys: Range
  x(value: number): number
  y(value: number): number
}

export function plotOf(xs: Range, ys: Range, height: number): Plot {
  const across = width - margin.left - margin.right
  const up = height - margin.top - margin.bottom
  return {
    height,
    xs,
    ys,
    x: value => margin.left + ((value - xs.low) / (xs.high - xs.low)) * across,
    y: value => height - margin.bottom - ((value - ys.low) / (ys.high - ys.low)) * up,
  }
}

/// `text` is all that the picture shows, for a screen reader.
export function PlotPicture(props: {
  readonly plot: Plot
  readonly text: string
  readonly children: ComponentChildren
}): VNode {
  const {plot} = props
  const {xs, ys, height} = plot
  // Numbers that would be written over each other are left out.
  const shown = (low: number, high: number, zero: number, room: number) =>
    Math.min(zero - low, high - zero) > room ? [low, 0, high] : [low, high]
  const xTicks = new Set(shown(xs.low, xs.high, 0, (xs.high - xs.low) / 8))
  const yTicks = new Set(shown(ys.low, ys.high, 0, (ys.high - ys.low) / 6))
  return (
    <svg class="plot" viewBox={`0 0 ${width} ${height}`} role="img" aria-label={props.text}>
      <path
        class="axis"
        d={`M${plot.x(xs.low)} ${plot.y(0)}H${plot.x(xs.high)}M${plot.x(0)} ${plot.y(ys.low)}V${plot.y(ys.high)}`}
      />
      {[...xTicks].map(value => (
        <text key={value} x={plot.x(value)} y={height - 5} text-anchor={value === xs.high ? "end" : "middle"}>
          {measures.short(value, 2)}
        </text>
      ))}
      {[...yTicks].map(value => (
        <text key={value} x={margin.left - 5} y={plot.y(value) + 4} text-anchor="end">
          {measures.short(value, 2)}
        </text>
      ))}
      {props.children}
    </svg>
  )
}
