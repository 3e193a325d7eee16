/// Sound synthesis: the base's seven sounds, made with Web Audio as short tones. The base's recordings are not public, so only their character is the same: rising is good,
/// falling is bad.

/// A tone: pitch in Hz, start and length in seconds, and how the wave is shaped.
interface Tone {
  readonly hz: number
  readonly at: number
  readonly length: number
  readonly wave: OscillatorType
}

const tune = (wave: OscillatorType, length: number, ...notes: readonly number[]): readonly Tone[] =>
  notes.map((hz, i) => ({hz, at: i * length, length: length * 1.25, wave}))

/// protocol §2: 0 on, 1 off, 2 recharge, 3 button, 4 error, 5 cleaning start, 6 cleaning end.
const sounds: readonly (readonly Tone[])[] = [
  tune("triangle", 0.11, 523, 659, 784),
  tune("triangle", 0.11, 784, 659, 523),
  tune("sine", 0.16, 587, 880),
  tune("sine", 0.06, 988),
  tune("square", 0.13, 220, 165),
  tune("triangle", 0.09, 523, 523, 784, 1047),
  tune("triangle", 0.12, 1047, 784, 523),
]

/// Loudest part of a tone, of 1; a square wave sounds louder than it is.
const loudness: Record<string, number> = {sine: 0.16, triangle: 0.18, square: 0.06}

export interface Speaker {
  /// Plays sound 0 to 6; does nothing where the browser makes no sound.
  play(sound: number): void
}

/// Browsers let a page sound only after a click or a key; the context is made at the first sound.
export function openSpeaker(): Speaker {
  let context: AudioContext | null = null
  return {
    play(sound) {
      if (typeof AudioContext === "undefined") return
      context ??= new AudioContext()
      void context.resume()
      const start = context.currentTime + 0.01
      for (const tone of sounds[sound] ?? []) {
        const oscillator = context.createOscillator()
        const envelope = context.createGain()
        oscillator.type = tone.wave
        oscillator.frequency.value = tone.hz
        const from = start + tone.at
        envelope.gain.setValueAtTime(0, from)
        envelope.gain.linearRampToValueAtTime(loudness[tone.wave] ?? 0.1, from + 0.012)
        envelope.gain.exponentialRampToValueAtTime(0.0008, from + tone.length)
        oscillator.connect(envelope).connect(context.destination)
        oscillator.start(from)
        oscillator.stop(from + tone.length + 0.02)
      }
    },
  }
}
