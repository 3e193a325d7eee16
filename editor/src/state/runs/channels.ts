/// Channels of a frame, by name: what each sensor reads and what each command left, as `protocol/README.md` section 4 has them. Pure.

/// The values of a channel; of an event with several sensors the state of each.
export type ChannelValues = readonly (number | string)[]

/// All channels, by name.
export type Channels = {readonly [name: string]: ChannelValues}

/// What has channels: a frame.
export type Sensed = {readonly channels: Channels}

/// A number of a channel; 0 while it is not known.
export function numberAt(frame: Sensed | null, channel: string, place = 0): number {
  const value = frame?.channels[channel]?.[place]
  return typeof value === "number" ? value : 0
}

/// Whether a sensor of a channel is on: pressed, over a hole, in the air.
export function isOn(frame: Sensed | null, channel: string, place: number): boolean {
  return numberAt(frame, channel, place) === 1
}

/// Forwards, m/s.
export const speedOf = (frame: Sensed | null): number => numberAt(frame, "Velocity", 0)

/// Counter-clockwise, rad/s.
export const turningOf = (frame: Sensed | null): number => numberAt(frame, "Velocity", 1)
