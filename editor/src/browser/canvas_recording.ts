/// Pictures and video recordings of a canvas.

export interface CanvasRecording {
  /// Ends the film; it is handed over when its last piece has been written.
  stop(): void
  /// The film stands still until `resume`.
  pause(): void
  resume(): void
}

/// Pictures a second, and how much a second of film may weigh, bits.
const rate = 30
const weight = 2_500_000

/// Milliseconds after which a film ends by itself: it is kept in memory, some 20 MB a minute at most.
const longest = 10 * 60 * 1000

const kinds = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"]

/// Whether this browser can make films (WebM).
export function canRecord(): boolean {
  return filmKind() !== undefined
}

function filmKind(): string | undefined {
  if (typeof MediaRecorder === "undefined") return undefined
  return kinds.find(kind => MediaRecorder.isTypeSupported(kind))
}

/// Films the canvas from now on; `ended` is called once, with `null` when nothing was to be seen. Answers `null`
/// where no film can be made.
export function startRecording(
  canvas: HTMLCanvasElement,
  ended: (film: Blob | null) => void,
): CanvasRecording | null {
  const kind = filmKind()
  if (kind === undefined) return null
  const stream = canvas.captureStream(rate)
  const recorder = new MediaRecorder(stream, {mimeType: kind, videoBitsPerSecond: weight})
  const pieces: Blob[] = []
  const end = setTimeout(() => recorder.stop(), longest)
  recorder.ondataavailable = event => {
    if (event.data.size > 0) pieces.push(event.data)
  }
  recorder.onstop = () => {
    clearTimeout(end)
    for (const track of stream.getTracks()) track.stop()
    ended(pieces.length === 0 ? null : new Blob(pieces, {type: "video/webm"}))
  }
  recorder.start(1000)
  return {
    stop() {
      if (recorder.state !== "inactive") recorder.stop()
    },
    pause: () => recorder.state === "recording" && recorder.pause(),
    resume: () => recorder.state === "paused" && recorder.resume(),
  }
}

/// What the canvas shows now, as a PNG; `null` when it shows nothing.
export function takePicture(canvas: HTMLCanvasElement): Promise<Blob | null> {
  return new Promise(resolve => canvas.toBlob(resolve, "image/png"))
}
