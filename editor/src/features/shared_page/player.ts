/// Script of the shared page: draws the film of a run on the canvas, and plays it. The slider and the button are those of HTML and work by keyboard. Nothing
/// moves before a person presses Play; where less motion is wanted, the film advances in steps.

import {cornerOf, follow, lookAt, toScreen} from "../../views/room/camera.ts"
import {type Palette, readPalette} from "../../views/room/palette.ts"
import {drawBubble, drawRobot} from "../../views/room/robot_drawing.ts"
import {drawInk} from "../../views/room/trail_drawing.ts"
import {drawObjects, drawWorld} from "../../views/room/world_drawing.ts"
import {isLarge} from "../../worlds/world.ts"
import {durationOf, type Film, momentAt} from "./film.ts"

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id)
  if (found === null) throw new Error(`expected #${id} in the shared page, found none`)
  return found as T
}

const film = JSON.parse(element("film").textContent ?? "") as Film
const canvas = element<HTMLCanvasElement>("room")
const button = element<HTMLButtonElement>("play")
const slider = element<HTMLInputElement>("time")
const clock = element<HTMLOutputElement>("clock")
const ctx = canvas.getContext("2d")
const {from, to} = durationOf(film)
const [width, height] = film.world.size

const lessMotion = window.matchMedia("(prefers-reduced-motion: reduce)")
const dark = window.matchMedia("(prefers-color-scheme: dark)")
/// Seconds of the run between two pictures where less motion is wanted.
const quietStep = 1

const seconds = new Intl.NumberFormat(document.documentElement.lang, {
  minimumFractionDigits: 1,
  maximumFractionDigits: 1,
})

let palette: Palette = readPalette(document.documentElement)
/// A whole room fits into most windows with the controls below it.
const mostHeight = 0.6
/// The time that is shown, s; the end shows the whole path.
let shown = to
/// When the playing film would have been at its start, on the clock of the page, ms; `null` while it is paused.
let startedAt: number | null = null

function draw(): void {
  const w = canvas.parentElement?.clientWidth ?? 300
  const h = Math.min(Math.round((w * height) / width) + 36, Math.round(window.innerHeight * mostHeight))
  const ratio = window.devicePixelRatio || 1
  canvas.width = w * ratio
  canvas.height = h * ratio
  if (ctx === null) return
  const moment = momentAt(film, shown)
  const look = isLarge(film.world) ? follow(null, moment, width, height, w, h) : null
  const camera = lookAt(look, width, height, w, h, cornerOf(film.world))
  ctx.fillStyle = palette.around
  ctx.fillRect(0, 0, canvas.width, canvas.height)
  const k = ratio * camera.scale
  ctx.setTransform(k, 0, 0, -k, camera.left * ratio, camera.bottom * ratio)
  drawWorld(ctx, film.world, palette, camera.scale)
  ctx.beginPath()
  for (const [x, y] of moment.path) ctx.lineTo(x, y)
  ctx.lineJoin = "round"
  ctx.lineCap = "round"
  ctx.lineWidth = Math.max(2.5 / camera.scale, 0.02)
  ctx.strokeStyle = palette.trail
  ctx.stroke()
  drawInk(ctx, moment.ink, palette, camera.scale)
  drawObjects(ctx, film.world, moment.objects, palette, camera.scale)
  ctx.save()
  ctx.translate(moment.x, moment.y)
  ctx.rotate(moment.theta)
  drawRobot(ctx, moment, palette, camera.scale, film.world.robot)
  ctx.restore()
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0)
  if (moment.said !== null) {
    const at = toScreen(camera, moment.x, moment.y)
    drawBubble(ctx, moment.said, at, 0.2 * camera.scale + 14, {w, h}, palette)
  }
  ctx.setTransform(1, 0, 0, 1, 0, 0)
}

function show(time: number): void {
  shown = Math.min(to, Math.max(from, time))
  slider.value = `${shown}`
  const text = `${seconds.format(shown)} s`
  clock.value = text
  slider.setAttribute("aria-valuetext", text)
  draw()
}

function pause(): void {
  startedAt = null
  button.textContent = button.dataset["play"] ?? ""
}

function play(): void {
  const first = shown >= to ? from : shown
  startedAt = performance.now() - (first - from) * 1000
  button.textContent = button.dataset["pause"] ?? ""
  show(first)
  requestAnimationFrame(advance)
}

function advance(now: number): void {
  if (startedAt === null) return
  const passed = Math.max(0, (now - startedAt) / 1000)
  const time = from + passed
  if (!lessMotion.matches || time >= to) show(time)
  else if (Math.abs(time - shown) >= quietStep) show(from + Math.floor(passed / quietStep) * quietStep)
  if (time >= to) pause()
  else requestAnimationFrame(advance)
}

slider.min = `${from}`
slider.max = `${to}`
button.addEventListener("click", () => (startedAt === null ? play() : pause()))
slider.addEventListener("input", () => {
  pause()
  show(Number(slider.value))
})
window.addEventListener("resize", draw)
dark.addEventListener("change", () => {
  palette = readPalette(document.documentElement)
  draw()
})
show(to)
