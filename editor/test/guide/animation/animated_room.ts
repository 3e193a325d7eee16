/// Animated SVG of a recorded run: the room, the robot and its trail in the page's own drawing, moved by CSS.
///
/// A second picture, without the movement, shows the end of the run. Pure: the same recording is the same text.

import type {Channels} from "../../../src/state/runs/channels.ts"
import type {Palette} from "../../../src/views/room/palette.ts"
import {drawRobot} from "../../../src/views/room/robot_drawing.ts"
import {drawWorld} from "../../../src/views/room/world_drawing.ts"
import type {Recording, TimedPose} from "./recording.ts"
import {drawnSvg, svgNumber} from "./svg_context.ts"

/// In CSS pixels, at most; a metre has no more than `closest`.
const most = {width: 480, height: 320}
const closest = 150
/// Metres that are shown around the path, and of what is outside the room.
const around = 0.7
const outside = 0.12
/// The animation runs faster than the robot by this, and rests at the end for some seconds.
const faster = 2
const rest = 1.5
/// As on the page (`trail_drawing.ts`), in pixels.
const trailWidth = 2.5
/// The bar below the room that shows how far the run is, in pixels.
const barHeight = 4

/// A pose is left out when it lies so near the straight way between its neighbours: m, rad.
const nearEnough = {distance: 0.002, angle: 0.01}

