/// Number formats and plural forms of a language.

export interface Measures {
  /// With exactly so many digits behind the point.
  fixed(value: number, digits: number): string
  /// With the digits that it has, at most so many behind the point.
  short(value: number, digits: number): string
  seconds(value: number, digits: number): string
  /// A day and its time.
  moment(date: Date): string
  /// A time of the day.
  time(date: Date): string
  metres(value: number): string
  degrees(radians: number): string
  /// The form of a sentence that goes with a number of things. A form `one` that is a text says the number itself, so it is
  /// for exactly one (CLDR counts 0 with it in Portuguese and French); one that is a function is told the number.
  count(n: number, forms: Forms): string
}

export interface Forms {
  /// A function in a language that says 0 and 1 alike, as French does.
  readonly one: string | ((n: string) => string)
  readonly other: (n: string) => string
}

export function measuresOf(language: string): Measures {
  const moments = new Intl.DateTimeFormat(language, {dateStyle: "medium", timeStyle: "short"})
  const plurals = new Intl.PluralRules(language)
  const times = new Intl.DateTimeFormat(language, {timeStyle: "short"})
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
    time: date => times.format(date),
    metres: value => `${short(value, 2)} m`,
    degrees: radians => `${Math.round((radians * 180) / Math.PI)}°`,
    // A form for one that is a function counts too: where the language says 0 like 1 (French), it is told which.
    count: (n, forms) => {
      const isOne = typeof forms.one === "string" ? n === 1 : plurals.select(n) === "one"
      const form = isOne ? forms.one : forms.other
      return typeof form === "string" ? form : form(short(n, 0))
    },
  }
}
