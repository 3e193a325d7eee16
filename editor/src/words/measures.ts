/// Numbers and counted things as a language writes them.

export interface Measures {
  /// With exactly so many digits behind the point.
  fixed(value: number, digits: number): string
  /// With the digits that it has, at most so many behind the point.
  short(value: number, digits: number): string
  seconds(value: number, digits: number): string
  /// A day and its time.
  moment(date: Date): string
  metres(value: number): string
  degrees(radians: number): string
  /// The form of a sentence that goes with a number of things, as the language counts.
  count(n: number, forms: Forms): string
}

export interface Forms {
  readonly one: string
  readonly other: (n: string) => string
}

export function measuresOf(language: string): Measures {
  const plurals = new Intl.PluralRules(language)
  const moments = new Intl.DateTimeFormat(language, {dateStyle: "medium", timeStyle: "short"})
  const formats = new Map<string, Intl.NumberFormat>()
  const write = (value: number, least: number, most: number) => {
    const key = `${least} ${most}`
    let format = formats.get(key)
    if (format === undefined) {
      format = new Intl.NumberFormat(language, {
        minimumFractionDigits: least,
        maximumFractionDigits: most,
        useGrouping: false,
        // A robot that stands has no speed of -0.000.
        signDisplay: "negative",
      })
      formats.set(key, format)
    }
    return format.format(value)
  }
  const fixed = (value: number, digits: number) => write(value, digits, digits)
  const short = (value: number, digits: number) => write(value, 0, digits)
  return {
    fixed,
    short,
    seconds: (value, digits) => `${fixed(value, digits)} s`,
    moment: date => moments.format(date),
    metres: value => `${short(value, 2)} m`,
    degrees: radians => `${Math.round((radians * 180) / Math.PI)}°`,
    count: (n, forms) => (plurals.select(n) === "one" ? forms.one : forms.other(short(n, 0))),
  }
}