export function animatedRoom(
  {world, seconds, poses, looks}: Recording,
  palette: Palette,
  moves: boolean,
): string {
  const [left, right] = shownPart(
    poses.map(pose => pose.x),
    world.size[0],
  )
  const [low, high] = shownPart(
    poses.map(pose => pose.y),
    world.size[1],
  )
  const scale = Math.min(most.width / (right - left), most.height / (high - low), closest)
  const width = Math.round((right - left) * scale)
  const height = Math.round((high - low) * scale)
  const whole = seconds / faster + rest
  const percent = (time: number) => svgNumber((100 * time) / faster / whole)
  const kept = withoutStraightOnes(poses)
  const lengths = lengthsOf(poses)
  const length = lengths.at(-1) ?? 0
  const frames = (name: string, times: readonly (readonly [number, string])[]) =>
    `@keyframes ${name}{${times.map(([time, style]) => `${percent(time)}%{${style}}`).join("")}100%{${times.at(-1)?.[1]}}}`
  const last = poses.at(-1) ?? {time: 0, ...world.start}
  const appearances = appearancesOf(looks)

  const moving = [
    `#robot{animation:drive ${svgNumber(whole)}s linear infinite}`,
    `#trail{animation:trail ${svgNumber(whole)}s linear infinite}`,
    `#time{animation:time ${svgNumber(whole)}s linear infinite}`,
    ...appearances
      .filter(({shown}) => shown.length > 1)
      .map(({name}) => `#${name}{animation:${name} ${svgNumber(whole)}s step-end infinite}`),
  ]
  const keyframes = [
    frames(
      "drive",
      kept.map(pose => [pose.time, `transform:${placed(pose)}`] as const),
    ),
    frames(
      "trail",
      poses
        .map((pose, i) => [pose.time, lengths[i] ?? 0] as const)
        .filter((_, i) => i === 0 || i === poses.length - 1 || kept.includes(poses[i] as TimedPose))
        .map(([time, driven]) => [time, `stroke-dashoffset:${svgNumber(length - driven)}`] as const),
    ),
    frames("time", [
      [0, "transform:scaleX(0)"],
      [seconds, "transform:scaleX(1)"],
    ]),
    ...appearances
      .filter(({shown}) => shown.length > 1)
      .map(({name, shown}) =>
        frames(
          name,
          shown.map(([time, isShown]) => [time, `visibility:${isShown ? "visible" : "hidden"}`] as const),
        ),
      ),
  ]
  const path = poses.map(({x, y}, i) => `${i === 0 ? "M" : "L"}${svgNumber(x)} ${svgNumber(y)}`).join("")
  const drawnRobot = appearances.map(({name, channels, shown}) => {
    const hidden = shown.at(-1)?.[1] === true ? "" : ' visibility="hidden"'
    return `<g id="${name}"${hidden}>${drawnSvg(ctx => drawRobot(ctx, {channels}, palette, scale))}</g>`
  })
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height + barHeight}" viewBox="0 0 ${width} ${height + barHeight}">
${moves ? `<style>\n#time{transform-origin:left}\n${[...moving, ...keyframes].join("\n")}\n</style>` : ""}
<rect width="${width}" height="${height}" fill="${palette.around}"/>
<g transform="translate(${svgNumber(-left * scale)} ${svgNumber(high * scale)}) scale(${svgNumber(scale)} ${svgNumber(-scale)})">
${drawnSvg(ctx => drawWorld(ctx, world, palette, scale))}
<path id="trail" d="${path}" fill="none" stroke="${palette.trail}" stroke-width="${svgNumber(trailWidth / scale)}" stroke-linejoin="round" stroke-dasharray="${svgNumber(length)}"/>
<g id="robot" style="transform:${placed(last)}">
${drawnRobot.join("\n")}
</g>
</g>
<rect y="${height}" width="${width}" height="${barHeight}" fill="${palette.around}"/>
<rect id="time" y="${height}" width="${width}" height="${barHeight}" fill="${palette.wall}"/>
</svg>
`
}

/// Along one axis of the room.
function shownPart(path: readonly number[], size: number): readonly [number, number] {
  return [
    Math.max(-outside, Math.min(...path) - around),
    Math.min(size + outside, Math.max(...path) + around),
  ]
}

/// Metres are the unit of the group around it.
const placed = ({x, y, theta}: TimedPose): string =>
  `translate(${svgNumber(x)}px,${svgNumber(y)}px) rotate(${svgNumber(theta)}rad)`

/// A way in which the robot is drawn, and from when on it is shown or not.
interface Appearance {
  readonly name: string
  readonly channels: Channels
  readonly shown: readonly (readonly [time: number, isShown: boolean])[]
}

/// Each appearance once, also when the robot has it several times.
function appearancesOf(looks: Recording["looks"]): readonly Appearance[] {
  const keys = looks.map(look => JSON.stringify(look.channels))
  return [...new Set(keys)].map((key, number) => ({
    name: `look-${number}`,
    channels: looks[keys.indexOf(key)]?.channels ?? {},
    shown: looks
      .map(({time}, i) => [i === 0 ? 0 : time, keys[i] === key] as const)
      .filter(([, isShown], i, all) => i === 0 || all[i - 1]?.[1] !== isShown),
  }))
}

/// How far the robot has driven at each pose, m.
function lengthsOf(poses: readonly TimedPose[]): readonly number[] {
  let length = 0
  return poses.map((pose, i) => {
    const before = poses[i - 1] ?? pose
    length += Math.hypot(pose.x - before.x, pose.y - before.y)
    return length
  })
}

/// The poses between which the robot drives straight on, evenly: what lies between two of them is what the browser computes.
function withoutStraightOnes(poses: readonly TimedPose[]): readonly TimedPose[] {
  const kept: TimedPose[] = []
  let from = 0
  poses.forEach((pose, to) => {
    if (to === 0 || to === poses.length - 1) kept.push(pose)
    const [first, next] = [poses[from], poses[to + 1]]
    if (first === undefined || next === undefined || to === from) return
    const between = poses.slice(from + 1, to + 1)
    if (between.every(one => isNear(one, first, next))) return
    kept.push(pose)
    from = to
  })
  return kept
}

function isNear(pose: TimedPose, first: TimedPose, last: TimedPose): boolean {
  const part = (pose.time - first.time) / (last.time - first.time)
  const mix = (a: number, b: number) => a + (b - a) * part
  const apart = Math.hypot(pose.x - mix(first.x, last.x), pose.y - mix(first.y, last.y))
  return (
    apart <= nearEnough.distance && Math.abs(pose.theta - mix(first.theta, last.theta)) <= nearEnough.angle
  )
}
